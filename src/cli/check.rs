//! `prove-cap check STATEMENT CERTIFICATE` and `prove-cap canonical STATEMENT`.

use std::path::Path;

use super::files::read_limited;
use super::outcome::{Format, Outcome};
use crate::commands::{self, Failure};
use crate::exact::{Work, limits};
use crate::report::pages::{Canonical, Checking};

pub(super) fn run(statement: &Path, certificate: &Path, format: Format) -> Result<Outcome, Failure> {
    let text = read_limited(statement, limits::STATEMENT_BYTES.at_most)?;
    let argument = read_limited(certificate, limits::CERTIFICATE_BYTES.at_most)?;
    let checked = &commands::check((statement, &text), (certificate, &argument), &mut Work::full())?;
    Outcome::of(&Checking { checked, certificate: &certificate.display().to_string() }, format)
}

pub(super) fn canonical(statement: &Path, format: Format) -> Result<Outcome, Failure> {
    let text = read_limited(statement, limits::STATEMENT_BYTES.at_most)?;
    let canonical = commands::canonical((statement, &text))?;
    Outcome::of(&Canonical { canonical }, format)
}
