//! The independent checker: replays a certificate against a statement and returns a [`Theorem`].
//!
//! It derives the equations from the statement itself, by substitution into the surface polynomial, and
//! multiplies out what the certificate says. It knows no monomial order, no division and no elimination,
//! and shares no code with the prover.

mod equations;
mod error;
mod net;
mod replay;
mod subdivision;
mod theorem;

pub use equations::Equations;
pub use error::{CheckError, Rejection};
pub use theorem::{Claim, Theorem};

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
