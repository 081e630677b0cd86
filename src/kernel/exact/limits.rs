//! The limits that protect the trusted part from hostile files, in one table.
//!
//! Reaching one is an error, never a verdict. `proofs/FORMAT.md` prints this table; a test compares them.

/// Bytes of a statement file.
pub const STATEMENT_BYTES: u64 = 1 << 20;
/// Bytes of a certificate file.
pub const CERTIFICATE_BYTES: u64 = 16 << 20;
/// Bytes of one line of a certificate.
pub const LINE_BYTES: usize = 1 << 20;
/// Steps of a certificate.
pub const STEPS: usize = 100_000;
/// Decimal digits of one integer (a numerator, a denominator, a number under a root).
pub const DIGITS: usize = 4096;
/// Terms of one polynomial.
pub const TERMS: usize = 1_000_000;
/// Powers of variables in all terms of one polynomial.
pub const POWERS: usize = 10_000_000;
/// Bits of a number on the way to a result: a common denominator, a product before it is reduced.
pub const BITS: u64 = 1 << 17;
/// Bits of all numbers of one sum before it is reduced.
pub const SUM_BITS: u64 = 1 << 31;
/// Bits of all numbers of a statement together.
pub const STATEMENT_BITS: u64 = 1 << 27;
/// Total degree of a power product, and any one exponent.
pub const DEGREE: u32 = 1000;
/// Unknowns of a statement.
pub const UNKNOWNS: usize = 1024;
/// Non-vanishing assumptions of a statement.
pub const ASSUMPTIONS: usize = 64;
/// Polynomials of a bare system.
pub const EQUATIONS: usize = 4096;
/// Degree of a patch in either parameter.
pub const BIDEGREE: u32 = 32;
/// Degree of the surface.
pub const SURFACE_DEGREE: u32 = 8;
/// Nesting of brackets in an expression.
pub const NESTING: usize = 64;
/// Radicands of a field.
pub const RADICANDS: usize = 4;
/// The largest radicand.
pub const RADICAND: u32 = 1_000_000;
/// Characters of an unknown's or a constant's name.
pub const NAME: usize = 32;
/// Characters of a title.
pub const TITLE: usize = 200;
/// Units of work for one statement with one certificate; [`super::Work`] has the prices.
pub const WORK: u64 = 4_000_000_000;
/// Decimal places of a bound.
pub const PLACES: u32 = 1000;
/// Boxes of a subdivision.
pub const BOXES: usize = 1_000_000;
/// Sample points of an argument over all values of the unknowns.
pub const SAMPLES: usize = 10_000;
