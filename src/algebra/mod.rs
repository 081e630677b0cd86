//! The prover's exact algebra: integers, multiquadratic fields, polynomials, and prime fields to guess with.
//!
//! Unlike `exact`, which is short, this is made to compute with: field elements are vectors of integers over
//! one common denominator, polynomials are sorted by a monomial order, and every operation has its operator.

mod convert;
mod field;
mod fixed;
mod integer;
mod lattice;
mod monomial;
mod polynomial;
mod prime_field;
mod residue_polynomial;
mod roots;
mod sign;
mod spell;
mod square_root;
mod univariate;

pub use convert::{polynomial_from_exact, polynomial_to_exact};
pub use field::{FieldElement, MultiquadraticField};
pub use fixed::{Magnitude, fixed, magnitude};
pub use integer::{BACKEND, Integer};
pub use monomial::Monomial;
pub use polynomial::Polynomial;
pub use prime_field::{PrimeField, splitting_primes};
pub use sign::Sign;
pub use spell::spell;
pub use univariate::Univariate;
