//! Whether a patch is a surface, or shrinks to a curve or to a point.

use super::bernstein::binomial;
use crate::algebra::{FieldElement, Integer, MultiquadraticField};

/// What the image of a rational map from the plane to projective space is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Image {
    /// One point.
    Point,
    /// A curve.
    Curve,
    /// A surface: its normal vanishes on no open set.
    Surface,
}

/// The image of a patch of bidegree (m,n), the homogeneous control points row by row, not all of them 0.
///
/// Its dimension is one less than the rank of P, ∂P/∂u, ∂P/∂v at a general (u,v). The minors of size k have degrees at
/// most km and kn in u and v, so one that vanishes at all points of a grid of more rows and columns vanishes
/// identically: the rank is the largest one on a grid of 3m + 1 by 3n + 1 points. Exact.
pub fn image(field: MultiquadraticField, bidegree: (u32, u32), points: &[[FieldElement; 4]]) -> Image {
    let mut rank = 1;
    // From 2 on: the boundary of the square, at 0 and 1, is where patches degenerate.
    let bases = |degree: u32| (2..=3 * degree + 2).map(move |at| basis(field, degree, at));
    for of_u in bases(bidegree.0) {
        for of_v in bases(bidegree.1) {
            let combined = |of_u: &[FieldElement], of_v: &[FieldElement]| -> [FieldElement; 4] {
                let factors = of_u.iter().flat_map(|a| of_v.iter().map(move |b| a * b));
                let zero = std::array::from_fn(|_| field.zero());
                factors.zip(points).fold(zero, |sum: [FieldElement; 4], (factor, point)| {
                    std::array::from_fn(|k| &sum[k] + &(&factor * &point[k]))
                })
            };
            let vectors =
                [combined(&of_u.0, &of_v.0), combined(&of_u.1, &of_v.0), combined(&of_u.0, &of_v.1)];
            rank = rank.max(rank_of(vectors));
            if rank == 3 {
                return Image::Surface;
            }
        }
    }
    if rank == 2 { Image::Curve } else { Image::Point }
}

/// The Bernstein polynomials of a degree, and their derivatives, at an integer.
fn basis(field: MultiquadraticField, degree: u32, at: u32) -> (Vec<FieldElement>, Vec<FieldElement>) {
    let at = i64::from(at);
    let bernstein = |degree: u32| -> Vec<Integer> {
        let term = |i: u32| {
            let powers = &Integer::from(at).power(i) * &Integer::from(1 - at).power(degree - i);
            &binomial(degree, i) * &powers
        };
        (0..=degree).map(term).collect()
    };
    let values = bernstein(degree);
    // B′ᵢⁿ = n·(Bᵢ₋₁ⁿ⁻¹ − Bᵢⁿ⁻¹)
    let lower = degree.checked_sub(1).map(bernstein).unwrap_or_default();
    let zero = Integer::zero();
    let derivative = |i: usize| {
        let before = i.checked_sub(1).and_then(|k| lower.get(k)).unwrap_or(&zero);
        &(before - lower.get(i).unwrap_or(&zero)) * &Integer::from(degree)
    };
    let derivatives: Vec<Integer> = (0..values.len()).map(derivative).collect();
    let element = |value: Integer| field.rational(value, Integer::one());
    (values.into_iter().map(element).collect(), derivatives.into_iter().map(element).collect())
}

/// The rank of vectors: Gauss.
fn rank_of(vectors: [[FieldElement; 4]; 3]) -> usize {
    let mut rest = vectors.to_vec();
    let mut rank = 0;
    while let Some(pivot) = rest.pop() {
        let Some((column, inverse)) = (0..4).find_map(|k| Some((k, pivot[k].inverse()?))) else { continue };
        rank += 1;
        for vector in &mut rest {
            let factor = &vector[column] * &inverse;
            *vector = std::array::from_fn(|k| &vector[k] - &(&factor * &pivot[k]));
        }
    }
    rank
}
