//! Least squares by sequential quadratic programming, from many starts.

use itertools::iproduct;
use slsqp::{Func, StopTols, minimize};

use super::levenberg::{Limits, REACH, bottom};
use super::model::Model;
use super::progress::Progress;
use crate::control::{Control, Interrupted};

/// Starts that are tried.
pub(super) const STARTS: usize = 48;
/// Intervals of the grid while a start is looked for.
const COARSE: usize = 8;
/// The smallest denominator that is taken, in the net's own unit of weights.
const WEIGHT: f64 = 1e-3;
/// Enough to compare starts.
const QUICK: Limits = Limits { steps: 60, gain: 1e-4 };
/// To the last digit.
const LAST: Limits = Limits { steps: 1000, gain: 1e-14 };
/// How far random starts are from the fairest net, in units of each unknown.
const AROUND: f64 = 1.5;

/// The sum of squares of F/Wᵉ over a grid, and its gradient.
fn squares(model: &Model, values: &[f64], intervals: usize, divided: bool) -> (f64, Vec<f64>) {
    let fitted = model.at(values);
    let at = |i: usize| i as f64 / intervals as f64;
    let (mut sum, mut gradient) = (0.0, vec![0.0; values.len()]);
    for (i, j) in iproduct!(0..=intervals, 0..=intervals) {
        let deviation = if divided { fitted.ratio(at(i), at(j)) } else { fitted.surface(at(i), at(j)) };
        sum += deviation.value * deviation.value;
        for (slope, of) in gradient.iter_mut().zip(&deviation.gradient) {
            *slope += 2.0 * deviation.value * of;
        }
    }
    (sum, gradient)
}

/// A search that was stopped, and the best values that it had.
#[derive(Debug)]
pub(super) struct Stopped {
    pub(super) why: Interrupted,
    pub(super) best: Option<Vec<f64>>,
}

/// Values of the unknowns from where to look for the best: the smallest sum of squares of F/Wᵉ over a coarse grid, from the fairest net
/// and from random starts around it, among those with a positive denominator.
pub(super) fn start(
    model: &Model,
    fairest: Option<&[f64]>,
    seed: u64,
    control: &Control,
) -> Result<Option<Vec<f64>>, Stopped> {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut best: Option<(f64, Vec<f64>)> = None;
    for tried in 1..=STARTS {
        control.observe(&Progress::Starts { tried, of: STARTS });
        let from: Vec<f64> = match fairest {
            Some(fairest) if tried == 1 => fairest.to_vec(),
            fairest => (0..model.unknowns())
                .map(|k| fairest.map_or(0.5, |fairest| fairest[k]) + AROUND * (2.0 * random.f64() - 1.0))
                .collect(),
        };
        match descent(model, &from, control) {
            Ok(Some((sum, found))) => {
                if best.as_ref().is_none_or(|(least, _)| sum < least * (1.0 - 1e-6)) {
                    best = Some((sum, found));
                }
            }
            Ok(None) => {}
            Err(Stopped { why, best: now }) => {
                return Err(Stopped { why, best: best.map(|(_, values)| values).or(now) });
            }
        }
    }
    Ok(best.map(|(_, values)| values))
}

/// The sum of squares that is reached from a start, and where; nothing without a positive denominator.
fn descent(model: &Model, from: &[f64], control: &Control) -> Result<Option<(f64, Vec<f64>)>, Stopped> {
    let positive = |values: &[f64]| model.at(values).smallest_weight(2 * COARSE) >= WEIGHT;
    // F without its denominator leads from anywhere to near the surface, or to a patch that is nowhere.
    let near = sequential(model, from, (COARSE, false), &[], control);
    let near = near.map_err(|why| Stopped { why, best: None })?;
    let Some(from) = [&near[..], from].into_iter().find(|from| positive(from)) else { return Ok(None) };
    let found = bottom(model, from, COARSE, QUICK, control)?;
    // Where the sum does not depend on some unknowns, such as a common factor of all weights, they may drift away.
    let found = if positive(&found) { found } else { from.to_vec() };
    let sum = graded(model, &found);
    Ok(sum.is_finite().then_some((sum, found)))
}

