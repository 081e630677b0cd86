//! Exact arithmetic of the trusted part: polynomials in the unknowns with coefficients in a real
//! multiquadratic field K = Q(√d₁, …, √dₖ).
//!
//! K is not a type here. As a vector space over Q it has the basis √(product of a subset of the
//! radicands), so a polynomial over K is a finite sum of `rational · √n · power product`, and one map
//! from basis elements to rationals serves for constants, polynomials and control points alike.
//! Slow and short on purpose: everything that is believed rests on this folder. It has no monomial
//! order to speak of (only an order of spelling), no division of polynomials, no elimination.
//! The prover has its own, faster algebra and does not use this one to reason.

mod combination;
pub mod limits;
mod monomial;
mod polynomial;
mod radicands;
mod root;
mod sign;
mod spelling;
mod work;

pub use combination::combination;
pub use monomial::Monomial;
pub use polynomial::Polynomial;
pub use radicands::{Radicands, RadicandsError};
pub use root::NoRoot;
pub use sign::sign;
pub use spelling::{Ring, SpellingError, read_natural};
pub use work::{Limit, Stop, Work};
