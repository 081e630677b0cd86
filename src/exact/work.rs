//! A meter for work done on behalf of a file nobody has vetted.

use std::fmt;

use num_bigint::BigInt;

use super::limits;

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

    /// The limit on the length of a polynomial.
    pub fn terms() -> Self {
        Limit::new("terms of a polynomial", words(limits::TERMS))
    }

    /// The limit on the length of a number.
    pub fn digits() -> Self {
        Limit::new("digits of a number", words(limits::DIGITS))
    }
}

impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "limit reached: at most {} {}", self.at_most, self.what)
    }
}

impl std::error::Error for Limit {}

/// The work still allowed. It is charged before the work is done.
#[derive(Debug, Clone)]
pub struct Work {
    left: u64,
}

impl Work {
    /// What visiting one term costs, in word products.
    const TERM: u64 = 64;

    /// The full allowance of [`limits::WORK`].
    pub fn full() -> Self {
        Work { left: limits::WORK }
    }

    /// Takes `amount` from the allowance.
    pub fn charge(&mut self, amount: u64) -> Result<(), Limit> {
        match self.left.checked_sub(amount) {
            Some(left) => {
                self.left = left;
                Ok(())
            }
            None => Err(Limit::new("units of work", limits::WORK)),
        }
    }

    /// Takes the cost of visiting `count` terms.
    pub fn charge_terms(&mut self, count: usize) -> Result<(), Limit> {
        self.charge(words(count).saturating_mul(Work::TERM))
    }

    /// Takes the cost of one product, quotient or common divisor of `a` and `b`.
    pub fn charge_product(&mut self, a: &BigInt, b: &BigInt) -> Result<(), Limit> {
        let (a, b) = (a.bits().div_ceil(64), b.bits().div_ceil(64));
        self.charge(a.saturating_mul(b).saturating_add(1))
    }
}

fn words(count: usize) -> u64 {
    u64::try_from(count).unwrap_or(u64::MAX)
}
