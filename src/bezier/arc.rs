//! Rational Bézier curves in homogeneous form.

use crate::algebra::{FieldElement, Integer};

/// A rational Bézier curve of degree n with n + 1 homogeneous control points (X, Y, Z, W).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RationalArc {
    /// The control points, from u = 0 to u = 1; never empty.
    pub points: Vec<[FieldElement; 4]>,
}

impl RationalArc {
    /// n.
    pub fn degree(&self) -> u32 {
        self.points.len() as u32 - 1
    }

    /// The same curve with one more control point: Qᵢ = i/(n+1)·Pᵢ₋₁ + (1 − i/(n+1))·Pᵢ
    /// (Farin, Curves and Surfaces for CAGD, section 6.1, applied to homogeneous points).
    pub fn elevated(&self) -> Self {
        let n = self.degree();
        let field = self.points[0][0].field();
        let blend = |i: u32| {
            let share = field.rational(Integer::from(i), Integer::from(n + 1));
            let rest = &field.one() - &share;
            let before = &self.points[i.saturating_sub(1) as usize];
            let at = &self.points[i.min(n) as usize];
            std::array::from_fn(|k| &(&share * &before[k]) + &(&rest * &at[k]))
        };
        RationalArc { points: (0..=n + 1).map(blend).collect() }
    }

    /// The same curve with degree `degree`, which is not below its own.
    pub fn elevated_to(&self, degree: u32) -> Self {
        (self.degree()..degree).fold(self.clone(), |curve, _| curve.elevated())
    }
}
