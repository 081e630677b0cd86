//! Least squares by Levenberg and Marquardt's method: Gauss and Newton's steps, shortened where they lead too far.
//!
//! It comes to the bottom of long flat valleys, where a method that knows only the gradient stops on the way.

use super::linear::Orthogonal;
use super::model::Model;
use super::start::Stopped;
use crate::control::{Control, Interrupted};

/// Steps that are tried at most.
const STEPS: usize = 200;
/// So many steps with little gain, one after another, are the last.
const IDLE: usize = 3;

/// How far unknowns may go, in their own units.
pub(super) const REACH: f64 = 1e3;

/// The sum of (F/Wᵉ)², the columns of its Jacobian, and −F/Wᵉ.
type Equations = (f64, Vec<Vec<f64>>, Vec<f64>);

/// Values with the smallest sum of squares of F/Wᵉ over a grid of so many intervals, as far as it goes down from a start: until the
/// steps gain less than a given part of the sum.
pub(super) fn bottom(
    model: &Model,
    from: &[f64],
    intervals: usize,
    least_gain: f64,
    control: &Control,
) -> Result<Vec<f64>, Stopped> {
    let mut values = from.to_vec();
    let stopped = |values: &[f64]| {
        let best = Some(values.to_vec());
        move |why| Stopped { why, best }
    };
    let mut here = equations(model, &values, intervals, control).map_err(stopped(&values))?;
    let (mut damping, mut idle) = (0.03, 0);
    for _ in 0..STEPS {
        let (sum, columns, right) = &here;
        // The damping is one more equation for each unknown: its step is nothing.
        let unknowns = values.len();
        let damped = columns.iter().enumerate().map(|(k, column)| {
            let size = column.iter().map(|x| x * x).sum::<f64>().sqrt();
            let own = (0..unknowns).map(|l| if l == k { damping * size } else { 0.0 });
            column.iter().copied().chain(own).collect()
        });
        let right: Vec<f64> = right.iter().copied().chain(std::iter::repeat_n(0.0, unknowns)).collect();
        let step = Some(Orthogonal::of(damped.collect()).solved(&right));
        let step = step.filter(|step| step.iter().all(|dx| dx.is_finite()));
        let moved: Option<Vec<f64>> =
            step.map(|step| values.iter().zip(&step).map(|(x, dx)| x + dx).collect());
        let next = match &moved {
            Some(moved) => Some(equations(model, moved, intervals, control).map_err(stopped(&values))?),
            None => None,
        };
        match moved.zip(next) {
            Some((moved, next)) if next.0 < *sum && in_reach(model, &moved, intervals) => {
                let gain = (sum - next.0) / sum;
                (values, here) = (moved, next);
                damping = (damping / 5.0).max(1e-12);
                idle = if gain < least_gain { idle + 1 } else { 0 };
                if idle == IDLE {
                    break;
                }
            }
            _ => {
                damping *= 5.0;
                if damping > 1e6 {
                    break;
                }
            }
        }
    }
    Ok(values)
}

/// Whether the denominator is positive on the grid and no unknown far beyond its own unit.
fn in_reach(model: &Model, values: &[f64], intervals: usize) -> bool {
    values.iter().all(|value| value.abs() < REACH) && model.at(values).smallest_weight(intervals) > 0.0
}

fn equations(
    model: &Model,
    values: &[f64],
    intervals: usize,
    control: &Control,
) -> Result<Equations, Interrupted> {
    let fitted = model.at(values);
    let at = |i: usize| i as f64 / intervals as f64;
    let points = (intervals + 1) * (intervals + 1);
    let (mut sum, mut right) = (0.0, Vec::with_capacity(points));
    let mut columns = vec![Vec::with_capacity(points); values.len()];
    for i in 0..=intervals {
        control.check()?;
        for j in 0..=intervals {
            let d = fitted.ratio(at(i), at(j));
            sum += d.value * d.value;
            right.push(-d.value);
            columns.iter_mut().zip(&d.gradient).for_each(|(column, slope)| column.push(*slope));
        }
    }
    Ok((sum, columns, right))
}
