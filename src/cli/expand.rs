//! `prove-cap expand NAME|FILE`: the coefficients of the surface condition.

use std::path::Path;

use super::arguments::{Format, to_json};
use super::outcome::{Failure, Outcome};
use super::source::Source;
use crate::expand::Basis;
use crate::report::{describe_expansion, json};

pub(super) fn run(name_or_file: &Path, basis: Basis, format: Format) -> Result<Outcome, Failure> {
    let source = Source::find(name_or_file)?;
    match format {
        Format::Text | Format::Latex => {
            describe_expansion(&source.statement, basis).map_err(Failure::of).map(Outcome::shown)
        }
        Format::Json => {
            let data = serde_json::json!({
                "name": source.name,
                "statement": json::statement(&source.statement),
                "basis": if basis == Basis::Bernstein { "bernstein" } else { "monomial" },
                "coefficients": json::expansion(&source.statement, basis).map_err(Failure::of)?,
            });
            to_json(&data).map(Outcome::shown)
        }
    }
}
