//! Claim `bounds`: subdivisions that show how far a patch is from its surface.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::form::{Form, Interval, Signs};
use crate::certificate::{Bounds, End, Quantity, Side, Tree, Units, decimal_value};
use crate::checker::equations::{Expanded, S, T, expand};
use crate::checker::error::{CheckError, Rejection};
use crate::checker::net::evaluated;
use crate::checker::theorem::{Claim, Theorem};
use crate::exact::{Limit, Monomial, Polynomial, Radicands, Work, combination};
use crate::statement::{Patch, Statement, Subject};

/// The positive quadrant of signs that is asked for.
const POSITIVE: &[Ordering] = &[Ordering::Greater];
const NOT_NEGATIVE: &[Ordering] = &[Ordering::Greater, Ordering::Equal];

pub(in crate::checker) fn verify(
    statement: &Statement,
    bounds: &Bounds,
    work: &mut Work,
) -> Result<Theorem, CheckError> {
    let patch = subject(statement, bounds.quantity)?;
    let limited = |limit| CheckError::Replay { step: 0, limit };
    let net = evaluated(patch, &bounds.values, statement, work).map_err(limited)?;
    let patch = Patch { net, ..patch.clone() };
    let field = statement.field();
    let expanded = expand(field, &patch, work).map_err(limited)?;
    let (m, n) = patch.bidegree;
    let degree = patch.surface.degree();
    let scene = Scene {
        field,
        signs: Signs::new(field),
        degrees: [m.saturating_mul(degree), n.saturating_mul(degree)],
    };
    let powers =
        Powers { power: expanded.weight.power(degree, field, work).map_err(limited)?, expanded, field };

    let weight = scene.form(&powers.expanded.weight, [m, n], work).map_err(limited)?;
    let boxes = scene.subdivide("denominator", weight, &bounds.denominator, POSITIVE, work)?;
    let mut total = boxes;
    let ends = [("lower", &bounds.lower, Side::Lower), ("upper", &bounds.upper, Side::Upper)];
    for (name, End { bound, at, tree }, side) in ends {
        let form =
            powers.side(side, threshold(bounds.quantity, bound, bounds.places)?, work).map_err(limited)?;
        let form = scene.form(&form, scene.degrees, work).map_err(limited)?;
        total = total.saturating_add(scene.subdivide(name, form, tree, NOT_NEGATIVE, work)?);
        // The next decimal towards the other end is reached: there the opposite inequality holds at the point.
        let (next, opposite) = match side {
            Side::Lower => (bound + BigInt::one(), Side::Upper),
            _ => (bound - BigInt::one(), Side::Lower),
        };
        let value = decimal_value(&next, bounds.places);
        let form = powers.side(opposite, on_ratio(bounds.quantity, &value), work).map_err(limited)?;
        let form = scene.form(&form, scene.degrees, work).map_err(limited)?;
        if scene.at(form, at, work).map_err(limited)? == Ordering::Less {
            return Err(Rejection::NotReached { end: name }.into());
        }
    }
    let claim = Claim::Bounds {
        values: bounds.values.clone(),
        quantity: bounds.quantity,
        places: bounds.places,
        between: [bounds.lower.bound.clone(), bounds.upper.bound.clone()],
        at: [bounds.lower.at.clone(), bounds.upper.at.clone()],
        boxes: total,
    };
    Ok(Theorem::established(statement, claim))
}

/// The patch of a statement that this quantity belongs to.
pub(super) fn subject(statement: &Statement, quantity: Quantity) -> Result<&Patch, Rejection> {
    let Subject::Patch(patch) = statement.subject() else {
        return Err(Rejection::NotAPatch);
    };
    let squares = (0u16..4).map(|k| {
        let monomial = Monomial::new(0, vec![(k, 2)]).and_then(Result::ok).unwrap_or_else(Monomial::one);
        (monomial, if k == 3 { -BigRational::one() } else { BigRational::one() })
    });
    let sphere = Polynomial::from_terms(squares);
    match quantity == Quantity::Radius && patch.surface != sphere {
        true => Err(Rejection::NotTheUnitSphere),
        false => Ok(patch),
    }
}

/// The bound on F/Wᵉ that a stated bound means.
pub(super) fn threshold(quantity: Quantity, bound: &Units, places: u32) -> Result<BigRational, Rejection> {
    match quantity == Quantity::Radius && bound.is_negative() {
        true => Err(Rejection::NegativeRadius),
        false => Ok(on_ratio(quantity, &decimal_value(bound, places))),
    }
}

