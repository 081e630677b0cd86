//! What a command comes to: text for stdout, and an exit status that is part of the answer.

use std::fmt;
use std::io::Write;
use std::process::ExitCode;

/// The exit status and what it means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// 0: VERIFIED; the claim is established. Also for what claims nothing.
    Established,
    /// 1: REJECTED; the certificate is wrong.
    Wrong,
    /// 2: ERROR; what a [`Failure`] comes to.
    Failed,
}

impl Status {
    /// The number.
    pub const fn code(self) -> u8 {
        match self {
            Status::Established => 0,
            Status::Wrong => 1,
            Status::Failed => 2,
        }
    }
}

/// What a command prints on stdout, and how it exits.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The text.
    pub text: String,
    /// The status.
    pub status: Status,
}

/// A command that could not be carried out: exit 2, the message on stderr after `ERROR`.
#[derive(Debug, Clone)]
pub struct Failure(pub String);

impl Failure {
    /// From anything that explains itself.
    pub fn of(error: impl fmt::Display) -> Self {
        Failure(error.to_string())
    }
}

impl Outcome {
    /// A text that claims nothing.
    pub fn plain(text: String) -> Self {
        Outcome { text, status: Status::Established }
    }
}

/// Prints a text on stdout.
///
/// # Errors
/// Where it cannot be written. A reader that closes the pipe early has seen enough.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut stdout = std::io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Failure(format!("the result cannot be written: {error}")))
        }
        _ => Ok(()),
    }
}

/// Prints what a command came to and turns it into the exit status.
pub fn finish(result: Result<Outcome, Failure>) -> ExitCode {
    let status = match result.and_then(|outcome| print(&outcome.text).map(|()| outcome.status)) {
        Ok(status) => status,
        Err(failure) => failed(&failure),
    };
    ExitCode::from(status.code())
}

/// Tells of a failure on stderr.
pub fn failed(Failure(message): &Failure) -> Status {
    let _ = writeln!(std::io::stderr().lock(), "ERROR: {}", message.trim_end());
    Status::Failed
}
