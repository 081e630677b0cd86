//! Spinors: patches that lie on the unit sphere by construction.
//!
//! For α, β with complex values, (X, Y, Z, W) = (2 Re ᾱβ, 2 Im ᾱβ, |α|² − |β|², |α|² + |β|²) lies on the sphere
//! X² + Y² + Z² = W²: the generalised stereographic projection (Dietz, Hoschek & Jüttler 1993,
//! doi:10.1016/0167-8396(93)90037-4).

use itertools::iproduct;

use super::complex::Complex;
use super::cube_face::Vector;
use crate::algebra::{FieldElement, Integer};
use crate::bezier::binomial;

/// (X, Y, Z, W).
pub type Point = [FieldElement; 4];

/// (α, β).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Spinor(pub [Complex; 2]);

impl Spinor {
    /// A spinor of a point of the unit sphere: (1 + z, x + iy), which the projection takes to 2(1 + z)·(x, y, z, 1), or
    /// for the half z < 0 in the same way (x − iy, 1 − z).
    pub fn of([x, y, z]: &Vector) -> Self {
        let one = x.field().one();
        let south = z.sign() == crate::algebra::Sign::Negative;
        match south {
            false => Spinor([Complex::real(&one + z), Complex { re: x.clone(), im: y.clone() }]),
            true => Spinor([Complex { re: x.clone(), im: -y }, Complex::real(&one - z)]),
        }
    }

    /// ⟨p, q⟩ = p̄₀q₀ + p̄₁q₁.
    pub fn product(&self, other: &Self) -> Complex {
        let Spinor([a, b]) = self;
        let Spinor([c, d]) = other;
        a.conjugate().times(c).plus(&b.conjugate().times(d))
    }

    /// |α|² + |β|².
    pub fn norm(&self) -> FieldElement {
        &self.0[0].norm() + &self.0[1].norm()
    }

    /// The multiple.
    pub fn scaled(&self, factor: &Complex) -> Self {
        Spinor(self.0.each_ref().map(|part| factor.times(part)))
    }

    /// The sum.
    pub fn plus(&self, other: &Self) -> Self {
        Spinor(std::array::from_fn(|k| self.0[k].plus(&other.0[k])))
    }

    /// The symmetric bilinear form whose quadratic form is the projection.
    fn polar(&self, other: &Self) -> Point {
        let Spinor([a, b]) = self;
        let Spinor([c, d]) = other;
        let cross = a.conjugate().times(d).plus(&c.conjugate().times(b));
        let of = |p: &Complex, q: &Complex| &(&p.re * &q.re) + &(&p.im * &q.im);
        let (first, second) = (of(a, c), of(b, d));
        [cross.re, cross.im, &first - &second, &first + &second]
    }
}

/// A spinor that depends on u and v: Bernstein coefficients, p + 1 rows of q + 1.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SpinorForm(pub Vec<Vec<Spinor>>);

impl SpinorForm {
    /// The patch of bidegree (2p, 2q) that is its image.
    pub fn image(&self) -> Vec<Vec<Point>> {
        let (p, q) = (self.0.len() - 1, self.0[0].len() - 1);
        let field = self.0[0][0].0[0].re.field();
        let choose = |n: usize, k: usize| binomial(n as u32, k as u32);
        let mut net = vec![vec![std::array::from_fn(|_| field.zero()); 2 * q + 1]; 2 * p + 1];
        for ((i, j), (k, l)) in iproduct!(iproduct!(0..=p, 0..=q), iproduct!(0..=p, 0..=q)) {
            let above = &(&choose(p, i) * &choose(p, k)) * &(&choose(q, j) * &choose(q, l));
            let below: Integer = &choose(2 * p, i + k) * &choose(2 * q, j + l);
            let share = field.rational(above, below);
            let term = self.0[i][j].polar(&self.0[k][l]);
            let sum: &mut Point = &mut net[i + k][j + l];
            for (coordinate, value) in sum.iter_mut().zip(&term) {
                *coordinate = &*coordinate + &(&share * value);
            }
        }
        net
    }
}
