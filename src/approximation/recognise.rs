//! Elements of K of small height near numbers in floating point.

use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::frame::Frame;
use super::normal::Normal;
use super::size::{parts, power_of_two};
use crate::algebra::{
    FieldElement, Integer, MultiquadraticField, Polynomial, polynomial_from_exact, polynomial_to_exact,
};
use crate::exact;
use crate::problem::field_of;
use crate::statement::Statement;

/// How near the number must be.
const TOLERANCE: f64 = 1e-12;
/// The largest common denominator that is tried.
const DENOMINATOR: i64 = 12;
/// The largest numerator.
const NUMERATOR: i64 = 24;

/// An element (Σ n_S √ΠS)/d with |n_S| ≤ 24 and the smallest d ≤ 12, for fields of degree 4 at most. It is a guess: so many
/// candidates there are that of a million random numbers one or so has such an element near it.
fn recognise(value: f64, field: MultiquadraticField) -> Option<FieldElement> {
    let degree = field.degree();
    if degree > 4 || !value.is_finite() {
        return None;
    }
    let root = |subset: usize| {
        let radicand = field.under_root(subset).to_i64().unwrap_or(0);
        (radicand as f64).sqrt()
    };
    let roots: Vec<f64> = (1..degree).map(root).collect();
    for denominator in 1..=DENOMINATOR {
        let scaled = value * denominator as f64;
        let mut best: Option<(i64, Vec<i64>)> = None;
        let combinations = roots.iter().fold(vec![(0.0, vec![])], |sums: Vec<(f64, Vec<i64>)>, root| {
            let more = |(sum, numerators): &(f64, Vec<i64>)| {
                let (sum, numerators) = (*sum, numerators.clone());
                (-NUMERATOR..=NUMERATOR)
                    .map(move |n| (sum + n as f64 * root, [&numerators[..], &[n]].concat()))
            };
            sums.iter().flat_map(more).collect()
        });
        for (sum, numerators) in combinations {
            let rational = (scaled - sum).round();
            let near = (scaled - sum - rational).abs() < TOLERANCE * denominator as f64;
            if !near || rational.abs() > NUMERATOR as f64 {
                continue;
            }
            let height = rational.abs() as i64 + numerators.iter().map(num_traits::Signed::abs).sum::<i64>();
            if best.as_ref().is_none_or(|(least, _)| height < *least) {
                best = Some((height, [&[rational as i64], &numerators[..]].concat()));
            }
        }
        if let Some((_, numerators)) = best {
            let numerators = numerators.into_iter().map(Integer::from).collect();
            return Some(field.element(numerators, Integer::from(denominator)));
        }
    }
    None
}

/// Elements of K of small height that the values seem to be: all of them, or, for a coordinate of a point with an unknown weight, its
/// product with that.
///
/// A weight is compared with a known weight of the net, a coordinate with the known ones: what is recognised does not depend
/// on what the patch is measured in. Nothing is verified here; the values are near those found, and the enclosure at them is proved.
pub(super) fn recognised(
    statement: &Statement,
    normal: &Normal,
    y: &[f64],
) -> Option<Vec<exact::Polynomial>> {
    let field = field_of(statement);
    let number = |value: &BigRational| {
        field.rational(Integer::from_bigint(value.numer()), Integer::from_bigint(value.denom()))
    };
    let mut exact: Vec<FieldElement> = Vec::new();
    for (k, affine) in normal.unknowns.iter().enumerate() {
        let unit = yardstick(field, normal, k as u16)?;
        let (mantissa, exponent) = parts(&unit);
        let ratio = y[k] / mantissa * power_of_two(affine.exponent - exponent);
        exact.push(&recognise(ratio, field)? * &unit);
    }
    // What was shifted for the search is shifted back.
    let own = exact.clone();
    for (k, affine) in normal.unknowns.iter().enumerate() {
        exact[k] = &exact[k] + &number(&affine.shift);
        for (l, factor) in &affine.shears {
            let of_other = &own[*l] * &number(&(factor / &normal.unknowns[*l].unit));
            exact[k] = &exact[k] + &of_other;
        }
    }
    for &(z, w) in &normal.products {
        exact[usize::from(z)] = &exact[usize::from(z)] * &exact[usize::from(w)].inverse()?;
    }
    let constants = exact.into_iter().map(Polynomial::constant);
    constants.map(|value| polynomial_to_exact(&value).ok()).collect()
}

/// What an unknown is compared with: a known weight, or that times a known length, over the unknown's own factor in the net.
fn yardstick(field: MultiquadraticField, normal: &Normal, unknown: u16) -> Option<FieldElement> {
    let entries = normal.patch.net.iter().flatten().flat_map(|point| point.iter().enumerate());
    let mut factors = entries.filter_map(|(coordinate, entry)| {
        let entry = polynomial_from_exact(field, entry);
        let terms = entry.terms().iter().filter(|(monomial, _)| monomial.powers() == [(unknown, 1)]);
        terms.map(|(_, value)| (coordinate, value.clone())).next()
    });
    let Some(first) = factors.next() else { return Some(field.one()) };
    let (coordinate, factor) =
        std::iter::once(first.clone()).chain(factors).find(|(c, _)| *c == 3).unwrap_or(first);
    let affine = &normal.unknowns[usize::from(unknown)];
    let own =
        field.rational(Integer::from_bigint(affine.unit.numer()), Integer::from_bigint(affine.unit.denom()));
    let weight =
        normal.frame.known.iter().find_map(|point| point.weight.clone()).unwrap_or_else(|| field.one());
    let length = if coordinate == 3 { BigRational::one() } else { length(&normal.frame) };
    let length = field.rational(Integer::from_bigint(length.numer()), Integer::from_bigint(length.denom()));
    // The patch is written by y, which is the unknown over its unit.
    Some(&(&(&weight * &length) * &own) * &factor.inverse()?)
}

/// A length that the known points have in common: the greatest common divisor of the numerators of the differences of their
/// coordinates, over that of the denominators. 1/3 and 5/2 are compared with 1, 500/3 and 250 with 250, 0.001 and 0.002 with 0.001.
fn length(frame: &Frame) -> BigRational {
    let (mut numerators, mut denominators) = (BigInt::zero(), BigInt::zero());
    let Some((first, others)) = frame.known.split_first() else { return BigRational::one() };
    let differences =
        others.iter().flat_map(|point| point.place.iter().zip(&first.place).map(|(x, y)| x - y));
    for value in differences {
        for numerator in value.numerators().iter().filter(|numerator| !numerator.is_zero()) {
            let value = BigRational::new(numerator.to_bigint(), value.denominator().to_bigint());
            numerators = numerators.gcd(value.numer());
            denominators = denominators.gcd(value.denom());
        }
    }
    match numerators.is_positive() && denominators.is_positive() {
        true => BigRational::new(numerators, denominators),
        false => BigRational::one(),
    }
}
