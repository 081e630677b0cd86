//! Two ways to go about it: the one whose proofs people follow, and the one for large systems.

/// How elimination proceeds where it has a choice.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Strategy {
    /// Equations as they are given; a linear polynomial is solved and substituted as soon as it turns up. Given up
    /// when a matrix has more than [`PLAIN`] columns, or the proof is not short.
    Plain,
    /// Homogeneous, sparse equations, and no polynomial lifted that 1 does not need.
    Thorough,
}

/// Columns of a matrix up to which proofs are meant to be followed step by step.
pub(super) const PLAIN: usize = 21;

/// Characters of such a proof.
pub(super) const SHORT: usize = 2_000;
