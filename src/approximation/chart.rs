//! The inequalities that a good patch would satisfy at sample points, as polynomials on charts of the unknowns' space,
//! in floating point. What the charts and samples are: `proofs/FORMAT.md`.

use std::collections::BTreeMap;

use super::fixed::to_f64;
use crate::algebra::{FieldElement, Polynomial};
use crate::bezier::BernsteinForm;
use crate::certificate::{Odds, Side};

/// Coefficients by exponents, one for each unknown.
type Terms = BTreeMap<Vec<u32>, f64>;

/// One inequality on one chart: the polynomial that would be positive.
#[derive(Debug, Clone)]
pub(super) struct Inequality {
    pub(super) side: Side,
    /// From 1, as certificates count.
    pub(super) sample: usize,
    /// By which power of h the polynomial was divided.
    pub(super) divided: u32,
    degrees: Vec<usize>,
    /// By exponents, the last one fastest.
    coefficients: Vec<f64>,
}

/// The interval of each variable.
pub(super) type Region = Vec<(f64, f64)>;

/// A side at every point of the square: coefficients of tʳsˢ by unknowns.
#[derive(Debug)]
pub(super) struct SideForm {
    pub(super) side: Side,
    /// (r, s, exponents of the unknowns, coefficient).
    terms: Vec<(u32, u32, Vec<u32>, f64)>,
    degree: u32,
}

impl SideForm {
    /// first·factor + second, with the products put in for unknowns. `None` if the forms are not polynomials in the products.
    pub(super) fn new(
        side: Side,
        parts: &[(&BernsteinForm, FieldElement)],
        unknowns: usize,
        products: &[(u16, u16)],
    ) -> Option<Self> {
        let mut terms = Vec::new();
        for (form, factor) in parts {
            for (r, s, coefficient) in form.coefficients() {
                for (monomial, value) in Polynomial::terms(coefficient) {
                    let mut exponents = vec![0; unknowns];
                    for &(k, exponent) in monomial.powers() {
                        exponents[usize::from(k)] = exponent;
                    }
                    for &(z, w) in products {
                        let spent = exponents[usize::from(z)];
                        exponents[usize::from(w)] = exponents[usize::from(w)].checked_sub(spent)?;
                    }
                    terms.push((r, s, exponents, to_f64(&(value * factor))));
                }
            }
        }
        let degree = terms.iter().map(|(_, _, exponents, _)| exponents.iter().sum()).max().unwrap_or(0);
        Some(SideForm { side, terms, degree })
    }

    /// At a sample, on the chart with this number, homogenised to `degree` in the unknowns.
    fn on_chart(&self, odds: &[Odds; 2], chart: usize, range: f64, degree: u32) -> Terms {
        let far = (chart > 0).then(|| ((chart - 1) / 2, (chart - 1) % 2 == 1));
        let value = |odds: &Odds| ratio(&odds.value);
        let mut sum = Terms::new();
        for (r, s, exponents, coefficient) in &self.terms {
            let total: u32 = exponents.iter().sum();
            let mut factor = coefficient * range.powi(total as i32);
            let mut of_h = degree - total;
            for (odds, exponent) in odds.iter().zip([*r, *s]) {
                factor *= value(odds).powi(exponent as i32);
                of_h += if odds.shrinking { exponent } else { 0 };
            }
            let mut exponents = exponents.clone();
            if let Some((far, negative)) = far {
                if negative && exponents[far] % 2 == 1 {
                    factor = -factor;
                }
                exponents[far] = of_h;
            }
            *sum.entry(exponents).or_default() += factor;
        }
        sum
    }
}

/// All inequalities at all samples on one chart.
pub(super) fn inequalities(
    forms: &[SideForm],
    samples: &[[Odds; 2]],
    chart: usize,
    range: f64,
) -> Vec<Inequality> {
    let degree = forms.iter().map(|form| form.degree).max().unwrap_or(0);
    let mut all = Vec::new();
    for (number, odds) in (1..).zip(samples) {
        for form in forms {
            let mut terms = form.on_chart(odds, chart, range, degree);
            let mut divided = 0;
            if let Some(far) = chart.checked_sub(1).map(|chart| chart / 2) {
                divided = terms.keys().map(|exponents| exponents[far]).min().unwrap_or(0);
                let divide = |(mut exponents, value): (Vec<u32>, f64)| {
                    exponents[far] -= divided;
                    (exponents, value)
                };
                terms = terms.into_iter().map(divide).collect();
            }
            let unknowns = terms.keys().next().map_or(0, Vec::len);
            let largest =
                |axis: usize| terms.keys().map(|exponents| exponents[axis] as usize).max().unwrap_or(0);
            let degrees: Vec<usize> = (0..unknowns).map(largest).collect();
            let mut coefficients = vec![0.0; degrees.iter().map(|degree| degree + 1).product()];
            for (exponents, value) in &terms {
                let place = exponents
                    .iter()
                    .zip(&degrees)
                    .fold(0, |place, (e, degree)| place * (degree + 1) + *e as usize);
                coefficients[place] = *value;
            }
            all.push(Inequality { side: form.side, sample: number, divided, degrees, coefficients });
        }
    }
    all
}

impl Inequality {
    /// The Bernstein coefficients on a box, for degrees raised to at least these.
    pub(super) fn bernstein(&self, region: &Region, degrees: &[usize]) -> Vec<f64> {
        let mut shape: Vec<usize> = self.degrees.iter().map(|degree| degree + 1).collect();
        let mut values = self.coefficients.clone();
        for (axis, (&(low, high), &degree)) in region.iter().zip(degrees).enumerate() {
            let stride: usize = shape[axis + 1..].iter().product();
            let (length, raised) = (shape[axis], degree.max(shape[axis] - 1) + 1);
            let matrix = bernstein_matrix(length, raised, low, high);
            let blocks: usize = shape[..axis].iter().product();
            let mut next = vec![0.0; blocks * raised * stride];
            for block in 0..blocks {
                for (k, row) in matrix.iter().enumerate() {
                    for (a, factor) in row.iter().enumerate() {
                        for j in 0..stride {
                            next[(block * raised + k) * stride + j] +=
                                factor * values[(block * length + a) * stride + j];
                        }
                    }
                }
            }
            values = next;
            shape[axis] = raised;
        }
        values
    }

    /// The degree in each variable.
    pub(super) fn degrees(&self) -> &[usize] {
        &self.degrees
    }
}

/// Rows k = 0..raised, columns a: the k-th Bernstein coefficient, of degree raised − 1, of xᵃ on an interval.
///
/// By blossoming: the mean of the products of a of the k highs and raised − 1 − k lows.
fn bernstein_matrix(length: usize, raised: usize, low: f64, high: f64) -> Vec<Vec<f64>> {
    let degree = raised - 1;
    let binomial = |n: usize, k: usize| (0..k).fold(1.0, |c, i| c * (n - i) as f64 / (i + 1) as f64);
    let entry = |k: usize, a: usize| -> f64 {
        let products = (0..=a.min(k)).filter(|&i| a - i <= degree - k).map(|i| {
            binomial(k, i) * binomial(degree - k, a - i) * high.powi(i as i32) * low.powi((a - i) as i32)
        });
        products.sum::<f64>() / binomial(degree, a)
    };
    (0..raised).map(|k| (0..length).map(|a| entry(k, a)).collect()).collect()
}

fn ratio(value: &num_rational::BigRational) -> f64 {
    num_traits::ToPrimitive::to_f64(value).unwrap_or(0.0)
}
