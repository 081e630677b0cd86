//! `prove-cap prove [NAME|FILE]`: prove a statement, write statement and certificate, check what was written.

use std::path::Path;

use super::arguments::{Format, to_json};
use super::control::{Limits, under_control};
use super::files::write_and_check;
use super::outcome::{Failure, Outcome, Status};
use super::source::Source;
use crate::prove::{Attempt, prove};
use crate::report::{describe, json};

pub(super) fn run(
    name_or_file: &Path,
    directory: Option<&Path>,
    limits: &Limits,
    format: Format,
) -> Result<Outcome, Failure> {
    let source = Source::find(name_or_file)?;
    let attempt = under_control(limits, |control| prove(&source.statement, control))?;
    let attempt = attempt.map_err(Failure::of)?;
    let files = match &attempt {
        Attempt::Proved { certificate, .. } => {
            let text = certificate.write(&source.statement.ring());
            Some(write_and_check(&source, directory, &text, "certificate.txt")?)
        }
        Attempt::Undecided(_) => None,
    };
    let text = match format {
        Format::Text | Format::Latex => {
            let named = (source.name.as_str(), &*name_or_file.to_string_lossy());
            describe(named, &source.statement, source.cap, &attempt, files.as_ref()).map_err(Failure::of)?
        }
        Format::Json => {
            let data = json::attempt(&source.name, &source.statement, &attempt, files.as_ref())
                .map_err(Failure::of)?;
            to_json(&data)?
        }
    };
    let status = if files.is_some() { Status::Established } else { Status::Undecided };
    Ok(Outcome { text, status })
}
