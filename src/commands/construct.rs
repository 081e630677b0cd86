//! `construct`: an exact patch that covers a polygon, or a whole tiling.

use super::{Failure, NoAnswer, Nonexistent, Shape, Undecided, Verdict};
use crate::algebra::FieldElement;
use crate::construction::{self, Construction, Refusal, tile};
use crate::control::Control;

/// An exact patch.
#[derive(Debug)]
pub struct Constructed {
    /// The polygon.
    pub shape: Shape,
    /// The patch, with certificates that the checker has accepted.
    pub made: Construction,
}

/// Exact patches of all polygons of a tiling.
#[derive(Debug)]
pub struct Tiled {
    /// The polygon they are images of.
    pub shape: Shape,
    /// Their bidegree.
    pub bidegree: (u32, u32),
    /// The patches, and where they meet.
    pub tiled: construction::Tiled,
}

impl Tiled {
    /// Whether every patch covers its polygon, and neighbours meet point for point.
    pub fn whole(&self) -> bool {
        self.tiled.faces.iter().all(|face| face.cover.is_ok())
            && self.tiled.seams.iter().all(|seam| seam.meets)
    }

    /// Whether the sphere is covered.
    pub fn verdict(&self) -> Verdict {
        if self.whole() { Verdict::Exact } else { Verdict::Undecided }
    }
}

/// An exact patch of this bidegree; `centre` is free where the patch has the symmetry of the square.
///
/// # Errors
/// [`NoAnswer`]: there is none, none was found, or nothing can be done.
pub fn construct(
    shape: Shape,
    bidegree: (u32, u32),
    centre: Option<&FieldElement>,
    control: &Control,
) -> Result<Constructed, NoAnswer> {
    match construction::construct(&shape.polygon, &shape.name, bidegree, centre, control) {
        Ok(made) => Ok(Constructed { shape, made }),
        Err(refusal) => Err(refused(&shape, bidegree, refusal)),
    }
}

/// The whole sphere, covered by images of the polygon.
///
/// # Errors
/// As [`construct`] has them, and where the polygon has no tiling.
pub fn construct_tiling(shape: Shape, bidegree: (u32, u32), control: &Control) -> Result<Tiled, NoAnswer> {
    let Some(named) = shape.named else {
        return Err(Failure::about(&shape.name, "only built-in polygons have a tiling").into());
    };
    match tile(named, bidegree, control) {
        Ok(tiled) => Ok(Tiled { shape, bidegree, tiled }),
        Err(refusal) => Err(refused(&shape, bidegree, refusal)),
    }
}

/// What it comes to that there is no patch.
pub(super) fn refused(shape: &Shape, bidegree: (u32, u32), refusal: Refusal) -> NoAnswer {
    let undecided = |undecided| Undecided { bidegree: Some(bidegree), ..undecided }.into();
    match refusal {
        Refusal::Impossible(cell) => NoAnswer::Nonexistent(Box::new(Nonexistent {
            name: shape.name.clone(),
            polygon: shape.polygon.clone(),
            bidegree,
            cell,
        })),
        Refusal::Interrupted(why) => undecided(Undecided::stopped(&shape.name, why)),
        Refusal::Limit(_) | Refusal::NoneFound => undecided(Undecided::new(&shape.name, refusal.to_string())),
        refusal => Failure::about(&shape.name, refusal).into(),
    }
}
