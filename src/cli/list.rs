//! `prove-cap list`: the built-in statements.

use std::fmt::Write as _;

use super::arguments::Format;
use super::outcome::{Failure, Outcome};
use crate::catalogue::{ENTRIES, FAMILY};
use crate::report::json;
use crate::statement::Statement;

pub(super) fn run(format: Format) -> Result<Outcome, Failure> {
    let mut text = String::new();
    let mut data = Vec::new();
    let width = ENTRIES.iter().map(|entry| entry.name.len()).max().unwrap_or(0);
    let _ = writeln!(text, "{:<width$}  unknowns  about", "name");
    for entry in ENTRIES {
        let statement = Statement::read(&entry.statement()).map_err(Failure::of)?;
        let _ =
            writeln!(text, "{:<width$}  {:>8}  {}", entry.name, statement.unknowns().len(), entry.summary);
        data.push(serde_json::json!({
            "name": entry.name,
            "summary": entry.summary,
            "statement": json::statement(&statement),
        }));
    }
    let _ = writeln!(text, "\nCaps of other degrees: {FAMILY}, M and N from 2.");
    match format {
        Format::Text | Format::Latex => Ok(Outcome::shown(text)),
        Format::Json => super::arguments::to_json(&data).map(Outcome::shown),
    }
}
