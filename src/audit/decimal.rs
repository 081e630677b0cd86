//! Printed decimals, and decimals of elements of K whose digits are all right.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::algebra::{MultiquadraticField, polynomial_from_exact};
use crate::approximation::fixed;
use crate::exact::{Arithmetic, Limit, Polynomial, Radicands, Work};

/// A printed decimal: what it spells, and by how much the number meant may differ.
#[derive(Debug, Clone)]
pub(super) struct Decimal {
    pub(super) value: BigRational,
    /// Half a unit of the last place; 0 for one without a decimal point, which is meant exactly.
    pub(super) tolerance: BigRational,
}

impl Decimal {
    /// Of a text of digits with an optional sign and point.
    pub(super) fn read(text: &str) -> Self {
        let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len() as u32);
        let digits: String = text.chars().filter(|&c| c != '.').collect();
        let unit = BigRational::new(BigInt::one(), BigInt::from(10).pow(decimals));
        let value = BigRational::from_integer(digits.parse().unwrap_or_default()) * &unit;
        let half = BigRational::new(BigInt::one(), BigInt::from(2));
        Decimal { value, tolerance: if decimals > 0 { unit * half } else { BigRational::zero() } }
    }

    /// Whether a constant of K is what was meant.
    pub(super) fn is_close_to(&self, exact: &Polynomial, field: &Radicands) -> Result<bool, Limit> {
        let above = compare(exact, &(&self.value + &self.tolerance), field)? != Ordering::Greater;
        Ok(above && compare(exact, &(&self.value - &self.tolerance), field)? != Ordering::Less)
    }
}

/// How a constant of K compares with a rational.
pub(super) fn compare(exact: &Polynomial, with: &BigRational, field: &Radicands) -> Result<Ordering, Limit> {
    let mut work = Work::full();
    let arithmetic = &mut Arithmetic::new(field, &mut work);
    let difference = arithmetic.difference(exact, &Polynomial::rational(with.clone()))?;
    Ok(arithmetic.sign(&difference)?.unwrap_or(Ordering::Equal))
}

/// The decimal of a constant of K, cut off (towards zero) after some places.
///
/// # Errors
/// Where a number on the way exceeds what the formats allow.
pub fn decimal(exact: &Polynomial, places: u32, field: &Radicands) -> Result<String, Limit> {
    let negative = compare(exact, &BigRational::zero(), field)? == Ordering::Less;
    let size = if negative { exact.negate() } else { exact.clone() };
    let unit = BigInt::from(10).pow(places);
    let below = |n: &BigInt| {
        let bound = BigRational::new(n.clone(), unit.clone());
        Ok(compare(&size, &bound, field)? != Ordering::Less)
    };
    let mut digits = guess(&size, places, field);
    if !below(&digits)? && digits.is_positive() {
        digits -= 1;
    }
    if !below(&digits)? || below(&(&digits + BigInt::one()))? {
        digits = largest(below)?;
    }
    Ok(spelled(&digits, places, negative))
}

/// The digits in fixed point with some bits to spare, rounded up a little: right, or one too large where the number is just below a
/// decimal; decided exactly by who asks.
fn guess(size: &Polynomial, places: u32, field: &Radicands) -> BigInt {
    let value = polynomial_from_exact(MultiquadraticField::new(field.values()), size).as_constant();
    let bits = 4 * places + 64;
    let digits = value.map(|value| {
        ((fixed(&value, bits).to_bigint() + BigInt::from(256)) * BigInt::from(10).pow(places)) >> bits
    });
    digits.filter(|digits| !digits.is_negative()).unwrap_or_default()
}

/// The largest n ≥ 0 for which a decreasing property holds; it holds for 0.
fn largest(holds: impl Fn(&BigInt) -> Result<bool, Limit>) -> Result<BigInt, Limit> {
    let mut high = BigInt::one();
    while holds(&high)? {
        high *= 2;
    }
    let mut low = BigInt::zero();
    while &high - &low > BigInt::one() {
        let middle = (&low + &high) / 2;
        if holds(&middle)? {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok(low)
}

fn spelled(digits: &BigInt, places: u32, negative: bool) -> String {
    let unit = BigInt::from(10).pow(places);
    let (whole, rest) = (digits / &unit, (digits % &unit).abs());
    let sign = if negative && !digits.is_zero() { "−" } else { "" };
    match places {
        0 => format!("{sign}{whole}"),
        _ => format!("{sign}{whole}.{rest:0>width$}", rest = rest.to_string(), width = places as usize),
    }
}
