//! `prove-cap prove [NAME|FILE]`: prove a statement, write statement and certificate, check what was written.

use std::path::Path;

use super::arguments::{Format, to_json};
use super::control::{Limits, under_control};
use super::files::write_and_check;
use super::outcome::{Failure, Outcome};
use super::source::Source;
use crate::checker::Claim;
use crate::commands::Verdict;
use crate::control::Control;
use crate::prove::{Attempt, Reason, prove};
use crate::report::{describe, json};

pub(super) fn run(
    name_or_file: &Path,
    directory: Option<&Path>,
    extend: bool,
    limits: &Limits,
    format: Format,
) -> Result<Outcome, Failure> {
    under_control(limits, (&name_or_file.to_string_lossy(), format), |control| {
        let source = Source::find_within(name_or_file, control)?;
        carried_out(name_or_file, source, (directory, extend), format, control)
    })
}

fn carried_out(
    name_or_file: &Path,
    source: Source,
    (directory, extend): (Option<&Path>, bool),
    format: Format,
    control: &Control,
) -> Result<Outcome, Failure> {
    let (mut source, mut added) = (source, false);
    let attempt = loop {
        let attempt = prove(&source.statement, control).map_err(Failure::of)?;
        match extension_of(&attempt).filter(|_| extend) {
            // Each time the field grows, and four radicands are the limit.
            Some(radicands) => source = source.with_radicands(radicands)?,
            None => break attempt,
        }
        added = true;
    };
    let files = match &attempt {
        Attempt::Proved { certificate, .. } => {
            let text = certificate.write(&source.statement.ring());
            match write_and_check(&source, directory, (&text, "certificate.txt"), control) {
                Ok(files) => Some(files),
                Err(unchecked) => return unchecked.outcome(&source.name, format),
            }
        }
        Attempt::Undecided(_) => None,
    };
    let text = match format {
        Format::Text | Format::Latex => {
            let named = (source.name.as_str(), &*name_or_file.to_string_lossy());
            let described = describe(named, &source.statement, source.cap, &attempt, files.as_ref(), control);
            let mut text = described.map_err(Failure::of)?;
            if added {
                text += &format!("Extended     radicands = {:?}\n", source.statement.field().values());
            }
            text
        }
        Format::Json => {
            let data = json::attempt(&source.name, &source.statement, &attempt, files.as_ref(), control)
                .map_err(Failure::of)?;
            to_json(&data)?
        }
    };
    let verdict = match &attempt {
        Attempt::Undecided(_) => Verdict::Undecided,
        Attempt::Proved { theorem, .. } => match theorem.claim() {
            Claim::Impossible(_) => Verdict::Impossible,
            _ => Verdict::Exact,
        },
    };
    Ok(Outcome { text, verdict })
}

/// The radicands with which an undecided statement is exact.
fn extension_of(attempt: &Attempt) -> Option<&[u32]> {
    match attempt {
        Attempt::Undecided(Reason::Consistent(consistent)) => {
            consistent.extension.as_ref().map(|extension| extension.radicands.as_slice())
        }
        _ => None,
    }
}
