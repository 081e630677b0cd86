//! Claim `cover`: the patch maps the square one to one onto the spherical polygon between its corners.
//!
//! That it lies on the unit sphere has been checked before. Here: W > 0; every edge runs in the plane of the great circle
//! through its ends, and on the side of the middle of the shorter arc; and det[P, P_u, P_v] = W³·det[p, p_u, p_v] for p = P/W
//! has one sign on the closed square. Then the map is an immersion, hence monotonous along each edge, so that the edges are the
//! shorter arcs; the corners have angles below π, so that the polygon is convex and simple; and an immersed disc whose
//! boundary is run through once is embedded (glue a disc to it: what results is a covering of the sphere, which has only one
//! sheet). Where one edge is a point, the determinant is divided by the distance from that edge.

use super::bounds::subject;
use super::scene::{POSITIVE, Scene};
use crate::certificate::{Cover, EDGES, EdgeTree, Quantity};
use crate::checker::equations::{S, T, expand};
use crate::checker::error::{CheckError, Rejection};
use crate::checker::net::evaluated;
use crate::checker::theorem::{Claim, Theorem};
use crate::exact::{Limit, Monomial, Polynomial, Radicands, Work};
use crate::statement::{Patch, Statement};

/// X, Y, Z.
type Vector = [Polynomial; 3];

/// Where a parameter is at its end: the variable, and the exponent of what is left there.
#[derive(Clone, Copy)]
struct End {
    variable: u16,
    exponent: u32,
}

pub(in crate::checker) fn verify(
    statement: &Statement,
    cover: &Cover,
    work: &mut Work,
) -> Result<Theorem, CheckError> {
    let patch = subject(statement, Quantity::Radius)?;
    let limited = |limit| CheckError::Replay { step: 0, limit };
    let field = statement.field();
    let net = evaluated(patch, &cover.values, statement, work).map_err(limited)?;
    let (m, n) = patch.bidegree;
    let expanded = expand(field, &Patch { net, ..patch.clone() }, work).map_err(limited)?;
    let Ok(position) = Vector::try_from(expanded.position) else { return Err(Rejection::NotAPatch.into()) };
    let scene = Scene::new(field);
    let algebra = Algebra { field };

    let weight = scene.form(&expanded.weight, [m, n], work).map_err(limited)?;
    let mut boxes = scene.subdivide("denominator", weight, &cover.denominator, POSITIVE, work)?;

    let ends = |variable, degree| [0, degree].map(|exponent| End { variable, exponent });
    let ([u0, u1], [v0, v1]) = (ends(T, m), ends(S, n));
    let mut point: Option<(&'static str, End)> = None;
    for ((name, edge), (fixed, along)) in EDGES.into_iter().zip(&cover.edges).zip([
        (u0, [v0, v1]),
        (u1, [v0, v1]),
        (v0, [u0, u1]),
        (v1, [u0, u1]),
    ]) {
        let curve = position.each_ref().map(|x| at(x, fixed));
        let [a, b] = along.map(|end| curve.each_ref().map(|x| at(x, end)));
        let normal = algebra.cross(&a, &b, work).map_err(limited)?;
        let in_line = normal.iter().all(Polynomial::is_zero);
        match edge {
            EdgeTree::Point => {
                // Its direction is that of its start throughout.
                let turned = algebra.cross(&curve, &a, work).map_err(limited)?;
                if !turned.iter().all(Polynomial::is_zero) {
                    return Err(Rejection::Edge { edge: name, expected: "a point" }.into());
                }
                if point.replace((name, fixed)).is_some() {
                    return Err(Rejection::Points { edge: name }.into());
                }
            }
            EdgeTree::Arc(tree) => {
                let height = algebra.dot(&normal, &curve, work).map_err(limited)?;
                if in_line || !height.is_zero() {
                    return Err(Rejection::Edge { edge: name, expected: "an arc of a great circle" }.into());
                }
                // A direction of the middle of the shorter arc.
                let [of_a, of_b] = along.map(|end| at(&at(&expanded.weight, fixed), end));
                let [of_a, of_b] =
                    [(&a, &of_b), (&b, &of_a)].map(|(corner, weight)| algebra.scaled(corner, weight, work));
                let middle =
                    algebra.sum(&of_a.map_err(limited)?, &of_b.map_err(limited)?, work).map_err(limited)?;
                let side = algebra.dot(&middle, &curve, work).map_err(limited)?;
                let degrees = if fixed.variable == T { [0, n] } else { [m, 0] };
                let side = scene.form(&side, degrees, work).map_err(limited)?;
                boxes = boxes.saturating_add(scene.subdivide(name, side, tree, POSITIVE, work)?);
            }
        }
    }

    let along_u = position.each_ref().map(|x| derivative(x, T));
    let along_v = position.each_ref().map(|x| derivative(x, S));
    let normal = algebra.cross(&along_u, &along_v, work).map_err(limited)?;
    let mut determinant = algebra.dot(&position, &normal, work).map_err(limited)?;
    if cover.inward {
        determinant = determinant.negate();
    }
    let degree = |degree: u32| degree.saturating_mul(3).saturating_sub(2);
    let mut degrees = [degree(m), degree(n)];
    if let Some((name, end)) = point {
        let [of_u, of_v] = &mut degrees;
        let degree = if end.variable == T { of_u } else { of_v };
        determinant = without_factor(&determinant, end, degree)
            .ok_or(Rejection::Edge { edge: name, expected: "a point" })?;
    }
    let regular = scene.form(&determinant, degrees, work).map_err(limited)?;
    boxes = boxes.saturating_add(scene.subdivide("regular", regular, &cover.regular, POSITIVE, work)?);

    let mut corners = Vec::with_capacity(4);
    for (u, v) in [(u0, v0), (u1, v0), (u1, v1), (u0, v1)] {
        let weight = at(&at(&expanded.weight, u), v).inverse(field, work).map_err(limited)?;
        let weight = weight.ok_or(Rejection::NoDenominator)?;
        let corner = position.each_ref().map(|x| at(&at(x, u), v));
        corners.push(algebra.scaled(&corner, &weight, work).map_err(limited)?);
    }
    let claim = Claim::Cover {
        values: cover.values.clone(),
        corners,
        inward: cover.inward,
        point: point.map(|(name, _)| name),
        boxes,
    };
    Ok(Theorem::established(statement, claim))
}

/// What is left of a polynomial of degree D in t (or s) at t = 0, or of t^−D times it at t = ∞.
fn at(polynomial: &Polynomial, end: End) -> Polynomial {
    let there = polynomial.terms().filter(|(monomial, _)| monomial.exponent(end.variable) == end.exponent);
    Polynomial::from_terms(
        there.map(|(monomial, value)| (with_exponent(monomial, end.variable, 0), value.clone())),
    )
}

fn derivative(polynomial: &Polynomial, variable: u16) -> Polynomial {
    let terms = polynomial.terms().filter_map(|(monomial, value)| {
        let exponent = monomial.exponent(variable);
        let lower = exponent.checked_sub(1)?;
        Some((with_exponent(monomial, variable, lower), value * num_bigint::BigInt::from(exponent)))
    });
    Polynomial::from_terms(terms)
}

/// A form of this degree in u and 1−u (or v) divided by u, or by 1−u, whichever vanishes at the end; `None` if it is not
/// divisible.
fn without_factor(polynomial: &Polynomial, end: End, degree: &mut u32) -> Option<Polynomial> {
    *degree = degree.checked_sub(1)?;
    if end.exponent != 0 {
        let divisible = polynomial.terms().all(|(monomial, _)| monomial.exponent(end.variable) <= *degree);
        return divisible.then(|| polynomial.clone());
    }
    let mut terms = Vec::with_capacity(polynomial.term_count());
    for (monomial, value) in polynomial.terms() {
        let lower = monomial.exponent(end.variable).checked_sub(1)?;
        terms.push((with_exponent(monomial, end.variable, lower), value.clone()));
    }
    Some(Polynomial::from_terms(terms))
}

/// The same power product with another, not larger, exponent of one variable in it.
fn with_exponent(monomial: &Monomial, variable: u16, exponent: u32) -> Monomial {
    let kept =
        monomial.powers().iter().map(|&(other, e)| (other, if other == variable { exponent } else { e }));
    let powers = kept.filter(|&(_, exponent)| exponent > 0).collect();
    Monomial::new(monomial.mask(), powers).and_then(Result::ok).unwrap_or_else(|| monomial.clone())
}

struct Algebra<'a> {
    field: &'a Radicands,
}

