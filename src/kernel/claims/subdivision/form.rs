//! Homogeneous forms in pairs of variables, and their signs on boxes.
//!
//! A polynomial of degree D in ξ = x/y, on the interval with ends ξ₀ = x₀/y₀ and ξ₁ = x₁/y₁ (y₀, y₁ > 0), is found by putting
//! x = x₀p + x₁q, y = y₀p + y₁q. For p, q ≥ 0 the result, a form in p and q, is a sum of its coefficients with factors
//! that are not negative: if none of them is negative, the polynomial is nowhere negative on the interval. (They are Bernstein
//! coefficients, but for positive factors.) The same holds in several variables, one pair at a time.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::exact::{Limit, Monomial, Polynomial, Radicands, Stop, Work, limits, sign};

/// The ends of an interval in one variable, as coefficients of p and q: x = x\[0\]·p + x\[1\]·q, y likewise.
#[derive(Debug, Clone)]
pub(in crate::claims) struct Interval {
    pub(in crate::claims) x: [BigInt; 2],
    pub(in crate::claims) y: [BigInt; 2],
}

impl Interval {
    pub(in crate::claims) fn new(x: [i32; 2], y: [i32; 2]) -> Self {
        Interval { x: x.map(BigInt::from), y: y.map(BigInt::from) }
    }

    /// One point x/y as an interval: the form's first coefficient becomes its value there.
    pub(in crate::claims) fn point(x: BigInt, y: BigInt) -> Self {
        Interval { x: [x, BigInt::ZERO], y: [y, BigInt::ZERO] }
    }

    /// Both halves of an interval whose y has equal coefficients.
    pub(in crate::claims) fn halves(&self) -> [Interval; 2] {
        let (Interval { x: [a, b], y: [c, d] }, two) = (self, BigInt::from(2));
        let middle = (a + b, c + d);
        [
            Interval { x: [a * &two, middle.0.clone()], y: [c * &two, middle.1.clone()] },
            Interval { x: [middle.0, b * &two], y: [middle.1, d * &two] },
        ]
    }
}

/// Σ c[a] Π xᵢ^aᵢ yᵢ^(Dᵢ−aᵢ), but for a positive factor: each c an element of K by its integral coordinates.
#[derive(Debug, Clone)]
pub(in crate::claims) struct Form {
    /// Dᵢ.
    degrees: Vec<usize>,
    /// By exponents, the last one fastest; each a list by mask.
    coefficients: Vec<Vec<BigInt>>,
}

impl Form {
    /// From terms rational·√(mask)·Πxᵢ^aᵢ.
    pub(in crate::claims) fn new(
        field: &Radicands,
        degrees: Vec<usize>,
        terms: &[(Vec<usize>, u8, BigRational)],
        work: &mut Work,
    ) -> Result<Self, Stop> {
        let mut denominator = BigInt::one();
        for (_, _, value) in terms {
            work.charge_gcd(&denominator, value.denom())?;
            denominator = denominator.lcm(value.denom());
            if denominator.bits() > limits::BITS {
                return Err(Limit::digits().into());
            }
        }
        let size = degrees.iter().fold(1usize, |size, degree| size.saturating_mul(degree.saturating_add(1)));
        work.charge(count(size).saturating_mul(1000))?;
        let zero = vec![BigInt::ZERO; field.masks().count()];
        let mut form = Form { coefficients: vec![zero; size], degrees };
        for (exponents, mask, value) in terms {
            work.charge_product(&denominator, value.numer())?;
            let place = exponents.iter().zip(&form.degrees).fold(0usize, |place, (exponent, degree)| {
                place.saturating_mul(degree.saturating_add(1)).saturating_add(*exponent)
            });
            let coordinate =
                form.coefficients.get_mut(place).and_then(|value| value.get_mut(usize::from(*mask)));
            if let Some(coordinate) = coordinate {
                *coordinate += value.numer() * (&denominator / value.denom());
            }
        }
        Ok(form)
    }

