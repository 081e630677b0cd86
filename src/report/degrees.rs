//! The table of bidegrees, and the argument for each of its cells.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::attempt::{Files, wrapped_at};
use super::construction::{Numbers, corners_text, how_covered};
use crate::construction::{Cell, Construction, Phase, classify, triple_products};
use crate::geometry::{Complex, Polygon};

/// What was computed and verified for a table.
#[derive(Debug, Default)]
pub struct Backing {
    /// The refutation of the closing condition.
    pub closing: Option<Files>,
    /// Exact patches.
    pub nets: Vec<((u32, u32), Construction, Vec<Files>)>,
}

/// What stands behind the lemmas.
pub(super) const ON_PAPER: &str = "The lemmas, with their hypotheses and proofs, are in proofs/STRUCTURE.md: mathematics on paper, which no program has \
     checked.";

/// `degrees`.
pub fn degrees_text(name: &str, polygon: &Polygon, up_to: u32, backing: &Backing) -> String {
    let phase = Phase::of(polygon);
    let mut text = String::new();
    let condition = match phase {
        Phase::Open => "min(m,n) ≥ 2 and max(m,n) ≥ 4",
        Phase::Reversed => "min(m,n) ≥ 2 and max(m,n) ≥ 4; from (2,2) on with an edge the longer way round",
        Phase::None | Phase::Absorbed => "min(m,n) ≥ 2",
    };
    let _ = writeln!(
        text,
        "PROVED  {name}: on the unit sphere bidegree (m,n) is exact if and only if {condition}\n"
    );
    let _ = writeln!(text, "Corners, in the order of the boundary\n{}", corners_text(polygon));
    text += &holonomy_text(polygon);
    text.push('\n');
    let _ = write!(text, "       n");
    for n in 1..=up_to {
        let _ = write!(text, "{n:>4}");
    }
    text += "\n   m\n";
    for m in 1..=up_to {
        let _ = write!(text, "{m:>4}    ");
        for n in 1..=up_to {
            let _ = write!(text, "{:>4}", symbol(classify(phase, (m, n)), (m, n)));
        }
        text.push('\n');
    }
    text.push('\n');
    let all: Vec<(u32, u32)> = (1..=up_to).flat_map(|m| (1..=up_to).map(move |n| (m, n))).collect();
    for (mark, meaning) in [
        ("·", "impossible: no surface (parity)"),
        ("×", "impossible: the phase does not close (parity and holonomy; certificate below)"),
        ("~", "edges in their great circles, but no net with all of them the shorter arcs (net below)"),
        ("E", "exact: constructed (net below, with what the independent checker has verified of it)"),
        ("e", "exact: a net above or to the left of it, with its degrees raised"),
    ] {
        if all.iter().any(|at| symbol(classify(phase, *at), *at) == mark) {
            let _ = writeln!(text, "   {mark}  {meaning}");
        }
    }
    text += "\nThe argument for a cell: --explain M N. The lemmas, with their hypotheses and proofs, are in proofs/STRUCTURE.md:\n\
             mathematics on paper. The independent checker has verified the files that are named here.\n\n";
    if let Some(files) = &backing.closing {
        let _ = writeln!(
            text,
            "   ×        the closing condition has no solution: VERIFIED  {}",
            files.certificate.display()
        );
    }
    for ((m, n), made, files) in &backing.nets {
        let theorem = made.cover.as_ref().unwrap_or(&made.exact).theorem();
        let last = files.last().map_or_else(String::new, |files| files.certificate.display().to_string());
        let _ = writeln!(
            text,
            "   {} ({m},{n})  {}: VERIFIED  {last}",
            symbol(classify(phase, (*m, *n)), (*m, *n)),
            match theorem.kind() {
                "cover" => format!("covers the polygon{}", how_covered(theorem)),
                _ => "lies on the sphere".to_owned(),
            }
        );
    }
    text
}

fn symbol(cell: Cell, at: (u32, u32)) -> &'static str {
    match cell {
        Cell::NoSurface => "·",
        Cell::NoClosure => "×",
        Cell::LongerWay => "~",
        Cell::Exact(base) if base == at => "E",
        Cell::Exact(_) => "e",
    }
}

/// Z and its imaginary part.
fn holonomy_text(polygon: &Polygon) -> String {
    let numbers = Numbers::new(polygon);
    let mut text = String::new();
    if polygon.is_triangle() {
        return "A triangle: the edge that is a point takes up any phase.\n".to_owned();
    }
    let (products, sum) = triple_products(polygon);
    let _ = writeln!(text, "Triple products [123] + [234] + [341] + [412], a positive multiple of Im Z");
    let spelled: Vec<String> = products.iter().map(|product| numbers.factor(product)).collect();
    let _ = writeln!(text, "   {} = {}", spelled.join(" + "), numbers.exact(&sum));
    if let Some(Complex { re, im }) = polygon.holonomy().direction() {
        let _ = writeln!(
            text,
            "   Z/|Z| = {} + i·{}, whose argument is half the solid angle",
            numbers.exact(&re),
            numbers.factor(&im)
        );
    }
    text
}

/// `degrees --explain M N`.
pub fn explain(name: &str, polygon: &Polygon, bidegree: (u32, u32)) -> String {
    let cell = classify(Phase::of(polygon), bidegree);
    let (m, n) = bidegree;
    let verdict = match cell {
        Cell::NoSurface | Cell::NoClosure => "no exact patch",
        Cell::LongerWay => "no exact patch with all edges the shorter arcs",
        Cell::Exact(_) => "exact patches",
    };
    format!(
        "PROVED  {name}: on the unit sphere bidegree ({m},{n}) has {verdict}\n\n{}\n\n{}\n",
        reason(polygon, bidegree, cell),
        wrapped_at(ON_PAPER, 3)
    )
}

