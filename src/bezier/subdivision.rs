//! The sign of a polynomial on the unit square, decided by subdivision.

use std::collections::VecDeque;

use crate::algebra::{FieldElement, Integer, MultiquadraticField, Polynomial, Sign};

use super::bernstein::{BernsteinForm, binomial};

/// How a polynomial without unknowns behaves on the unit square.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SignOnSquare {
    /// Nowhere positive: in each of so many boxes no Bernstein coefficient is positive.
    NowherePositive {
        /// How many boxes.
        boxes: usize,
    },
    /// Positive at this point (u, v).
    PositiveAt(FieldElement, FieldElement),
    /// Not decided within the boxes allowed.
    Undecided,
}

/// A box of the square: its lower corner and the polynomial's Bernstein coefficients on it, row by row.
struct Part {
    corner: (FieldElement, FieldElement),
    depth: (u32, u32),
    coefficients: Vec<FieldElement>,
}

/// Decides whether a form with constant coefficients is positive anywhere on the square.
///
/// A polynomial lies in the convex hull of its Bernstein coefficients, and those of the halves of a box, computed by
/// de Casteljau's algorithm, come as near to its values as one likes (Farin, Curves and Surfaces for CAGD, section 5.3;
/// Farouki 2012, doi:10.1016/j.cagd.2012.03.001, section 5). `None` where a sign cannot be decided within the limits.
pub fn sign_on_square(form: &BernsteinForm, at_most: usize) -> Option<SignOnSquare> {
    let (m, n) = form.bidegree();
    let field = form.field();
    let unscaled = form.coefficients().map(|(r, s, value)| {
        let scale = field.rational(Integer::one(), &binomial(m, r) * &binomial(n, s));
        value.as_constant().map(|value| &value * &scale)
    });
    let coefficients: Vec<FieldElement> = unscaled.collect::<Option<_>>()?;
    let mut queue =
        VecDeque::from([Part { corner: (field.zero(), field.zero()), depth: (0, 0), coefficients }]);
    let mut boxes = 0;
    while let Some(part) = queue.pop_front() {
        boxes += 1;
        if boxes > at_most {
            return Some(SignOnSquare::Undecided);
        }
        let positive: Vec<bool> =
            part.coefficients.iter().map(|c| Some(c.sign()? == Sign::Positive)).collect::<Option<_>>()?;
        if !positive.contains(&true) {
            continue;
        }
        // The coefficients at the corners are values.
        let size = |depth: u32| field.rational(Integer::one(), Integer::from(1i64 << depth));
        for (i, j) in [(0, 0), (0, n), (m, 0), (m, n)] {
            if positive[(i * (n + 1) + j) as usize] {
                let at = |corner: &FieldElement, end: bool, depth: u32| {
                    if end { corner + &size(depth) } else { corner.clone() }
                };
                let u = at(&part.corner.0, i > 0, part.depth.0);
                return Some(SignOnSquare::PositiveAt(u, at(&part.corner.1, j > 0, part.depth.1)));
            }
        }
        if part.depth.0.max(part.depth.1) >= 60 {
            return Some(SignOnSquare::Undecided);
        }
        queue.extend(halves(field, &part, (m, n)));
    }
    Some(SignOnSquare::NowherePositive { boxes })
}

/// The two halves of a box, cut across its longer side.
fn halves(field: MultiquadraticField, part: &Part, (m, n): (u32, u32)) -> [Part; 2] {
    let along_u = part.depth.0 <= part.depth.1;
    let (lines, length, stride, step) = match along_u {
        true => (n + 1, m + 1, 1, n + 1),
        false => (m + 1, n + 1, n + 1, 1),
    };
    let mut low = part.coefficients.clone();
    let mut high = part.coefficients.clone();
    let half = field.rational(Integer::one(), Integer::from(2i64));
    for line in 0..lines {
        let index = |k: u32| (line * stride + k * step) as usize;
        let mut row: Vec<FieldElement> = (0..length).map(|k| part.coefficients[index(k)].clone()).collect();
        for k in 0..length {
            low[index(k)] = row[0].clone();
            high[index(length - 1 - k)] = row[row.len() - 1].clone();
            row = row.windows(2).map(|pair| &(&pair[0] + &pair[1]) * &half).collect();
        }
    }
    let (u, v) = part.corner.clone();
    let depth = if along_u { (part.depth.0 + 1, part.depth.1) } else { (part.depth.0, part.depth.1 + 1) };
    let shift = |depth: u32| field.rational(Integer::one(), Integer::from(1i64 << depth));
    let middle = if along_u { (&u + &shift(depth.0), v.clone()) } else { (u.clone(), &v + &shift(depth.1)) };
    [Part { corner: (u, v), depth, coefficients: low }, Part { corner: middle, depth, coefficients: high }]
}

/// The value of a form with constant coefficients at a point.
pub fn value_at(form: &BernsteinForm, u: &FieldElement, v: &FieldElement) -> Option<FieldElement> {
    let (m, n) = form.bidegree();
    let field = form.field();
    let powers = |x: &FieldElement, degree: u32| -> Vec<FieldElement> {
        let complement = &field.one() - x;
        let power = |base: &FieldElement, exponent: u32| {
            (0..exponent).fold(field.one(), |product, _| &product * base)
        };
        (0..=degree).map(|r| &power(x, r) * &power(&complement, degree - r)).collect()
    };
    let (of_u, of_v) = (powers(u, m), powers(v, n));
    let mut sum = field.zero();
    for (r, s, value) in form.coefficients() {
        let basis = &of_u[r as usize] * &of_v[s as usize];
        sum = &sum + &(&Polynomial::as_constant(value)? * &basis);
    }
    Some(sum)
}
