//! Minimax problems by sequential linear programming: Remez' exchange of points in a trust region.
//!
//! In each round the local extremes of the deviation are found, and the linear program that is the objective, linearised
//! at these points (and those of the last rounds), is solved for a step of bounded size (Osborne & Watson 1969,
//! doi:10.1093/comjnl/12.1.63).

use std::collections::VecDeque;

use microlp::{ComparisonOp, OptimizationDirection, Problem};

use super::extremes::{Place, local_extremes};
use super::linear::Orthogonal;
use super::model::{Deviation, Fitted, Model};
use super::objective::{Objective, PENALTY};
use super::progress::Progress;
use super::start::Stopped;
use crate::control::Control;

/// Intervals of the grid on which extremes are looked for.
pub(super) const GRID: usize = 64;
const ROUNDS: usize = 200;
/// Rounds whose points are kept.
const KEPT: usize = 4;

/// Goes down from a start.
pub(super) fn descend(
    model: &Model,
    start: &[f64],
    objective: Objective,
    control: &Control,
) -> Result<Vec<f64>, Stopped> {
    let mut values = start.to_vec();
    let mut radius = 0.05;
    let mut points: VecDeque<Vec<Place>> = VecDeque::new();
    let mut extremes = local_extremes(&model.at(&values), GRID);
    let mut merit = objective.of(&extremes) + beside(&model.at(&values), objective);
    for round in 1..=ROUNDS {
        control.check().map_err(|why| Stopped { why, best: Some(values.clone()) })?;
        control.observe(&Progress::Descent { round, reached: format!("{:.6e}", merit * model.unit()) });
        points.push_front(extremes.clone());
        points.truncate(KEPT);
        let fitted = model.at(&values);
        let kept: Vec<Place> = points.iter().flatten().copied().collect();
        let try_step = |step: &[f64]| {
            let moved: Vec<f64> = values.iter().zip(step).map(|(x, dx)| x + dx).collect();
            let next = model.at(&moved);
            let found = local_extremes(&next, GRID);
            let reached = objective.of(&found) + beside(&next, objective);
            // Not a number: the step went through a zero of the denominator.
            let better = reached < merit && next.smallest_weight(GRID) > 0.0;
            (better, moved, reached, found)
        };
        let Some(step) = linear_step(&fitted, &kept, objective, radius, merit, None) else {
            radius /= 4.0;
            if radius < 1e-13 {
                break;
            }
            continue;
        };
        let length = step.iter().fold(0.0f64, |length, dx| length.max(dx.abs()));
        let (mut better, mut moved, mut reached, mut found) = try_step(&step);
        if !better {
            // Along a curved valley a straight step climbs its side: once more, with the deviations as they are there.
            let there = model.at(&moved);
            points.push_front(found.clone());
            let corrected = linear_step(&fitted, &kept, objective, radius, merit, Some((&there, &step)));
            if let Some(step) = corrected {
                (better, moved, reached, found) = try_step(&step);
            }
        }
        if better {
            let gain = (merit - reached) / merit;
            (values, merit, extremes) = (moved, reached, found);
            radius = (radius * 2.0).min(0.5);
            if gain < 1e-13 {
                break;
            }
        } else {
            points.push_front(found);
            radius = (radius / 3.0).min(length / 3.0);
        }
        if radius < 1e-14 {
            break;
        }
    }
    Ok(values)
}

