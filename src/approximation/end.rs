//! One end of an enclosure: the extreme, the decimal beyond it, and the tree of boxes that shows it.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::boxes::Coefficients;
use super::enclosure::EnclosureError;
use super::extreme::{Extreme, largest};
use super::scene::Scene;
use super::touch::touching;
use super::tree::{NoTree, Shown, tree};
use crate::algebra::fixed;
use crate::algebra::{FieldElement, Integer};
use crate::certificate::{End, Quantity, Side, Units, decimal_value, spell_decimal};
use crate::control::Control;

/// Boxes before an enclosure is given up.
pub(super) const BOXES: usize = 200_000;
/// Bits beyond those that the decimals need: for the rounding of the subdivision, and for the places of the extremes.
const SPARE: u32 = 96;
/// By how many bits the extremes are known better than one unit of the last decimal, at first.
const FINER: u32 = 2;
/// Bits that small weights and large quotients may cost without more being taken.
const COMMON: u32 = 16;
/// How often the precision is raised: where a radius near 0 is bounded, or an extreme lies next to a decimal.
const LEVELS: u32 = 3;

/// How exactly an extreme is computed.
struct Precision {
    /// Bits of the quotient after the point.
    bits: u32,
    /// Below how many of these units nothing is told apart.
    slack: Integer,
    /// What is this near to a decimal is taken for it: the tree tells.
    tolerance: Integer,
}

impl Precision {
    fn of(places: u32, level: u32) -> Self {
        // 10 < 2^(10/3). The square of a unit at the second level: r² is that small where r is one unit.
        let needed = (places * 10 / 3) << level;
        let finer = FINER + 24 * level;
        let power = |bits: u32| Integer::one().shifted_left(bits);
        Precision { bits: needed + SPARE, slack: power(SPARE - finer), tolerance: power(SPARE / 2) }
    }
}

/// An end of the scene, whose W is positive and nowhere smaller than 2^−small.
pub(super) struct Search<'a> {
    pub(super) scene: &'a Scene,
    pub(super) side: Side,
    pub(super) places: u32,
    pub(super) small: u32,
    pub(super) control: &'a Control,
}

