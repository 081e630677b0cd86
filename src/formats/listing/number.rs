//! Integers and decimals, exactly as they are spelled.

use num_bigint::BigInt;
use num_rational::BigRational;

use super::error::ListingFault;
use crate::exact::{Limit, limits};

/// How many digits a text starts with.
pub(super) fn digits_at(text: &str) -> usize {
    text.bytes().take_while(u8::is_ascii_digit).count()
}

/// The number a text starts with (a digit is there), and its length in bytes.
pub(super) fn number_at(text: &str) -> Result<(BigRational, usize), ListingFault> {
    let whole = digits_at(text);
    let decimals = text[whole..].strip_prefix('.').map_or(0, digits_at);
    if whole + decimals > limits::DIGITS {
        return Err(Limit::digits().into());
    }
    let length = if decimals > 0 { whole + 1 + decimals } else { whole };
    let after = &text[length..];
    if after.starts_with(',') && digits_at(&after[1..]) > 0 || after.starts_with("{,}") {
        return Err(ListingFault::DecimalComma);
    }
    let spelled: String = text[..length].chars().filter(char::is_ascii_digit).collect();
    let value: BigInt = spelled.parse().expect("digits");
    let scale = BigInt::from(10).pow(decimals as u32);
    Ok((BigRational::new(value, scale), length))
}
