//! The rules of claim `cover`: FORMAT.md, section 6, rule 6, in its order.
//!
//! W > 0; every edge runs in the plane of the great circle through its ends, and on the side of the middle of the
//! shorter arc; and det[P, P_u, P_v] = W³·det[p, p_u, p_v] for p = P/W has one sign on the closed square. Then the map
//! is an immersion, hence monotonous along each edge, so that the edges are the shorter arcs; the corners have angles
//! below π, so that the polygon is convex and simple; and an immersed disc whose boundary is run through once is
//! embedded (glue a disc to it: what results is a covering of the sphere, which has only one sheet). Where one edge is
//! a point, the determinant is divided by the distance from that edge.

use super::ends::{End, at, derivative, without_factor};
use super::vectors::{Algebra, Vector};
use super::{Cover, Covered, EDGES, EdgeTree, Rejection};
use crate::claims::exact::{self, evaluated};
use crate::claims::subdivision::{self, POSITIVE, Quantity, UnitSquare, subject};
use crate::equations::{S, T, expand};
use crate::exact::{Polynomial, Work};
use crate::failure::{At, Failure, Place};
use crate::statement::{Patch, Statement};

/// The name of an edge, what is fixed along it, and its ends.
type Edge = (&'static str, End, [End; 2]);

/// Tries the values, and follows the subdivisions.
pub(in crate::claims) fn verify(
    statement: &Statement,
    cover: &Cover,
    work: &mut Work,
) -> Result<Covered, Failure<Rejection>> {
    exact::verify(statement, &cover.values, work).map_err(|error| error.map(Rejection::from))?;
    let (patch, field) = (subject(statement, Quantity::Radius).map_err(Rejection::from)?, statement.field());
    let net = evaluated(patch, &cover.values, statement, work).at(Place::Values)?;
    let expanded = expand(field, &Patch { net, ..patch.clone() }, work).at(Place::Values)?;
    let Ok(position) = Vector::try_from(expanded.position) else {
        return Err(Failure::Defect("a position without three coordinates"));
    };
    let (square, algebra) = (UnitSquare::new(field), Algebra { field });
    let map = Map { position, weight: expanded.weight, degrees: patch.bidegree, square, algebra };

    let denominator = map.denominator(cover, work)?;
    let (edges, point) = map.edges(cover, work)?;
    let regular = map.regular(cover, point, work)?;
    let corners = map.corners(work)?;
    let boxes = denominator.saturating_add(edges).saturating_add(regular);
    let (values, inward) = (cover.values.clone(), cover.inward);
    Ok(Covered { values, corners, inward, point: point.map(|(name, ..)| name), boxes })
}

/// P = (X, Y, Z) and W, in t and s.
struct Map<'a> {
    position: Vector,
    weight: Polynomial,
    degrees: (u32, u32),
    square: UnitSquare<'a>,
    algebra: Algebra<'a>,
}

