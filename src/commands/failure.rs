//! ERROR: a command that could not be carried out, and where the fault is.

use std::fmt;
use std::path::Path;

use serde::Serialize;

use crate::certificate::CertificateError;
use crate::exact::Limit;
use crate::formats::listing::ListingError;
use crate::statement::StatementError;

/// Why a command could not be carried out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Failure {
    message: String,
    at: Location,
}

/// Where a fault is, as far as that is known.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub struct Location {
    /// The file, as it was named.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// The line, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<usize>,
    /// The column in characters, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub column: Option<usize>,
}

/// An error that knows its place in a text, and says it first: `12:18: …`.
pub trait Placed: fmt::Display {
    /// Line and column.
    fn place(&self) -> (usize, usize);
}

impl Placed for StatementError {
    fn place(&self) -> (usize, usize) {
        (self.place.line, self.place.column)
    }
}

impl Placed for ListingError {
    fn place(&self) -> (usize, usize) {
        (self.place.line, self.place.column)
    }
}

impl Placed for CertificateError {
    fn place(&self) -> (usize, usize) {
        (self.line, self.column)
    }
}

impl Failure {
    /// In words.
    pub fn new(message: impl Into<String>) -> Self {
        Failure { message: message.into(), at: Location::default() }
    }

    /// From anything that explains itself.
    pub fn of(error: impl fmt::Display) -> Self {
        Failure::new(error.to_string())
    }

    /// With a file or a name before it: `FILE: …`.
    pub fn about(name: impl fmt::Display, error: impl fmt::Display) -> Self {
        Failure::new(format!("{name}: {error}"))
    }

    /// Of a file as a whole: `FILE: …`.
    pub fn in_file(file: &Path, error: impl fmt::Display) -> Self {
        let at = Location { file: Some(file.display().to_string()), ..Location::default() };
        Failure { at, ..Failure::about(file.display(), error) }
    }

    /// At a place in a file: `FILE:LINE:COLUMN: …`.
    pub fn at(file: impl fmt::Display, error: &impl Placed) -> Self {
        let (line, column) = error.place();
        let at = Location { file: Some(file.to_string()), line: Some(line), column: Some(column) };
        Failure { message: format!("{file}:{error}"), at }
    }

    /// The same, of this file.
    #[must_use]
    pub fn of_file(mut self, file: &Path) -> Self {
        self.at.file = Some(file.display().to_string());
        self
    }

    /// What is printed after `ERROR:`.
    pub fn message(&self) -> &str {
        self.message.trim_end()
    }

    /// Where the fault is.
    pub fn location(&self) -> &Location {
        &self.at
    }

    /// The same with words before it.
    #[must_use]
    pub fn after(self, words: &str) -> Self {
        Failure { message: format!("{words}{}", self.message), ..self }
    }

    /// Whether it says that trusted work was ended from outside.
    pub fn is_end(&self) -> bool {
        self.message.contains(&Limit::ended().to_string())
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message())
    }
}

impl std::error::Error for Failure {}

impl From<prove_cap_kernel::outcome::Failure> for Failure {
    fn from(failure: prove_cap_kernel::outcome::Failure) -> Self {
        Failure::new(failure.0)
    }
}