impl Search<'_> {
    /// The end with the best decimal, or where boxes do not show that, the one after it.
    pub(super) fn end(&self) -> Result<End, EnclosureError> {
        let outwards: i64 = if self.side == Side::Lower { -1 } else { 1 };
        let mut left = None;
        for level in 0..LEVELS {
            let precision = Precision::of(self.places, level);
            let (Extreme { at, value }, bits) = match self.extreme(&precision) {
                Ok(found) => found,
                Err(EnclosureError::TooFine(_)) if left.is_some() => break,
                Err(error) => return Err(error),
            };
            let bound = self.decimal(&precision, &value);
            // The decimal at the extreme as far as it is known; then the one after it.
            let at_most = if level == 0 { BOXES / 10 } else { BOXES };
            match self.tree(&bound, bits, at_most)? {
                Ok(tree) => {
                    if let Some(at) = self.reaching(&(&bound - outwards), [Some(&at), None])? {
                        return Ok(End { bound, at, tree });
                    }
                }
                Err(near) => {
                    let further = &bound + outwards;
                    if let Some(at) = self.attaining(&bound, &at, near.as_ref())?
                        && let Ok(tree) = self.tree(&further, bits, BOXES)?
                    {
                        return Ok(End { bound: further, at, tree });
                    }
                }
            }
            left = Some((bound, at));
        }
        let (bound, at) = left.ok_or(EnclosureError::TooFine(BOXES))?;
        let end = if self.side == Side::Lower { "least" } else { "greatest" };
        Err(EnclosureError::Unsettled {
            end,
            bound: spell_decimal(&bound, self.places),
            near: Box::new(self.scene.outer(&at)),
        })
    }

    /// A point (u, v) where the quantity is the decimal or outside it: near one of these, given by u′ and v′.
    fn attaining(
        &self,
        decimal: &Units,
        extreme: &[BigRational; 2],
        near: Option<&[BigRational; 2]>,
    ) -> Result<Option<[BigRational; 2]>, EnclosureError> {
        if let Some(at) = self.reaching(decimal, [Some(extreme), near])? {
            return Ok(Some(at));
        }
        let form = self.scene.beyond(self.side, &decimal_value(decimal, self.places));
        let touching = touching(&form, extreme, self.control)?;
        self.reaching(decimal, [touching.as_ref(), None])
    }

    /// A point (u, v) where the quantity is the decimal or outside it: one of these, given by u′ and v′, or a simple one nearby.
    fn reaching(
        &self,
        decimal: &Units,
        near: [Option<&[BigRational; 2]>; 2],
    ) -> Result<Option<[BigRational; 2]>, EnclosureError> {
        let inside = if self.side == Side::Lower { Ordering::Greater } else { Ordering::Less };
        let near = near.into_iter().flatten();
        for point in near.clone().cloned().chain(near.flat_map(|near| self.scene.simple(near))) {
            self.control.check()?;
            let point = self.scene.outer(&point);
            if self.scene.compare_decimal(&point, decimal, self.places) != inside {
                return Ok(Some(point));
            }
        }
        Ok(None)
    }

    /// The extreme of F/Wᵉ, times −1 for the least, and how many bits of F and Wᵉ it took.
    fn extreme(&self, precision: &Precision) -> Result<(Extreme, u32), EnclosureError> {
        let Scene { surface, power, bidegree, degree, .. } = self.scene;
        let signed = |value: &FieldElement| if self.side == Side::Lower { -value } else { value.clone() };
        let mut large = 0u32;
        loop {
            let bits = precision.bits + (degree * self.small + large).saturating_sub(COMMON);
            let numerator = surface.iter().map(|value| fixed(&signed(value), bits)).collect();
            let denominator = power.iter().map(|value| fixed(value, bits)).collect();
            let [numerator, denominator] =
                [numerator, denominator].map(|values| Coefficients { bidegree: *bidegree, values });
            let found =
                largest(numerator, denominator, precision.bits, &precision.slack, BOXES, self.control);
            let found = found.map_err(|why| match why {
                NoTree::Interrupted(why) => EnclosureError::Interrupted(why),
                _ => EnclosureError::TooFine(BOXES),
            })?;
            // A large quotient magnifies the rounding of its denominator.
            let length = u32::try_from(found.value.bits()).unwrap_or(u32::MAX).saturating_sub(precision.bits);
            if length <= large.max(COMMON) {
                return Ok((found, bits));
            }
            large = length;
        }
    }

    /// The decimal beyond an extreme, or at it.
    fn decimal(&self, precision: &Precision, extreme: &Integer) -> Units {
        let (bits, unit) = (precision.bits, Integer::from(10i64).power(self.places));
        let value = if self.side == Side::Lower { -extreme } else { extreme.clone() };
        // In units 2^−bits; for the radius √(1 + value).
        let size = match self.scene.quantity {
            Quantity::Ratio => value,
            Quantity::Radius => {
                let square = &Integer::one().shifted_left(bits) + &value;
                if square.is_negative() { Integer::zero() } else { square.shifted_left(bits).floor_sqrt() }
            }
        };
        let tolerance = &precision.tolerance;
        let bound = match self.side {
            // The ceiling of −x is −⌊x⌋.
            Side::Lower => (&(&size + tolerance) * &unit).shifted_right(bits),
            _ => -&(&(tolerance - &size) * &unit).shifted_right(bits),
        };
        bound.to_bigint()
    }

    /// The tree that shows a bound; without one, a point nearby.
    fn tree(
        &self,
        bound: &Units,
        bits: u32,
        at_most: usize,
    ) -> Result<Result<Vec<bool>, Option<[BigRational; 2]>>, EnclosureError> {
        if self.scene.quantity == Quantity::Radius && self.side == Side::Lower {
            if bound.is_negative() {
                return Ok(Err(None));
            }
            // No radius is negative: nothing is left to be shown.
            if bound.is_zero() {
                return Ok(Ok(vec![false]));
            }
        }
        let value = BigRational::new(bound.clone(), BigInt::from(10).pow(self.places));
        let form = self.scene.beyond(self.side, &value);
        match tree(&form, bits, Shown::NotNegative, at_most, self.control) {
            Ok(grown) => Ok(Ok(grown.tree)),
            Err(NoTree::Interrupted(why)) => Err(EnclosureError::Interrupted(why)),
            Err(NoTree::Fails { at, .. } | NoTree::Near(at)) => Ok(Err(Some(*at))),
            Err(NoTree::TooMany) => Ok(Err(None)),
        }
    }
}

/// How small the denominator may be, in bits.
pub(super) fn small(least: i64) -> u32 {
    u32::try_from(-least).unwrap_or(if least > 0 { 0 } else { u32::MAX })
}

#[cfg(test)]
mod tests {
    use num_traits::One;

    use super::*;

    #[test]
    fn a_unit_of_the_radius_is_told_apart_where_the_radius_is_zero() {
        for places in [1, 12, 100] {
            let precision = Precision::of(places, 1);
            let unit = BigInt::from(10).pow(2 * places);
            assert!(precision.slack.to_bigint() * unit < BigInt::one() << precision.bits, "{places}");
        }
    }
}