/// The sum of squares of F/Wᵉ over a grid that becomes finer towards the edges: where a weight is very large, the patch is near a
/// point of the surface but for a strip along them that an even grid would miss.
fn graded(model: &Model, values: &[f64]) -> f64 {
    let fitted = model.at(values);
    let near = (4..=10).map(|k| 2f64.powi(-k));
    let even = (1..COARSE).map(|i| i as f64 / COARSE as f64);
    let nodes: Vec<f64> = even.chain(near.flat_map(|x| [x, 1.0 - x])).chain([0.0, 1.0]).collect();
    iproduct!(&nodes, &nodes).map(|(&u, &v)| fitted.ratio(u, v).value.powi(2)).sum()
}

/// The smallest sum of squares over a grid of so many intervals, the deviation being 0 at given points (the paper's
/// Eq. 16 and 17, as MATLAB's fmincon solves them).
pub(super) fn least_squares(
    model: &Model,
    from: &[f64],
    intervals: usize,
    pass: &[(f64, f64)],
    control: &Control,
) -> Result<Vec<f64>, Stopped> {
    if pass.is_empty() {
        // Most of the way on a coarse grid, where it costs little.
        let near = bottom(model, from, COARSE.min(intervals), LAST, control)?;
        return bottom(model, &near, intervals, LAST, control);
    }
    let mut values = from.to_vec();
    // The method stops early where the sum is small; started again it goes on.
    for _ in 0..4 {
        values = sequential(model, &values, (intervals, true), pass, control)
            .map_err(|why| Stopped { why, best: Some(values) })?;
    }
    Ok(values)
}

/// On a grid of so many intervals; F divided by Wᵉ or not.
fn sequential(
    model: &Model,
    from: &[f64],
    (intervals, divided): (usize, bool),
    pass: &[(f64, f64)],
    control: &Control,
) -> Result<Vec<f64>, Interrupted> {
    control.check()?;
    let (unit, _) = squares(model, from, intervals, divided);
    let unit = if unit > 0.0 && unit.is_finite() { unit } else { 1.0 };
    let objective = |values: &[f64], gradient: Option<&mut [f64]>, (): &mut ()| {
        // The method has no string to stop it by, but ends where nothing is to be gained.
        let (sum, slopes) = match control.check() {
            Ok(()) => squares(model, values, intervals, divided),
            Err(_) => (0.0, vec![0.0; values.len()]),
        };
        if let Some(gradient) = gradient {
            gradient.iter_mut().zip(&slopes).for_each(|(to, slope)| *to = slope / unit);
        }
        sum / unit
    };
    let through = |(u, v): (f64, f64), sign: f64| {
        move |values: &[f64], gradient: Option<&mut [f64]>, (): &mut ()| {
            let deviation = model.at(values).ratio(u, v);
            if let Some(gradient) = gradient {
                gradient.iter_mut().zip(&deviation.gradient).for_each(|(to, slope)| *to = sign * slope);
            }
            sign * deviation.value
        }
    };
    let constraints: Vec<_> =
        pass.iter().flat_map(|&point| [through(point, 1.0), through(point, -1.0)]).collect();
    let constraints: Vec<&dyn Func<()>> =
        constraints.iter().map(|constraint| constraint as &dyn Func<()>).collect();
    let bounds = vec![(-REACH, REACH); from.len()];
    let stop = StopTols { ftol_rel: 1e-15, xtol_rel: 1e-15, ..StopTols::default() };
    let (Ok((_, values, _)) | Err((_, values, _))) =
        minimize(objective, from, &bounds, &constraints, (), 2000, Some(stop));
    // What was stopped once stays stopped.
    control.check()?;
    Ok(if values.iter().all(|value| value.is_finite()) { values } else { from.to_vec() })
}
