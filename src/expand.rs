//! The coefficients of the surface condition in both bases, each with its name.

use crate::algebra::polynomial_to_exact;
pub use crate::bezier::Basis;
use crate::control::{Control, Interrupted};
use crate::exact::{Limit, Polynomial};
use crate::problem::Problem;
use crate::statement::Statement;

/// One coefficient.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Coefficient {
    /// Index in u and v.
    pub index: (u32, u32),
    /// `c[1,2]`, `a[1,2]` or, where the paper's numbering applies, `a2`.
    pub name: String,
    /// The coefficient.
    pub value: Polynomial,
}

/// All coefficients of a patch's surface condition, row by row; `None` for a bare system.
///
/// # Errors
/// Where a coefficient exceeds what the formats allow.
pub fn coefficients(statement: &Statement, basis: Basis) -> Result<Option<Vec<Coefficient>>, Limit> {
    coefficients_of(&Problem::of(statement), basis, &Control::default()).map_err(|error| match error {
        ExpansionError::Limit(limit) => limit,
        ExpansionError::Interrupted(_) => unreachable!("nobody stops it"),
    })
}

/// Why there is no expansion.
#[derive(Debug, thiserror::Error)]
pub enum ExpansionError {
    /// A coefficient exceeds what the formats allow.
    #[error(transparent)]
    Limit(#[from] Limit),
    /// Interrupted.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}

/// The same of a problem, whose condition is expanded once.
///
/// # Errors
/// [`ExpansionError`]
pub fn coefficients_of(
    problem: &Problem,
    basis: Basis,
    control: &Control,
) -> Result<Option<Vec<Coefficient>>, ExpansionError> {
    let Some(form) = problem.condition(control)? else {
        return Ok(None);
    };
    let entries: Vec<_> = match basis {
        Basis::Bernstein => form.coefficients().map(|(r, s, c)| (r, s, c.clone())).collect(),
        Basis::Monomial => form.to_monomial_basis_within(control)?,
    };
    let edge_free = entries.iter().all(|(i, j, value)| *i > 0 && *j > 0 || value.is_zero());
    let numbered = basis == Basis::Monomial && form.bidegree() == (4, 4) && edge_free;
    let mut list = Vec::with_capacity(entries.len());
    for (i, j, value) in entries {
        control.check()?;
        let name = match basis {
            Basis::Bernstein => format!("c[{i},{j}]"),
            Basis::Monomial if numbered && i > 0 && j > 0 => format!("a{}", 4 * (i - 1) + j),
            Basis::Monomial => format!("a[{i},{j}]"),
        };
        list.push(Coefficient { index: (i, j), name, value: polynomial_to_exact(&value)? });
    }
    Ok(Some(list))
}

/// The distinct non-zero coefficients, each with all names it has, and how many are zero.
pub fn grouped(list: &[Coefficient]) -> (Vec<(Vec<&str>, &Polynomial)>, usize) {
    let mut groups: Vec<(Vec<&str>, &Polynomial)> = Vec::new();
    for coefficient in list.iter().filter(|coefficient| !coefficient.value.is_zero()) {
        match groups.iter_mut().find(|(_, value)| **value == coefficient.value) {
            Some((names, _)) => names.push(&coefficient.name),
            None => groups.push((vec![&coefficient.name], &coefficient.value)),
        }
    }
    (groups, list.iter().filter(|coefficient| coefficient.value.is_zero()).count())
}
