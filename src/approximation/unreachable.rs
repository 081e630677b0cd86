//! No values do better: branch and bound over all values of the unknowns, with a certificate.
//!
//! A box of values is excluded by a sum of inequalities at sample points, each of which a better patch would satisfy, that is
//! negative on the whole box. One inequality does far from the optimum. Near it, several are needed, with the multipliers of
//! Kuhn and Tucker, that make their slopes cancel; a linear program finds them. All this is floating point and guesses;
//! the checker decides.

use std::collections::BTreeMap;

use microlp::{ComparisonOp, OptimizationDirection, Problem};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use super::chart::{Inequality, Region, SideForm, inequalities};
use super::enclosure::quantity_of;
use super::extremes::Place;
use super::normal::{Normal, power as power_of_two};
use super::progress::Progress;
use crate::algebra::Integer;
use crate::bezier::{BernsteinForm, surface_condition};
use crate::certificate::{Argument, Odds, Quantity, Region as Node, Side, Units, Unreachable, decimal_value};
use crate::checker::{CheckError, Rejection, UnreachableRejection};
use crate::control::{Control, Interrupted};
use crate::exact::{self, Arithmetic, Limit, Work};
use crate::problem::field_of;
use crate::proof::{NoProof, Proof};
use crate::statement::{Patch, Statement};

/// What the first chart reaches.
const RANGE: i64 = 8;
/// Intervals of the grid of samples.
const GRID: i64 = 16;
/// The places of extremes are rounded to a grid of so many intervals.
const FINE: f64 = 4096.0;
/// Boxes before the search is given up.
const BOXES: usize = 100_000;
/// Inequalities that enter a linear program.
const CANDIDATES: usize = 24;
/// Multipliers are rounded to this many units.
const UNITS: f64 = 1_048_576.0;

/// Why it is not proved.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum UnreachableError {
    /// A bare system, or a patch without unknowns.
    #[error("there is no patch with unknowns to choose")]
    NothingToChoose,
    /// The boxes became too many.
    #[error("the boxes became too many: {0}, in chart {1}")]
    TooMany(usize, usize),
    /// Interrupted.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
    /// A limit of the format.
    #[error("{0}")]
    Limit(#[from] Limit),
    /// A box that was excluded in floating point.
    #[error("chart {chart}: box {node} of the tree is excluded in floating point, but not exactly")]
    Inexact {
        /// The chart, from 1.
        chart: usize,
        /// The box, in preorder, from 1.
        node: usize,
    },
    /// The checker refused.
    #[error("the independent checker refused the argument: {0}")]
    Refused(CheckError),
}

impl From<NoProof> for UnreachableError {
    fn from(why: NoProof) -> Self {
        match why {
            NoProof::Interrupted(why) => UnreachableError::Interrupted(why),
            NoProof::Limit(limit) => UnreachableError::Limit(limit),
            NoProof::Refused(CheckError::Rejected(Rejection::Unreachable(
                UnreachableRejection::NotExcluded { chart, node },
            ))) => UnreachableError::Inexact { chart, node },
            NoProof::Refused(error) => UnreachableError::Refused(error),
        }
    }
}

/// An argument that no values of the unknowns reach further, accepted by the checker.
#[derive(Debug, Clone)]
pub struct Barrier {
    /// How many boxes were excluded.
    pub boxes: usize,
    /// Half of what lies between the decimals that no values stay between.
    pub half_width: BigRational,
    /// What the checker has accepted.
    pub proof: Proof,
}