impl Algebra<'_> {
    fn dot(&self, a: &Vector, b: &Vector, work: &mut Work) -> Result<Polynomial, Limit> {
        let mut products = Vec::with_capacity(3);
        for (x, y) in a.iter().zip(b) {
            products.push(x.multiply(y, self.field, work)?);
        }
        Polynomial::sum(&products, self.field, work)
    }

    fn cross(&self, [a, b, c]: &Vector, [x, y, z]: &Vector, work: &mut Work) -> Result<Vector, Limit> {
        let mut minor = |p: &Polynomial, q: &Polynomial, r: &Polynomial, s: &Polynomial| {
            let products = [p.multiply(s, self.field, work)?, q.multiply(r, self.field, work)?.negate()];
            Polynomial::sum(&products, self.field, work)
        };
        Ok([minor(b, c, y, z)?, minor(c, a, z, x)?, minor(a, b, x, y)?])
    }

    fn scaled(&self, a: &Vector, factor: &Polynomial, work: &mut Work) -> Result<Vector, Limit> {
        let [x, y, z] = a;
        let mut times = |p: &Polynomial| p.multiply(factor, self.field, work);
        Ok([times(x)?, times(y)?, times(z)?])
    }

    fn sum(&self, [a, b, c]: &Vector, [x, y, z]: &Vector, work: &mut Work) -> Result<Vector, Limit> {
        let mut plus =
            |p: &Polynomial, q: &Polynomial| Polynomial::sum(&[p.clone(), q.clone()], self.field, work);
        Ok([plus(a, x)?, plus(b, y)?, plus(c, z)?])
    }
}
