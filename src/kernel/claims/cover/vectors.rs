//! Vectors of polynomials, every operation charged.

use crate::exact::{Limit, Polynomial, Radicands, Work};

/// X, Y, Z.
pub(super) type Vector = [Polynomial; 3];

/// The operations, over a field.
pub(super) struct Algebra<'a> {
    pub(super) field: &'a Radicands,
}

impl Algebra<'_> {
    pub(super) fn dot(&self, a: &Vector, b: &Vector, work: &mut Work) -> Result<Polynomial, Limit> {
        let mut products = Vec::with_capacity(3);
        for (x, y) in a.iter().zip(b) {
            products.push(x.multiply(y, self.field, work)?);
        }
        Polynomial::sum(&products, self.field, work)
    }

    pub(super) fn cross(
        &self,
        [a, b, c]: &Vector,
        [x, y, z]: &Vector,
        work: &mut Work,
    ) -> Result<Vector, Limit> {
        let mut minor = |p: &Polynomial, q: &Polynomial, r: &Polynomial, s: &Polynomial| {
            let products = [p.multiply(s, self.field, work)?, q.multiply(r, self.field, work)?.negate()];
            Polynomial::sum(&products, self.field, work)
        };
        Ok([minor(b, c, y, z)?, minor(c, a, z, x)?, minor(a, b, x, y)?])
    }

    pub(super) fn scaled(&self, a: &Vector, factor: &Polynomial, work: &mut Work) -> Result<Vector, Limit> {
        let [x, y, z] = a;
        let mut times = |p: &Polynomial| p.multiply(factor, self.field, work);
        Ok([times(x)?, times(y)?, times(z)?])
    }

    pub(super) fn sum(
        &self,
        [a, b, c]: &Vector,
        [x, y, z]: &Vector,
        work: &mut Work,
    ) -> Result<Vector, Limit> {
        let mut plus =
            |p: &Polynomial, q: &Polynomial| Polynomial::sum(&[p.clone(), q.clone()], self.field, work);
        Ok([plus(a, x)?, plus(b, y)?, plus(c, z)?])
    }
}
