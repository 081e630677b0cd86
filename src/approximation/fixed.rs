//! Numbers of K in floating point.

use crate::algebra::{FieldElement, Magnitude, magnitude};

pub use crate::algebra::fixed;

/// The number as a double: 53 bits of it, however small it is.
pub(super) fn to_f64(value: &FieldElement) -> f64 {
    let Some(Magnitude { exponent, .. }) = magnitude(value) else { return 0.0 };
    let bits = u32::try_from(64 - exponent).unwrap_or(0).max(128);
    let scaled = fixed(value, bits);
    let excess = u32::try_from(scaled.bits().saturating_sub(62)).unwrap_or(u32::MAX);
    let leading = scaled.shifted_right(excess).to_i64().unwrap_or(0);
    let power = (i64::from(excess) - i64::from(bits)).clamp(-4000, 4000) as i32;
    // In two steps: a power of two by itself may be beyond the range that the number is in.
    leading as f64 * 2f64.powi(power / 2) * 2f64.powi(power - power / 2)
}
