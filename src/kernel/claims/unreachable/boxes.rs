//! The box of a chart that a tree has come to: what was halved is kept, not the boxes.

use std::collections::BTreeMap;

use crate::claims::subdivision::Interval;
use crate::exact::{Limit, Work};

/// Where a walk through the boxes of a chart is.
pub(super) struct Walk {
    /// The axis of h, where the chart has one.
    far: Option<usize>,
    unknowns: usize,
    /// The intervals of the axes that were halved.
    now: BTreeMap<usize, Interval>,
    /// What was halved on the way here, the last one last.
    halved: Vec<Halved>,
    /// Whether there is a box left.
    pub(super) open: bool,
}

struct Halved {
    axis: usize,
    /// The interval before; none where it was the whole one.
    before: Option<Interval>,
    /// The upper half, unless the walk is there already.
    upper: Option<Interval>,
    /// The memory of the two halves.
    bytes: u64,
}

impl Walk {
    pub(super) fn new(far: Option<usize>, unknowns: usize) -> Self {
        Walk { far, unknowns, now: BTreeMap::new(), halved: Vec::new(), open: true }
    }

    /// The interval of the box on an axis: ξ from −1 to 1, and h from 0 to 1 in the place of the unknown that
    /// is far, or the part of them that was come to. The whole one is made in `whole`.
    pub(super) fn interval<'a>(&'a self, axis: usize, whole: &'a mut Option<Interval>) -> &'a Interval {
        self.now.get(&axis).unwrap_or_else(|| whole.insert(self.whole(axis)))
    }

    fn whole(&self, axis: usize) -> Interval {
        Interval::new(if self.far == Some(axis) { [0, 1] } else { [-1, 1] }, [1, 1])
    }

    /// Goes on to the lower half of the box: across the variables in turn.
    pub(super) fn halve(&mut self, work: &mut Work) -> Result<(), Limit> {
        let held = work.held();
        work.keep(512)?;
        let axis = self.halved.len().checked_rem(self.unknowns.max(1)).unwrap_or(0);
        let mut whole = None;
        let [lower, upper] = self.interval(axis, &mut whole).halves(work)?;
        let before = self.now.insert(axis, lower);
        let bytes = work.held().saturating_sub(held);
        self.halved.push(Halved { axis, before, upper: Some(upper), bytes });
        Ok(())
    }

    /// Goes on to the next box: the upper half of the last one that was halved and whose upper half is left.
    pub(super) fn leave(&mut self, work: &mut Work) {
        while let Some(mut last) = self.halved.pop() {
            if let Some(upper) = last.upper.take() {
                self.now.insert(last.axis, upper);
                self.halved.push(last);
                return;
            }
            work.release(last.bytes);
            match last.before {
                Some(before) => self.now.insert(last.axis, before),
                None => self.now.remove(&last.axis),
            };
        }
        self.open = false;
    }
}
