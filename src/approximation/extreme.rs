//! The largest value of a quotient of two forms on the unit square.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use num_rational::BigRational;

use super::boxes::{Coefficients, Part};
use super::tree::NoTree;
use crate::algebra::Integer;
use crate::control::Control;

/// A point (u, v) of the square, and the quotient there in fixed point.
#[derive(Debug, Clone)]
pub(super) struct Extreme {
    pub(super) at: [BigRational; 2],
    pub(super) value: Integer,
}

/// The largest value of numerator/denominator, in units of 2^−bits: no point has one larger by more than `slack`.
///
/// The denominator is positive and both have one bidegree, and one precision, which need not be `bits`. If no Bernstein
/// coefficient nᵢ − bar·dᵢ on a box is positive, the quotient is at most the bar there. Boxes that cannot do better than the
/// best corner so far are dropped, the others halved, all of one depth before those of the next: near a maximum a
/// bounded number is left at each depth. Where a ridge that is lower than the maximum fills all depths before
/// the maximum is found, in a small corner, the boxes that promise most are halved first.
pub(super) fn largest(
    numerator: Coefficients,
    denominator: Coefficients,
    bits: u32,
    slack: &Integer,
    at_most: usize,
    control: &Control,
) -> Result<Extreme, NoTree> {
    let whole = Part::whole([numerator, denominator]);
    match by_depth(whole.clone(), bits, slack, at_most, control) {
        Err(NoTree::TooMany) => by_promise(whole, bits, slack, at_most, control),
        other => other,
    }
}

fn by_depth(
    whole: Part<2>,
    bits: u32,
    slack: &Integer,
    at_most: usize,
    control: &Control,
) -> Result<Extreme, NoTree> {
    let mut level = vec![whole];
    let mut best: Option<Extreme> = None;
    let mut seen = 0;
    while !level.is_empty() {
        for part in &level {
            control.check()?;
            improve(&mut best, part, bits);
        }
        let Some(Extreme { value, .. }) = &best else { break };
        let bar = value + slack;
        seen += level.len();
        if seen > at_most {
            return Err(NoTree::TooMany);
        }
        let mut halves = Vec::new();
        for part in level.iter().filter(|part| promises_more(part, &bar, bits)) {
            control.check()?;
            halves.extend(part.halves());
        }
        level = halves;
    }
    best.ok_or(NoTree::TooMany)
}

fn by_promise(
    whole: Part<2>,
    bits: u32,
    slack: &Integer,
    at_most: usize,
    control: &Control,
) -> Result<Extreme, NoTree> {
    let mut best: Option<Extreme> = None;
    let mut open = BinaryHeap::from([Promising::of(whole, bits)]);
    let mut seen = 0;
    while let Some(Promising { part, .. }) = open.pop() {
        seen += 1;
        if seen > at_most {
            return Err(NoTree::TooMany);
        }
        control.check()?;
        improve(&mut best, &part, bits);
        let bar = best.as_ref().map(|best| &best.value + slack);
        if bar.is_none_or(|bar| promises_more(&part, &bar, bits)) {
            open.extend(part.halves().map(|half| Promising::of(half, bits)));
        }
    }
    best.ok_or(NoTree::TooMany)
}

/// Takes the best corner of a box, if it is better.
fn improve(best: &mut Option<Extreme>, part: &Part<2>, bits: u32) {
    let [above, below] = &part.forms;
    for (number, &place) in above.corners().iter().enumerate() {
        // n/d > best iff n·2^bits > best·d: no division unless it is.
        let scaled = above.values[place].shifted_left(bits);
        let better = best.as_ref().is_none_or(|best| scaled > &best.value * &below.values[place]);
        // Where rounding has made the denominator 0 there is no quotient; with enough bits there is no such corner.
        if better
            && let Some(value) = quotient(&scaled, &below.values[place])
            && best.as_ref().is_none_or(|best| value > best.value)
        {
            *best = Some(Extreme { at: part.place(number), value });
        }
    }
}

/// Whether the quotient may be above the bar somewhere on a box.
fn promises_more(part: &Part<2>, bar: &Integer, bits: u32) -> bool {
    let [above, below] = &part.forms;
    above.values.iter().zip(&below.values).any(|(n, d)| n.shifted_left(bits) > bar * d)
}

fn quotient(scaled: &Integer, by: &Integer) -> Option<Integer> {
    (*by > Integer::zero()).then(|| scaled.quotient_and_remainder(by).0)
}

/// A box with the largest quotient of its coefficients; `None` for one without bound.
struct Promising {
    promise: Option<Integer>,
    part: Part<2>,
}

impl Promising {
    fn of(part: Part<2>, bits: u32) -> Self {
        let [above, below] = &part.forms;
        let quotients =
            above.values.iter().zip(&below.values).map(|(n, d)| quotient(&n.shifted_left(bits), d));
        let promise = quotients.reduce(|most, next| Some(most?.max(next?))).flatten();
        Promising { promise, part }
    }
}

impl PartialEq for Promising {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Promising {}

impl PartialOrd for Promising {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Promising {
    /// By promise, one without bound first; of several those nearer to the first corner.
    fn cmp(&self, other: &Self) -> Ordering {
        let unbounded = self.promise.is_none().cmp(&other.promise.is_none());
        let by_place = || (other.part.depth, &other.part.corner).cmp(&(self.part.depth, &self.part.corner));
        unbounded.then_with(|| self.promise.cmp(&other.promise)).then_with(by_place)
    }
}
