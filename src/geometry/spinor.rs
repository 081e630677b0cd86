//! Spinors: patches that lie on the unit sphere by construction.
//!
//! For α, β with complex values, (X, Y, Z, W) = (2 Re ᾱβ, 2 Im ᾱβ, |α|² − |β|², |α|² + |β|²) lies on the sphere
//! X² + Y² + Z² = W²: the generalised stereographic projection (Dietz, Hoschek & Jüttler 1993,
//! doi:10.1016/0167-8396(93)90037-4).

use super::cube_face::{CubeFace, Vector};
use crate::algebra::{FieldElement, Integer, Polynomial};
use crate::bezier::{BernsteinForm, binomial};

/// re + i·im.
#[derive(Debug, Clone)]
struct Complex {
    re: FieldElement,
    im: FieldElement,
}

impl Complex {
    fn plus(&self, other: &Self) -> Self {
        Complex { re: &self.re + &other.re, im: &self.im + &other.im }
    }

    fn times(&self, other: &Self) -> Self {
        Complex {
            re: &(&self.re * &other.re) - &(&self.im * &other.im),
            im: &(&self.re * &other.im) + &(&self.im * &other.re),
        }
    }

    fn conjugate(&self) -> Self {
        Complex { re: self.re.clone(), im: -&self.im }
    }

    /// self/|self|, where the absolute value is in K.
    fn direction(&self) -> Option<Self> {
        let size = (&(&self.re * &self.re) + &(&self.im * &self.im)).square_root()?;
        let inverse = size.inverse()?;
        let inverse = match inverse.sign()? {
            crate::algebra::Sign::Negative => -&inverse,
            _ => inverse,
        };
        Some(Complex { re: &self.re * &inverse, im: &self.im * &inverse })
    }
}

/// (α, β).
type Spinor = [Complex; 2];

/// (1 + z, x + iy), which the projection takes to 2(1 + z)·(x, y, z, 1).
fn spinor([x, y, z]: &Vector) -> Spinor {
    let field = x.field();
    [Complex { re: &field.one() + z, im: field.zero() }, Complex { re: x.clone(), im: y.clone() }]
}

/// ⟨p, q⟩ = p₀q̄₀ + p₁q̄₁.
fn product(p: &Spinor, q: &Spinor) -> Complex {
    p[0].times(&q[0].conjugate()).plus(&p[1].times(&q[1].conjugate()))
}

fn scaled(factor: &Complex, p: &Spinor) -> Spinor {
    p.each_ref().map(|part| factor.times(part))
}

/// q times the phase for which ⟨p, q⟩ is positive: real combinations of p and q then run along a great circle.
fn aligned(p: &Spinor, q: &Spinor) -> Option<Spinor> {
    Some(scaled(&product(p, q).direction()?, q))
}

/// The homogeneous control points of a patch of bidegree (4,2) that covers the cap over the cube face exactly, 5 rows of 3,
/// all corners with weight 1. `None` where a root that is needed is not in the field.
///
/// Each edge is a real combination of two corner spinors that are in phase, so that it runs along a great circle. Carried around the
/// face, the phase comes back changed by half its solid angle. Along the edges v = 0 and v = 1 a linear complex factor makes
/// up for one half of that each, at the price of two more degrees in u.
pub fn exact_cap(face: &CubeFace) -> Option<Vec<Vec<[FieldElement; 4]>>> {
    let field = face.side.field();
    let corner = |i: usize, j: usize| spinor(&face.corners[i][j]);
    let start = corner(0, 0);
    let end = aligned(&start, &corner(0, 1))?;
    let start_far = aligned(&start, &corner(1, 0))?;
    let end_far = aligned(&end, &corner(1, 1))?;
    // ⟨start_far, end_far⟩ = |…|·e^(iθ); e^(iθ/2) is the direction of 1 + e^(iθ).
    let one = Complex { re: field.one(), im: field.zero() };
    let phase = product(&start_far, &end_far).direction()?;
    let half = one.plus(&phase).direction()?;
    // ((1−u) + u·f)·((1−u)·near + u·far), scaled Bernstein coefficients.
    let along_u = |factor: &Complex, near: &Spinor, far: &Spinor| -> [Spinor; 3] {
        let turned = scaled(factor, near);
        let middle = std::array::from_fn(|k| turned[k].plus(&far[k]));
        [near.clone(), middle, scaled(factor, far)]
    };
    let low = along_u(&half.conjugate(), &start, &start_far);
    let high = along_u(&half, &end, &end_far);
    let form = |part: &dyn Fn(&Spinor) -> FieldElement| {
        let rows = [&low, &high].map(|curve| curve.each_ref().map(part));
        // `from_bernstein` multiplies by binomials, which the middle row has already.
        let two = field.rational(Integer::one(), Integer::from(2i64));
        BernsteinForm::from_bernstein(field, (2, 1), |i, j| {
            let value = rows[j][i].clone();
            Polynomial::constant(if i == 1 { &value * &two } else { value })
        })
    };
    let parts = [
        form(&|s| s[0].re.clone()),
        form(&|s| s[0].im.clone()),
        form(&|s| s[1].re.clone()),
        form(&|s| s[1].im.clone()),
    ];
    let [a, b, c, d] = &parts;
    let constant = |value: i64| BernsteinForm::constant(field.integer(value));
    let sum = |terms: &[(i64, &BernsteinForm, &BernsteinForm)]| {
        let products = terms.iter().map(|(factor, p, q)| constant(*factor).multiply(p).multiply(q));
        products.reduce(|sum, next| sum.add(&next)).expect("a sum has terms")
    };
    let coordinates = [
        sum(&[(2, a, c), (2, b, d)]),
        sum(&[(2, a, d), (-2, b, c)]),
        sum(&[(1, a, a), (1, b, b), (-1, c, c), (-1, d, d)]),
        sum(&[(1, a, a), (1, b, b), (1, c, c), (1, d, d)]),
    ];
    let unit = coordinates[3].coefficient(0, 0).as_constant()?.inverse()?;
    let point = |i: u32, j: u32| -> Option<[FieldElement; 4]> {
        let scale = field.rational(Integer::one(), &binomial(4, i) * &binomial(2, j));
        let scale = &scale * &unit;
        let entry = |k: usize| Some(&coordinates[k].coefficient(i, j).as_constant()? * &scale);
        Some([entry(0)?, entry(1)?, entry(2)?, entry(3)?])
    };
    (0..=4).map(|i| (0..=2).map(|j| point(i, j)).collect()).collect()
}
