//! The limits that protect the trusted part from hostile files, in one table.
//!
//! Reaching one is an error, never a verdict. A limit carries its name and its number, and every message
//! about it is made from these two. `proofs/FORMAT.md` prints the table; a test compares them.

use std::fmt;

/// A limit that a file may run into: what is limited and at what. Never a verdict on the file's claim.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limit {
    /// What there is too much of, in the plural: "terms of a polynomial".
    pub what: &'static str,
    /// The largest amount allowed.
    pub at_most: u64,
}

impl Limit {
    /// The limit `at_most` on `what`.
    pub const fn new(what: &'static str, at_most: u64) -> Self {
        Limit { what, at_most }
    }

    /// Whether this much is within the limit; an amount beyond 64 bits is not.
    pub fn allows(self, amount: impl TryInto<u64>) -> bool {
        amount.try_into().is_ok_and(|amount| amount <= self.at_most)
    }

    /// The limit as an error, unless this much is within it.
    ///
    /// # Errors
    /// The limit itself.
    pub fn check(self, amount: impl TryInto<u64>) -> Result<(), Limit> {
        if self.allows(amount) { Ok(()) } else { Err(self) }
    }

    /// The number, where 32 bits are wanted.
    pub fn number(self) -> u32 {
        u32::try_from(self.at_most).unwrap_or(u32::MAX)
    }

    /// The number, where lengths are wanted.
    pub fn length(self) -> usize {
        usize::try_from(self.at_most).unwrap_or(usize::MAX)
    }
}

impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if *self == ENDED {
            return f.write_str("ended from outside before it was done");
        }
        write!(f, "limit reached: at most {} {}", self.at_most, self.what)
    }
}

impl std::error::Error for Limit {}

/// The numbers that stand in the words of [`A_NAME`] and [`A_TITLE`] too.
macro_rules! letters_after_the_first {
    () => {
        31
    };
}
macro_rules! title {
    () => {
        200
    };
}

/// Bytes of a statement file.
pub const STATEMENT_BYTES: Limit = Limit::new("bytes in a statement", 1 << 20);
/// Bytes of a certificate file.
pub const CERTIFICATE_BYTES: Limit = Limit::new("bytes in a certificate", 16 << 20);
/// Bytes of one line of a certificate.
pub const LINE_BYTES: Limit = Limit::new("bytes in a line", 1 << 20);
/// Steps of a certificate.
pub const STEPS: Limit = Limit::new("steps", 100_000);
/// Decimal digits of one integer (a numerator, a denominator, a number under a root).
pub const DIGITS: Limit = Limit::new("digits of a number", 4096);
/// Terms of one polynomial.
pub const TERMS: Limit = Limit::new("terms of a polynomial", 1_000_000);
/// Powers of variables in all terms of one polynomial.
pub const POWERS: Limit = Limit::new("powers of variables in a polynomial", 10_000_000);
/// Bits of a number on the way to a result: a common denominator, a product before it is reduced.
pub const BITS: Limit = Limit::new("bits of an intermediate number", 1 << 17);
/// Bits of all numbers of one sum before it is reduced.
pub const SUM_BITS: Limit = Limit::new("bits in the numbers of a sum", 1 << 31);
/// Bits of all numbers of a statement together.
pub const STATEMENT_BITS: Limit = Limit::new("bits in the numbers of a statement", 1 << 27);
/// Total degree of a power product.
pub const DEGREE: Limit = Limit::new("in the degree of a power product", 1000);
/// Any one exponent.
pub const EXPONENT: Limit = Limit::new("in an exponent", 1000);
/// Unknowns of a statement.
pub const UNKNOWNS: Limit = Limit::new("unknowns", 1024);
/// Non-vanishing assumptions of a statement.
pub const ASSUMPTIONS: Limit = Limit::new("polynomials in one list", 64);
/// Polynomials of a bare system.
pub const EQUATIONS: Limit = Limit::new("polynomials in one list", 4096);
/// Degree of a patch in either parameter.
pub const BIDEGREE: Limit = Limit::new("in the degree of a patch", 32);
/// Degree of the surface.
pub const SURFACE_DEGREE: Limit = Limit::new("in the degree of the surface", 8);
/// Nesting of brackets in an expression.
pub const NESTING: Limit = Limit::new("nested brackets", 64);
/// Radicands of a field.
pub const RADICANDS: Limit = Limit::new("radicands", 4);
/// The largest radicand.
pub const RADICAND: Limit = Limit::new("in a radicand", 1_000_000);
/// Characters of an unknown's or a constant's name.
pub const NAME: Limit = Limit::new("characters of a name", 1 + letters_after_the_first!());
/// What a name is, in words.
pub(crate) const A_NAME: &str =
    concat!("a letter followed by at most ", letters_after_the_first!(), " letters, digits and underscores");
/// Characters of a title.
pub const TITLE: Limit = Limit::new("characters of a title", title!());
/// What a title is, in words.
pub(crate) const A_TITLE: &str = concat!("at most ", title!(), " characters on one line");
/// Units of work for one statement with one certificate; [`super::Work`] has the prices.
pub const WORK: Limit = Limit::new("units of work", 15_000_000_000);
/// Bytes held at any one time for one statement with one certificate, the texts of the two files apart.
pub const MEMORY: Limit = Limit::new("bytes of memory", 800_000_000);
/// Decimal places of a bound.
pub const PLACES: Limit = Limit::new("decimal places", 1000);
/// Boxes of a subdivision.
pub const BOXES: Limit = Limit::new("boxes", 1_000_000);
/// Sample points of an argument over all values of the unknowns.
pub const SAMPLES: Limit = Limit::new("samples", 10_000);

/// The work was ended from outside ([`super::Work::until`]).
pub const ENDED: Limit = Limit::new("units of work before it was ended from outside", 0);
/// No quotient has a denominator that is not positive; nothing asks for one.
pub(super) const DENOMINATORS: Limit = Limit::new("denominators that are not positive", 0);
/// A mask names a root of the field it belongs to.
pub(super) const FOREIGN_ROOTS: Limit = Limit::new("roots of another field", 0);
