//! A meter for work done on behalf of a file nobody has vetted.
//!
//! A unit is about a nanosecond. Work is charged before it is done, so that a small file cannot ask for much.

use std::fmt;
use std::sync::Arc;

use num_bigint::BigInt;

use super::limits;
use super::monomial::Monomial;
use super::polynomial::Polynomial;

/// A limit that a file ran into: what was limited and at what. Never a verdict on the file's claim.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Limit {
    /// What there is too much of, in the plural: "terms of a polynomial".
    pub what: &'static str,
    /// The largest amount allowed.
    pub at_most: u64,
}

impl Limit {
    /// The limit `at_most` on `what`.
    pub fn new(what: &'static str, at_most: u64) -> Self {
        Limit { what, at_most }
    }

    /// The work was ended from outside ([`Work::until`]).
    pub fn ended() -> Self {
        Limit::new("units of work before it was ended from outside", 0)
    }

    /// The limit on the length of a polynomial.
    pub fn terms() -> Self {
        Limit::new("terms of a polynomial", count(limits::TERMS))
    }

    /// The limit on the length of a number.
    pub fn digits() -> Self {
        Limit::new("digits of a number", count(limits::DIGITS))
    }
}

impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if *self == Limit::ended() {
            return f.write_str("ended from outside before it was done");
        }
        write!(f, "limit reached: at most {} {}", self.at_most, self.what)
    }
}

impl std::error::Error for Limit {}

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
    left: u64,
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
    /// Visiting a term, and each power in it.
    const TERM: u64 = 300;
    const POWER: u64 = 40;
    /// One step of a division, a common divisor or a root, beside its words.
    const STEP: u64 = 8;

    /// Units between two questions whether the work is ended from outside: some milliseconds.
    const PAUSE: u64 = 1 << 22;

    /// The full allowance of [`limits::WORK`].
    pub fn full() -> Self {
        Work { left: limits::WORK, ended: None }
    }

    /// The full allowance, which whoever waits for the work can end before its time: every few million units `ended` is
    /// asked. To be ended is to reach a limit, which is an error and never a verdict.
    pub fn until(ended: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        Work { left: limits::WORK, ended: Some(Arc::new(ended)) }
    }

    /// Not more than so many units.
    #[must_use]
    pub fn at_most(self, units: u64) -> Self {
        Work { left: self.left.min(units), ..self }
    }

    /// Takes `amount` from the allowance.
    pub fn charge(&mut self, amount: u64) -> Result<(), Limit> {
        let Some(left) = self.left.checked_sub(amount) else {
            return Err(Limit::new("units of work", limits::WORK));
        };
        let asks = self.left.div_ceil(Work::PAUSE) != left.div_ceil(Work::PAUSE);
        if asks && self.ended.as_ref().is_some_and(|ended| ended()) {
            return Err(Limit::ended());
        }
        self.left = left;
        Ok(())
    }

    /// Units taken so far from the full allowance.
    pub fn spent(&self) -> u64 {
        limits::WORK.saturating_sub(self.left)
    }

    /// A look through a list of so many names.
    pub fn charge_search(&mut self, names: usize) -> Result<(), Limit> {
        self.charge(count(names).saturating_mul(4))
    }

    /// Visiting one term.
    pub fn charge_term(&mut self, monomial: &Monomial) -> Result<(), Limit> {
        self.charge(Work::TERM.saturating_add(count(monomial.powers().len()).saturating_mul(Work::POWER)))
    }

    /// All pairs of terms of two polynomials with so many terms and powers.
    pub fn charge_pairs(&mut self, terms: (usize, usize), powers: (usize, usize)) -> Result<(), Limit> {
        let pairs = count(terms.0).saturating_mul(count(terms.1));
        let left = count(powers.0).saturating_mul(count(terms.1));
        let right = count(powers.1).saturating_mul(count(terms.0));
        let powers = left.saturating_add(right).saturating_mul(Work::POWER);
        self.charge(pairs.saturating_mul(Work::TERM).saturating_add(powers))
    }

    /// Keeping, or copying, a polynomial: as much as makes the memory of what is kept bounded by the allowance.
    pub fn charge_copy(&mut self, polynomial: &Polynomial) -> Result<(), Limit> {
        let terms = count(polynomial.term_count()).saturating_mul(1500);
        let powers = count(polynomial.power_count()).saturating_mul(100);
        self.charge(terms.saturating_add(powers).saturating_add(polynomial.bit_count().saturating_mul(16)))
    }

    /// One product of `a` and `b`.
    pub fn charge_product(&mut self, a: &BigInt, b: &BigInt) -> Result<(), Limit> {
        self.charge(words(a).saturating_mul(words(b)))
    }

    /// One greatest common divisor: about one subtraction of the longer number for each bit of both.
    pub fn charge_gcd(&mut self, a: &BigInt, b: &BigInt) -> Result<(), Limit> {
        let steps = a.bits().saturating_add(b.bits());
        self.charge(steps.saturating_mul(words(a).max(words(b)).saturating_add(Work::STEP)))
    }

    /// One square root: a few divisions of numbers that long.
    pub fn charge_root(&mut self, a: &BigInt) -> Result<(), Limit> {
        self.charge(words(a).saturating_mul(words(a)).saturating_mul(64).saturating_add(1000))
    }
}

fn count(length: usize) -> u64 {
    u64::try_from(length).unwrap_or(u64::MAX)
}

fn words(a: &BigInt) -> u64 {
    a.bits().div_ceil(64)
}
