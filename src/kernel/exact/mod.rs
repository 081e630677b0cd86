//! Exact arithmetic of the trusted part: polynomials in the unknowns with coefficients in a real
//! multiquadratic field K = Q(√d₁, …, √dₖ).
//!
//! K is not a type here. As a vector space over Q it has the basis √(product of a subset of the
//! radicands), so a polynomial over K is a finite sum of `rational · √n · power product`, and one map
//! from basis elements to rationals serves for constants, polynomials and control points alike.
//! Slow and short on purpose: everything that is believed rests on this folder. It has no monomial
//! order to speak of (only an order of spelling), no division of polynomials, no elimination.
//! The prover has its own, faster algebra and does not use this one to reason.

// Layers: each uses those above it only.
pub mod limits;
mod work;
mod numbers;
mod radicands;
mod monomial;
mod polynomial;
mod arithmetic;
mod substitution;
mod sign;
mod root;
mod spelling;

pub use arithmetic::Arithmetic;
pub use limits::Limit;
pub use monomial::Monomial;
pub(crate) use numbers::bytes;
pub use numbers::decimal_value;
pub use polynomial::Polynomial;
pub use radicands::{Radicands, RadicandsError};
pub use root::NoRoot;
pub use spelling::{Ring, SpellingError, read_natural};
pub(crate) use work::count;
pub use work::{Stop, Work};