/// Proves that no values of the unknowns keep the quantity strictly between two decimals with the given places.
///
/// `extremes` are where the best patch that is known is worst: the samples there decide.
///
/// # Errors
/// [`UnreachableError`]
pub fn exclude(
    statement: &Statement,
    between: [Units; 2],
    places: u32,
    extremes: &[Place],
    control: &Control,
) -> Result<Barrier, UnreachableError> {
    let unknowns = statement.unknowns().len();
    let quantity =
        quantity_of(statement).filter(|_| unknowns > 0).ok_or(UnreachableError::NothingToChoose)?;
    let samples = samples(extremes);
    let normal = Normal::of(statement)?.ok_or(UnreachableError::NothingToChoose)?;
    let forms = forms(statement, quantity, &between, places, &normal)?;
    let units = SideUnits::of(&normal, quantity);
    let mut charts = Vec::new();
    let mut boxes = 0;
    for chart in 0..Unreachable::chart_count(unknowns) {
        let inequalities = inequalities(&forms, &samples, chart, RANGE as f64);
        let far = chart.checked_sub(1).map(|chart| chart / 2);
        let whole: Region = (0..unknowns).map(|k| (if far == Some(k) { 0.0 } else { -1.0 }, 1.0)).collect();
        charts.push(cover(&inequalities, units, whole, chart + 1, &mut boxes, control)?);
    }
    let (samples, charts) = used(&samples, charts);
    let [lower, upper] = between;
    let half_width = decimal_value(&(&upper - &lower), places) / BigRational::from_integer(2.into());
    let argument = Unreachable {
        quantity,
        places,
        lower,
        upper,
        products: normal.products.clone(),
        forms: normal.forms(),
        range: BigInt::from(RANGE),
        samples,
        charts,
    };
    let proof = Proof::of(statement, Argument::Unreachable(argument), control)?;
    Ok(Barrier { boxes, half_width, proof })
}

/// Powers of two that the sides are measured in, so that none is lost beside another: F and Wᵉ, and W.
#[derive(Debug, Clone, Copy)]
struct SideUnits {
    surface: i64,
    weight: i64,
}

impl SideUnits {
    fn of(normal: &Normal, quantity: Quantity) -> Self {
        let ratio = if quantity == Quantity::Radius { 0 } else { normal.ratio };
        let degree = i64::from(normal.patch.surface.degree());
        SideUnits { surface: degree * normal.weight + ratio, weight: normal.weight }
    }

    fn exponent(self, side: Side) -> i64 {
        if side == Side::Weight { self.weight } else { self.surface }
    }

    /// Multipliers of sides in these units as multipliers of the sides themselves: integers without a common power of two.
    fn undone(self, sum: &mut [(BigInt, Side, usize)]) {
        let largest = sum.iter().map(|(_, side, _)| self.exponent(*side)).max().unwrap_or(0);
        for (factor, side, _) in sum {
            *factor <<= (largest - self.exponent(*side)).unsigned_abs();
        }
    }
}

/// F − low·Wᵉ, high·Wᵉ − F and W, by unknowns in their own units, in the units of the sides.
fn forms(
    statement: &Statement,
    quantity: Quantity,
    between: &[Units; 2],
    places: u32,
    normal: &Normal,
) -> Result<Vec<SideForm>, UnreachableError> {
    let (field, patch) = (field_of(statement), &normal.patch);
    let along = |surface: exact::Polynomial| surface_condition(field, &Patch { surface, ..patch.clone() });
    let weight = exact::Polynomial::variable(3);
    let power =
        Arithmetic::new(statement.field(), &mut Work::full()).power(&weight, patch.surface.degree())?;
    let (surface, power, weight) = (along(patch.surface.clone()), along(power), along(weight));
    let threshold = |bound: &Units| {
        let value = decimal_value(bound, places);
        let value = if quantity == Quantity::Radius { &value * &value - BigRational::one() } else { value };
        field.rational(Integer::from_bigint(value.numer()), Integer::from_bigint(value.denom()))
    };
    let (low, high) = (threshold(&between[0]), threshold(&between[1]));
    let units = SideUnits::of(normal, quantity);
    let [unit, of_weight] = [Side::Lower, Side::Weight].map(|side| {
        let unit = power_of_two(-units.exponent(side));
        field.rational(Integer::from_bigint(unit.numer()), Integer::from_bigint(unit.denom()))
    });
    let sides: [(Side, Vec<(&BernsteinForm, _)>); 3] = [
        (Side::Lower, vec![(&surface, unit.clone()), (&power, -&(&low * &unit))]),
        (Side::Upper, vec![(&power, &high * &unit), (&surface, -&unit)]),
        (Side::Weight, vec![(&weight, of_weight)]),
    ];
    let unknowns = statement.unknowns().len();
    let read = sides.iter().map(|(side, parts)| SideForm::new(*side, parts, unknowns, &[]));
    read.collect::<Option<_>>().ok_or(UnreachableError::NothingToChoose)
}

