//! The sign of an element of K, decided exactly.

use std::cmp::Ordering;

use super::convert::polynomial_to_exact;
use super::field::FieldElement;
use super::polynomial::Polynomial;
use crate::exact::{self, Radicands, Work};

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
    /// The sign, as the trusted part decides it. `None` where numbers grow beyond its limits.
    pub fn sign(&self) -> Option<Sign> {
        if self.is_zero() {
            return Some(Sign::Zero);
        }
        let signs: Vec<bool> =
            self.numerators().iter().filter(|n| !n.is_zero()).map(super::Integer::is_negative).collect();
        // All coordinates of one sign: nothing to compute.
        match (signs.contains(&true), signs.contains(&false)) {
            (true, false) => return Some(Sign::Negative),
            (false, true) => return Some(Sign::Positive),
            _ => {}
        }
        let field = Radicands::new(self.field().radicands().to_vec()).ok()?;
        let constant = polynomial_to_exact(&Polynomial::constant(self.clone())).ok()?;
        match exact::sign(&constant, &field, &mut Work::full()).ok()?? {
            Ordering::Less => Some(Sign::Negative),
            Ordering::Equal => Some(Sign::Zero),
            Ordering::Greater => Some(Sign::Positive),
        }
    }
}
