//! Sizes of numbers of K, however small or large: a mantissa in floating point and a power of two.

use crate::algebra::FieldElement;
use crate::algebra::fixed;

/// Bits beyond which a number that is not zero is no longer told from zero; no number of a statement is so small.
const BITS: u32 = 1 << 20;

/// (m, e) with the number near m·2ᵉ and 1/2 ≤ |m| ≤ 1, relative error 2⁻⁵³; (0, 0) for zero.
pub(super) fn parts(value: &FieldElement) -> (f64, i64) {
    let mut bits = 128;
    while !value.is_zero() && bits <= BITS {
        let fixed = fixed(value, bits);
        let length = fixed.bits();
        // Of these bits a few of the last are uncertain.
        if length >= 72 {
            let excess = u32::try_from(length - 62).unwrap_or(u32::MAX);
            let leading = fixed.shifted_right(excess).to_i64().unwrap_or(0);
            return (leading as f64 / 2f64.powi(62), i64::from(excess) + 62 - i64::from(bits));
        }
        bits *= 2;
    }
    (0.0, 0)
}

/// The number times 2^exponent, as a double.
pub(super) fn scaled(value: &FieldElement, exponent: i64) -> f64 {
    let (mantissa, own) = parts(value);
    mantissa * power_of_two(own.saturating_add(exponent))
}

/// log₂ of the absolute value; nothing for zero.
pub(super) fn log2(value: &FieldElement) -> Option<f64> {
    let (mantissa, exponent) = parts(value);
    (mantissa != 0.0).then(|| mantissa.abs().log2() + exponent as f64)
}

/// 2ᵉ, 0 or infinite where a double does not reach.
pub(super) fn power_of_two(exponent: i64) -> f64 {
    2f64.powi(exponent.clamp(-1100, 1100) as i32)
}
