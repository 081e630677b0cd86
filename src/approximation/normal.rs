//! Unknowns of a patch in their own units: what the search works with, whatever the patch is measured in.
//!
//! A coordinate of a point with an unknown weight stands for its product with that first. Then every unknown is written
//! as 2ˢ·y plus, for a coordinate, multiples of the weights and a constant: so that all y are near 1 for every patch that looks like
//! one, be it given in millimetres or kilometres, around the origin or far from it, with weights around 1 or around 10⁻⁴⁰. The change is
//! exact. Where the units differ by less than a factor of three from those of a patch on the unit sphere with weights around 1,
//! and the origin is nearer than four lengths, nothing is changed.

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::frame::Frame;
use super::linear::least_squares;
use super::size::{log2, scaled};
use crate::algebra::{self, FieldElement, MultiquadraticField, polynomial_from_exact};
use crate::exact::{self, Arithmetic, Limit, Polynomial, Work};
use crate::problem::field_of;
use crate::statement::{Patch, Statement, Subject};

/// Units are powers of two to the power of this.
const STEP: f64 = 3.0;
/// Shifts are multiples of so many units.
const SHIFT: f64 = 4.0;

/// An unknown of the statement, or a product of two, by unknowns in their own units.
#[derive(Debug, Clone)]
pub(super) struct Affine {
    /// Of its own y: a power of two.
    pub(super) unit: BigRational,
    /// The exponent of that.
    pub(super) exponent: i64,
    /// Multiples of the y of weights.
    pub(super) shears: Vec<(usize, BigRational)>,
    /// A constant.
    pub(super) shift: BigRational,
}

/// A patch with its unknowns in their own units.
#[derive(Debug, Clone)]
pub(super) struct Normal {
    /// The patch, by y.
    pub(super) patch: Patch,
    /// Pairs (z, w): from here on z stands for the product z·w.
    pub(super) products: Vec<(u16, u16)>,
    /// Each unknown by y.
    pub(super) unknowns: Vec<Affine>,
    pub(super) frame: Frame,
    /// W is near 2^weight.
    pub(super) weight: i64,
    /// F/Wᵉ is near 2^ratio for a patch that is off by its length.
    pub(super) ratio: i64,
    /// From where to look, if the net is linear in the unknowns: the y of the fairest net.
    pub(super) fairest: Option<Vec<f64>>,
}

impl Normal {
    /// Of a patch with its unknowns; nothing for a system.
    pub(super) fn of(statement: &Statement) -> Result<Option<Self>, Limit> {
        let Subject::Patch(patch) = statement.subject() else { return Ok(None) };
        let field = field_of(statement);
        let count = statement.unknowns().len();
        let products = products(statement);
        let patch = with_products(patch, &products);
        let frame = Frame::of(field, &patch);
        let net = Net::of(field, &patch, count);
        let exponents: Vec<i64> = net.units(&frame).into_iter().map(rounded).collect();
        let mut unknowns: Vec<Affine> = exponents
            .iter()
            .map(|&exponent| Affine {
                unit: power(exponent),
                exponent,
                shears: Vec::new(),
                shift: BigRational::zero(),
            })
            .collect();
        net.centre(&frame, &mut unknowns);
        let forms: Vec<Polynomial> = (0..).zip(&unknowns).map(|(k, affine)| affine.polynomial(k)).collect();
        let mut patch = patch;
        let mut work = Work::full();
        for entry in patch.net.iter_mut().flatten().flatten() {
            *entry = Arithmetic::new(statement.field(), &mut work).substitute(entry, &forms)?;
        }
        let (weight, ratio) = (rounded(frame.weight), rounded(frame.ratio));
        let fairest = Net::of(field, &patch, count).fairest(&frame, patch.bidegree);
        Ok(Some(Normal { patch, products, unknowns, frame, weight, ratio, fairest }))
    }

    /// What is put for the unknowns, one after another, as a certificate says it.
    pub(super) fn forms(&self) -> Vec<(u16, Polynomial)> {
        let form = |(k, affine): (u16, &Affine)| {
            // Weights that come before have been replaced already, those that come after have not.
            let shear = |(l, factor): &(usize, BigRational)| {
                let factor = match *l < usize::from(k) {
                    true => factor.clone(),
                    false => factor / &self.unknowns[*l].unit,
                };
                (*l, factor)
            };
            let shears = affine.shears.iter().map(shear).collect();
            (k, Affine { shears, ..affine.clone() }.polynomial(k))
        };
        let all = (0..).zip(&self.unknowns).map(form);
        all.filter(|(k, form)| *form != Polynomial::variable(*k)).collect()
    }

    /// The statement's unknowns (and products) at y, exactly.
    pub(super) fn exactly(&self, y: &[f64]) -> Vec<BigRational> {
        let y: Vec<BigRational> = y.iter().map(|&y| BigRational::from_float(y).unwrap_or_default()).collect();
        let value = |(affine, own): (&Affine, &BigRational)| {
            let shears = affine.shears.iter().map(|(l, factor)| factor * &y[*l]);
            shears.fold(&affine.unit * own + &affine.shift, |sum, term| sum + term)
        };
        self.unknowns.iter().zip(&y).map(value).collect()
    }

