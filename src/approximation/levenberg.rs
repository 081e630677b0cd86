//! Least squares by Levenberg and Marquardt's method: Gauss and Newton's steps, shortened where they lead too far, and bent where
//! the valley bends (the geodesic acceleration of Transtrum & Sethna 2012, arXiv 1201.5885).
//!
//! It comes to the bottom of long, flat and curved valleys, where a method that knows only the gradient stops on the way.

use super::linear::Orthogonal;
use super::model::Model;
use super::start::Stopped;
use crate::control::{Control, Interrupted};

/// So many steps with little gain, one after another, are the last.
const IDLE: usize = 3;
/// How far unknowns may go, in their own units.
pub(super) const REACH: f64 = 1e3;
/// The part of a step over which its second derivative is measured.
const PROBE: f64 = 0.1;
/// The longest acceleration, in proportion to the velocity.
const BEND: f64 = 0.75;

/// Where a search for the bottom ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    /// Steps that are tried at most.
    pub(super) steps: usize,
    /// Steps that gain less, in proportion, are idle.
    pub(super) gain: f64,
}

/// F/Wᵉ over a grid.
struct Residuals {
    sum: f64,
    values: Vec<f64>,
    /// The columns of its Jacobian.
    columns: Vec<Vec<f64>>,
}

/// Values with the smallest sum of squares of F/Wᵉ over a grid of so many intervals, as far as it goes down from a start.
pub(super) fn bottom(
    model: &Model,
    from: &[f64],
    intervals: usize,
    limits: Limits,
    control: &Control,
) -> Result<Vec<f64>, Stopped> {
    let mut values = from.to_vec();
    let (mut damping, mut idle) = (0.03, 0);
    let result = (|| {
        let mut here = Residuals::of(model, &values, intervals, control)?;
        for _ in 0..limits.steps {
            let step = here.step(model, &values, intervals, damping, control)?;
            let moved: Vec<f64> = values.iter().zip(&step).map(|(x, dx)| x + dx).collect();
            let next = match in_reach(model, &moved, intervals) {
                true => Some(Residuals::of(model, &moved, intervals, control)?),
                false => None,
            };
            if let Some(next) = next.filter(|next| next.sum < here.sum) {
                idle = if here.sum - next.sum < limits.gain * here.sum { idle + 1 } else { 0 };
                (values, here) = (moved, next);
                damping = (damping / 4.0).max(1e-14);
            } else {
                damping *= 3.0;
            }
            if idle == IDLE || damping > 1e6 {
                break;
            }
        }
        Ok(())
    })();
    match result {
        Ok(()) => Ok(values),
        Err(why) => Err(Stopped { why, best: Some(values) }),
    }
}

/// Whether the denominator is positive on the grid and no unknown far beyond its own unit.
fn in_reach(model: &Model, values: &[f64], intervals: usize) -> bool {
    values.iter().all(|value| value.abs() < REACH) && model.at(values).smallest_weight(intervals) > 0.0
}

impl Residuals {
    fn of(model: &Model, values: &[f64], intervals: usize, control: &Control) -> Result<Self, Interrupted> {
        let fitted = model.at(values);
        let at = |i: usize| i as f64 / intervals as f64;
        let points = (intervals + 1) * (intervals + 1);
        let mut all = Vec::with_capacity(points);
        let mut columns = vec![Vec::with_capacity(points); values.len()];
        for i in 0..=intervals {
            control.check()?;
            for j in 0..=intervals {
                let ratio = fitted.ratio(at(i), at(j));
                all.push(ratio.value);
                columns.iter_mut().zip(&ratio.gradient).for_each(|(column, slope)| column.push(*slope));
            }
        }
        Ok(Residuals { sum: all.iter().map(|x| x * x).sum(), values: all, columns })
    }

    /// The velocity and half the acceleration of the way down.
    fn step(
        &self,
        model: &Model,
        from: &[f64],
        intervals: usize,
        damping: f64,
        control: &Control,
    ) -> Result<Vec<f64>, Interrupted> {
        // The damping is one more equation for each unknown: its step is nothing.
        let unknowns = from.len();
        let sizes: Vec<f64> =
            self.columns.iter().map(|column| column.iter().map(|x| x * x).sum::<f64>().sqrt()).collect();
        let damped = self.columns.iter().zip(&sizes).enumerate().map(|(k, (column, size))| {
            let own = (0..unknowns).map(|l| if l == k { damping * size } else { 0.0 });
            column.iter().copied().chain(own).collect()
        });
        let system = Orthogonal::of(damped.collect());
        let solved = |right: &mut dyn Iterator<Item = f64>| {
            system.solved(&right.chain(std::iter::repeat_n(0.0, unknowns)).collect::<Vec<_>>())
        };
        let velocity = solved(&mut self.values.iter().map(|value| -value));
        let probe: Vec<f64> = from.iter().zip(&velocity).map(|(x, dx)| x + PROBE * dx).collect();
        if !in_reach(model, &probe, intervals) {
            return Ok(velocity);
        }
        let there = Residuals::of(model, &probe, intervals, control)?;
        let curvature = |(place, (there, here)): (usize, (&f64, &f64))| {
            let slope: f64 = self.columns.iter().zip(&velocity).map(|(column, dx)| column[place] * dx).sum();
            -2.0 / PROBE * ((there - here) / PROBE - slope)
        };
        let pairs = there.values.iter().zip(&self.values).enumerate();
        let acceleration = solved(&mut pairs.map(curvature));
        let length =
            |step: &[f64]| -> f64 { step.iter().zip(&sizes).map(|(x, size)| (x * size).powi(2)).sum() };
        let bent = 4.0 * length(&acceleration) <= BEND * BEND * length(&velocity);
        let factor = if bent { 0.5 } else { 0.0 };
        Ok(velocity.iter().zip(&acceleration).map(|(v, a)| v + factor * a).collect())
    }
}
