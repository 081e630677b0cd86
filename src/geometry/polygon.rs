//! Spherical polygons with three or four corners, their sides shorter arcs of great circles.

use itertools::Itertools;

use super::complex::Complex;
use super::cube_face::{Vector, dot};
use super::spinor::Spinor;
use crate::algebra::{FieldElement, MultiquadraticField, Sign, spell};

/// A spherical triangle or quadrilateral.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Polygon {
    /// In the order of the boundary, the interior to the left as seen from outside.
    corners: Vec<Vector>,
}

/// Why corners do not make a polygon. Corners are counted from 1.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs, reason = "the fields are what the message prints")]
pub enum PolygonError {
    /// Neither three nor four.
    #[error("{0} corners, expected 4, or 3 for a triangle")]
    Count(usize),
    /// A corner off the sphere.
    #[error("corner {corner} is not on the unit sphere: x² + y² + z² − 1 = {excess}, expected 0")]
    OffSphere { corner: usize, excess: String },
    /// The same point twice.
    #[error("corners {first} and {second} are the same point{hint}")]
    Repeated { first: usize, second: usize, hint: &'static str },
    /// Neighbours with no shorter arc between them.
    #[error("corners {first} and {second} are antipodal: no side between them is the shorter one")]
    Antipodal { first: usize, second: usize },
    /// Two sides cross.
    #[error(
        "the side from corner {first} to {} crosses the side from corner {second} to {}: give the corners in the order of the boundary",
        first % 4 + 1, second % 4 + 1
    )]
    Crossing { first: usize, second: usize },
}

impl Polygon {
    /// The polygon with these corners.
    ///
    /// # Errors
    /// [`PolygonError`]
    pub fn new(corners: Vec<Vector>) -> Result<Self, PolygonError> {
        let count = corners.len();
        if !(3..=4).contains(&count) {
            return Err(PolygonError::Count(count));
        }
        let one = corners[0][0].field().one();
        for (number, corner) in (1..).zip(&corners) {
            let excess = &dot(corner, corner) - &one;
            if !excess.is_zero() {
                return Err(PolygonError::OffSphere { corner: number, excess: spell(&excess) });
            }
        }
        for [(first, a), (second, b)] in (1..).zip(&corners).array_combinations() {
            if a == b {
                let neighbours = second - first == 1 || second - first == count - 1;
                let hint = if neighbours && count == 4 { "; for a triangle give three corners" } else { "" };
                return Err(PolygonError::Repeated { first, second, hint });
            }
        }
        for (first, (a, b)) in (1..).zip(corners.iter().circular_tuple_windows()) {
            if (&dot(a, b) + &one).is_zero() {
                return Err(PolygonError::Antipodal { first, second: first % count + 1 });
            }
        }
        if let [a, b, c, d] = &corners[..] {
            for (first, second, sides) in [(1, 3, [a, b, c, d]), (2, 4, [b, c, d, a])] {
                if cross(sides) {
                    return Err(PolygonError::Crossing { first, second });
                }
            }
        }
        Ok(Polygon { corners })
    }

    /// The corners.
    pub fn corners(&self) -> &[Vector] {
        &self.corners
    }

    /// K.
    pub fn field(&self) -> MultiquadraticField {
        self.corners[0][0].field()
    }

    /// Whether it is a triangle.
    pub fn is_triangle(&self) -> bool {
        self.corners.len() == 3
    }

    /// The determinants of three successive corners: for a convex polygon all have one sign.
    pub fn turns(&self) -> Vec<FieldElement> {
        self.corners.iter().circular_tuple_windows().map(|(a, b, c)| determinant(a, b, c)).collect()
    }

    /// Whether every corner turns to the left.
    pub fn is_convex(&self) -> bool {
        self.turns().iter().all(|turn| turn.sign() == Sign::Positive)
    }

    /// The same polygon seen from the other side.
    pub fn reversed(&self) -> Self {
        Polygon { corners: self.corners.iter().rev().cloned().collect() }
    }

    /// The same polygon, its corners counted from a later one.
    pub fn rotated(&self, by: usize) -> Self {
        let mut corners = self.corners.clone();
        corners.rotate_left(by);
        Polygon { corners }
    }

    /// Spinors of the corners.
    pub fn spinors(&self) -> Vec<Spinor> {
        self.corners.iter().map(Spinor::of).collect()
    }

    /// Z = ⟨s₁,s₂⟩⟨s₂,s₃⟩…, whose argument is half the solid angle, for any spinors of the corners.
    pub fn holonomy(&self) -> Complex {
        let spinors = self.spinors();
        let products = spinors.iter().circular_tuple_windows().map(|(p, q)| p.product(q));
        products.reduce(|z, next| z.times(&next)).expect("a polygon has corners")
    }
}

/// The triple product.
pub fn determinant(a: &Vector, b: &Vector, c: &Vector) -> FieldElement {
    let minor = |i: usize, j: usize| &(&b[i] * &c[j]) - &(&b[j] * &c[i]);
    dot(a, &[minor(1, 2), minor(2, 0), minor(0, 1)])
}

/// Whether the shorter arcs from a to b and from c to d have a point in common.
fn cross([a, b, c, d]: [&Vector; 4]) -> bool {
    let sides = [determinant(a, b, c), determinant(a, b, d), determinant(c, d, a), determinant(c, d, b)];
    let [c_side, d_side, a_side, b_side] = sides.each_ref().map(FieldElement::sign);
    if [c_side, d_side, a_side, b_side].iter().all(|side| *side == Sign::Zero) {
        // On one great circle: c or d between a and b, or a between c and d.
        let between = |p: &Vector, q: &Vector, x: &Vector| -> bool {
            // x = λp + μq with λ, μ ≥ 0; for unit vectors, by products with the dual basis.
            let (pq, px, qx) = (dot(p, q), dot(p, x), dot(q, x));
            let parts = [&px - &(&pq * &qx), &qx - &(&pq * &px)];
            parts.iter().all(|part| part.sign() != Sign::Negative)
        };
        return between(a, b, c) || between(a, b, d) || between(c, d, a);
    }
    let apart = |x: Sign, y: Sign| x == y && x != Sign::Zero;
    if apart(c_side, d_side) || apart(a_side, b_side) {
        return false;
    }
    // Where each arc meets the plane of the other: the same point, or its antipode?
    let [to_c, to_d, to_a, to_b] = sides.each_ref().map(absolute);
    let meet = |p: &Vector, q: &Vector, of_p: &FieldElement, of_q: &FieldElement| -> Vector {
        std::array::from_fn(|k| &(&p[k] * of_p) + &(&q[k] * of_q))
    };
    let (first, second) = (meet(a, b, &to_b, &to_a), meet(c, d, &to_d, &to_c));
    dot(&first, &second).sign() == Sign::Positive
}

fn absolute(value: &FieldElement) -> FieldElement {
    if value.sign() == Sign::Negative { -value } else { value.clone() }
}
