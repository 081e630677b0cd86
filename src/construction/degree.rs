//! Which bidegrees are exact, and why.

use crate::algebra::{FieldElement, Sign};
use crate::geometry::{Complex, Polygon};

/// What becomes of a spinor that is carried around a polygon: Z, which is |Z|·e^(iΩ/2) up to its direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// Z > 0: it comes back as it was. Only for polygons whose solid angle is a multiple of 4π.
    None,
    /// Z < 0: it comes back reversed; the solid angle is 2π.
    Reversed,
    /// Z is not real.
    Open,
    /// A triangle: the edge that is a point takes up any phase.
    Absorbed,
}

impl Phase {
    /// The phase of a polygon.
    pub fn of(polygon: &Polygon) -> Self {
        let Complex { re, im } = polygon.holonomy();
        match (polygon.is_triangle(), im.is_zero(), re.sign()) {
            (true, ..) => Phase::Absorbed,
            (_, false, _) => Phase::Open,
            (_, true, Sign::Positive) => Phase::None,
            _ => Phase::Reversed,
        }
    }
}

/// The four triple products whose sum is, up to a positive factor, the imaginary part of Z: of corners 1 2 3, 2 3 4, 3 4 1, 4 1 2.
pub fn triple_products(polygon: &Polygon) -> (Vec<FieldElement>, FieldElement) {
    let turns = polygon.turns();
    let sum = turns.iter().fold(polygon.field().zero(), |sum, turn| &sum + turn);
    (turns, sum)
}

/// Whether patches of a bidegree cover a polygon exactly.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cell {
    /// No: where a degree is 1 or less, the patch does not depend on that parameter.
    NoSurface,
    /// No: the phase does not close.
    NoClosure,
    /// With all edges in their great circles, but one of them, or three, the longer way round.
    LongerWay,
    /// Yes, from the patch of this bidegree by raising degrees.
    Exact((u32, u32)),
}

/// The answer for one bidegree.
pub fn classify(phase: Phase, (m, n): (u32, u32)) -> Cell {
    let carries = if m >= 4 {
        Some((4, 2))
    } else if n >= 4 {
        Some((2, 4))
    } else {
        None
    };
    match (m.min(n) >= 2, phase, carries) {
        (false, ..) => Cell::NoSurface,
        (true, Phase::None | Phase::Absorbed, _) => Cell::Exact((2, 2)),
        (true, _, Some(base)) => Cell::Exact(base),
        (true, Phase::Reversed, None) => Cell::LongerWay,
        (true, Phase::Open, None) => Cell::NoClosure,
    }
}
