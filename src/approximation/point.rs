//! A simple point of a patch where a printed bound fails, exactly.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::contact::rounded;
use super::enclosure::EnclosureError;
use super::scene::Scene;
use crate::certificate::Side;
use crate::control::Control;
use crate::exact;
use crate::statement::Statement;

/// The largest denominator of a simple point.
const DENOMINATOR: u32 = 64;

/// How the quantity at a point (u, v) of the patch compares with a bound, exactly. W is positive there.
///
/// # Errors
/// Where there is no patch, or W is not positive at u = v = 0, or a limit of the format is exceeded.
pub fn compare_at(
    statement: &Statement,
    values: &[exact::Polynomial],
    at: &[BigRational; 2],
    bound: &BigRational,
) -> Result<Ordering, EnclosureError> {
    Ok(Scene::of(statement, values, &Control::default())?.compare(at, bound))
}

/// The point of smallest denominator near `near` where the quantity is beyond a bound, or `near` itself.
pub(super) fn simple_point_beyond(
    scene: &Scene,
    side: Side,
    bound: &BigRational,
    near: &[BigRational; 2],
) -> [BigRational; 2] {
    let beyond = if side == Side::Upper { Ordering::Greater } else { Ordering::Less };
    let points = (1..=DENOMINATOR).map(|denominator| near.each_ref().map(|x| rounded(x, denominator)));
    let mut simple = points.filter(|point| scene.compare(point, bound) == beyond);
    simple.next().unwrap_or_else(|| near.clone())
}

/// The quantity at a point, cut off (towards zero) after so many places.
pub(super) fn decimal_at(
    scene: &Scene,
    at: &[BigRational; 2],
    places: u32,
    within: [&BigRational; 2],
) -> BigRational {
    let unit = BigRational::new(1.into(), BigInt::from(10).pow(places));
    // Bisection between two decimals in units of the last place.
    let mut low: BigInt = (within[0] / &unit).floor().to_integer();
    let mut high: BigInt = (within[1] / &unit).ceil().to_integer() + 1;
    while high > BigInt::one() + &low {
        let middle: BigInt = (high.clone() + &low) / 2;
        match scene.compare(at, &(BigRational::from_integer(middle.clone()) * &unit)) {
            Ordering::Less => high = middle,
            _ => low = middle,
        }
    }
    // Of a negative number the decimal below is one too far, unless it is the number itself.
    let below = BigRational::from_integer(low.clone()) * &unit;
    if low.is_negative() && scene.compare(at, &below) != Ordering::Equal {
        low += 1;
    }
    BigRational::from_integer(low) * unit
}
