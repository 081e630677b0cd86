//! F, W and Wᵉ along a patch whose unknowns have values: exactly, at one scale and in one parametrisation, whatever those of the
//! net are.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::contact::candidates;
use super::enclosure::{EnclosureError, patch_at, quantity_of};
use super::exactly::ExactForm;
use crate::algebra::{FieldElement, Integer, MultiquadraticField};
use crate::algebra::{Magnitude, magnitude};
use crate::bezier::surface_condition_within;
use crate::certificate::{Quantity, Side, Units, decimal_value};
use crate::control::Control;
use crate::exact::{Arithmetic, Polynomial};
use crate::problem::field_of;
use crate::statement::{Patch, Statement};

/// Bits of the numbers in 1/W at the first corner, beyond which only its size is divided out.
const LONG: u64 = 1 << 13;

/// Weights that change by less than this power of two from row to row are left as they are.
const LITTLE: f64 = 2.0;

/// F, W and Wᵉ along a patch: the net is divided by its first weight, and the parameters u′, v′ are those in which weights
/// change least over the square.
#[derive(Debug, Clone)]
pub(super) struct Scene {
    field: MultiquadraticField,
    pub(super) quantity: Quantity,
    /// u/(1 − u) over u′/(1 − u′), and for v likewise: powers of two.
    pub(super) odds: [BigRational; 2],
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
        let exponents = balance(&weights, patch.bidegree);
        let [of_u, of_v] = exponents;
        // In the other parameters the coefficient (r, s) is multiplied by the odds to these powers.
        let balanced = |values: Vec<FieldElement>, n: u32| -> Vec<FieldElement> {
            let places = (0..).map(|k: i64| (k / (i64::from(n) + 1), k % (i64::from(n) + 1)));
            let exponent = |(r, s): (i64, i64)| of_u * r + of_v * s;
            values.into_iter().zip(places.map(exponent)).map(|(value, e)| shifted(&value, e)).collect()
        };
        let n = patch.bidegree.1;
        let to_degree = (0..degree).fold(field.one(), |power, _| &power * &scale);
        let power = Arithmetic::new(statement.field(), &mut control.work())
            .power(&Polynomial::variable(3), degree)?;
        let size = |(m, n): (u32, u32), times: u32| ((m * times) as usize, (n * times) as usize);
        Ok(Scene {
            field,
            quantity,
            degree,
            odds: exponents.map(power_of_two),
            weight: ExactForm::new(field, size(patch.bidegree, 1), balanced(times(weights, &scale), n)),
            bidegree: size(patch.bidegree, degree),
            surface: balanced(times(along(patch.surface.clone())?, &to_degree), n * degree),
            power: balanced(times(along(power)?, &to_degree), n * degree),
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

    /// The point (u, v) with parameters (u′, v′).
    pub(super) fn outer(&self, [u, v]: &[BigRational; 2]) -> [BigRational; 2] {
        let [of_u, of_v] = &self.odds;
        [moved(u, of_u), moved(v, of_v)]
    }

    /// The parameters (u′, v′) of a point (u, v).
    pub(super) fn inner(&self, [u, v]: &[BigRational; 2]) -> [BigRational; 2] {
        let [of_u, of_v] = &self.odds;
        [moved(u, &of_u.recip()), moved(v, &of_v.recip())]
    }

    /// Points (u′, v′) near one, simple in these or in the net's own parameters.
    pub(super) fn simple(&self, near: &[BigRational; 2]) -> Vec<[BigRational; 2]> {
        let mut points = candidates(near);
        if self.odds.iter().any(|odds| !odds.is_one()) {
            points.extend(candidates(&self.outer(near)).iter().map(|point| self.inner(point)));
        }
        points
    }

    /// How the quantity at a point (u, v) of the square compares with a bound, exactly; for a patch with W > 0.
    pub(super) fn compare(&self, at: &[BigRational; 2], bound: &BigRational) -> Ordering {
        if self.quantity == Quantity::Radius && bound.is_negative() {
            return Ordering::Greater;
        }
        let difference = self.beyond(Side::Lower, bound).at(&self.inner(at));
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

/// λx/(1 − x + λx): the number from 0 to 1 whose odds are λ times those of x.
fn moved(x: &BigRational, odds: &BigRational) -> BigRational {
    if odds.is_one() {
        return x.clone();
    }
    let above = x * odds;
    let below = BigRational::one() - x + &above;
    above / below
}

/// 2ᵉ.
fn power_of_two(exponent: i64) -> BigRational {
    let size = BigInt::one() << exponent.unsigned_abs();
    if exponent < 0 { BigRational::new(BigInt::one(), size) } else { BigRational::from_integer(size) }
}

/// A number times 2ᵉ.
fn shifted(value: &FieldElement, exponent: i64) -> FieldElement {
    if exponent == 0 {
        return value.clone();
    }
    let factor = power_of_two(exponent);
    let [above, below] = [factor.numer(), factor.denom()].map(Integer::from_bigint);
    value * &value.field().rational(above, below)
}

/// Exponents of two for the odds of u and v that make the weights as equal as can be, by least squares of their logarithms;
/// 0 where that would change little.
fn balance(weights: &[FieldElement], (_, n): (u32, u32)) -> [i64; 2] {
    let columns = n as usize + 1;
    let points: Vec<[f64; 3]> = weights
        .iter()
        .enumerate()
        .filter_map(|(k, weight)| {
            let exponent = magnitude(weight).filter(|found| !found.negative)?.exponent;
            Some([(k / columns) as f64, (k % columns) as f64, exponent as f64])
        })
        .collect();
    let mean = |k: usize| points.iter().map(|point| point[k]).sum::<f64>() / points.len().max(1) as f64;
    let means = [mean(0), mean(1), mean(2)];
    let product = |k: usize, l: usize| -> f64 {
        points.iter().map(|point| (point[k] - means[k]) * (point[l] - means[l])).sum()
    };
    let (uu, uv, vv, ul, vl) = (product(0, 0), product(0, 1), product(1, 1), product(0, 2), product(1, 2));
    let determinant = uu * vv - uv * uv;
    if determinant < 1e-6 {
        return [0, 0];
    }
    let slopes = [(ul * vv - vl * uv) / determinant, (vl * uu - ul * uv) / determinant];
    slopes.map(|slope| if slope.abs() < LITTLE { 0 } else { -(slope.round() as i64) })
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