impl Map<'_> {
    /// The ends of u and of v.
    fn ends(&self) -> [[End; 2]; 2] {
        let ends = |variable, degree| [0, degree].map(|exponent| End { variable, exponent });
        [ends(T, self.degrees.0), ends(S, self.degrees.1)]
    }

    /// The coefficients of W are positive.
    fn denominator(&self, cover: &Cover, work: &mut Work) -> Result<usize, Failure<Rejection>> {
        let degrees = [self.degrees.0, self.degrees.1];
        let weight = self.square.form(&self.weight, degrees, work).at(Place::Values)?;
        self.follow("denominator", weight, &cover.denominator, work)
    }

    /// Every edge is an arc or a point, one at most a point; which one.
    fn edges(&self, cover: &Cover, work: &mut Work) -> Result<(usize, Option<Edge>), Failure<Rejection>> {
        let [u, v] = self.ends();
        let ([u0, u1], [v0, v1]) = (u, v);
        let (mut boxes, mut point) = (0usize, None);
        let places = [(u0, v), (u1, v), (v0, u), (v1, u)];
        for ((name, edge), (fixed, ends)) in EDGES.into_iter().zip(&cover.edges).zip(places) {
            let place = (name, fixed, ends);
            match edge {
                EdgeTree::Arc(tree) => boxes = boxes.saturating_add(self.arc(place, tree, work)?),
                EdgeTree::Point => {
                    self.point(place, work)?;
                    if point.replace(place).is_some() {
                        return Err(Rejection::Points { edge: name }.into());
                    }
                }
            }
        }
        Ok((boxes, point))
    }

    /// A × B ≠ 0, (A × B)·P ≡ 0, and the coefficients of (bA + aB)·P are positive.
    fn arc(
        &self,
        (name, fixed, ends): Edge,
        tree: &subdivision::Tree,
        work: &mut Work,
    ) -> Result<usize, Failure<Rejection>> {
        let values = Place::Values;
        let curve = self.position.each_ref().map(|x| at(x, fixed));
        let [start, end] = ends.map(|end| curve.each_ref().map(|x| at(x, end)));
        let [at_start, at_end] = ends.map(|end| at(&at(&self.weight, fixed), end));
        let normal = self.algebra.cross(&start, &end, work).at(values)?;
        let height = self.algebra.dot(&normal, &curve, work).at(values)?;
        if normal.iter().all(Polynomial::is_zero) || !height.is_zero() {
            return Err(Rejection::Edge { edge: name, expected: "an arc of a great circle" }.into());
        }
        let of_start = self.algebra.scaled(&start, &at_end, work).at(values)?;
        let of_end = self.algebra.scaled(&end, &at_start, work).at(values)?;
        let middle = self.algebra.sum(&of_start, &of_end, work).at(values)?;
        let side = self.algebra.dot(&middle, &curve, work).at(values)?;
        let degrees = if fixed.variable == T { [0, self.degrees.1] } else { [self.degrees.0, 0] };
        let side = self.square.form(&side, degrees, work).at(values)?;
        self.follow(name, side, tree, work)
    }

    /// P × A ≡ 0: the direction is that of the start throughout.
    fn point(&self, (name, fixed, [start, _]): Edge, work: &mut Work) -> Result<(), Failure<Rejection>> {
        let curve = self.position.each_ref().map(|x| at(x, fixed));
        let start = curve.each_ref().map(|x| at(x, start));
        let turned = self.algebra.cross(&curve, &start, work).at(Place::Values)?;
        match turned.iter().all(Polynomial::is_zero) {
            true => Ok(()),
            false => Err(Rejection::Edge { edge: name, expected: "a point" }.into()),
        }
    }

    /// The coefficients of det[P, ∂P/∂u, ∂P/∂v] have one sign, divided by the distance from an edge that is a point.
    fn regular(
        &self,
        cover: &Cover,
        point: Option<Edge>,
        work: &mut Work,
    ) -> Result<usize, Failure<Rejection>> {
        let values = Place::Values;
        let [along_u, along_v] =
            [T, S].map(|variable| self.position.each_ref().map(|x| derivative(x, variable)));
        let normal = self.algebra.cross(&along_u, &along_v, work).at(values)?;
        let mut determinant = self.algebra.dot(&self.position, &normal, work).at(values)?;
        if cover.inward {
            determinant = determinant.negate();
        }
        let mut degrees =
            [self.degrees.0, self.degrees.1].map(|degree| degree.saturating_mul(3).saturating_sub(2));
        if let Some((name, end, _)) = point {
            let [of_u, of_v] = &mut degrees;
            let degree = if end.variable == T { of_u } else { of_v };
            determinant = without_factor(&determinant, end, degree)
                .ok_or(Rejection::Edge { edge: name, expected: "a point" })?;
        }
        let regular = self.square.form(&determinant, degrees, work).at(values)?;
        self.follow("regular", regular, &cover.regular, work)
    }

    /// The points at (u, v) = (0,0), (1,0), (1,1), (0,1).
    fn corners(&self, work: &mut Work) -> Result<Vec<Vector>, Failure<Rejection>> {
        let [[u0, u1], [v0, v1]] = self.ends();
        let mut corners = Vec::with_capacity(4);
        for (u, v) in [(u0, v0), (u1, v0), (u1, v1), (u0, v1)] {
            let weight = at(&at(&self.weight, u), v).inverse(self.algebra.field, work).at(Place::Values)?;
            let weight = weight.ok_or(Rejection::Exact(exact::Rejection::NoDenominator))?;
            let corner = self.position.each_ref().map(|x| at(&at(x, u), v));
            corners.push(self.algebra.scaled(&corner, &weight, work).at(Place::Values)?);
        }
        Ok(corners)
    }

    fn follow(
        &self,
        name: &'static str,
        form: subdivision::Form,
        tree: &subdivision::Tree,
        work: &mut Work,
    ) -> Result<usize, Failure<Rejection>> {
        let followed = self.square.subdivide(name, form, tree, POSITIVE, work);
        followed.map_err(|error| error.map(Rejection::from))
    }
}
