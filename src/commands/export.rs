//! `export`: a proof in another language, for another program to verify.

use std::path::Path;

use super::{Failure, NoAnswer, Rejected, Source, Undecided};
use crate::certificate::Certificate;
use crate::checker::{CheckError, check_read_within};
use crate::control::Control;
use crate::elimination;
use crate::formats::export::{self, Case, ExportError, Target, pac_files};
use crate::prove::{Attempt, Reason, prove};

/// The certificate that is exported.
#[derive(Debug, Clone, Copy)]
pub enum Which<'a> {
    /// One that is found now.
    Found,
    /// The bytes of a file; unless `unchecked`, our checker judges it first.
    Given {
        /// The file.
        file: &'a Path,
        /// Its bytes.
        bytes: &'a [u8],
        /// Whether it is exported even if our own checker rejects it.
        unchecked: bool,
    },
}

/// How the text is divided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Division {
    /// One text.
    Whole,
    /// As many files as the other program reads.
    Files,
}

/// A proof in another language.
#[derive(Debug)]
pub struct Exported {
    /// What it proves.
    pub name: String,
    /// The text, or the texts with what the names of their files end in.
    pub parts: Vec<(Option<&'static str>, String)>,
}

/// Writes a proof in another language.
///
/// # Errors
/// [`NoAnswer`]: there is no proof to export, or the language cannot say it.
pub fn export(
    source: &Source,
    which: Which<'_>,
    (target, division): (Target, Division),
    control: &Control,
) -> Result<Exported, NoAnswer> {
    let name = source.name.clone();
    let certificate = match which {
        Which::Given { file, bytes, unchecked } => given(source, (file, bytes), unchecked, control)?,
        Which::Found => found(source, control)?,
    };
    let unfit = |error: ExportError| match control.unless_stopped(error) {
        ExportError::Interrupted(why) => NoAnswer::from(Undecided::stopped(&name, why)),
        error => Failure::about(&name, error).into(),
    };
    let case = Case::within(&source.statement, &certificate, control).map_err(unfit)?;
    let parts = match (target, division) {
        (Target::Pac, Division::Files) => {
            let files = pac_files(&case).map_err(unfit)?;
            files.into_iter().map(|(ending, text)| (Some(ending), text)).collect()
        }
        _ => vec![(None, export::export(&case, target).map_err(unfit)?)],
    };
    Ok(Exported { name, parts })
}

/// The certificate in a file, or what our checker has against it.
fn given(
    source: &Source,
    (file, bytes): (&Path, &[u8]),
    unchecked: bool,
    control: &Control,
) -> Result<Certificate, NoAnswer> {
    let statement = &source.statement;
    let unknowns = statement.unknowns().len();
    let certificate = Certificate::read(bytes, &statement.ring(), unknowns, &mut control.work())
        .map_err(|error| Failure::at(file.display(), &error))?;
    if unchecked {
        return Ok(certificate);
    }
    match check_read_within(statement, &certificate, &mut control.work()) {
        Ok(_) => Ok(certificate),
        Err(CheckError::Rejected(rejection)) => Err(NoAnswer::Rejected(Rejected {
            name: source.name.clone(),
            file: file.display().to_string(),
            rejection,
        })),
        Err(error) => Err(Failure::in_file(file, error).into()),
    }
}

/// The certificate that is found for the statement, or that none was.
fn found(source: &Source, control: &Control) -> Result<Certificate, NoAnswer> {
    Err(match prove(&source.statement, control).map_err(Failure::of)? {
        Attempt::Proved { proof, .. } => return Ok(proof.certificate().clone()),
        Attempt::Undecided(Reason::Elimination(elimination::Undecided::Interrupted(why))) => {
            Undecided::stopped(&source.name, why).into()
        }
        Attempt::Undecided(_) => Undecided::new(
            &source.name,
            "no proof was found to be exported; `prove-cap prove` says what was found instead",
        )
        .into(),
    })
}
