//! The scale of a patch: how long the object is, how large its weights are, and how large F/Wᵉ is for a patch that is off by its length.

use crate::algebra::{FieldElement, MultiquadraticField, polynomial_from_exact};
use crate::exact::Polynomial;
use crate::statement::{HomogeneousPoint, Patch};

use super::size::{log2, power_of_two, scaled};

/// A control point whose place is known: its Cartesian coordinates, exactly, and its weight if that is known too.
#[derive(Debug, Clone)]
pub(super) struct KnownPoint {
    pub(super) place: [FieldElement; 3],
    pub(super) weight: Option<FieldElement>,
}

/// Sizes, as logarithms to the base 2.
#[derive(Debug, Clone)]
pub(super) struct Frame {
    pub(super) known: Vec<KnownPoint>,
    /// The centroid of the known points.
    pub(super) centre: [f64; 3],
    /// Of the mean distance from it.
    pub(super) length: f64,
    /// Of the known weights, their geometric mean.
    pub(super) weight: f64,
    /// Of F/Wᵉ: half the gradient at the known points, times the length. 0 or so for a unit sphere and a patch of its size.
    pub(super) ratio: f64,
}

impl Frame {
    pub(super) fn of(field: MultiquadraticField, patch: &Patch) -> Self {
        let points = patch.net.iter().flatten();
        let known: Vec<KnownPoint> = points.filter_map(|point| known_point(field, point)).collect();
        let places: Vec<[f64; 3]> =
            known.iter().map(|point| point.place.each_ref().map(|x| scaled(x, 0))).collect();
        let count = places.len().max(1) as f64;
        let centre = std::array::from_fn(|k| places.iter().map(|place| place[k]).sum::<f64>() / count);
        let square =
            |place: &[f64; 3]| -> f64 { place.iter().zip(&centre).map(|(x, c)| (x - c).powi(2)).sum() };
        let spread = (places.iter().map(square).sum::<f64>() / count).sqrt();
        let surface = Surface::of(field, &patch.surface);
        // Points that differ by rounding only are one point.
        let far = centre.iter().fold(0.0f64, |most, c: &f64| most.max(c.abs()));
        let length =
            if spread > 1e-12 * far && spread.is_finite() { spread.log2() } else { surface.length() };
        let weights: Vec<f64> =
            known.iter().filter_map(|point| point.weight.as_ref().and_then(log2)).collect();
        let weight = weights.iter().sum::<f64>() / weights.len().max(1) as f64;
        let slopes = places.iter().map(|place| surface.slope(place));
        let slope = slopes.sum::<f64>() / count;
        let ratio = match slope > 0.0 && slope.is_finite() {
            true => slope.log2() - 1.0 + length,
            false => surface.leading() + f64::from(patch.surface.degree()) * length,
        };
        Frame { known, centre, length, weight, ratio }
    }
}

/// A point (a·m, b·m, c·m, d·m) with constants a to d and one power product m.
fn known_point(field: MultiquadraticField, point: &HomogeneousPoint) -> Option<KnownPoint> {
    let entries = point.each_ref().map(|entry| polynomial_from_exact(field, entry));
    let [(monomial, weight)] = entries[3].terms() else { return None };
    let inverse = weight.inverse()?;
    let mut place = [field.zero(), field.zero(), field.zero()];
    for (to, entry) in place.iter_mut().zip(&entries) {
        match entry.terms() {
            [] => {}
            [(same, value)] if same == monomial => *to = value * &inverse,
            _ => return None,
        }
    }
    Some(KnownPoint { place, weight: (monomial.degree() == 0).then(|| weight.clone()) })
}

/// F in floating point: exponents of X, Y, Z and the logarithm and sign of the coefficient, with W = 1.
struct Surface {
    terms: Vec<([i32; 3], f64, f64)>,
    degree: i32,
}

impl Surface {
    fn of(field: MultiquadraticField, surface: &Polynomial) -> Self {
        let all = polynomial_from_exact(field, surface);
        let term = |(monomial, value): &(crate::algebra::Monomial, FieldElement)| {
            let exponents = std::array::from_fn(|k| monomial.exponent(k as u16) as i32);
            let (mantissa, _) = super::size::parts(value);
            Some((exponents, log2(value)?, mantissa.signum()))
        };
        let terms = all.terms().iter().filter_map(term).collect();
        Surface { terms, degree: surface.degree() as i32 }
    }

    /// The largest coefficient of each degree in X, Y, Z.
    fn of_degree(&self, degree: i32) -> Option<f64> {
        let same = self.terms.iter().filter(|(exponents, ..)| exponents.iter().sum::<i32>() == degree);
        same.map(|(_, size, _)| *size).reduce(f64::max)
    }

    fn leading(&self) -> f64 {
        self.of_degree(self.degree).unwrap_or(0.0)
    }

    /// How far out the highest terms outweigh the others: the radius, for a sphere around the origin.
    fn length(&self) -> f64 {
        let Some(leading) = self.of_degree(self.degree) else { return 0.0 };
        let others = (0..self.degree)
            .filter_map(|degree| Some((self.of_degree(degree)? - leading) / f64::from(self.degree - degree)));
        others.reduce(f64::max).unwrap_or(0.0)
    }

    /// The length of the gradient.
    fn slope(&self, place: &[f64; 3]) -> f64 {
        let by = |axis: usize| -> f64 {
            let terms = self.terms.iter().filter(|(exponents, ..)| exponents[axis] > 0);
            let values = terms.map(|(exponents, size, sign)| {
                let power = |k: usize| {
                    let exponent = exponents[k] - i32::from(k == axis);
                    if exponent == 0 { 1.0 } else { place[k].powi(exponent) }
                };
                let whole = size.floor();
                sign * f64::from(exponents[axis])
                    * power(0)
                    * power(1)
                    * power(2)
                    * (size - whole).exp2()
                    * power_of_two(whole as i64)
            });
            values.sum()
        };
        (0..3).map(|axis| by(axis).powi(2)).sum::<f64>().sqrt()
    }
}
