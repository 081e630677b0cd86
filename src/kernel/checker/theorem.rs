//! What a completed check establishes, as a value that nothing else can make.

use std::fmt;

use crate::claims::Claim;
use crate::statement::Statement;

/// A proved claim about a statement. Only a completed check constructs one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Theorem {
    statement: Statement,
    claim: Claim,
}

impl Theorem {
    pub(super) fn established(statement: &Statement, claim: Claim) -> Self {
        Theorem { statement: statement.clone(), claim }
    }

    /// The statement.
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    /// The claim.
    pub fn claim(&self) -> &Claim {
        &self.claim
    }

    /// `impossible`, `exact`, `solution`, `bounds`, `unreachable` or `cover`.
    pub fn kind(&self) -> &'static str {
        self.claim.kind()
    }

    /// What was proved, as sentences.
    pub fn sentence(&self) -> String {
        self.claim.sentence(&self.statement)
    }

    /// What was replayed, and the values of the unknowns, a line each.
    pub fn details(&self) -> Vec<String> {
        self.claim.details(&self.statement)
    }
}

impl fmt::Display for Theorem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.sentence())
    }
}
