//! The command line of the full build.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Parser, Subcommand};

use super::approximate::{self, ApproximateOptions};
use super::audit::{self, AuditOptions};
use super::bound::{self, BoundOptions};
use super::construct::{self, ConstructOptions};
use super::degrees::{self, DegreesOptions};
use super::expand::{self, ExpandOptions};
use super::export::{self, ExportOptions};
use super::outcome::{Format, Outcome};
use super::prove::{self, ProveOptions};
use super::table::{self, TableOptions};
use super::{check, list};
use crate::commands::{Failure, Verdict};
use crate::report::pages::Help;

/// Can this rational Bézier patch lie exactly on that surface, for any values of its unknowns?
///
/// Answers PROVED (impossible, with a certificate), EXACT (with a control net) or UNDECIDED. Without a command it
/// proves the paper's theorem, cap-2x2: no biquadratic rational patch with the paper's edges, and its centre on the axis,
/// represents the spherical cap over one face of the inscribed cube.
#[derive(Debug, Parser)]
#[command(version, max_term_width = 110, args_conflicts_with_subcommands = true)]
#[command(
    after_help = Verdict::summary()
)]
struct CommandLine {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    options: ProveOptions,
    /// How results are printed.
    #[arg(long, value_enum, default_value_t = Format::Text, global = true)]
    format: Format,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Prove a statement, write its certificate and check it.
    Prove {
        /// A built-in statement (see `list`) or a statement file [default: cap-2x2].
        #[arg(value_name = "NAME|FILE")]
        source: Option<PathBuf>,
        #[command(flatten)]
        options: ProveOptions,
    },
    /// Replay a certificate against a statement with the independent checker.
    Check {
        /// The statement file.
        statement: PathBuf,
        /// The certificate file.
        certificate: PathBuf,
    },
    /// Print the canonical text of a statement, whose SHA-256 certificates name.
    Canonical {
        /// The statement file.
        statement: PathBuf,
    },
    /// Print the coefficients of the condition that the patch lies on the surface.
    Expand(ExpandOptions),
    /// Hold a printed coefficient listing, or a printed control net, against the truth.
    Audit(AuditOptions),
    /// Enclose the radius (of another surface F/Wᵉ) over the whole patch, with a proof, at given values of the unknowns.
    Bound(BoundOptions),
    /// Search for the best values of the unknowns, and enclose the radius there, with a proof.
    Approximate(ApproximateOptions),
    /// The best patches found of the cap, degree by degree, with proved errors, and how six of them fit together.
    Table(TableOptions),
    /// Construct a patch that covers a spherical polygon exactly, and verify it.
    Construct(ConstructOptions),
    /// Which bidegrees cover a spherical polygon exactly, with proofs.
    Degrees(DegreesOptions),
    /// Write the proof in another language: for Coq, for a computer-algebra system.
    Export(ExportOptions),
    /// List the built-in statements.
    List,
}

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
