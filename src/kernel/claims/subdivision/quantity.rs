//! What is bounded, and decimals.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::Rejection;
use crate::claims::wording;
use crate::exact::{Limit, Work};
use crate::failure::{At, Failure, Place};
use crate::statement::{Statement, Subject};

/// What is bounded, along a patch with denominator W > 0 on a surface F = 0 of degree e.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// r = √(x² + y² + z²), for the unit sphere only, where F/W² = r² − 1.
    Radius,
    /// F/Wᵉ.
    Ratio,
}

impl Quantity {
    /// What F is; nothing for a radius.
    pub(in crate::claims) fn meaning(self, statement: &Statement) -> String {
        match (self, statement.subject()) {
            (Quantity::Ratio, Subject::Patch(patch)) => {
                format!(", for F = {}", wording::written(&statement.coordinate_ring(), &patch.surface))
            }
            _ => String::new(),
        }
    }

    /// As sentences name it: `F/W²`.
    pub(in crate::claims) fn name(self, statement: &Statement) -> String {
        match (self, statement.subject()) {
            (Quantity::Ratio, Subject::Patch(patch)) => {
                format!("F/W{}", wording::exponent(patch.surface.degree()))
            }
            _ => "√(x² + y² + z²)".to_owned(),
        }
    }
}

/// A decimal with a fixed number of places, as an integer of units of the last one.
pub type Units = BigInt;

/// A decimal as it is spelled: a sign, digits, and a point with all places after it (none for no places).
pub fn spell_decimal(units: &Units, places: u32) -> String {
    let width = usize::try_from(places).unwrap_or(usize::MAX);
    let digits = units.magnitude().to_string();
    let sign = if *units < BigInt::zero() { "-" } else { "" };
    let missing = width.saturating_add(1).saturating_sub(digits.len());
    let padded: String = std::iter::repeat_n('0', missing).chain(digits.chars()).collect();
    match padded.split_at_checked(padded.len().saturating_sub(width)) {
        Some((whole, decimals)) if width > 0 => format!("{sign}{whole}.{decimals}"),
        _ => format!("{sign}{padded}"),
    }
}

/// The bound on F/Wᵉ that a stated bound means.
pub(in crate::claims) fn threshold(
    quantity: Quantity,
    bound: &Units,
    places: u32,
    work: &mut Work,
) -> Result<BigRational, Failure<Rejection>> {
    match quantity == Quantity::Radius && bound.is_negative() {
        true => Err(Rejection::NegativeRadius.into()),
        false => on_ratio(quantity, bound, places, work).at(Place::Values),
    }
}

/// The same for a bound that may be negative: r² − 1 for a radius r.
pub(in crate::claims) fn on_ratio(
    quantity: Quantity,
    bound: &Units,
    places: u32,
    work: &mut Work,
) -> Result<BigRational, Limit> {
    let value = work.decimal(bound, places)?;
    match quantity {
        Quantity::Radius => work.square_less_one(&value),
        Quantity::Ratio => Ok(value),
    }
}
