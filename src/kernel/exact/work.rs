//! A meter for work done on behalf of a file nobody has vetted.
//!
//! Work is charged before it is done, so that a small file cannot ask for much. A unit is about a nanosecond,
//! as
//! `benches/kernel.rs` shows: the whole allowance of 15·10⁹ lasts about 15 seconds.
//!
//! Memory is counted where it is taken, at no less than it is with all that the allocator adds. To give it
//! back is to say that it was let go of; what nobody says so of stays counted, so that the count is never too
//! low.

use std::fmt;
use std::sync::Arc;

use super::limits::{self, Limit};

/// Why arithmetic did not come to an end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Stop {
    /// A limit was reached.
    Limit(Limit),
    /// What an earlier check has excluded came about: a fault of this program, never a verdict.
    Defect(&'static str),
}

impl From<Limit> for Stop {
    fn from(limit: Limit) -> Self {
        Stop::Limit(limit)
    }
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Stop::Limit(limit) => limit.fmt(f),
            Stop::Defect(what) => write!(f, "a fault of this program: {what}; please report it"),
        }
    }
}

impl std::error::Error for Stop {}

/// The work still allowed.
#[derive(Clone)]
pub struct Work {
    allowed: u64,
    left: u64,
    held: u64,
    most: u64,
    ended: Option<Arc<Ended>>,
}

/// Whether whoever waits for the work has had enough.
type Ended = dyn Fn() -> bool + Send + Sync;

impl fmt::Debug for Work {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Work({} units left)", self.left)
    }
}

impl Work {
    /// What a call of an operation on polynomials costs at least.
    pub(super) const CALL: u64 = 1000;
    /// Visiting a term, and each power in it.
    pub(crate) const TERM: u64 = 300;
    pub(crate) const POWER: u64 = 40;
    /// Comparing two names.
    const NAME: u64 = 4;

    /// Units between two questions whether the work is ended from outside: some milliseconds.
    const PAUSE: u64 = 1 << 22;

    /// The full allowance of [`limits::WORK`].
    pub fn full() -> Self {
        Work { allowed: limits::WORK.at_most, left: limits::WORK.at_most, held: 0, most: 0, ended: None }
    }

    /// The full allowance, which whoever waits for the work can end before its time: every few million units `ended` is
    /// asked. To be ended is to reach a limit, which is an error and never a verdict.
    pub fn until(ended: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        Work { ended: Some(Arc::new(ended)), ..Work::full() }
    }

    /// Not more than so many units from here on.
    #[must_use]
    pub fn at_most(self, units: u64) -> Self {
        let left = self.left.min(units);
        Work { allowed: left, left, ..self }
    }

    /// Takes `amount` from the allowance.
    ///
    /// # Errors
    /// Where less than that is left: nothing is taken then.
    pub fn charge(&mut self, amount: u64) -> Result<(), Limit> {
        let Some(left) = self.left.checked_sub(amount) else {
            return Err(Limit { at_most: self.allowed, ..limits::WORK });
        };
        let asks = self.left.div_ceil(Work::PAUSE) != left.div_ceil(Work::PAUSE);
        if asks && self.ended.as_ref().is_some_and(|ended| ended()) {
            return Err(limits::ENDED);
        }
        self.left = left;
        Ok(())
    }

    /// Units taken so far.
    pub fn spent(&self) -> u64 {
        self.allowed.saturating_sub(self.left)
    }

    /// So many times the same.
    pub(crate) fn charge_each(&mut self, number: usize, amount: u64) -> Result<(), Limit> {
        self.charge(count(number).saturating_mul(amount))
    }

    /// Memory of so many bytes, and writing to it.
    pub(crate) fn keep(&mut self, bytes: u64) -> Result<(), Limit> {
        self.charge(bytes)?;
        self.hold(bytes)
    }

    /// Memory of so many bytes, which was written to already.
    pub(crate) fn hold(&mut self, bytes: u64) -> Result<(), Limit> {
        let held = self.held.saturating_add(bytes);
        limits::MEMORY.check(held)?;
        self.held = held;
        self.most = self.most.max(held);
        Ok(())
    }

    /// Bytes held now.
    pub fn held(&self) -> u64 {
        self.held
    }

    /// The most bytes that were held at any one time.
    pub fn most_held(&self) -> u64 {
        self.most
    }

    /// Nothing that was taken since so many bytes were held is there any more.
    pub(crate) fn release_to(&mut self, held: u64) {
        self.held = self.held.min(held);
    }

    /// So many bytes were let go of.
    pub(crate) fn release(&mut self, bytes: u64) {
        self.held = self.held.saturating_sub(bytes);
    }

    /// Memory for a list.
    pub(crate) fn keep_each(&mut self, number: usize, bytes: u64) -> Result<(), Limit> {
        self.keep(count(number).saturating_mul(bytes))
    }

    /// A look through a list of so many names.
    pub(crate) fn charge_search(&mut self, names: usize) -> Result<(), Limit> {
        self.charge_each(names, Work::NAME)
    }

    /// A look at a text, a fixed number of times.
    pub(crate) fn charge_text(&mut self, bytes: usize) -> Result<(), Limit> {
        self.charge_each(bytes, 20)
    }
}

/// A length as a number.
pub(crate) fn count(length: usize) -> u64 {
    u64::try_from(length).unwrap_or(u64::MAX)
}
