//! A simple point of a patch where a printed bound fails, exactly.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};

use super::enclosure::{EnclosureError, patch_at, quantity_of};
use crate::algebra::{Integer, Sign};
use crate::bezier::{surface_condition, value_at};
use crate::certificate::{Quantity, Side};
use crate::exact::{self, Work};
use crate::prove::field_of;
use crate::statement::{Patch, Statement};

/// The largest denominator of a simple point.
const DENOMINATOR: u32 = 64;

/// How the quantity at a point (u, v) of the patch compares with a bound, exactly. W is positive there.
pub fn compare_at(
    statement: &Statement,
    values: &[exact::Polynomial],
    at: &[BigRational; 2],
    bound: &BigRational,
) -> Result<Ordering, EnclosureError> {
    let patch = patch_at(statement, values)?;
    let field = field_of(statement);
    let quantity = quantity_of(statement).ok_or(EnclosureError::NotAPatch)?;
    if quantity == Quantity::Radius && bound.is_negative() {
        return Ok(Ordering::Greater);
    }
    let threshold =
        if quantity == Quantity::Radius { bound * bound - BigRational::one() } else { bound.clone() };
    let number =
        |x: &BigRational| field.rational(Integer::from_bigint(x.numer()), Integer::from_bigint(x.denom()));
    let along = |surface: exact::Polynomial| {
        let form = surface_condition(field, &Patch { surface, ..patch.clone() });
        value_at(&form, &number(&at[0]), &number(&at[1])).unwrap_or_else(|| field.zero())
    };
    let power =
        exact::Polynomial::variable(3).power(patch.surface.degree(), statement.field(), &mut Work::full())?;
    let difference = &along(patch.surface.clone()) - &(&number(&threshold) * &along(power));
    Ok(match difference.sign() {
        Some(Sign::Negative) => Ordering::Less,
        Some(Sign::Positive) => Ordering::Greater,
        Some(Sign::Zero) | None => Ordering::Equal,
    })
}

/// The point of smallest denominator near `near` where the quantity is beyond a bound, or `near` itself.
pub fn simple_point_beyond(
    statement: &Statement,
    values: &[exact::Polynomial],
    side: Side,
    bound: &BigRational,
    near: &[BigRational; 2],
) -> Result<[BigRational; 2], EnclosureError> {
    let beyond = if side == Side::Upper { Ordering::Greater } else { Ordering::Less };
    for denominator in 1..=DENOMINATOR {
        let rounded = |x: &BigRational| {
            let numerator = (x.to_f64().unwrap_or(0.0) * f64::from(denominator)).round() as i64;
            BigRational::new(numerator.into(), denominator.into())
        };
        let point = near.each_ref().map(rounded);
        if compare_at(statement, values, &point, bound)? == beyond {
            return Ok(point);
        }
    }
    Ok(near.clone())
}

/// The quantity at a point, cut off after so many places.
pub fn decimal_at(
    statement: &Statement,
    values: &[exact::Polynomial],
    at: &[BigRational; 2],
    places: u32,
    within: [&BigRational; 2],
) -> Result<BigRational, EnclosureError> {
    let unit = BigRational::new(1.into(), BigInt::from(10).pow(places));
    // Bisection between two decimals in units of the last place.
    let mut low: BigInt = (within[0] / &unit).floor().to_integer();
    let mut high: BigInt = (within[1] / &unit).ceil().to_integer() + 1;
    while high > BigInt::one() + &low {
        let middle: BigInt = (high.clone() + &low) / 2;
        let bound = BigRational::from_integer(middle.clone()) * &unit;
        match compare_at(statement, values, at, &bound)? {
            Ordering::Less => high = middle,
            _ => low = middle,
        }
    }
    Ok(BigRational::from_integer(low) * unit)
}
