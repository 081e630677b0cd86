//! The largest value of a quotient of two forms on the unit square.

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
/// coefficient nᵢ − bar·dᵢ on a box is positive, the quotient is at most the bar there. Boxes that cannot do better than the best corner so far are dropped, the others halved, all
/// of one depth before those of the next: near a maximum a bounded number is left at each depth.
pub(super) fn largest(
    numerator: Coefficients,
    denominator: Coefficients,
    bits: u32,
    slack: &Integer,
    at_most: usize,
    control: &Control,
) -> Result<Extreme, NoTree> {
    let mut level = vec![Part::whole([numerator, denominator])];
    let mut best: Option<Extreme> = None;
    let mut seen = 0;
    while !level.is_empty() {
        for part in &level {
            control.check()?;
            let [above, below] = &part.forms;
            for (number, &place) in above.corners().iter().enumerate() {
                // n/d > best iff n·2^bits > best·d: no division unless it is.
                let scaled = above.values[place].shifted_left(bits);
                let better = best.as_ref().is_none_or(|best| scaled > &best.value * &below.values[place]);
                // Where the denominator is so small that it is lost in rounding, there is no quotient: the caller has seen to it that
                // there is no such corner.
                if better && !below.values[place].is_negative() && !below.values[place].is_zero() {
                    let (value, _) = scaled.quotient_and_remainder(&below.values[place]);
                    if best.as_ref().is_none_or(|best| value > best.value) {
                        best = Some(Extreme { at: part.place(number), value });
                    }
                }
            }
        }
        let Some(Extreme { value, .. }) = &best else { break };
        let bar = value + slack;
        let promising = |part: &Part<2>| {
            let [above, below] = &part.forms;
            above.values.iter().zip(&below.values).any(|(n, d)| n.shifted_left(bits) > &bar * d)
        };
        seen += level.len();
        if seen > at_most {
            return Err(NoTree::TooMany);
        }
        let mut halves = Vec::new();
        for part in level.iter().filter(|part| promising(part)) {
            control.check()?;
            halves.extend(part.halves());
        }
        level = halves;
    }
    best.ok_or(NoTree::TooMany)
}
