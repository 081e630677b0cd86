//! The canonical text, continued: arguments by subdivision.

use super::bounds::{Bounds, End, Odds, Quantity, Region, Tree, Unreachable, spell_decimal};
use super::cover::{Cover, EDGES, EdgeTree};
use crate::exact::Ring;

/// The lines of `claim bounds`, and how many boxes there are.
pub(super) fn bounds(bounds: &Bounds, ring: &Ring) -> (Vec<String>, usize) {
    let mut lines = vec!["claim bounds".to_owned()];
    for (name, value) in ring.variables.iter().zip(&bounds.values) {
        lines.push(format!("value {name} = {}", ring.spell(value)));
    }
    lines.push(quantity(bounds.quantity, bounds.places));
    lines.push(format!("denominator {}", spelled(&bounds.denominator)));
    for (name, End { bound, at: [u, v], tree }) in [("lower", &bounds.lower), ("upper", &bounds.upper)] {
        let bound = spell_decimal(bound, bounds.places);
        lines.push(format!("{name} {bound} at {u} {v} over {}", spelled(tree)));
    }
    let trees = [&bounds.denominator, &bounds.lower.tree, &bounds.upper.tree];
    let boxes = trees.into_iter().flatten().filter(|halved| !**halved).count();
    (lines, boxes)
}

/// The lines of `claim cover`, and how many boxes there are.
pub(super) fn cover(cover: &Cover, ring: &Ring) -> (Vec<String>, usize) {
    let mut lines = vec!["claim cover".to_owned()];
    for (name, value) in ring.variables.iter().zip(&cover.values) {
        lines.push(format!("value {name} = {}", ring.spell(value)));
    }
    lines.push(format!("denominator {}", spelled(&cover.denominator)));
    for (name, edge) in EDGES.iter().zip(&cover.edges) {
        lines.push(match edge {
            EdgeTree::Arc(tree) => format!("edge {name} arc {}", spelled(tree)),
            EdgeTree::Point => format!("edge {name} point"),
        });
    }
    let direction = if cover.inward { "inward" } else { "outward" };
    lines.push(format!("regular {direction} {}", spelled(&cover.regular)));
    let boxes = cover.trees().flatten().filter(|halved| !**halved).count();
    (lines, boxes)
}

/// The lines of `claim unreachable`, and how many boxes there are.
pub(super) fn unreachable(argument: &Unreachable, ring: &Ring) -> (Vec<String>, usize) {
    let decimal = |units| spell_decimal(units, argument.places);
    let name = |index: u16| ring.variables.get(usize::from(index)).cloned().unwrap_or_default();
    let mut lines = vec!["claim unreachable".to_owned(), quantity(argument.quantity, argument.places)];
    lines.push(format!("between {} {}", decimal(&argument.lower), decimal(&argument.upper)));
    lines.extend(argument.products.iter().map(|&(z, w)| format!("product {}*{}", name(z), name(w))));
    lines.extend(argument.forms.iter().map(|(x, form)| format!("put {} = {}", name(*x), ring.spell(form))));
    lines.push(format!("range {}", argument.range));
    let odds =
        |odds: &Odds| if odds.shrinking { format!("{}*h", odds.value) } else { odds.value.to_string() };
    for (number, [u, v]) in (1usize..).zip(&argument.samples) {
        lines.push(format!("sample {number} at {} {}", odds(u), odds(v)));
    }
    let mut boxes = 0usize;
    for (number, chart) in (1usize..).zip(&argument.charts) {
        lines.push(format!("chart {number}"));
        for region in chart {
            lines.push(match region {
                Region::Halved => "halve".to_owned(),
                Region::Excluded(sum) => {
                    boxes = boxes.saturating_add(1);
                    let terms = sum
                        .iter()
                        .map(|(factor, side, sample)| format!("{factor}*{}[{sample}]", side.name()));
                    format!("exclude {}", terms.collect::<Vec<_>>().join(" + "))
                }
            });
        }
    }
    (lines, boxes)
}

fn quantity(quantity: Quantity, places: u32) -> String {
    match quantity {
        Quantity::Radius => format!("quantity radius {places}"),
        Quantity::Ratio => format!("quantity ratio {places}"),
    }
}

fn spelled(tree: &Tree) -> String {
    tree.iter().map(|halved| if *halved { 'h' } else { '.' }).collect()
}
