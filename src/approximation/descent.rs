//! Minimax problems by sequential linear programming: Remez' exchange of points in a trust region.
//!
//! In each round the local extremes of the deviation are found, and the linear program that is the objective, linearised
//! at these points (and those of the last rounds), is solved for a step of bounded size (Osborne & Watson 1969,
//! doi:10.1093/comjnl/12.1.63).

use std::collections::VecDeque;

use microlp::{ComparisonOp, OptimizationDirection, Problem};

use super::extremes::{Place, local_extremes};
use super::model::{Deviation, Fitted, Model};
use super::objective::{Objective, PENALTY};
use crate::elimination::{Control, Interrupted, Progress};

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
    control: &Control<'_>,
) -> Result<Vec<f64>, Interrupted> {
    let mut values = start.to_vec();
    let mut radius = 0.05;
    let mut points: VecDeque<Vec<Place>> = VecDeque::new();
    let mut extremes = local_extremes(&model.at(&values), GRID);
    let mut merit = objective.of(&extremes) + beside(&model.at(&values), objective);
    for round in 1..=ROUNDS {
        control.check()?;
        control.observe(&Progress::Descent { round, reached: format!("{merit:.6e}") });
        points.push_front(extremes.clone());
        points.truncate(KEPT);
        let fitted = model.at(&values);
        let kept: Vec<Place> = points.iter().flatten().copied().collect();
        let Some(step) = linear_step(&fitted, &kept, objective, radius, merit) else {
            radius /= 4.0;
            if radius < 1e-13 {
                break;
            }
            continue;
        };
        let moved: Vec<f64> = values.iter().zip(&step).map(|(x, dx)| x + dx).collect();
        let length = step.iter().fold(0.0f64, |length, dx| length.max(dx.abs()));
        let next = model.at(&moved);
        let found = local_extremes(&next, GRID);
        let reached = objective.of(&found) + beside(&next, objective);
        // Not a number: the step went through a zero of the denominator.
        if reached < merit && next.smallest_weight(GRID) > 0.0 {
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

/// The step of at most `radius` in each unknown that is best for the linearised deviations at the points.
fn linear_step(
    fitted: &Fitted<'_>,
    points: &[Place],
    objective: Objective,
    radius: f64,
    scale: f64,
) -> Option<Vec<f64>> {
    // In units in which the deviations and the steps are near 1, as the solver's tolerance wants it.
    let deviations: Vec<_> = points.iter().map(|place| fitted.deviation(place.u, place.v)).collect();
    let steepest =
        deviations.iter().flat_map(|d| &d.gradient).fold(0.0f64, |most, slope| most.max(slope.abs()));
    let unit = (scale / steepest).min(radius);
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
    let bound = radius / unit;
    let unknowns: Vec<_> =
        deviations.first()?.gradient.iter().map(|_| problem.add_var(0.0, (-bound, bound))).collect();
    for deviation in &deviations {
        for (side, sign) in [(above, 1.0), (below, -1.0)] {
            let slopes =
                unknowns.iter().zip(&deviation.gradient).map(|(&x, slope)| (x, -sign * slope * unit / scale));
            let row: Vec<_> =
                [(side, 1.0)].into_iter().chain(slopes.filter(|(_, slope)| slope.abs() > 1e-7)).collect();
            problem.add_constraint(&row, ComparisonOp::Ge, sign * deviation.value / scale);
        }
    }
    for (deviation, sign) in edges(fitted, objective) {
        // sign·(value + slopes·step) ≥ 0, but for what is paid for.
        let side = if objective == Objective::Outer { below } else { above };
        let slopes =
            unknowns.iter().zip(&deviation.gradient).map(|(&x, slope)| (x, sign * slope * unit / scale));
        let row: Vec<_> =
            [(side, 1.0)].into_iter().chain(slopes.filter(|(_, slope)| slope.abs() > 1e-7)).collect();
        problem.add_constraint(&row, ComparisonOp::Ge, -sign * deviation.value / scale);
    }
    let solution = problem.solve().ok()?.into_solution().ok()?;
    let step: Vec<f64> = unknowns.iter().map(|&x| solution.var_value(x) * unit).collect();
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
