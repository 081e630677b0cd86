//! What a command comes to, on standard output and as an exit status.

use std::process::ExitCode;

use prove_cap_kernel::outcome::{failed, print};

pub use prove_cap_kernel::outcome::Failure;

use crate::commands::Verdict;

/// What a command prints, and the verdict in it.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The text for standard output.
    pub text: String,
    /// The verdict, which is the exit status.
    pub verdict: Verdict,
}

impl Outcome {
    /// A text without a verdict.
    pub(super) fn shown(text: String) -> Self {
        Outcome { text, verdict: Verdict::Shown }
    }
}

/// Prints what a command came to and turns it into the exit status.
pub fn finish(result: Result<Outcome, Failure>) -> ExitCode {
    match result.and_then(|outcome| print(&outcome.text).map(|()| outcome.verdict)) {
        Ok(verdict) => ExitCode::from(verdict.status()),
        Err(failure) => ExitCode::from(failed(&failure).code()),
    }
}
