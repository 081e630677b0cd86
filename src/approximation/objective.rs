//! What is to be made small.

use super::extremes::Place;

/// What makes an approximation a good one. d is the deviation: r − 1 for the unit sphere, F/Wᵉ otherwise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Objective {
    /// The sum of (F/Wᵉ)² over a grid of points is smallest (the paper's Eq. 17, with F/W² = x² + y² + z² − R²).
    LeastSquares,
    /// The largest |d| is smallest.
    Minimax,
    /// d ≥ 0, and the largest d is smallest.
    Outer,
    /// d ≤ 0, and the largest −d is smallest.
    Inner,
    /// The largest d minus the smallest is smallest.
    Width,
}

/// How much worse it is to be on the wrong side by some amount than to be off by it.
pub(super) const PENALTY: f64 = 1000.0;

impl Objective {
    /// What is minimised, from the largest d and the largest −d.
    pub(super) fn merit(self, above: f64, below: f64) -> f64 {
        match self {
            Objective::LeastSquares | Objective::Minimax => above.max(below),
            Objective::Outer => above + PENALTY * below.max(0.0),
            Objective::Inner => below + PENALTY * above.max(0.0),
            Objective::Width => above + below,
        }
    }

    /// What is minimised, from the extremes.
    pub(super) fn of(self, extremes: &[Place]) -> f64 {
        let largest =
            |sign: f64| extremes.iter().map(|place| sign * place.value).fold(f64::NEG_INFINITY, f64::max);
        self.merit(largest(1.0), largest(-1.0))
    }
}