    /// The values of the unknowns themselves, from those in which z stands for z·w. Nothing where a weight is 0.
    pub(super) fn undone(&self, values: &[BigRational]) -> Option<Vec<BigRational>> {
        let mut result = values.to_vec();
        for &(z, w) in &self.products {
            let weight = &values[usize::from(w)];
            if weight.is_zero() {
                return None;
            }
            result[usize::from(z)] = &values[usize::from(z)] / weight;
        }
        Some(result)
    }

    /// How many decimals of each unknown are as many digits as a double has.
    pub(super) fn decimals(&self, of_one: i64) -> Vec<i64> {
        let mut exponents: Vec<i64> = self.unknowns.iter().map(|affine| affine.exponent).collect();
        for &(z, w) in &self.products {
            exponents[usize::from(z)] -= exponents[usize::from(w)];
        }
        exponents.into_iter().map(|exponent| of_one - decimal_exponent(exponent)).collect()
    }
}

/// log₁₀ 2ᵉ, rounded.
pub(super) fn decimal_exponent(exponent: i64) -> i64 {
    (exponent as f64 * std::f64::consts::LOG10_2).round() as i64
}

impl Affine {
    fn polynomial(&self, k: u16) -> Polynomial {
        let term = |k: usize, factor: &BigRational| {
            let monomial = exact::Monomial::new(0, vec![(k as u16, 1)]).and_then(Result::ok);
            (monomial.unwrap_or_else(exact::Monomial::one), factor.clone())
        };
        let own = term(usize::from(k), &self.unit);
        let shears = self.shears.iter().map(|(l, factor)| term(*l, factor));
        let shift = (exact::Monomial::one(), self.shift.clone());
        Polynomial::from_terms([own, shift].into_iter().chain(shears))
    }
}

/// One entry of the net: which of X, Y, Z, W, and its terms.
struct Entry {
    coordinate: usize,
    terms: Vec<(algebra::Monomial, FieldElement)>,
}

struct Net {
    entries: Vec<Entry>,
    count: usize,
    /// Whether an unknown occurs in a weight.
    in_weight: Vec<bool>,
    linear: bool,
}

impl Net {
    fn of(field: MultiquadraticField, patch: &Patch, count: usize) -> Self {
        let points = patch.net.iter().flatten();
        let entries = points.flat_map(|point| {
            point.iter().enumerate().map(|(coordinate, entry)| Entry {
                coordinate,
                terms: polynomial_from_exact(field, entry).terms().to_vec(),
            })
        });
        let entries: Vec<Entry> = entries.collect();
        let mut in_weight = vec![false; count];
        for (monomial, _) in entries.iter().filter(|entry| entry.coordinate == 3).flat_map(|one| &one.terms) {
            monomial.powers().iter().for_each(|&(k, _)| in_weight[usize::from(k)] = true);
        }
        let linear =
            entries.iter().flat_map(|entry| &entry.terms).all(|(monomial, _)| monomial.degree() <= 1);
        Net { entries, count, in_weight, linear }
    }

    /// log₂ of the unknowns' units: those with which every term of the net comes nearest to the size of its coordinate.
    fn units(&self, frame: &Frame) -> Vec<f64> {
        let mut rows = Vec::new();
        for Entry { coordinate, terms } in &self.entries {
            for (monomial, value) in terms {
                // What is a weight and nothing else is measured by weights.
                let counts = |k: u16| *coordinate == 3 || !self.in_weight[usize::from(k)];
                if !monomial.powers().iter().any(|&(k, _)| counts(k)) {
                    continue;
                }
                let target = frame.weight + if *coordinate == 3 { 0.0 } else { frame.length };
                let mut row = vec![0.0; self.count];
                monomial.powers().iter().for_each(|&(k, e)| row[usize::from(k)] = f64::from(e));
                rows.push((row, target - log2(value).unwrap_or(0.0)));
            }
        }
        least_squares(&rows, self.count, 1e-9).unwrap_or_else(|| vec![0.0; self.count])
    }

    /// The entries by columns: the unknowns', then the constant one; in units of the object, around its centre.
    fn columns(&self, frame: &Frame, units: &[i64]) -> Vec<Vec<f64>> {
        let weight = rounded(frame.weight);
        let mut columns = vec![vec![0.0; self.entries.len()]; self.count + 1];
        for (place, Entry { terms, .. }) in self.entries.iter().enumerate() {
            for (monomial, value) in terms {
                let column = monomial.powers().first().map_or(self.count, |&(k, _)| usize::from(k));
                let unit = units.get(column).copied().unwrap_or(0);
                columns[column][place] = scaled(value, unit - weight);
            }
        }
        for (place, Entry { coordinate, .. }) in
            self.entries.iter().enumerate().filter(|(_, e)| e.coordinate < 3)
        {
            for column in &mut columns {
                let of_weight = column[place - coordinate + 3];
                column[place] =
                    (column[place] - frame.centre[*coordinate] * of_weight) * (-frame.length).exp2();
            }
        }
        columns
    }