/// The step of at most `radius` in each unknown that is best for the linearised deviations at the points. If the deviations after some
/// step are known, the linear functions agree with them there.
fn linear_step(
    fitted: &Fitted<'_>,
    points: &[Place],
    objective: Objective,
    radius: f64,
    scale: f64,
    known: Option<(&Fitted<'_>, &[f64])>,
) -> Option<Vec<f64>> {
    // In units in which the deviations and the steps are near 1, as the solver's tolerance wants it.
    let at = |place: &Place| {
        let mut deviation = fitted.deviation(place.u, place.v);
        if let Some((there, step)) = known {
            let linear = deviation.gradient.iter().zip(step).map(|(slope, dx)| slope * dx);
            deviation.value = there.value(place.u, place.v) - linear.sum::<f64>();
        }
        deviation
    };
    let deviations: Vec<_> = points.iter().map(at).collect();
    let steepest =
        deviations.iter().flat_map(|d| &d.gradient).fold(0.0f64, |most, slope| most.max(slope.abs()));
    // Nothing is to be gained where no unknown changes anything, or nothing is left.
    let unit = (scale / steepest).min(radius);
    if unit.is_nan() || unit <= 0.0 || steepest <= 0.0 {
        return None;
    }
    let scale = unit * steepest;
    let mut problem = Problem::new(OptimizationDirection::Minimize);
    let free = (f64::NEG_INFINITY, f64::INFINITY);
    let (of_above, of_below, of_both) = match objective {
        Objective::LeastSquares | Objective::Minimax => (0.0, 0.0, 1.0),
        Objective::Outer => (1.0, PENALTY, 0.0),
        Objective::Inner => (PENALTY, 1.0, 0.0),
        Objective::Width => (1.0, 1.0, 0.0),
    };
    let at_least_zero = (0.0, f64::INFINITY);
    let above = problem.add_var(of_above, if objective == Objective::Inner { at_least_zero } else { free });
    let below = problem.add_var(of_below, if objective == Objective::Outer { at_least_zero } else { free });
    let both = problem.add_var(of_both, if of_both > 0.0 { free } else { (0.0, 0.0) });
    if of_both > 0.0 {
        problem.add_constraint([(both, 1.0), (above, -1.0)], ComparisonOp::Ge, 0.0);
        problem.add_constraint([(both, 1.0), (below, -1.0)], ComparisonOp::Ge, 0.0);
    }
    // Along long flat valleys the slopes of all deviations nearly cancel: the program is written in coordinates in which they do not.
    let slopes = |deviation: &Deviation| -> Vec<f64> {
        deviation.gradient.iter().map(|slope| slope * unit / scale).collect()
    };
    let rows: Vec<Vec<f64>> = deviations.iter().map(slopes).collect();
    let columns = (0..rows.first()?.len()).map(|k| rows.iter().map(|row| row[k]).collect()).collect();
    let basis = Orthogonal::of(columns);
    let unknowns: Vec<_> = rows.first()?.iter().map(|_| problem.add_var(0.0, free)).collect();
    let sum = |slopes: &[f64], sign: f64| -> Vec<_> {
        let slopes = basis.slopes(slopes).into_iter().map(|slope| sign * slope);
        unknowns.iter().copied().zip(slopes).filter(|(_, slope)| slope.abs() > 1e-9).collect()
    };
    // No step is longer than the radius in any unknown.
    let bound = radius / unit;
    for k in 0..unknowns.len() {
        let mut row = vec![0.0; unknowns.len()];
        row[k] = 1.0 / bound;
        for sign in [1.0, -1.0] {
            problem.add_constraint(sum(&row, sign), ComparisonOp::Le, 1.0);
        }
    }
    for (deviation, slopes) in deviations.iter().zip(&rows) {
        for (side, sign) in [(above, 1.0), (below, -1.0)] {
            let row = [vec![(side, 1.0)], sum(slopes, -sign)].concat();
            problem.add_constraint(&row, ComparisonOp::Ge, sign * deviation.value / scale);
        }
    }
    for (deviation, sign) in edges(fitted, objective) {
        // sign·(value + slopes·step) ≥ 0, but for what is paid for.
        let side = if objective == Objective::Outer { below } else { above };
        let row = [vec![(side, 1.0)], sum(&slopes(&deviation), sign)].concat();
        problem.add_constraint(&row, ComparisonOp::Ge, -sign * deviation.value / scale);
    }
    let solution = problem.solve().ok()?.into_solution().ok()?;
    let white: Vec<f64> = unknowns.iter().map(|&x| solution.var_value(x)).collect();
    let step: Vec<f64> = basis.step(&white).into_iter().map(|dx| dx * unit).collect();
    // The solver keeps its bounds to its tolerance only.
    let step: Vec<f64> = step.into_iter().map(|dx| dx.clamp(-radius, radius)).collect();
    step.iter().all(|dx| dx.is_finite()).then_some(step)
}

/// What must not be negative beside the edges, times the sign.
fn edges(fitted: &Fitted<'_>, objective: Objective) -> Vec<(Deviation, f64)> {
    let sign = match objective {
        Objective::Outer => 1.0,
        Objective::Inner => -1.0,
        Objective::LeastSquares | Objective::Minimax | Objective::Width => return Vec::new(),
    };
    fitted.beside_the_edges(GRID / 4).into_iter().map(|deviation| (deviation, sign)).collect()
}

/// The penalty for being on the wrong side beside the edges, where the deviation itself is too small to show it.
fn beside(fitted: &Fitted<'_>, objective: Objective) -> f64 {
    let wrong = edges(fitted, objective).into_iter().map(|(deviation, sign)| -sign * deviation.value);
    PENALTY * wrong.fold(0.0, f64::max)
}
