//! What is claimed: a field, unknowns, and equations in them, given as a patch on a surface or as a list.
//!
//! A statement is pure data. [`Statement::read`] reads the TOML that people write, with every expression
//! evaluated exactly; [`Statement::canonical`] writes the one canonical text of its mathematical content,
//! whose SHA-256 a certificate names. Grammar and meaning: `proofs/FORMAT.md`.

// Layers: each uses those above it only.
mod place;
mod error;
mod model;
mod canonical;
mod expression;
mod keys;
mod patch;
mod document;

pub use error::{StatementError, StatementFault};
pub use model::{COORDINATES, HomogeneousPoint, Patch, Statement, Subject};
pub use patch::{Convention, UNIT_SPHERE};
pub use place::Place;