    /// Coordinates around the centre of the object: multiples of the weights and constants, where it is far away.
    fn centre(&self, frame: &Frame, unknowns: &mut [Affine]) {
        if !self.linear {
            return;
        }
        let units: Vec<i64> = unknowns.iter().map(|affine| affine.exponent).collect();
        let columns = self.columns(frame, &units);
        let own: Vec<usize> = (0..self.count).filter(|&k| !self.in_weight[k]).collect();
        let others = (0..=self.count).filter(|&l| l == self.count || self.in_weight[l]);
        for l in others {
            let rows = (0..self.entries.len())
                .map(|place| (own.iter().map(|&k| columns[k][place]).collect(), columns[l][place]));
            let rows: Vec<(Vec<f64>, f64)> = rows.collect();
            let Some(multiples) = least_squares(&rows, own.len(), 1e-9) else { continue };
            for (&k, multiple) in own.iter().zip(multiples) {
                let shift = -(multiple / SHIFT).round() * SHIFT;
                if shift != 0.0 {
                    // In units of the other y, which is 2^unit times the unknown.
                    let value = BigRational::from_float(shift).unwrap_or_default() * power(units[k]);
                    match l == self.count {
                        true => unknowns[k].shift = value,
                        false => unknowns[k].shears.push((l, value)),
                    }
                }
            }
        }
    }

    /// The unknowns for which the net's second differences are smallest.
    fn fairest(&self, frame: &Frame, (m, n): (u32, u32)) -> Option<Vec<f64>> {
        if !self.linear {
            return None;
        }
        let columns = self.columns(frame, &vec![0; self.count]);
        let (m, n) = (m as usize, n as usize);
        let at = |i: usize, j: usize, coordinate: usize| 4 * (i * (n + 1) + j) + coordinate;
        let mut rows: Vec<(Vec<f64>, f64)> = Vec::new();
        let mut difference = |places: [usize; 3]| {
            let of = |column: &Vec<f64>| column[places[0]] - 2.0 * column[places[1]] + column[places[2]];
            rows.push((columns[..self.count].iter().map(of).collect(), -of(&columns[self.count])));
        };
        for (i, j, k) in itertools::iproduct!(0..=m, 0..=n, 0..4) {
            if i + 2 <= m {
                difference([at(i, j, k), at(i + 1, j, k), at(i + 2, j, k)]);
            }
            if j + 2 <= n {
                difference([at(i, j, k), at(i, j + 1, k), at(i, j + 2, k)]);
            }
        }
        least_squares(&rows, self.count, 1e-6)
    }
}

/// The exponent of a unit for numbers of this size.
pub(super) fn rounded(logarithm: f64) -> i64 {
    ((logarithm / STEP).round() * STEP) as i64
}

/// 2ᵉ.
pub(super) fn power(exponent: i64) -> BigRational {
    let size = BigInt::one() << exponent.unsigned_abs();
    if exponent < 0 { BigRational::new(BigInt::one(), size) } else { BigRational::from_integer(size) }
}

/// z is put for the product z·w.
fn with_products(patch: &Patch, products: &[(u16, u16)]) -> Patch {
    let mut patch = patch.clone();
    if products.is_empty() {
        return patch;
    }
    for entry in patch.net.iter_mut().flatten().flatten() {
        let terms = entry.terms().map(|(monomial, value)| {
            let spent = |&(k, e): &(u16, u32)| {
                let product = products.iter().any(|&(z, w)| w == k && monomial.exponent(z) > 0);
                (!product).then_some((k, e))
            };
            let powers = monomial.powers().iter().filter_map(spent).collect();
            let replaced = exact::Monomial::new(monomial.mask(), powers).and_then(Result::ok);
            (replaced.unwrap_or_else(|| monomial.clone()), value.clone())
        });
        *entry = Polynomial::from_terms(terms.collect::<Vec<_>>());
    }
    patch
}

/// Unknown coordinates z of points whose unknown weight is w: in homogeneous coordinates the product z·w is the unknown. (Where z
/// grows as w vanishes, only the product tells what becomes of the patch.)
fn products(statement: &Statement) -> Vec<(u16, u16)> {
    let Subject::Patch(patch) = statement.subject() else { return Vec::new() };
    let entries = || patch.net.iter().flatten().flatten();
    let mut found: BTreeMap<u16, Option<u16>> = BTreeMap::new();
    for (monomial, _) in entries().flat_map(exact::Polynomial::terms) {
        match monomial.powers() {
            &[(a, 1), (b, 1)] => {
                for (z, w) in [(a, b), (b, a)] {
                    let other = found.entry(z).or_insert(Some(w));
                    *other = other.filter(|&other| other == w);
                }
            }
            powers => powers.iter().for_each(|&(k, _)| {
                found.insert(k, None);
            }),
        }
    }
    // Only where z occurs in this product alone, and w without it too.
    let pairs = found.iter().filter_map(|(&z, w)| Some((z, (*w)?)));
    pairs.filter(|(_, w)| found.get(w) == Some(&None)).collect()
}
