//! Why a certificate was not accepted.

use std::fmt;

use crate::claims::Rejection;
use crate::exact::Limit;
use crate::failure::{Failure, Place};
use crate::statement::{StatementError, StatementFault};
use crate::text::{CertificateError, CertificateFault};

/// Why there is no theorem.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum CheckError {
    /// The statement cannot be read.
    Statement(StatementError),
    /// The certificate cannot be read.
    Certificate(CertificateError),
    /// A limit was reached.
    Limited {
        /// Where.
        place: Place,
        /// Which.
        limit: Limit,
    },
    /// A check found what an earlier check has excluded: a fault of this program.
    Defect(&'static str),
    /// The certificate does not prove its claim.
    Rejected(Rejection),
}

impl CheckError {
    /// The limit that was reached, if that is what the error is: it says nothing of the claim.
    pub fn limit(&self) -> Option<&Limit> {
        match self {
            CheckError::Limited { limit, .. } => Some(limit),
            CheckError::Statement(error) => match &error.fault {
                StatementFault::Limit(limit) => Some(limit),
                _ => None,
            },
            CheckError::Certificate(error) => match &error.fault {
                CertificateFault::Limit(limit) => Some(limit),
                _ => None,
            },
            CheckError::Defect(_) | CheckError::Rejected(_) => None,
        }
    }
}

impl fmt::Display for CheckError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CheckError::Statement(error) => error.fmt(f),
            CheckError::Certificate(error) => error.fmt(f),
            CheckError::Limited { place, limit } => match place {
                Place::Equations => write!(f, "deriving the equations: {limit}"),
                Place::Values => write!(f, "trying the values: {limit}"),
                Place::Step(step) => write!(f, "step {step}: {limit}"),
                Place::Node(tree, node) => write!(f, "{tree}, box {node}: {limit}"),
            },
            CheckError::Defect(what) => write!(f, "a fault of this program: {what}; please report it"),
            CheckError::Rejected(rejection) => rejection.fmt(f),
        }
    }
}

impl std::error::Error for CheckError {}

impl From<StatementError> for CheckError {
    fn from(error: StatementError) -> Self {
        CheckError::Statement(error)
    }
}

impl From<CertificateError> for CheckError {
    fn from(error: CertificateError) -> Self {
        CheckError::Certificate(error)
    }
}

impl From<Failure<Rejection>> for CheckError {
    fn from(failure: Failure<Rejection>) -> Self {
        match failure {
            Failure::Rejected(rejection) => CheckError::Rejected(rejection),
            Failure::Limited { place, limit } => CheckError::Limited { place, limit },
            Failure::Defect(what) => CheckError::Defect(what),
        }
    }
}