/// r² − 1 for a radius r.
fn on_ratio(quantity: Quantity, value: &BigRational) -> BigRational {
    match quantity {
        Quantity::Radius => value * value - BigRational::one(),
        Quantity::Ratio => value.clone(),
    }
}

/// F, W and Wᵉ along the patch, in t and s.
pub(super) struct Powers<'a> {
    pub(super) expanded: Expanded,
    pub(super) power: Polynomial,
    pub(super) field: &'a Radicands,
}

impl Powers<'_> {
    /// F − bound·Wᵉ, bound·Wᵉ − F, or W.
    pub(super) fn side(&self, side: Side, bound: BigRational, work: &mut Work) -> Result<Polynomial, Limit> {
        let (one, bound) = (Polynomial::integer(1), Polynomial::rational(bound));
        let (surface, power) = (&self.expanded.surface, &self.power);
        match side {
            Side::Lower => combination(&[(&one, surface), (&bound.negate(), power)], self.field, work),
            Side::Upper => combination(&[(&bound, power), (&one.negate(), surface)], self.field, work),
            Side::Weight => Ok(self.expanded.weight.clone()),
        }
    }
}

struct Scene<'a> {
    field: &'a Radicands,
    signs: Signs,
    degrees: [u32; 2],
}

impl Scene<'_> {
    /// A polynomial in t and s, without unknowns, as a form in u and 1 − u, v and 1 − v: t = u/(1−u), s = v/(1−v).
    fn form(&self, polynomial: &Polynomial, degrees: [u32; 2], work: &mut Work) -> Result<Form, Limit> {
        let size = |exponent: u32| usize::try_from(exponent).unwrap_or(usize::MAX);
        let mut terms = Vec::with_capacity(polynomial.term_count());
        for (monomial, value) in polynomial.terms() {
            let exponents = [T, S].map(|variable| size(monomial.exponent(variable))).to_vec();
            terms.push((exponents, monomial.mask(), value.clone()));
        }
        Form::new(self.field, degrees.map(size).to_vec(), &terms, work)
    }

    /// The sign at a point of the square.
    fn at(&self, form: Form, point: &[BigRational; 2], work: &mut Work) -> Result<Ordering, Limit> {
        let mut form = form;
        for (axis, x) in (0usize..).zip(point) {
            let interval = Interval::point(x.numer().clone(), x.denom() - x.numer());
            form = form.on(axis, &interval, work)?;
        }
        form.first(&self.signs, work)
    }

    /// Follows a tree from the whole square: the boxes that are not halved have accepted signs, the others have not.
    /// Returns how many boxes are not halved.
    fn subdivide(
        &self,
        name: &'static str,
        form: Form,
        tree: &Tree,
        accepted: &[Ordering],
        work: &mut Work,
    ) -> Result<usize, CheckError> {
        // u = q/(p+q) and 1 − u = p/(p+q): the lower half has u = q/(2p+2q), the upper one u = (p+2q)/(2p+2q).
        let (low, high) = (Interval::new([0, 1], [2, 1]), Interval::new([1, 2], [1, 0]));
        let mut open = vec![(form, 0usize)];
        let mut boxes = 0usize;
        for (position, halved) in (1usize..).zip(tree) {
            let limited = |limit| CheckError::Subdivision { tree: name, node: position, limit };
            let Some((form, depth)) = open.pop() else {
                return Err(Rejection::Tree { tree: name }.into());
            };
            let holds = form.all(&self.signs, accepted, work).map_err(limited)?;
            match (halved, holds) {
                (false, false) => return Err(Rejection::Sign { tree: name, node: position }.into()),
                (true, true) => return Err(Rejection::NeedlessHalving { tree: name, node: position }.into()),
                (false, true) => boxes = boxes.saturating_add(1),
                (true, false) => {
                    // Across u first, then v, in turn.
                    let axis = depth.checked_rem(2).unwrap_or(0);
                    let next = depth.saturating_add(1);
                    open.push((form.on(axis, &high, work).map_err(limited)?, next));
                    open.push((form.on(axis, &low, work).map_err(limited)?, next));
                }
            }
        }
        match open.is_empty() {
            true => Ok(boxes),
            false => Err(Rejection::Tree { tree: name }.into()),
        }
    }
}