/// The argument for one cell.
pub(super) fn reason(polygon: &Polygon, (m, n): (u32, u32), cell: Cell) -> String {
    let parity = "Parity. Let X, Y, Z, W be without common factor and X² + Y² + Z² = W². In C[u,v], which has unique factorisation, \
         (X + iY)(X − iY) = (W + Z)(W − Z) makes W + Z = 2|α|², W − Z = 2|β|², X + iY = 2ᾱβ up to one sign, and the \
         degrees of W in u and in v are twice those of the spinor (α, β). A common factor moves no point; without it the degrees are even.";
    let even = (m - m % 2, n - n % 2);
    let paragraphs = match cell {
        Cell::NoSurface => vec![
            parity.to_owned(),
            format!(
                "Here bidegree ({m},{n}) leaves at most ({},{}): the patch does not depend on {}, and two corners coincide.",
                even.0,
                even.1,
                if even.0 == 0 { "u" } else { "v" }
            ),
        ],
        Cell::NoClosure | Cell::LongerWay => {
            let mut paragraphs = vec![];
            if even != (m, n) {
                paragraphs.push(parity.to_owned());
                paragraphs.push(format!(
                    "Here bidegree ({m},{n}) leaves at most ({},{}), a bilinear spinor.",
                    even.0, even.1
                ));
            } else {
                paragraphs.push(format!("{parity} Here the spinor is bilinear."));
            }
            paragraphs.push(
                "Holonomy. Along an edge the spinor runs linearly from a to b. Its image lies in a great circle, and a and b belong to \
                 different points that are not antipodal: then ⟨a,b⟩ is real. Around the quadrilateral, the product of the four \
                 products, Π|c|²·Z, would be real, with Z = ⟨s₁,s₂⟩⟨s₂,s₃⟩⟨s₃,s₄⟩⟨s₄,s₁⟩ for any spinors s of the corners."
                    .to_owned(),
            );
            paragraphs.push(holonomy_text(polygon).trim_end().to_owned());
            paragraphs.push(match cell {
                Cell::NoClosure => "It is not 0, so that Z is not real: there is no such patch, whatever its weights and control \
                     points. (As equations in the corners' factors c, with a certificate: `degrees` writes it.)"
                    .to_owned(),
                _ => "It is 0, and Z is negative: the four products are real, but an odd number of them is negative, and such an edge \
                     runs the longer way round."
                    .to_owned(),
            });
            paragraphs
        }
        Cell::Exact(base) => {
            let from = match (base == (m, n), base) {
                (true, _) => String::new(),
                (false, (a, b)) => {
                    format!(" Raising degrees takes ({a},{b}) to ({m},{n}) and changes no point.")
                }
            };
            let how = match (polygon.is_triangle(), base) {
                (true, _) => {
                    "The edge that is a single point may have any spinor of that point, times a linear complex factor: \
                     the phase closes, and a bilinear spinor is enough."
                }
                (false, (2, 2)) => {
                    "Z is positive: the corners' spinors can be put in phase all around, and a bilinear spinor is enough."
                }
                _ => {
                    "A linear complex factor f on two opposite edges makes up for the phase that is missing: |f|²·δ(s) is the same point. \
                     The spinor then has degree 2 along these edges and 1 across."
                }
            };
            vec![format!("Construction. {how}{from} `construct --bidegree {m} {n}` gives the net, verified.")]
        }
    };
    let wrapped = |paragraph: &String| match paragraph.contains('\n') {
        true => paragraph.lines().map(|line| format!("   {line}")).collect::<Vec<_>>().join("\n"),
        false => wrapped_at(paragraph, 3),
    };
    paragraphs.iter().map(wrapped).collect::<Vec<_>>().join("\n\n")
}

/// `degrees` as data.
pub fn degrees_data(name: &str, polygon: &Polygon, up_to: u32, backing: &Backing) -> Value {
    let phase = Phase::of(polygon);
    let cell = |m: u32, n: u32| match classify(phase, (m, n)) {
        Cell::NoSurface => json!({ "bidegree": (m, n), "verdict": "impossible", "lemma": "parity" }),
        Cell::NoClosure => json!({ "bidegree": (m, n), "verdict": "impossible", "lemma": "holonomy" }),
        Cell::LongerWay => json!({ "bidegree": (m, n), "verdict": "longer way", "lemma": "holonomy" }),
        Cell::Exact(base) => json!({ "bidegree": (m, n), "verdict": "exact", "from": base }),
    };
    let cells: Vec<Value> =
        (1..=up_to).flat_map(|m| (1..=up_to).map(move |n| (m, n))).map(|(m, n)| cell(m, n)).collect();
    let nets: Vec<Value> = backing
        .nets
        .iter()
        .map(|(base, made, files)| {
            json!({
                "bidegree": base,
                "covers": made.cover.is_ok(),
                "files": files.iter().map(|files| files.certificate.display().to_string()).collect::<Vec<_>>(),
            })
        })
        .collect();
    json!({
        "verdict": "PROVED",
        "name": name,
        "cells": cells,
        "closing": backing.closing.as_ref().map(|files| files.certificate.display().to_string()),
        "nets": nets,
    })
}
