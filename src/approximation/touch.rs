//! Where a form that is nowhere negative touches 0: a rational point, found by Newton's method and verified exactly.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::contact::{fraction_near, rounded};
use super::exactly::ExactForm;
use crate::algebra::fixed;
use crate::control::{Control, Interrupted};

/// Bits after the point that Newton's method works with; denominators of up to half as many are recognised.
const BITS: u32 = 320;
/// Steps of Newton's method: the last ones double the digits.
const STEPS: usize = 24;
/// How near to an edge of the square a contact may be on it: 2^−8.
const EDGE: u32 = 8;
/// Denominators for the coordinate that is chosen where the form touches along a curve.
const CHOSEN: u32 = 16;

/// Which coordinates are looked for; the others are given.
type Free = [bool; 2];

/// A rational point near this one at which the form is 0, exactly.
///
/// At an inner contact both slopes are 0, on an edge the slope along it; where the form touches along a curve, one
/// coordinate is chosen.
///
/// # Errors
/// [`Control::check`]
pub(super) fn touching(
    form: &ExactForm,
    near: &[BigRational; 2],
    control: &Control,
) -> Result<Option<[BigRational; 2]>, Interrupted> {
    for (start, free) in starts(near) {
        let Some(found) = critical(form, start, free, control)? else { continue };
        let recognised = found.each_ref().map(|x| fraction_near(x, BITS / 2));
        let [Some(u), Some(v)] = recognised else { continue };
        let inside = |x: &BigRational| !x.is_negative() && *x <= BigRational::one();
        let point = [u, v];
        if point.iter().all(inside) && form.at(&point).is_zero() {
            return Ok(Some(point));
        }
    }
    Ok(None)
}

/// From where Newton's method starts, and in which coordinates.
fn starts(near: &[BigRational; 2]) -> Vec<([BigRational; 2], Free)> {
    let mut all = vec![(near.clone(), [true, true])];
    for axis in 0..2 {
        let mut given = |value: BigRational| {
            let mut start = near.clone();
            start[axis] = value;
            let mut free = [true, true];
            free[axis] = false;
            all.push((start, free));
        };
        let edge = near[axis].round();
        if (&near[axis] - &edge).abs() < BigRational::new(BigInt::one(), BigInt::one() << EDGE) {
            given(edge);
        }
        given(rounded(&near[axis], CHOSEN));
    }
    all
}

/// A zero of the slopes along the free coordinates, to 2^−BITS; `None` where Newton's method does not come to one.
fn critical(
    form: &ExactForm,
    mut at: [BigRational; 2],
    free: Free,
    control: &Control,
) -> Result<Option<[BigRational; 2]>, Interrupted> {
    let [of_u, of_v] = [0, 1].map(|axis| form.derivative(axis));
    let second = |slope: &Option<ExactForm>, axis| slope.as_ref().and_then(|slope| slope.derivative(axis));
    let (of_uu, of_uv, of_vv) = (second(&of_u, 0), second(&of_u, 1), second(&of_v, 1));
    let value = |form: &Option<ExactForm>, at: &[BigRational; 2]| match form {
        Some(form) => {
            BigRational::new(fixed(&form.at(at), 2 * BITS).to_bigint(), BigInt::one() << (2 * BITS))
        }
        None => BigRational::zero(),
    };
    for _ in 0..STEPS {
        control.check()?;
        // A coordinate that is given stays: its slope is 0, and its curvature 1.
        let unless_given = |axis: usize, form: &Option<ExactForm>, given: i64| match free[axis] {
            true => value(form, &at),
            false => BigRational::from_integer(given.into()),
        };
        let (u, v) = (unless_given(0, &of_u, 0), unless_given(1, &of_v, 0));
        let (uu, vv) = (unless_given(0, &of_uu, 1), unless_given(1, &of_vv, 1));
        let uv = if free == [true, true] { value(&of_uv, &at) } else { BigRational::zero() };
        let determinant = &uu * &vv - &uv * &uv;
        if determinant.is_zero() {
            return Ok(None);
        }
        let step = [(&vv * &u - &uv * &v) / &determinant, (&uu * &v - &uv * &u) / &determinant];
        let small =
            step.iter().all(|x| x.abs() < BigRational::new(BigInt::one(), BigInt::one() << (BITS - 24)));
        let unit = BigRational::from_integer(BigInt::one() << BITS);
        at = std::array::from_fn(|k| ((&at[k] - &step[k]) * &unit).round() / &unit);
        let far = at.iter().any(|x| x.abs() > BigRational::from_integer(2.into()));
        if small || far {
            return Ok(Some(at).filter(|_| small));
        }
    }
    Ok(None)
}
