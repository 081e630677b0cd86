//! What a command comes to, in the format that was asked for, on standard output and as an exit status.

use std::process::ExitCode;

use clap::ValueEnum;
use prove_cap_kernel::outcome::{failed, print};

use crate::commands::{Failure, NoAnswer, Undecided, Verdict};
use crate::report::pages::Unchecked;
use crate::report::{Page, json, latex, text};

/// How results are printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// For people.
    Text,
    /// As data: polynomials and elements of the field are strings in the canonical spelling of certificates, proved bounds
    /// are decimals in quotes.
    Json,
    /// As a LaTeX document.
    Latex,
}

/// What a command prints, and the verdict in it.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The text for standard output.
    pub text: String,
    /// The verdict, which is the exit status.
    pub verdict: Verdict,
}

/// Why a command ended without an answer.
pub(super) enum Ended {
    /// There is none.
    NoAnswer(NoAnswer),
    /// There is one, in files that the checker has not come to judge.
    Unchecked(Box<Unchecked>),
}

impl<N: Into<NoAnswer>> From<N> for Ended {
    fn from(why: N) -> Self {
        Ended::NoAnswer(why.into())
    }
}

impl Outcome {
    /// An answer in a format: the only place that knows the formats.
    pub(super) fn of(page: &impl Page, format: Format) -> Result<Outcome, Failure> {
        let text = match format {
            Format::Text => text(page).map_err(Failure::of)?,
            Format::Json => json(page).map_err(Failure::of)?,
            Format::Latex => latex(page).map_err(Failure::of)?,
        };
        Ok(Outcome { text, verdict: page.verdict() })
    }

    /// An answer, or what it comes to that there is none. A failure is told on standard error, but for data.
    pub(super) fn or_ended(outcome: Result<Outcome, Ended>, format: Format) -> Result<Outcome, Failure> {
        match outcome {
            Ok(outcome) => Ok(outcome),
            Err(Ended::NoAnswer(NoAnswer::Failed(failure))) => Err(failure),
            Err(Ended::NoAnswer(none)) => Outcome::of(&none, format),
            Err(Ended::Unchecked(unchecked)) => Outcome::of(unchecked.as_ref(), format),
        }
    }
}

impl Ended {
    /// Where the trusted part could not finish because it was stopped, that is no failure.
    pub(super) fn unless_stopped(self, name: &str, stopped: Result<(), crate::control::Interrupted>) -> Self {
        match (self, stopped) {
            (Ended::NoAnswer(NoAnswer::Failed(failure)), Err(why)) if failure.is_end() => {
                Undecided::stopped(name, why).into()
            }
            (ended, _) => ended,
        }
    }
}

/// Prints what a command came to and turns it into the exit status.
pub fn finish(result: Result<Outcome, Failure>) -> ExitCode {
    let printed = result.and_then(|outcome| Ok(print(&outcome.text).map(|()| outcome.verdict)?));
    match printed {
        Ok(verdict) => ExitCode::from(verdict.status()),
        Err(failure) => {
            let failure = prove_cap_kernel::outcome::Failure(failure.message().to_owned());
            ExitCode::from(failed(&failure).code())
        }
    }
}
