//! Claim `bounds`: subdivisions that show how far a patch is from its surface.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::One;

use super::{Bounded, Bounds, End, Rejection};
use crate::claims::exact::evaluated;
use crate::claims::subdivision::{
    self, Along, NOT_NEGATIVE, POSITIVE, Side, UnitSquare, decimal_value, on_ratio, subject, threshold,
};
use crate::equations::expand;
use crate::exact::Work;
use crate::failure::{At, Failure, Place};
use crate::statement::{Patch, Statement};

/// Follows the subdivisions, and tries the points.
pub(in crate::claims) fn verify(
    statement: &Statement,
    bounds: &Bounds,
    work: &mut Work,
) -> Result<Bounded, Failure<Rejection>> {
    let patch = subject(statement, bounds.quantity).map_err(Rejection::from)?;
    let at = Place::Values;
    let of_boxes = |error: Failure<subdivision::Rejection>| error.map(Rejection::from);
    let net = evaluated(patch, &bounds.values, statement, work).at(at)?;
    let patch = Patch { net, ..patch.clone() };
    let field = statement.field();
    let expanded = expand(field, &patch, work).at(at)?;
    let (m, n) = patch.bidegree;
    let degree = patch.surface.degree();
    let square = UnitSquare::new(field);
    let degrees = [m.saturating_mul(degree), n.saturating_mul(degree)];
    let along = Along { power: expanded.weight.power(degree, field, work).at(at)?, expanded, field };

    let weight = square.form(&along.expanded.weight, [m, n], work).at(at)?;
    let boxes =
        square.subdivide("denominator", weight, &bounds.denominator, POSITIVE, work).map_err(of_boxes)?;
    let mut total = boxes;
    let ends = [("lower", &bounds.lower, Side::Lower), ("upper", &bounds.upper, Side::Upper)];
    for (name, End { bound, at: point, tree }, side) in ends {
        let form = along
            .side(side, threshold(bounds.quantity, bound, bounds.places).map_err(Rejection::from)?, work)
            .at(at)?;
        let form = square.form(&form, degrees, work).at(at)?;
        total =
            total.saturating_add(square.subdivide(name, form, tree, NOT_NEGATIVE, work).map_err(of_boxes)?);
        // The next decimal towards the other end is reached: there the opposite inequality holds at the point.
        let (next, opposite) = match side {
            Side::Lower => (bound + BigInt::one(), Side::Upper),
            _ => (bound - BigInt::one(), Side::Lower),
        };
        let value = decimal_value(&next, bounds.places);
        let form = along.side(opposite, on_ratio(bounds.quantity, &value), work).at(at)?;
        let form = square.form(&form, degrees, work).at(at)?;
        if square.at(form, point, work).at(at)? == Ordering::Less {
            return Err(Rejection::NotReached { end: name }.into());
        }
    }
    Ok(Bounded {
        values: bounds.values.clone(),
        quantity: bounds.quantity,
        places: bounds.places,
        between: [bounds.lower.bound.clone(), bounds.upper.bound.clone()],
        at: [bounds.lower.at.clone(), bounds.upper.at.clone()],
        boxes: total,
    })
}
