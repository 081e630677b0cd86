//! Claim `bounds`: subdivisions that show how far a patch is from its surface.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::scene::{NOT_NEGATIVE, POSITIVE, Scene};
use crate::certificate::{Bounds, End, Quantity, Side, Units, decimal_value};
use crate::checker::equations::{Expanded, expand};
use crate::checker::error::{CheckError, Rejection};
use crate::checker::net::evaluated;
use crate::checker::theorem::{Claim, Theorem};
use crate::exact::{Limit, Polynomial, Radicands, Work, combination};
use crate::statement::{Patch, Statement, Subject};

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
    let scene = Scene::new(field);
    let degrees = [m.saturating_mul(degree), n.saturating_mul(degree)];
    let powers =
        Powers { power: expanded.weight.power(degree, field, work).map_err(limited)?, expanded, field };

    let weight = scene.form(&powers.expanded.weight, [m, n], work).map_err(limited)?;
    let boxes = scene.subdivide("denominator", weight, &bounds.denominator, POSITIVE, work)?;
    let mut total = boxes;
    let ends = [("lower", &bounds.lower, Side::Lower), ("upper", &bounds.upper, Side::Upper)];
    for (name, End { bound, at, tree }, side) in ends {
        let form =
            powers.side(side, threshold(bounds.quantity, bound, bounds.places)?, work).map_err(limited)?;
        let form = scene.form(&form, degrees, work).map_err(limited)?;
        total = total.saturating_add(scene.subdivide(name, form, tree, NOT_NEGATIVE, work)?);
        // The next decimal towards the other end is reached: there the opposite inequality holds at the point.
        let (next, opposite) = match side {
            Side::Lower => (bound + BigInt::one(), Side::Upper),
            _ => (bound - BigInt::one(), Side::Lower),
        };
        let value = decimal_value(&next, bounds.places);
        let form = powers.side(opposite, on_ratio(bounds.quantity, &value), work).map_err(limited)?;
        let form = scene.form(&form, degrees, work).map_err(limited)?;
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
    match quantity == Quantity::Radius && !patch.is_on_unit_sphere() {
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
