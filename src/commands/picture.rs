//! `--plot`: what is seen of a patch at the values that were enclosed, and which extremes are marked.

use std::path::Path;

use num_traits::ToPrimitive;

use super::Failure;
use crate::approximation::{Enclosure, FloatPatch, Model, Place, local_extremes};
use crate::certificate::Quantity;
use crate::control::{Control, Interrupted};
use crate::figure::{Extreme, Figure, Scene, draw};
use crate::statement::Statement;

/// Extremes that are marked at most; if there are more, only the two that the bounds name.
const MARKED: usize = 16;

/// The bytes of a picture, of the kind that the file's name says. `title` stands above it, `symbol` names what is drawn. What is
/// proved stands without a picture: that the work was stopped is no failure.
///
/// # Errors
/// Where there is no such kind, or no memory for it.
pub fn picture(
    (figure, file): (Figure, &Path),
    statement: &Statement,
    enclosure: &Enclosure,
    (title, symbol): (&str, &str),
    control: &Control,
) -> Result<Result<Vec<u8>, Interrupted>, Failure> {
    let bounds = &enclosure.bounds;
    let model = Model::at_values(statement, &bounds.values).map_err(Failure::of)?;
    let fitted = model.at(&[]);
    let patch = FloatPatch::at(statement, &bounds.values).map_err(Failure::of)?;
    let named = [(&bounds.lower, false), (&bounds.upper, true)].map(|(end, maximum)| {
        let [u, v] = end.at.each_ref().map(|x| x.to_f64().unwrap_or(f64::NAN));
        Extreme { u, v, value: fitted.value(u, v), maximum }
    });
    let extremes = marked(&local_extremes(&fitted, 64), named);
    let scene = Scene {
        title,
        symbol,
        deviation: &|u, v| fitted.value(u, v),
        point: &|u, v| patch.jet(u, v)[0],
        unit_sphere: bounds.quantity == Quantity::Radius,
        net: &patch.control_points(),
        extremes: &extremes,
    };
    if let Err(why) = control.check() {
        return Ok(Err(why));
    }
    draw(figure, &scene, file).map(Ok).map_err(Failure::of)
}

/// Those that are as far out as the two that the bounds name, by symmetry or because the optimum makes them so.
fn marked(all: &[Place], named: [Extreme; 2]) -> Vec<Extreme> {
    let size = named[1].value - named[0].value;
    let as_far = |place: &Place| {
        let [low, high] = named.map(|extreme| (place.value - extreme.value).abs() < 1e-6 * size);
        let Place { u, v, value } = *place;
        (low || high).then_some(Extreme { u, v, value, maximum: high })
    };
    let all: Vec<Extreme> = all.iter().filter_map(as_far).collect();
    if (1..=MARKED).contains(&all.len()) { all } else { named.to_vec() }
}
