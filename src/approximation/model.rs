//! A patch with unknowns, in floating point: how far it is from its surface, and how that changes with the unknowns.

use itertools::iproduct;

use super::enclosure::{EnclosureError, patch_at, quantity_of};
use super::frame::Frame;
use super::normal::{Normal, rounded};
use super::size::{power_of_two, scaled};
use crate::algebra::{MultiquadraticField, Polynomial};
use crate::bezier::{BernsteinForm, surface_condition};
use crate::certificate::Quantity;
use crate::exact;
use crate::problem::field_of;
use crate::statement::{Patch, Statement, Subject};

/// A polynomial in the unknowns: coefficients with (unknown, exponent) pairs.
type Terms = Vec<(f64, Vec<(usize, i32)>)>;

/// A form in the scaled Bernstein basis whose coefficients are polynomials in the unknowns.
#[derive(Debug)]
struct Form {
    bidegree: (usize, usize),
    coefficients: Vec<Terms>,
}

/// The patch of a statement.
#[derive(Debug)]
pub struct Model {
    surface: Form,
    weight: Form,
    /// The degree of the surface.
    degree: i32,
    quantity: Quantity,
    unknowns: usize,
    /// Deviations are in units of 2 to the power of this.
    ratio: i64,
}

/// The model at certain values of the unknowns: F and W, and their derivatives, by Bernstein coefficients.
#[derive(Debug)]
pub struct Fitted<'a> {
    model: &'a Model,
    /// The coefficients of F, then of its derivative by each unknown.
    surface: Vec<Vec<f64>>,
    /// Of W likewise.
    weight: Vec<Vec<f64>>,
}

/// The deviation at a point, and its derivative by each unknown.
#[derive(Debug, Clone)]
pub struct Deviation {
    /// r − 1 for the unit sphere, F/Wᵉ otherwise.
    pub value: f64,
    /// By each unknown.
    pub gradient: Vec<f64>,
}

impl Model {
    /// Of a statement about a patch, by its own unknowns; `None` for a system.
    pub fn of(statement: &Statement) -> Option<Self> {
        let Subject::Patch(patch) = statement.subject() else { return None };
        let weight = rounded(Frame::of(field_of(statement), patch).weight);
        Model::by(statement, patch, statement.unknowns().len(), weight, 0)
    }

    /// Of the patch at these values, exactly, before anything is rounded; no unknowns are left.
    ///
    /// # Errors
    /// For a system, and where a limit of the format is exceeded.
    pub fn at_values(statement: &Statement, values: &[exact::Polynomial]) -> Result<Self, EnclosureError> {
        let patch = patch_at(statement, values)?;
        let weight = rounded(Frame::of(field_of(statement), &patch).weight);
        Model::by(statement, &patch, 0, weight, 0).ok_or(EnclosureError::NotAPatch)
    }

    /// By unknowns in their own units, deviations in units of what is natural for the object.
    pub(super) fn normal(statement: &Statement, normal: &Normal) -> Option<Self> {
        // A radius is without units as it is.
        let ratio = if quantity_of(statement)? == Quantity::Radius { 0 } else { normal.ratio };
        Model::by(statement, &normal.patch, normal.unknowns.len(), normal.weight, ratio)
    }

    fn by(statement: &Statement, patch: &Patch, unknowns: usize, weight: i64, ratio: i64) -> Option<Self> {
        let quantity = quantity_of(statement)?;
        let field = field_of(statement);
        let degree = i64::from(patch.surface.degree());
        let along = |surface: exact::Polynomial, size: i64| {
            Form::of(field, &Patch { surface, ..patch.clone() }, -size)
        };
        Some(Model {
            surface: along(patch.surface.clone(), degree * weight + ratio),
            weight: along(exact::Polynomial::variable(3), weight),
            degree: patch.surface.degree() as i32,
            quantity,
            unknowns,
            ratio,
        })
    }

    /// The unit of deviations.
    pub fn unit(&self) -> f64 {
        power_of_two(self.ratio)
    }

    /// How many unknowns there are.
    pub fn unknowns(&self) -> usize {
        self.unknowns
    }

    /// At these values of the unknowns.
    pub fn at(&self, values: &[f64]) -> Fitted<'_> {
        Fitted { model: self, surface: self.surface.at(values), weight: self.weight.at(values) }
    }
}

impl Form {
    /// The surface condition of a patch, its coefficients times a power of two: exact until they are rounded.
    fn of(field: MultiquadraticField, patch: &Patch, exponent: i64) -> Self {
        let form: BernsteinForm = surface_condition(field, patch);
        let (m, n) = form.bidegree();
        let terms = |polynomial: &Polynomial| {
            let term = |(monomial, value): &(crate::algebra::Monomial, crate::algebra::FieldElement)| {
                let powers = monomial.powers().iter().map(|&(k, e)| (usize::from(k), e as i32)).collect();
                (scaled(value, exponent), powers)
            };
            polynomial.terms().iter().map(term).collect()
        };
        let coefficients = form.coefficients().map(|(_, _, polynomial)| terms(polynomial)).collect();
        Form { bidegree: (m as usize, n as usize), coefficients }
    }

    /// The coefficients, and those of the derivatives.
    fn at(&self, values: &[f64]) -> Vec<Vec<f64>> {
        let mut result = vec![vec![0.0; self.coefficients.len()]; values.len() + 1];
        for (place, terms) in self.coefficients.iter().enumerate() {
            for (factor, powers) in terms {
                let product = |skip: usize| -> f64 {
                    let others = powers.iter().filter(|(k, _)| *k != skip);
                    others.map(|&(k, e)| values[k].powi(e)).product()
                };
                result[0][place] += factor * product(usize::MAX);
                for &(k, e) in powers {
                    result[k + 1][place] += factor * f64::from(e) * values[k].powi(e - 1) * product(k);
                }
            }
        }
        result
    }

