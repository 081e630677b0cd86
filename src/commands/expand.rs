//! `expand`: the coefficients of the surface condition.

use super::{Failure, Source};
use crate::expand::{Basis, Coefficient, coefficients};

/// The coefficients of a patch's condition in a basis.
#[derive(Debug)]
pub struct Expanded {
    /// The statement.
    pub source: Source,
    /// The basis.
    pub basis: Basis,
    /// All coefficients, row by row; none of a bare system.
    pub coefficients: Option<Vec<Coefficient>>,
}

/// Expands the condition.
///
/// # Errors
/// Where a coefficient exceeds what the formats allow.
pub fn expand(source: Source, basis: Basis) -> Result<Expanded, Failure> {
    let coefficients = coefficients(&source.statement, basis).map_err(Failure::of)?;
    Ok(Expanded { source, basis, coefficients })
}
