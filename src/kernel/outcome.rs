//! What a command comes to: text for stdout, and an exit status that is part of the answer.

use std::fmt;
use std::io::Write;
use std::process::ExitCode;

/// The exit status and what it means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// 0: VERIFIED, PROVED, EXACT; the full claim is established. Also for commands that claim nothing.
    Established,
    /// 1: REJECTED; the certificate is wrong.
    Wrong,
    /// 3: UNDECIDED.
    Undecided,
    /// 2: ERROR, where it is told as data on stdout; else it is a [`Failure`].
    Failed,
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

/// Prints what a command came to and turns it into the exit status.
pub fn finish(result: Result<Outcome, Failure>) -> ExitCode {
    let printed = result.and_then(|outcome| {
        let mut stdout = std::io::stdout().lock();
        let written = stdout.write_all(outcome.text.as_bytes()).and_then(|()| stdout.flush());
        match written {
            // A reader that closes the pipe early has seen enough; any other loss is an error.
            Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
                Err(Failure(format!("the result cannot be written: {error}")))
            }
            _ => Ok(outcome),
        }
    });
    match printed {
        Ok(outcome) => match outcome.status {
            Status::Established => ExitCode::SUCCESS,
            Status::Wrong => ExitCode::from(1),
            Status::Undecided => ExitCode::from(3),
            Status::Failed => ExitCode::from(2),
        },
        Err(Failure(message)) => {
            let _ = writeln!(std::io::stderr().lock(), "ERROR: {}", message.trim_end());
            ExitCode::from(2)
        }
    }
}
