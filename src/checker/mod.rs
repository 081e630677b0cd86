//! The independent checker: replays a certificate against a statement and returns a [`Theorem`].
//!
//! It derives the equations from the statement itself, by substitution into the surface polynomial, and
//! multiplies out what the certificate says. It knows no monomial order, no division and no elimination,
//! and uses nothing of the prover. (The prover uses it: both read statements and certificates with the
//! same readers and know the trusted numbers and polynomials, and the prover's reports evaluate the checker's
//! equations; what is found is found with arithmetic and an expansion of the prover's own.)

// No rejecting check is an assertion, and no machine arithmetic wraps: see ARCHITECTURE.md, "The trusted part".
#![deny(
    clippy::arithmetic_side_effects,
    clippy::as_conversions,
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::panic,
    clippy::string_slice,
    clippy::unreachable,
    clippy::unwrap_used
)]
#![deny(clippy::disallowed_macros, reason = "assert! and its like")]

mod equations;
mod error;
mod net;
mod replay;
mod subdivision;
mod theorem;
mod wording;

pub use equations::Equations;
pub use error::{CheckError, Rejection};
pub use theorem::{Claim, Theorem};
pub use wording::written;

use crate::certificate::{Argument, Certificate};
use crate::exact::{Polynomial, Work};
use crate::statement::Statement;

/// Checks the bytes of a certificate file against the bytes of a statement file.
///
/// # Errors
/// [`CheckError::Rejected`] where the certificate is well formed and does not prove its claim; the other
/// variants where a file cannot be read or reaches a limit, which says nothing about the claim.
pub fn check(statement: &[u8], certificate: &[u8]) -> Result<Theorem, CheckError> {
    // One allowance for everything that is done for these two files.
    let mut work = Work::full();
    let statement = Statement::read_bytes(statement, &mut work)?;
    let certificate =
        Certificate::read(certificate, &statement.ring(), statement.unknowns().len(), &mut work)?;
    examine(&statement, &certificate, &mut work)
}

/// Checks a certificate against a statement, both read already.
pub fn check_read(statement: &Statement, certificate: &Certificate) -> Result<Theorem, CheckError> {
    // What was built in memory need not be well formed; what the reader accepts is.
    let (ring, mut work) = (statement.ring(), Work::full());
    let text = certificate.write(&ring);
    let read = Certificate::read(text.as_bytes(), &ring, statement.unknowns().len(), &mut work)?;
    examine(statement, &read, &mut work)
}

fn examine(statement: &Statement, certificate: &Certificate, work: &mut Work) -> Result<Theorem, CheckError> {
    let expected = statement.hash();
    if certificate.statement != expected {
        let actual = certificate.statement.clone();
        return Err(Rejection::OtherStatement { expected, actual }.into());
    }
    match &certificate.argument {
        Argument::Impossible(steps) => {
            let equations = Equations::of(statement, work).map_err(CheckError::Equations)?;
            replay::replay(statement, &equations, steps, work)
        }
        Argument::Exact(values) => identity(statement, values, work),
        Argument::Cover(cover) => {
            // The patch lies on the sphere; then, that it covers what its corners span.
            identity(statement, &cover.values, work)?;
            subdivision::cover::verify(statement, cover, work)
        }
        Argument::Bounds(bounds) => subdivision::bounds::verify(statement, bounds, work),
        Argument::Unreachable(argument) => subdivision::unreachable::verify(statement, argument, work),
    }
}

fn identity(statement: &Statement, values: &[Polynomial], work: &mut Work) -> Result<Theorem, CheckError> {
    let equations = Equations::of(statement, work).map_err(CheckError::Equations)?;
    net::verify(statement, &equations, values, work).map_err(|error| match error {
        net::Failure::Rejected(rejection) => rejection.into(),
        net::Failure::Limit(limit) => CheckError::Replay { step: 0, limit },
    })
}
