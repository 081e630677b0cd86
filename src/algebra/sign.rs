//! The sign of an element of K, decided exactly.

use super::field::FieldElement;
use super::fixed::{Magnitude, magnitude};

/// A sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sign {
    /// < 0.
    Negative,
    /// = 0.
    Zero,
    /// > 0.
    Positive,
}

impl FieldElement {
    /// The sign.
    pub fn sign(&self) -> Sign {
        let signs =
            |negative: bool| self.numerators().iter().any(|n| !n.is_zero() && n.is_negative() == negative);
        match (signs(true), signs(false)) {
            (false, false) => Sign::Zero,
            // All coordinates of one sign: nothing to compute.
            (true, false) => Sign::Negative,
            (false, true) => Sign::Positive,
            (true, true) => match magnitude(self) {
                None => Sign::Zero,
                Some(Magnitude { negative: true, .. }) => Sign::Negative,
                Some(Magnitude { negative: false, .. }) => Sign::Positive,
            },
        }
    }
}
