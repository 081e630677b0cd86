//! F, W and Wᵉ along a patch whose unknowns have values: exactly, at one scale whatever the net is multiplied by.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::enclosure::{EnclosureError, patch_at, quantity_of};
use super::exactly::ExactForm;
use crate::algebra::{FieldElement, Integer, MultiquadraticField};
use crate::algebra::{Magnitude, magnitude};
use crate::bezier::surface_condition_within;
use crate::certificate::{Quantity, Side, Units, decimal_value};
use crate::control::Control;
use crate::exact::Polynomial;
use crate::prove::field_of;
use crate::statement::{Patch, Statement};

/// Bits of the numbers in 1/W at the first corner, beyond which only its size is divided out.
const LONG: u64 = 1 << 13;

/// F, W and Wᵉ along a patch: the net is divided by its first weight.
#[derive(Debug, Clone)]
pub(super) struct Scene {
    field: MultiquadraticField,
    pub(super) quantity: Quantity,
    /// e, the degree of the surface.
    pub(super) degree: u32,
    pub(super) weight: ExactForm,
    /// Of both forms below.
    pub(super) bidegree: (usize, usize),
    pub(super) surface: Vec<FieldElement>,
    pub(super) power: Vec<FieldElement>,
}

impl Scene {
    /// The patch of a statement at these values, if its first weight is positive.
    pub(super) fn of(
        statement: &Statement,
        values: &[Polynomial],
        control: &Control,
    ) -> Result<Self, EnclosureError> {
        let quantity = quantity_of(statement).ok_or(EnclosureError::NotAPatch)?;
        let patch = patch_at(statement, values)?;
        let field = field_of(statement);
        let along = |surface: Polynomial| {
            surface_condition_within(field, &Patch { surface, ..patch.clone() }, control)
                .map(|form| form.constants())
        };
        let degree = patch.surface.degree();
        let weights = along(Polynomial::variable(3))?;
        let scale = match weights.first().and_then(magnitude) {
            Some(Magnitude { negative: false, exponent }) => unit(&weights[0], exponent),
            found => {
                let origin = Box::new([BigRational::zero(), BigRational::zero()]);
                return Err(EnclosureError::Denominator {
                    at: origin,
                    zero: found.is_none(),
                    vanishes: false,
                });
            }
        };
        let times = |values: Vec<FieldElement>, factor: &FieldElement| -> Vec<FieldElement> {
            if factor.is_one() { values } else { values.iter().map(|value| value * factor).collect() }
        };
        let to_degree = (0..degree).fold(field.one(), |power, _| &power * &scale);
        let power = Polynomial::variable(3).power(degree, statement.field(), &mut control.work())?;
        let size = |(m, n): (u32, u32), times: u32| ((m * times) as usize, (n * times) as usize);
        Ok(Scene {
            field,
            quantity,
            degree,
            weight: ExactForm::new(field, size(patch.bidegree, 1), times(weights, &scale)),
            bidegree: size(patch.bidegree, degree),
            surface: times(along(patch.surface.clone())?, &to_degree),
            power: times(along(power)?, &to_degree),
        })
    }

    /// F − bound·Wᵉ for a lower bound, bound·Wᵉ − F for an upper one.
    pub(super) fn beyond(&self, side: Side, bound: &BigRational) -> ExactForm {
        let threshold = self.number(&on_ratio(self.quantity, bound));
        let difference = |(surface, power): (&FieldElement, &FieldElement)| {
            let beyond = surface - &(&threshold * power);
            if side == Side::Lower { beyond } else { -&beyond }
        };
        let values = self.surface.iter().zip(&self.power).map(difference).collect();
        ExactForm::new(self.field, self.bidegree, values)
    }

    /// How the quantity at a point of the square compares with a bound, exactly; for a patch with W > 0.
    pub(super) fn compare(&self, at: &[BigRational; 2], bound: &BigRational) -> Ordering {
        if self.quantity == Quantity::Radius && bound.is_negative() {
            return Ordering::Greater;
        }
        let difference = self.beyond(Side::Lower, bound).at(at);
        magnitude(&difference).map_or(Ordering::Equal, |found| match found.negative {
            true => Ordering::Less,
            false => Ordering::Greater,
        })
    }

    /// Likewise, with a decimal.
    pub(super) fn compare_decimal(&self, at: &[BigRational; 2], bound: &Units, places: u32) -> Ordering {
        self.compare(at, &decimal_value(bound, places))
    }

    fn number(&self, value: &BigRational) -> FieldElement {
        self.field.rational(Integer::from_bigint(value.numer()), Integer::from_bigint(value.denom()))
    }
}

/// r² − 1 for a radius r.
fn on_ratio(quantity: Quantity, value: &BigRational) -> BigRational {
    match quantity {
        Quantity::Radius => value * value - BigRational::one(),
        Quantity::Ratio => value.clone(),
    }
}

/// What the net is multiplied by: 1/W at the first corner, or where that is long, a power of two near it.
fn unit(weight: &FieldElement, exponent: i64) -> FieldElement {
    let inverse = weight.inverse().filter(|inverse| {
        let numbers = inverse.numerators().iter().chain([inverse.denominator()]);
        numbers.map(Integer::bits).max().unwrap_or(0) <= LONG
    });
    inverse.unwrap_or_else(|| {
        let size = Integer::from_bigint(&(BigInt::one() << exponent.unsigned_abs()));
        let (above, below) = if exponent < 0 { (size, Integer::one()) } else { (Integer::one(), size) };
        weight.field().rational(above, below)
    })
}
