//! Arguments that the checker has accepted: what every search ends in.

use crate::certificate::{Argument, Certificate};
use crate::checker::{CheckError, Theorem, check_text_within};
use crate::control::{Control, Interrupted};
use crate::exact::Limit;
use crate::statement::Statement;

/// A certificate whose bytes the checker has accepted. There is no other way to make one than [`Proof::of`].
#[derive(Debug, Clone)]
pub struct Proof {
    certificate: Certificate,
    text: String,
    theorem: Box<Theorem>,
}

/// Why an argument is no proof.
#[derive(Debug, thiserror::Error)]
pub enum NoProof {
    /// The check was stopped.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
    /// It is beyond the limits of the checker.
    #[error("the checker, which judges every certificate, has limits: {0}")]
    Limit(Limit),
    /// The checker refuses it: a defect of this program.
    #[error("the independent checker refused the certificate: {0}")]
    Refused(CheckError),
}

impl Proof {
    /// The argument as a certificate of the statement, if the checker accepts it.
    ///
    /// Costs what the check costs: see proofs/FORMAT.md.
    ///
    /// # Errors
    /// [`NoProof`]
    pub fn of(statement: &Statement, argument: Argument, control: &Control) -> Result<Self, NoProof> {
        let certificate = Certificate { statement: statement.hash(), argument };
        let text = certificate.write(&statement.ring());
        match check_text_within(statement, text.as_bytes(), &mut control.work()) {
            Ok(theorem) => Ok(Proof { certificate, text, theorem: Box::new(theorem) }),
            Err(error) => Err(match error.limit() {
                // The limit may be that the work was stopped.
                Some(limit) => control.unless_stopped(NoProof::Limit(*limit)),
                None => NoProof::Refused(error),
            }),
        }
    }

    /// The certificate.
    pub fn certificate(&self) -> &Certificate {
        &self.certificate
    }

    /// Its bytes, as they are written to a file.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// What the checker made of it.
    pub fn theorem(&self) -> &Theorem {
        &self.theorem
    }
}
