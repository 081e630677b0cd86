//! Rounded numbers in sentences: always in the direction in which the sentence stays true.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::certificate::spell_decimal;

/// Which way a number is rounded: a lower bound down, an upper bound up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Towards {
    /// What is printed is not above the number.
    Below,
    /// What is printed is not below the number.
    Above,
}

/// 1.2346·10⁻⁵ with so many decimals, or 12.346 with as many digits, exactly rounded.
pub fn rounded(value: &BigRational, decimals: u32, towards: Towards) -> String {
    if value.is_zero() {
        return "0".to_owned();
    }
    let mut exponent = floor_log10(&value.abs());
    let one = power_of_ten(i64::from(decimals));
    let mut units = in_units(value, exponent - i64::from(decimals), towards);
    // 9.99… up to 10, or −9.99… down to −10.
    if BigRational::from_integer(units.abs()) >= &one * BigInt::from(10) {
        exponent += 1;
        units = in_units(value, exponent - i64::from(decimals), towards);
    }
    // With so many digits before the point at most, a number is written without a power.
    if let Ok(whole) = u32::try_from(exponent)
        && whole <= decimals
    {
        return spell_decimal(&units, decimals - whole).replace('-', "−");
    }
    let mantissa = spell_decimal(&units, decimals).replace('-', "−");
    format!("{mantissa}·10{}", raised(exponent))
}

/// ⁻⁵.
fn raised(exponent: i64) -> String {
    let digit = |c: char| match c {
        '-' => '⁻',
        c => "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(c as usize - '0' as usize).unwrap_or(c),
    };
    exponent.to_string().chars().map(digit).collect()
}

/// The number in units of 10ᵉ.
fn in_units(value: &BigRational, exponent: i64, towards: Towards) -> BigInt {
    let scaled = value / power_of_ten(exponent);
    match towards {
        Towards::Below => scaled.floor().to_integer(),
        Towards::Above => scaled.ceil().to_integer(),
    }
}

/// ⌊log₁₀⌋ of a positive number.
fn floor_log10(value: &BigRational) -> i64 {
    let bits = value.numer().bits() as f64 - value.denom().bits() as f64;
    let mut exponent = (bits * std::f64::consts::LOG10_2).floor().to_i64().unwrap_or(0) - 1;
    while &power_of_ten(exponent + 1) <= value {
        exponent += 1;
    }
    exponent
}

/// 10ⁿ.
fn power_of_ten(exponent: i64) -> BigRational {
    let size = BigInt::from(10).pow(u32::try_from(exponent.unsigned_abs()).unwrap_or(u32::MAX));
    if exponent < 0 { BigRational::new(BigInt::one(), size) } else { BigRational::from_integer(size) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(text: &str, decimals: u32) -> [String; 2] {
        let (digits, exponent) = text.split_once('e').unwrap();
        let value =
            BigRational::from_integer(digits.parse().unwrap()) * power_of_ten(exponent.parse().unwrap());
        [Towards::Below, Towards::Above].map(|towards| rounded(&value, decimals, towards))
    }

    #[test]
    fn bounds_are_rounded_outwards_at_every_size() {
        assert_eq!(at("60217819e-12", 4), ["6.0217·10⁻⁵", "6.0218·10⁻⁵"]);
        assert_eq!(at("-60217819e-12", 4), ["−6.0218·10⁻⁵", "−6.0217·10⁻⁵"]);
        assert_eq!(at("999999e-6", 2), ["9.99·10⁻¹", "1.00"]);
        assert_eq!(at("-999999e-6", 2), ["−1.00", "−9.99·10⁻¹"]);
        assert_eq!(at("3e1", 0), ["3·10¹", "3·10¹"]);
        assert_eq!(at("301091281e-7", 7), ["30.109128", "30.109129"]);
        assert_eq!(at("-301091281e-7", 7), ["−30.109129", "−30.109128"]);
        assert_eq!(at("1e-400", 1), ["1.0·10⁻⁴⁰⁰", "1.0·10⁻⁴⁰⁰"]);
        assert_eq!(at("0e0", 3), ["0", "0"]);
    }
}
