//! Printed intervals held against proved bounds.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use super::enclosure::{Enclosure, EnclosureError};
use super::point::{decimal_at, simple_point_beyond};
use super::scene::Scene;
use crate::certificate::{Side, decimal_value, spell_decimal};
use crate::control::Control;
use crate::statement::Statement;

/// One end of a printed interval, judged.
#[derive(Debug, Clone)]
pub struct EndVerdict {
    /// The bound as it is printed.
    pub printed: String,
    /// `≤` or `≥`.
    pub relation: &'static str,
    /// How it comes out.
    pub finding: Finding,
}

/// How a printed bound comes out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Finding {
    /// It is a bound as it stands.
    Bound,
    /// It is one to the digits printed: the true bound lies beyond it by at most half a unit of its last place.
    Rounded,
    /// It is none: at this point the quantity is this, cut off.
    Fails {
        /// (u, v).
        at: [BigRational; 2],
        /// The quantity there.
        value: String,
    },
    /// The true bound agrees with it to all places that were computed.
    Open,
}

/// Holds a printed interval `[low, high]`, two decimals, against proved bounds.
///
/// # Errors
/// Where a number on the way exceeds what the formats allow.
pub fn judge(
    statement: &Statement,
    enclosure: &Enclosure,
    claim: &[String; 2],
) -> Result<Vec<EndVerdict>, EnclosureError> {
    let bounds = &enclosure.bounds;
    let scene = Scene::of(statement, &bounds.values, &Control::default())?;
    let proved = [&bounds.lower.bound, &bounds.upper.bound].map(|units| decimal_value(units, bounds.places));
    let unit = decimal_value(&BigInt::one(), bounds.places);
    let ends = [
        ("≥", Side::Lower, &claim[0], &bounds.lower, &proved[0]),
        ("≤", Side::Upper, &claim[1], &bounds.upper, &proved[1]),
    ];
    let mut verdicts = Vec::new();
    for (relation, side, text, end, bound) in ends {
        let (value, half) = printed(text);
        let outwards = BigRational::from_integer(if side == Side::Upper { 1 } else { -1 }.into());
        let beyond = (bound - &value) * outwards;
        let finding = if beyond <= BigRational::default() {
            Finding::Bound
        } else if beyond <= half {
            Finding::Rounded
        } else if beyond > &half + &unit {
            // The quantity comes within a unit of the bound. Not just outside: half way to the true bound at least.
            let limit = (&value + bound) / BigRational::from_integer(2.into());
            let at = simple_point_beyond(&scene, side, &limit, &end.at);
            let within = [&proved[0], &proved[1]];
            let shown = decimal_at(&scene, &at, bounds.places, within);
            let units = (shown / &unit).to_integer();
            Finding::Fails { at, value: spell_decimal(&units, bounds.places) }
        } else {
            Finding::Open
        };
        verdicts.push(EndVerdict { printed: text.clone(), relation, finding });
    }
    Ok(verdicts)
}

/// What a printed decimal spells, and half a unit of its last place; nothing for one without a point, which is meant exactly.
fn printed(text: &str) -> (BigRational, BigRational) {
    let decimals = text.split_once('.').map(|(_, decimals)| decimals.len() as u32);
    let digits: String = text.chars().filter(|&c| c != '.').collect();
    let unit = BigRational::new(BigInt::one(), BigInt::from(10).pow(decimals.unwrap_or(0)));
    let value = BigRational::from_integer(digits.parse().unwrap_or_default()) * &unit;
    let half = unit / BigRational::from_integer(2.into());
    (value, if decimals.is_some() { half } else { BigRational::default() })
}