    fn value(&self, coefficients: &[f64], basis: &(Vec<f64>, Vec<f64>)) -> f64 {
        let products = iproduct!(&basis.0, &basis.1);
        products.zip(coefficients).map(|((a, b), c)| a * b * c).sum()
    }

    /// uʳ(1−u)^(m−r) and vˢ(1−v)^(n−s).
    fn basis(&self, u: f64, v: f64) -> (Vec<f64>, Vec<f64>) {
        let powers = |x: f64, degree: usize| {
            (0..=degree).map(|r| x.powi(r as i32) * (1.0 - x).powi((degree - r) as i32)).collect()
        };
        (powers(u, self.bidegree.0), powers(v, self.bidegree.1))
    }
}

impl Fitted<'_> {
    /// F, without dividing by anything.
    pub fn surface(&self, u: f64, v: f64) -> Deviation {
        let form = &self.model.surface;
        let basis = form.basis(u, v);
        let mut values = self.surface.iter().map(|coefficients| form.value(coefficients, &basis));
        Deviation { value: values.next().unwrap_or(0.0), gradient: values.collect() }
    }

    /// W.
    pub fn weight(&self, u: f64, v: f64) -> f64 {
        let form = &self.model.weight;
        form.value(&self.weight[0], &form.basis(u, v))
    }

    /// The deviation, without derivatives.
    pub fn value(&self, u: f64, v: f64) -> f64 {
        let form = &self.model.surface;
        let surface = form.value(&self.surface[0], &form.basis(u, v));
        self.model.deviation(surface / self.weight(u, v).powi(self.model.degree)).0
    }

    /// The deviation with its derivatives.
    pub fn deviation(&self, u: f64, v: f64) -> Deviation {
        let ratio = self.ratio(u, v);
        let (value, slope) = self.model.deviation(ratio.value);
        Deviation { value, gradient: ratio.gradient.iter().map(|of_ratio| slope * of_ratio).collect() }
    }

    /// F/Wᵉ with its derivatives.
    pub fn ratio(&self, u: f64, v: f64) -> Deviation {
        let surface = self.surface(u, v);
        let form = &self.model.weight;
        let basis = form.basis(u, v);
        let weights: Vec<f64> = self.weight.iter().map(|w| form.value(w, &basis)).collect();
        let degree = self.model.degree;
        let ratio = surface.value / weights[0].powi(degree);
        let by = |(of_surface, of_weight): (&f64, &f64)| {
            of_surface / weights[0].powi(degree) - f64::from(degree) * ratio * of_weight / weights[0]
        };
        let gradient = surface.gradient.iter().zip(&weights[1..]).map(by).collect();
        Deviation { value: ratio, gradient }
    }

    /// Where F vanishes on the whole boundary of the square, whatever the unknowns: F/(u(1−u)v(1−v)) at so many points of each edge.
    /// Its sign is that of F nearby.
    pub fn beside_the_edges(&self, intervals: usize) -> Vec<Deviation> {
        let form = &self.model.surface;
        let (m, n) = form.bidegree;
        let place = |r: usize, s: usize| r * (n + 1) + s;
        let inner = |r: usize, s: usize| (1..m).contains(&r) && (1..n).contains(&s);
        let edge = iproduct!(0..=m, 0..=n).filter(|&(r, s)| !inner(r, s));
        if m < 2 || n < 2 || edge.into_iter().any(|(r, s)| !form.coefficients[place(r, s)].is_empty()) {
            return Vec::new();
        }
        let reduced = Form { bidegree: (m - 2, n - 2), coefficients: Vec::new() };
        let pick =
            |all: &Vec<f64>| -> Vec<f64> { iproduct!(1..m, 1..n).map(|(r, s)| all[place(r, s)]).collect() };
        let parts: Vec<Vec<f64>> = self.surface.iter().map(pick).collect();
        let at = |i: usize| i as f64 / intervals as f64;
        let points = (0..=intervals).flat_map(|i| [(at(i), 0.0), (at(i), 1.0), (0.0, at(i)), (1.0, at(i))]);
        let values = points.map(|(u, v)| {
            let basis = reduced.basis(u, v);
            let mut values = parts.iter().map(|part| reduced.value(part, &basis));
            Deviation { value: values.next().unwrap_or(0.0), gradient: values.collect() }
        });
        values.collect()
    }

    /// The smallest W on a grid of so many intervals each way.
    pub fn smallest_weight(&self, intervals: usize) -> f64 {
        let at = |i: usize| i as f64 / intervals as f64;
        let values = iproduct!(0..=intervals, 0..=intervals).map(|(i, j)| self.weight(at(i), at(j)));
        values.fold(f64::INFINITY, f64::min)
    }
}

impl Model {
    /// The deviation that belongs to F/Wᵉ, and its derivative by that.
    fn deviation(&self, ratio: f64) -> (f64, f64) {
        match self.quantity {
            // √(1 + q) − 1 = q/(1 + √(1 + q)) loses no digits.
            Quantity::Radius => {
                let radius = (1.0 + ratio).max(0.0).sqrt();
                (ratio / (1.0 + radius), 0.5 / radius.max(1e-3))
            }
            Quantity::Ratio => (ratio, 1.0),
        }
    }
}
