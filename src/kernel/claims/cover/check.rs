//! The rules of claim `cover`: FORMAT.md, section 6, rule 6, in its order.
//!
//! W > 0; every edge runs in the plane of the great circle through its ends, and on the side of the middle of the
//! shorter arc; and det[P, P_u, P_v] = W³·det[p, p_u, p_v] for p = P/W has one sign on the closed square. Then the map
//! is an immersion, hence monotonous along each edge, so that the edges are the shorter arcs; the corners have angles
//! below π, so that the polygon is convex and simple; and an immersed disc whose boundary is run through once is
//! embedded (glue a disc to it: what results is a covering of the sphere, which has only one sheet). Where one edge is
//! a point, the determinant is divided by the distance from that edge.

use super::ends::{End, at, derivative, without_factor};
use super::vectors::{Vector, each};
use super::{Cover, Covered, EDGES, EdgeTree, Rejection};
use crate::claims::exact::{self, copies, evaluated};
use crate::claims::subdivision::{self, POSITIVE, Quantity, UnitSquare, subject};
use crate::equations::{S, T, expand};
use crate::exact::{Arithmetic, Limit, Polynomial, Ring, Work};
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
    let patch = subject(statement, Quantity::Radius).map_err(Rejection::from)?;
    let values = Place::Values;
    let mut arithmetic = Arithmetic::new(statement.field(), work);
    let net = evaluated(patch, &cover.values, &mut arithmetic).at(values)?;
    let surface = arithmetic.copied(&patch.surface).at(values)?;
    let patch = Patch { net, surface, bidegree: patch.bidegree };
    let expanded = expand(&patch, &mut arithmetic).at(values)?;
    let Ok(position) = Vector::try_from(expanded.position) else {
        return Err(Failure::Defect("a position without three coordinates"));
    };
    let square = UnitSquare::new(statement.field(), arithmetic.work).at(values)?;
    let mut map = Map { position, weight: expanded.weight, degrees: patch.bidegree, square, arithmetic };

    let denominator = map.denominator(cover)?;
    let (edges, point) = map.edges(cover)?;
    let regular = map.regular(cover, point)?;
    let corners = map.corners().at(values)?.ok_or(Rejection::Exact(exact::Rejection::NoDenominator))?;
    let boxes = denominator.saturating_add(edges).saturating_add(regular);
    let values = copies(&cover.values, &mut map.arithmetic).at(values)?;
    let (inward, point) = (cover.inward, point.map(|(name, ..)| name));
    Ok(Covered { values, corners, inward, point, boxes })
}

/// P = (X, Y, Z) and W, in t and s.
struct Map<'a> {
    position: Vector,
    weight: Polynomial,
    degrees: (u32, u32),
    square: UnitSquare<'a>,
    arithmetic: Arithmetic<'a>,
}