    /// The form in p and q of the pair `axis` on an interval.
    pub(in crate::claims) fn on(
        &self,
        axis: usize,
        interval: &Interval,
        work: &mut Work,
    ) -> Result<Self, Stop> {
        let degree = self.degrees.get(axis).copied().unwrap_or(0);
        let stride = self.degrees.iter().skip(axis.saturating_add(1));
        let stride = stride.fold(1usize, |size, degree| size.saturating_mul(degree.saturating_add(1)));
        let factors = substitution(degree, interval);
        let mut result =
            Form { degrees: self.degrees.clone(), coefficients: vec![vec![]; self.coefficients.len()] };
        let length = degree.saturating_add(1);
        for (place, target) in (0usize..).zip(&mut result.coefficients) {
            // The line through `place` along the axis, and where on it the place is.
            let to = place.checked_div(stride).and_then(|line| line.checked_rem(length)).unwrap_or(0);
            let start = place.saturating_sub(to.saturating_mul(stride));
            let line = self.coefficients.iter().skip(start).step_by(stride.max(1)).take(length);
            let mut sum = vec![BigInt::ZERO; self.coefficients.first().map_or(0, Vec::len)];
            for (source, factors) in line.zip(&factors) {
                let Some(factor) = factors.get(to).filter(|factor| !factor.is_zero()) else {
                    continue;
                };
                for (coordinate, value) in sum.iter_mut().zip(source) {
                    work.charge(64)?;
                    work.charge_product(value, factor)?;
                    *coordinate += value * factor;
                }
            }
            // What is kept is charged for its length.
            let bits = sum.iter().fold(0u64, |bits, value| bits.saturating_add(value.bits()));
            work.charge(bits.saturating_mul(2).saturating_add(200))?;
            *target = sum;
        }
        Ok(result)
    }

    /// Whether all coefficients have an accepted sign.
    pub(in crate::claims) fn all(
        &self,
        signs: &Signs,
        accepted: &[Ordering],
        work: &mut Work,
    ) -> Result<bool, Stop> {
        if self.coefficients.is_empty() {
            return Err(Stop::Defect("a form without coefficients"));
        }
        for coefficient in &self.coefficients {
            if !accepted.contains(&signs.of(coefficient, work)?) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The sign of the first coefficient.
    pub(in crate::claims) fn first(&self, signs: &Signs, work: &mut Work) -> Result<Ordering, Stop> {
        let first = self.coefficients.first().ok_or(Stop::Defect("a form without coefficients"))?;
        signs.of(first, work)
    }
}

/// For each exponent a the coefficients, from q⁰ up, of (x₀p + x₁q)^a (y₀p + y₁q)^(D−a).
fn substitution(degree: usize, interval: &Interval) -> Vec<Vec<BigInt>> {
    let product = |factor: &[BigInt; 2], form: &[BigInt]| -> Vec<BigInt> {
        let [of_p, of_q] = factor;
        let kept = form.iter().map(|c| c * of_p).chain([BigInt::ZERO]);
        let moved = [BigInt::ZERO].into_iter().chain(form.iter().map(|c| c * of_q));
        kept.zip(moved).map(|(a, b)| a + b).collect()
    };
    let power = |exponent: usize| {
        let of_x = (0..exponent).fold(vec![BigInt::one()], |form, _| product(&interval.x, &form));
        (exponent..degree).fold(of_x, |form, _| product(&interval.y, &form))
    };
    (0..=degree).map(power).collect()
}

/// How signs of elements of K with integral coordinates are decided.
pub(in crate::claims) struct Signs {
    field: Radicands,
    /// ⌊√n·2ᵇ⌋ for each mask, for some b.
    roots: Vec<Vec<BigInt>>,
}

impl Signs {
    /// The bits b: nearly always the first suffice.
    const PRECISIONS: [u32; 3] = [128, 512, 2048];

    pub(in crate::claims) fn new(field: &Radicands) -> Self {
        let roots = |bits: u32| {
            let scale = (0..bits).fold(BigInt::one(), |scale, _| scale * BigInt::from(4));
            field.masks().map(|mask| (field.under_root(mask) * &scale).sqrt()).collect()
        };
        Signs { field: field.clone(), roots: Signs::PRECISIONS.map(roots).to_vec() }
    }

    /// Σ c·√n·2ᵇ differs from Σ c·⌊√n·2ᵇ⌋ by less than Σ|c| over the irrational √n. Where that leaves the sign
    /// open, it is found exactly.
    fn of(&self, coordinates: &[BigInt], work: &mut Work) -> Result<Ordering, Stop> {
        let error = coordinates.iter().skip(1).fold(BigInt::ZERO, |sum, value| sum + value.abs());
        for roots in &self.roots {
            let mut sum = BigInt::ZERO;
            for (value, root) in coordinates.iter().zip(roots) {
                work.charge_product(value, root)?;
                sum += value * root;
            }
            if sum.abs() > error || error.is_zero() {
                return Ok(sum.cmp(&BigInt::ZERO));
            }
        }
        let terms = (0u8..)
            .zip(coordinates)
            .map(|(mask, value)| (Monomial::radical(mask), BigRational::from_integer(value.clone())));
        let exact = sign(&Polynomial::from_terms(terms), &self.field, work)?;
        exact.ok_or(Stop::Defect("a coefficient of a form that is not constant"))
    }
}

fn count(length: usize) -> u64 {
    u64::try_from(length).unwrap_or(u64::MAX)
}
