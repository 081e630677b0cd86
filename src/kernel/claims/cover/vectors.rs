//! Vectors of polynomials.

use crate::exact::{Arithmetic, Limit, Polynomial};

/// X, Y, Z.
pub(super) type Vector = [Polynomial; 3];

/// Each coordinate changed.
pub(super) fn each(
    [x, y, z]: &Vector,
    mut change: impl FnMut(&Polynomial) -> Result<Polynomial, Limit>,
) -> Result<Vector, Limit> {
    Ok([change(x)?, change(y)?, change(z)?])
}

impl Arithmetic<'_> {
    /// a·b.
    pub(super) fn scalar_product(
        &mut self,
        [a, b, c]: &Vector,
        [x, y, z]: &Vector,
    ) -> Result<Polynomial, Limit> {
        self.dot(&[(a, x), (b, y), (c, z)])
    }

    /// a × b.
    pub(super) fn cross_product(&mut self, [a, b, c]: &Vector, [x, y, z]: &Vector) -> Result<Vector, Limit> {
        let [minus_a, minus_b, minus_c] = [self.negated(a)?, self.negated(b)?, self.negated(c)?];
        Ok([
            self.dot(&[(b, z), (&minus_c, y)])?,
            self.dot(&[(c, x), (&minus_a, z)])?,
            self.dot(&[(a, y), (&minus_b, x)])?,
        ])
    }

    /// factor·a.
    pub(super) fn scaled(&mut self, a: &Vector, factor: &Polynomial) -> Result<Vector, Limit> {
        each(a, |x| self.product(x, factor))
    }

    /// factor·a + other·b.
    pub(super) fn combined(
        &mut self,
        ([a, b, c], factor): (&Vector, &Polynomial),
        ([x, y, z], other): (&Vector, &Polynomial),
    ) -> Result<Vector, Limit> {
        Ok([
            self.dot(&[(factor, a), (other, x)])?,
            self.dot(&[(factor, b), (other, y)])?,
            self.dot(&[(factor, c), (other, z)])?,
        ])
    }
}
