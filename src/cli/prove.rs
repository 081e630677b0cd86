//! `prove-cap prove [NAME|FILE]`: prove a statement, write statement and certificate, check what was written.

use std::path::Path;

use super::arguments::ProveOptions;
use super::control::under_control;
use super::files::write_and_check;
use super::outcome::{Ended, Format, Outcome};
use super::source::find;
use crate::commands::{self, Failure};
use crate::control::Control;
use crate::prove::Attempt;
use crate::report::pages::Proving;

/// The statement that is proved when nothing else is asked for: the paper's theorem.
const DEFAULT: &str = "cap-2x2";

pub(super) fn run(source: Option<&Path>, options: &ProveOptions, format: Format) -> Result<Outcome, Failure> {
    let called = source.unwrap_or(Path::new(DEFAULT));
    let name = called.to_string_lossy();
    under_control(&options.limits, (&name, format), |control| carried_out(called, options, format, control))
}

fn carried_out(
    called: &Path,
    options: &ProveOptions,
    format: Format,
    control: &Control,
) -> Result<Outcome, Ended> {
    let proved = &commands::prove(find(called, control)?, options.extend, control)?;
    let files = match &proved.attempt {
        Attempt::Proved { proof, .. } => {
            let certificate = (proof.text(), "certificate.txt");
            Some(write_and_check(&proved.source, options.output.as_deref(), certificate, control)?)
        }
        Attempt::Undecided(_) => None,
    };
    let called = &*called.to_string_lossy();
    Ok(Outcome::of(&Proving { proved, called, files, control }, format)?)
}
