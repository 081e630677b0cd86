//! Simple points near one that is known approximately: where a form may touch a bound exactly.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// Both coordinates with one denominator: up to this one.
const COMMON: u32 = 64;
/// Continued fractions of each coordinate: denominators up to this one.
const DENOMINATOR: u32 = 1 << 20;

/// Points of the square that are simple and near this one of it, each once, the simplest first.
pub(super) fn candidates(near: &[BigRational; 2]) -> Vec<[BigRational; 2]> {
    let mut found: Vec<[BigRational; 2]> = Vec::new();
    let common = (1..=COMMON).map(|denominator| near.each_ref().map(|x| rounded(x, denominator)));
    let [of_u, of_v] = near.each_ref().map(|x| convergents(x, &DENOMINATOR.into()));
    let pairs = itertools::iproduct!(&of_u, &of_v).map(|(u, v)| [u.clone(), v.clone()]);
    for point in common.chain(pairs) {
        if !found.contains(&point) {
            found.push(point);
        }
    }
    found
}

/// The nearest number with this denominator.
pub(super) fn rounded(x: &BigRational, denominator: u32) -> BigRational {
    let denominator = BigRational::from_integer(denominator.into());
    (x * &denominator).round() / denominator
}

/// The fraction that a number of twice so many bits is, if it is one with a denominator of at most so many: to all but
/// an eighth of the bits.
pub(super) fn fraction_near(x: &BigRational, bits: u32) -> Option<BigRational> {
    let error = BigRational::new(BigInt::one(), BigInt::one() << (2 * bits - bits / 4));
    let largest = BigInt::one() << (bits * 3 / 4);
    convergents(x, &largest).into_iter().find(|fraction| (fraction - x).abs() < error)
}

/// The convergents of the continued fraction of a number, with denominators up to the largest.
fn convergents(x: &BigRational, largest: &BigInt) -> Vec<BigRational> {
    let (mut numerator, mut denominator) = (x.numer().clone(), x.denom().clone());
    let [mut before, mut last] = [[BigInt::zero(), BigInt::one()], [BigInt::one(), BigInt::zero()]];
    let mut found = Vec::new();
    while !denominator.is_zero() {
        let (whole, rest) = numerator.div_mod_floor(&denominator);
        let next = std::array::from_fn(|k| &whole * &last[k] + &before[k]);
        (before, last) = (last, next);
        if last[1] > *largest {
            break;
        }
        found.push(BigRational::new(last[0].clone(), last[1].clone()));
        (numerator, denominator) = (denominator, rest);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ratio(p: i64, q: i64) -> BigRational {
        BigRational::new(p.into(), q.into())
    }

    #[test]
    fn a_rational_is_found_from_a_dyadic_nearby() {
        for (u, v) in [((1, 3), (2, 7)), ((0, 1), (1, 1)), ((355, 452), (13, 997))] {
            let exact = [ratio(u.0, u.1), ratio(v.0, v.1)];
            let near = exact.each_ref().map(|x| (x * ratio(1 << 40, 1)).floor() / ratio(1 << 40, 1));
            assert!(candidates(&near).contains(&exact), "{exact:?}");
        }
    }

    #[test]
    fn all_points_are_in_the_square() {
        for x in [ratio(0, 1), ratio(1, 1), ratio(1, 1 << 30), ratio((1 << 30) - 1, 1 << 30), ratio(5, 7)] {
            let one = ratio(1, 1);
            let points = candidates(&[x.clone(), x]);
            assert!(points.iter().flatten().all(|x| *x >= ratio(0, 1) && *x <= one));
        }
    }
}