impl Map<'_> {
    /// The ends of u and of v.
    fn ends(&self) -> [[End; 2]; 2] {
        let ends = |variable, degree| [0, degree].map(|exponent| End { variable, exponent });
        [ends(T, self.degrees.0), ends(S, self.degrees.1)]
    }

    /// The coefficients of W are positive.
    fn denominator(&mut self, cover: &Cover) -> Result<usize, Failure<Rejection>> {
        let degrees = [self.degrees.0, self.degrees.1];
        let weight = self.square.form(&self.weight, degrees, self.arithmetic.work).at(Place::Values)?;
        self.follow("denominator", weight, &cover.denominator)
    }

    /// Every edge is an arc or a point, one at most a point; which one.
    fn edges(&mut self, cover: &Cover) -> Result<(usize, Option<Edge>), Failure<Rejection>> {
        let [u, v] = self.ends();
        let ([u0, u1], [v0, v1]) = (u, v);
        let (mut boxes, mut point) = (0usize, None);
        let places = [(u0, v), (u1, v), (v0, u), (v1, u)];
        for ((name, edge), (fixed, ends)) in EDGES.into_iter().zip(&cover.edges).zip(places) {
            let place = (name, fixed, ends);
            match edge {
                EdgeTree::Arc(tree) => boxes = boxes.saturating_add(self.arc(place, tree)?),
                EdgeTree::Point => {
                    if !self.is_point(place).at(Place::Values)? {
                        return Err(Rejection::Edge { edge: name, expected: "a point" }.into());
                    }
                    if point.replace(place).is_some() {
                        return Err(Rejection::Points { edge: name }.into());
                    }
                }
            }
        }
        Ok((boxes, point))
    }

    /// A × B ≠ 0, (A × B)·P ≡ 0, and the coefficients of (bA + aB)·P are positive.
    fn arc(&mut self, edge: Edge, tree: &subdivision::Tree) -> Result<usize, Failure<Rejection>> {
        let (name, fixed, _) = edge;
        let Some(side) = self.side(edge).at(Place::Values)? else {
            return Err(Rejection::Edge { edge: name, expected: "an arc of a great circle" }.into());
        };
        let degrees = if fixed.variable == T { [0, self.degrees.1] } else { [self.degrees.0, 0] };
        let side = self.square.form(&side, degrees, self.arithmetic.work).at(Place::Values)?;
        self.follow(name, side, tree)
    }

    /// (bA + aB)·P, where A × B ≠ 0 and (A × B)·P ≡ 0.
    fn side(&mut self, (_, fixed, ends): Edge) -> Result<Option<Polynomial>, Limit> {
        let arithmetic = &mut self.arithmetic;
        let curve = each(&self.position, |x| at(x, fixed, arithmetic))?;
        let weight = at(&self.weight, fixed, arithmetic)?;
        let [start, end] = ends;
        let (of_start, of_end) =
            (each(&curve, |x| at(x, start, arithmetic))?, each(&curve, |x| at(x, end, arithmetic))?);
        let (at_start, at_end) = (at(&weight, start, arithmetic)?, at(&weight, end, arithmetic)?);
        let normal = arithmetic.cross_product(&of_start, &of_end)?;
        let height = arithmetic.scalar_product(&normal, &curve)?;
        if normal.iter().all(Polynomial::is_zero) || !height.is_zero() {
            return Ok(None);
        }
        let middle = arithmetic.combined((&of_start, &at_end), (&of_end, &at_start))?;
        arithmetic.scalar_product(&middle, &curve).map(Some)
    }

    /// P × A ≡ 0: the direction is that of the start throughout.
    fn is_point(&mut self, (_, fixed, [start, _]): Edge) -> Result<bool, Limit> {
        let arithmetic = &mut self.arithmetic;
        let curve = each(&self.position, |x| at(x, fixed, arithmetic))?;
        let start = each(&curve, |x| at(x, start, arithmetic))?;
        let turned = arithmetic.cross_product(&curve, &start)?;
        Ok(turned.iter().all(Polynomial::is_zero))
    }

    /// The coefficients of det[P, ∂P/∂u, ∂P/∂v] have one sign, divided by the distance from an edge that is a point.
    fn regular(&mut self, cover: &Cover, point: Option<Edge>) -> Result<usize, Failure<Rejection>> {
        let mut determinant = self.determinant(cover.inward).at(Place::Values)?;
        let mut degrees =
            [self.degrees.0, self.degrees.1].map(|degree| degree.saturating_mul(3).saturating_sub(2));
        if let Some((name, end, _)) = point {
            let [of_u, of_v] = &mut degrees;
            let degree = if end.variable == T { of_u } else { of_v };
            let divided =
                without_factor(&determinant, end, degree, &mut self.arithmetic).at(Place::Values)?;
            determinant = divided.ok_or(Rejection::Edge { edge: name, expected: "a point" })?;
        }
        let regular = self.square.form(&determinant, degrees, self.arithmetic.work).at(Place::Values)?;
        self.follow("regular", regular, &cover.regular)
    }

    /// det[P, ∂P/∂u, ∂P/∂v], with the other sign where the normal is to point inwards.
    fn determinant(&mut self, inward: bool) -> Result<Polynomial, Limit> {
        let arithmetic = &mut self.arithmetic;
        let along_u = each(&self.position, |x| derivative(x, T, arithmetic))?;
        let along_v = each(&self.position, |x| derivative(x, S, arithmetic))?;
        let normal = arithmetic.cross_product(&along_u, &along_v)?;
        let determinant = arithmetic.scalar_product(&self.position, &normal)?;
        if inward { arithmetic.negated(&determinant) } else { Ok(determinant) }
    }

    /// The points at (u, v) = (0,0), (1,0), (1,1), (0,1); `None` where W is 0 at one of them.
    fn corners(&mut self) -> Result<Option<Vec<Vector>>, Limit> {
        let [[u0, u1], [v0, v1]] = self.ends();
        let arithmetic = &mut self.arithmetic;
        let mut corners = Vec::with_capacity(4);
        for (u, v) in [(u0, v0), (u1, v0), (u1, v1), (u0, v1)] {
            let mut corner = |x: &Polynomial| at(&at(x, u, arithmetic)?, v, arithmetic);
            let (weight, position) = (corner(&self.weight)?, each(&self.position, corner)?);
            let Some(weight) = arithmetic.inverse(&weight)? else { return Ok(None) };
            let corner = arithmetic.scaled(&position, &weight)?;
            for coordinate in &corner {
                // They are printed.
                Ring::charge_spelling(coordinate, arithmetic.work)?;
                arithmetic.work.keep(Ring::text_bytes(coordinate).saturating_mul(10))?;
            }
            corners.push(corner);
        }
        Ok(Some(corners))
    }

    fn follow(
        &mut self,
        name: &'static str,
        form: subdivision::Form,
        tree: &subdivision::Tree,
    ) -> Result<usize, Failure<Rejection>> {
        let followed = self.square.subdivide(name, form, tree, POSITIVE, self.arithmetic.work);
        followed.map_err(|error| error.map(Rejection::from))
    }
}
