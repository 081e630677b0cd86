//! What was found, as text for people and as data.

mod attempt;
mod expansion;
pub mod json;
mod mathematics;
mod refutation;
mod setting;
mod solution;
mod undecided;

pub use attempt::{Files, describe};
pub use expansion::{Basis, Coefficient, coefficients, describe_expansion, grouped};
pub use mathematics::Notation;
