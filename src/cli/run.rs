//! From the words of a command line to its outcome.

use std::ffi::OsString;

use clap::Parser;

use super::arguments::{Command, CommandLine};
use super::outcome::{Format, Outcome};
use super::{approximate, audit, bound, check, construct, degrees, expand, export, list, prove, table};
use crate::commands::Failure;
use crate::report::pages::Help;

/// Carries out the command line. Where data was asked for, an error is data too.
pub fn run() -> Result<Outcome, Failure> {
    let (format, outcome) = match CommandLine::try_parse() {
        Ok(line) => (line.format, carried_out(&line)),
        Err(error) => {
            let (format, message) = (format_of_words(std::env::args_os()), error.render().to_string());
            // --help and --version arrive as errors that go to stdout.
            let outcome = match error.use_stderr() {
                true => Err(Failure::new(message.trim_start_matches("error: "))),
                false => Outcome::of(&Help { help: message }, format),
            };
            (format, outcome)
        }
    };
    match (format, outcome) {
        (Format::Json, Err(failure)) => Outcome::of(&failure, format),
        (_, outcome) => outcome,
    }
}

/// The format of a command line that could not be read otherwise.
fn format_of_words(words: impl Iterator<Item = OsString>) -> Format {
    let words: Vec<OsString> = words.collect();
    let json = words.iter().any(|word| word == "--format=json")
        || words.windows(2).any(|pair| pair[0] == "--format" && pair[1] == "json");
    if json { Format::Json } else { Format::Text }
}

fn carried_out(line: &CommandLine) -> Result<Outcome, Failure> {
    let format = line.format;
    match &line.command {
        None => prove::run(None, &line.options, format),
        Some(Command::Prove { source, options }) => prove::run(source.as_deref(), options, format),
        Some(Command::Check { statement, certificate }) => check::run(statement, certificate, format),
        Some(Command::Canonical { statement }) => check::canonical(statement, format),
        Some(Command::Expand(options)) => expand::run(options, format),
        Some(Command::Audit(options)) => audit::run(options, format),
        Some(Command::Bound(options)) => bound::run(options, format),
        Some(Command::Approximate(options)) => approximate::run(options, format),
        Some(Command::Table(options)) => table::run(options, format),
        Some(Command::Construct(options)) => construct::run(options, format),
        Some(Command::Degrees(options)) => degrees::run(options, format),
        Some(Command::Export(options)) => export::run(options, format),
        Some(Command::List) => list::run(format),
    }
}