/// A grid, the extremes, and points that move to the edges as an unknown grows.
fn samples(extremes: &[Place]) -> Vec<[Odds; 2]> {
    let odds = |numerator: i64, denominator: i64| Odds {
        value: BigRational::new(numerator.into(), (denominator - numerator).into()),
        shrinking: false,
    };
    let mut samples = Vec::new();
    for place in extremes {
        let [u, v] = [place.u, place.v].map(|x| (x * FINE).round() as i64);
        // At x = 1 the odds are infinite.
        let inside = |x: i64| x >= 0 && x < FINE as i64;
        if inside(u) && inside(v) {
            samples.push([odds(u, FINE as i64), odds(v, FINE as i64)]);
        }
    }
    for (i, j) in itertools::iproduct!(0..GRID, 0..GRID) {
        samples.push([odds(i, GRID), odds(j, GRID)]);
    }
    for power in -6..=4i32 {
        let value = BigRational::from_integer(2.into()).pow(power);
        let moving = Odds { value, shrinking: true };
        for j in [4, 8, 12] {
            samples.push([moving.clone(), odds(j, GRID)]);
            samples.push([odds(j, GRID), moving.clone()]);
        }
        samples.push([moving.clone(), moving]);
    }
    let mut kept: Vec<[Odds; 2]> = Vec::new();
    for sample in samples {
        if !kept.contains(&sample) {
            kept.push(sample);
        }
    }
    kept
}

/// Covers a chart with boxes, each excluded.
fn cover(
    inequalities: &[Inequality],
    units: SideUnits,
    whole: Region,
    chart: usize,
    boxes: &mut usize,
    control: &Control,
) -> Result<Vec<Node>, UnreachableError> {
    let mut open = vec![(whole, 0usize)];
    let mut nodes = Vec::new();
    while let Some((region, depth)) = open.pop() {
        control.check()?;
        if let Some(mut sum) = excluded(inequalities, &region) {
            units.undone(&mut sum);
            nodes.push(Node::Excluded(sum));
            *boxes += 1;
            if boxes.is_multiple_of(64) {
                control.observe(&Progress::Boxes { excluded: *boxes, open: open.len() });
            }
            continue;
        }
        if nodes.len() + open.len() > BOXES || depth > 200 {
            return Err(UnreachableError::TooMany(nodes.len() + open.len(), chart));
        }
        nodes.push(Node::Halved);
        let axis = depth % region.len();
        let (low, high) = region[axis];
        let middle = (low + high) / 2.0;
        for half in [(middle, high), (low, middle)] {
            let mut part = region.clone();
            part[axis] = half;
            open.push((part, depth + 1));
        }
    }
    Ok(nodes)
}

/// A sum of inequalities that is negative on the box.
fn excluded(inequalities: &[Inequality], region: &Region) -> Option<Vec<(BigInt, Side, usize)>> {
    let degrees: Vec<usize> = (0..region.len())
        .map(|axis| inequalities.iter().map(|one| one.degrees()[axis]).max().unwrap_or(0))
        .collect();
    let mut candidates = Vec::new();
    for inequality in inequalities {
        // In its own degrees for itself; raised where it is to be added to others.
        let own = inequality.bernstein(region, inequality.degrees());
        let size = own.iter().fold(0.0f64, |size, value| size.max(value.abs()));
        let most = own.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if most < -1e-9 * size {
            return Some(vec![(BigInt::one(), inequality.side, inequality.sample)]);
        }
        // Of one power of h, so that the sum has no other.
        if inequality.divided == 0 {
            let mean = own.iter().sum::<f64>() / own.len() as f64;
            candidates.push((mean / size.max(1e-300), inequality));
        }
    }
    candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
    candidates.truncate(CANDIDATES);
    // Nothing near the middle of the box speaks against it: smaller boxes will tell.
    candidates.first().filter(|(mean, _)| *mean < 0.0)?;
    let chosen: Vec<(&Inequality, Vec<f64>)> =
        candidates.iter().map(|(_, one)| (*one, one.bernstein(region, &degrees))).collect();
    combination(&chosen)
}

