//! Least squares by sequential quadratic programming, from many starts.

use itertools::iproduct;
use slsqp::{Func, StopTols, minimize};

use super::model::Model;
use crate::elimination::{Control, Interrupted, Progress};

/// Starts that are tried.
pub(super) const STARTS: usize = 48;
/// Intervals of the grid while a start is looked for.
const COARSE: usize = 8;
/// The smallest denominator that is taken.
const WEIGHT: f64 = 1e-3;

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

/// Values of the unknowns from where to look for the best: the smallest sum of squares of F over a coarse grid, from
/// random starts, among those with a positive denominator.
pub(super) fn start(
    model: &Model,
    seed: u64,
    control: &Control<'_>,
) -> Result<Option<Vec<f64>>, Interrupted> {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut best: Option<(f64, Vec<f64>)> = None;
    for tried in 1..=STARTS {
        control.check()?;
        control.observe(&Progress::Starts { tried, of: STARTS });
        let from: Vec<f64> = (0..model.unknowns()).map(|_| 3.0 * random.f64() - 1.0).collect();
        let found = sequential(model, &from, COARSE, false, &[]);
        let fitted = model.at(&found);
        if fitted.smallest_weight(2 * COARSE) < WEIGHT {
            continue;
        }
        let found = sequential(model, &found, COARSE, true, &[]);
        if model.at(&found).smallest_weight(2 * COARSE) < WEIGHT {
            continue;
        }
        let (sum, _) = squares(model, &found, COARSE, true);
        if sum.is_finite() && best.as_ref().is_none_or(|(least, _)| sum < least * (1.0 - 1e-6)) {
            best = Some((sum, found));
        }
    }
    Ok(best.map(|(_, values)| values))
}

/// The smallest sum of squares over a grid of so many intervals, the deviation being 0 at given points (the paper's
/// Eq. 16 and 17, as MATLAB's fmincon solves them).
pub(super) fn least_squares(model: &Model, from: &[f64], intervals: usize, pass: &[(f64, f64)]) -> Vec<f64> {
    let mut values = from.to_vec();
    // The method stops early where the sum is small; started again it goes on.
    for _ in 0..4 {
        values = sequential(model, &values, intervals, true, pass);
    }
    values
}

fn sequential(model: &Model, from: &[f64], intervals: usize, divided: bool, pass: &[(f64, f64)]) -> Vec<f64> {
    let (unit, _) = squares(model, from, intervals, divided);
    let unit = if unit > 0.0 && unit.is_finite() { unit } else { 1.0 };
    let objective = |values: &[f64], gradient: Option<&mut [f64]>, (): &mut ()| {
        let (sum, slopes) = squares(model, values, intervals, divided);
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
    let bounds = vec![(-1e3, 1e3); from.len()];
    let stop = StopTols { ftol_rel: 1e-15, xtol_rel: 1e-15, ..StopTols::default() };
    let (Ok((_, values, _)) | Err((_, values, _))) =
        minimize(objective, from, &bounds, &constraints, (), 2000, Some(stop));
    if values.iter().all(|value| value.is_finite()) { values } else { from.to_vec() }
}
