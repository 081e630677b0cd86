//! Numbers of K in fixed point, integers of units 2^−bits; and their signs, which these decide.

use super::field::FieldElement;
use super::integer::Integer;

/// value·2^bits, to less than two units.
pub fn fixed(value: &FieldElement, bits: u32) -> Integer {
    let field = value.field();
    // √n to enough places that the numerators do not magnify the error: it is below Σ|numerator| ≤ 16·2^longest units
    // of the last place, over a denominator of at least 2^(size − 1).
    let longest = value.numerators().iter().map(Integer::bits).max().unwrap_or(0);
    let size = value.denominator().bits();
    let extra = u32::try_from(longest.saturating_sub(size)).unwrap_or(u32::MAX) + 8;
    let places = bits + extra;
    let mut sum = Integer::zero();
    for (subset, numerator) in value.numerators().iter().enumerate().filter(|(_, n)| !n.is_zero()) {
        let root = match subset {
            0 => Integer::one().shifted_left(places),
            _ => field.under_root(subset).shifted_left(2 * places).floor_sqrt(),
        };
        sum += &(numerator * &root);
    }
    let (quotient, _) = sum.quotient_and_remainder(value.denominator());
    quotient.shifted_right(extra)
}

/// The sign and the size of a number that is not 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Magnitude {
    /// Whether it is below 0: exactly.
    pub negative: bool,
    /// |number| ≥ 2^exponent, and below four times that.
    pub exponent: i64,
}

/// The sign, decided exactly, and the size; `None` for 0.
///
/// What differs from 0 by more than the error of [`fixed`] has the sign that it shows, and every number but 0 does at some
/// precision: the loop ends.
pub fn magnitude(value: &FieldElement) -> Option<Magnitude> {
    if value.is_zero() {
        return None;
    }
    let mut bits = 64;
    loop {
        let rounded = fixed(value, bits);
        if rounded.bits() > 8 {
            let exponent = rounded.bits() as i64 - i64::from(bits) - 2;
            return Some(Magnitude { negative: rounded.is_negative(), exponent });
        }
        bits *= 2;
    }
}