/// Multipliers ≥ 0 that make the largest coefficient of the sum as small as can be, if that is below zero.
fn combination(chosen: &[(&Inequality, Vec<f64>)]) -> Option<Vec<(BigInt, Side, usize)>> {
    let scales: Vec<f64> = chosen
        .iter()
        .map(|(_, values)| values.iter().fold(0.0f64, |size, value| size.max(value.abs())))
        .collect();
    let mut problem = Problem::new(OptimizationDirection::Minimize);
    let top = problem.add_var(1.0, (f64::NEG_INFINITY, f64::INFINITY));
    let multipliers: Vec<_> = chosen.iter().map(|_| problem.add_var(0.0, (0.0, 1.0))).collect();
    let sum: Vec<_> = multipliers.iter().map(|&x| (x, 1.0)).collect();
    problem.add_constraint(&sum, ComparisonOp::Eq, 1.0);
    for place in 0..chosen.first()?.1.len() {
        let terms = multipliers
            .iter()
            .zip(chosen)
            .zip(&scales)
            .map(|((&x, (_, values)), scale)| (x, values[place] / scale));
        let row: Vec<_> = terms.filter(|(_, value)| value.abs() > 1e-6).chain([(top, -1.0)]).collect();
        problem.add_constraint(&row, ComparisonOp::Le, 0.0);
    }
    let solution = problem.solve().ok()?.into_solution().ok()?;
    if solution.var_value(top) > -1e-7 {
        return None;
    }
    // Rounded in the scale of the inequalities themselves.
    let raw: Vec<f64> =
        multipliers.iter().zip(&scales).map(|(&x, scale)| solution.var_value(x) / scale).collect();
    let largest = raw.iter().copied().fold(0.0f64, f64::max);
    let rounded: Vec<f64> = raw.iter().map(|x| (x / largest * UNITS).round()).collect();
    let holds = (0..chosen[0].1.len()).all(|place| {
        let terms = || rounded.iter().zip(chosen).map(|(x, (_, values))| x * values[place]);
        terms().sum::<f64>() < -1e-12 * terms().map(f64::abs).sum::<f64>()
    });
    if !holds {
        return None;
    }
    let terms = rounded.iter().zip(chosen).filter(|(x, _)| **x > 0.0);
    let mut sum: Vec<_> =
        terms.map(|(x, (one, _))| (BigInt::from(*x as i64), one.side, one.sample)).collect();
    sum.sort_by_key(|(_, side, sample)| (*side, *sample));
    Some(sum)
}

/// Only the samples that are used, numbered anew.
fn used(samples: &[[Odds; 2]], mut charts: Vec<Vec<Node>>) -> (Vec<[Odds; 2]>, Vec<Vec<Node>>) {
    let mut numbers: BTreeMap<usize, usize> = BTreeMap::new();
    let sums = |charts: &mut Vec<Vec<Node>>, change: &mut dyn FnMut(&mut usize)| {
        for node in charts.iter_mut().flatten() {
            if let Node::Excluded(sum) = node {
                sum.iter_mut().for_each(|(_, _, sample)| change(sample));
            }
        }
    };
    sums(&mut charts, &mut |sample| {
        numbers.insert(*sample, 0);
    });
    for (new, number) in (1..).zip(numbers.values_mut()) {
        *number = new;
    }
    sums(&mut charts, &mut |sample| *sample = numbers[sample]);
    (numbers.keys().map(|&sample| samples[sample - 1].clone()).collect(), charts)
}
