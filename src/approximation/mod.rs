//! How well a patch approximates its surface: best values of the unknowns, and proved bounds.
//!
//! Optimisation is done in floating point and guesses. Whatever is said to be proved is a certificate that the checker
//! has accepted.

mod boxes;
mod chart;
mod descent;
mod enclosure;
mod extreme;
mod extremes;
mod fixed;
mod model;
mod objective;
mod start;
mod tree;
mod unreachable;

pub use enclosure::{Enclosure, EnclosureError, enclose, patch_at, quantity_of};
pub use extremes::{Place, local_extremes};
pub use model::{Deviation, Fitted, Model};
pub use objective::Objective;
pub use unreachable::{Barrier, UnreachableError, exclude};

use crate::elimination::{Control, Interrupted};

pub fn tmp(
    model: &Model,
    o: Objective,
    seed: u64,
    c: &Control<'_>,
) -> Result<Option<(Vec<f64>, Vec<f64>, Vec<Place>)>, Interrupted> {
    let t = std::time::Instant::now();
    let Some(s) = start::start(model, seed, c)? else { return Ok(None) };
    eprintln!("start {s:?} {:?}", t.elapsed());
    let l = start::least_squares(model, &s, 100, &[]);
    eprintln!("ls {l:?} {:?}", t.elapsed());
    let d = descent::descend(model, &l, o, c)?;
    eprintln!("slp {:?}", t.elapsed());
    let e = local_extremes(&model.at(&d), 64);
    Ok(Some((l, d, e)))
}
