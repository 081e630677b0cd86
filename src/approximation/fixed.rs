//! Numbers of K in fixed point: integers of units 2^−bits.
//!
//! What is computed with these is a guess with many digits. The checker decides exactly.

use crate::algebra::{FieldElement, Integer};

/// ⌊value·2^bits⌋, but for a few units.
pub fn fixed(value: &FieldElement, bits: u32) -> Integer {
    let field = value.field();
    // √n to enough places that the numerators do not magnify the error.
    let longest = value.numerators().iter().map(Integer::bits).max().unwrap_or(0);
    let size = value.denominator().bits();
    let extra = u32::try_from(longest.saturating_sub(size)).unwrap_or(u32::MAX).min(1 << 16) + 8;
    let places = bits + extra;
    let mut sum = Integer::zero();
    for (subset, numerator) in value.numerators().iter().enumerate().filter(|(_, n)| !n.is_zero()) {
        let root = field.under_root(subset).shifted_left(2 * places).floor_sqrt();
        sum += &(numerator * &root);
    }
    let (quotient, _) = sum.quotient_and_remainder(value.denominator());
    quotient.shifted_right(extra)
}

/// The number as a double.
pub(super) fn to_f64(value: &FieldElement) -> f64 {
    // 128 bits, and of these the leading 53.
    let scaled = fixed(value, 128);
    let excess = u32::try_from(scaled.bits().saturating_sub(62)).unwrap_or(u32::MAX);
    let leading = scaled.shifted_right(excess).to_i64().unwrap_or(0);
    leading as f64 * 2f64.powi(excess as i32 - 128)
}
