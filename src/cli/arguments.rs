//! The command line of the full build.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

use super::approximate::{self, ApproximateOptions};
use super::audit::{self, AuditOptions};
use super::bound::{self, BoundOptions};
use super::construct::{self, ConstructOptions};
use super::control::Limits;
use super::degrees::{self, DegreesOptions};
use super::export::{self, ExportOptions};
use prove_cap_kernel::outcome::Status;

use super::outcome::{Failure, Outcome};
use super::table::{self, TableOptions};
use super::{check, expand, list, prove};
use crate::commands::Verdict;
use crate::expand::Basis;

/// The statement that is proved when nothing else is asked for: the paper's theorem.
const DEFAULT: &str = "cap-2x2";

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

#[derive(Debug, Args)]
struct ProveOptions {
    /// Where statement.toml and certificate.txt are written [default: proofs/NAME].
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Add radicands to the statement where its values lie in a larger field.
    #[arg(long)]
    extend: bool,
    #[command(flatten)]
    limits: Limits,
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
    Expand {
        /// A built-in statement (see `list`) or a statement file.
        #[arg(value_name = "NAME|FILE")]
        source: PathBuf,
        /// The basis of the polynomials in u and v.
        #[arg(long, value_enum, default_value_t = BasisName::Bernstein)]
        basis: BasisName,
    },
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

/// How results are printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// For people.
    Text,
    /// As data: polynomials and elements of the field are strings in the canonical spelling of certificates, proved bounds
    /// are decimals in quotes.
    Json,
    /// As a LaTeX document (audit only).
    Latex,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum BasisName {
    /// `c[r,s]`, coefficients of uʳ(1−u)^(M−r)·vˢ(1−v)^(N−s).
    Bernstein,
    /// `a[i,j]`, coefficients of uⁱvʲ; the paper's a1, …, a16 where they apply.
    Monomial,
}

/// Pretty JSON with a final newline.
pub(super) fn to_json(data: &impl serde::Serialize) -> Result<String, Failure> {
    serde_json::to_string_pretty(data).map(|text| text + "\n").map_err(Failure::of)
}

/// Carries out the command line. Where data was asked for, an error is data too.
pub fn run() -> Result<Outcome, Failure> {
    let (format, outcome) = match CommandLine::try_parse() {
        Ok(line) => (line.format, carried_out(line)),
        // --help and --version arrive as errors that go to stdout.
        Err(error) if !error.use_stderr() => return Ok(Outcome::shown(error.render().to_string())),
        Err(error) => {
            let message = error.render().to_string();
            (
                format_of_words(std::env::args_os()),
                Err(Failure(message.trim_start_matches("error: ").to_owned())),
            )
        }
    };
    match (format, outcome) {
        (Format::Json, Err(Failure(message))) => {
            let data = serde_json::json!({ "verdict": "ERROR", "reason": message.trim_end() });
            Ok(Outcome { text: to_json(&data)?, verdict: Verdict::Failed })
        }
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

fn carried_out(line: CommandLine) -> Result<Outcome, Failure> {
    let format = line.format;
    if format == Format::Latex && !matches!(line.command, Some(Command::Audit(_))) {
        return Err(Failure("--format latex is for audit; the other commands have text and json".to_owned()));
    }
    let prove = |source: Option<PathBuf>, options: ProveOptions| {
        let source = source.unwrap_or_else(|| PathBuf::from(DEFAULT));
        prove::run(&source, options.output.as_deref(), options.extend, &options.limits, format)
    };
    match line.command {
        None => prove(None, line.options),
        Some(Command::Prove { source, options }) => prove(source, options),
        Some(Command::Check { statement, certificate }) => match format {
            Format::Text | Format::Latex => {
                let checked = check::check(&statement, &certificate)?;
                let verdict = match checked.status {
                    Status::Established => Verdict::Verified,
                    Status::Wrong => Verdict::Rejected,
                    Status::Failed => Verdict::Failed,
                };
                Ok(Outcome { text: checked.text, verdict })
            }
            Format::Json => check_as_data(&statement, &certificate),
        },
        Some(Command::Canonical { statement }) => {
            let canonical = check::canonical(&statement)?;
            match format {
                Format::Text | Format::Latex => Ok(Outcome::shown(canonical.text)),
                Format::Json => {
                    to_json(&serde_json::json!({ "canonical": canonical.text })).map(Outcome::shown)
                }
            }
        }
        Some(Command::Expand { source, basis }) => {
            let basis = match basis {
                BasisName::Bernstein => Basis::Bernstein,
                BasisName::Monomial => Basis::Monomial,
            };
            expand::run(&source, basis, format)
        }
        Some(Command::Audit(options)) => audit::run(&options, format),
        Some(Command::Bound(options)) => bound::run(&options, format),
        Some(Command::Approximate(options)) => approximate::run(&options, format),
        Some(Command::Table(options)) => table::run(&options, format),
        Some(Command::Construct(options)) => construct::run(&options, format),
        Some(Command::Degrees(options)) => degrees::run(&options, format),
        Some(Command::Export(options)) => export::run(&options, format),
        Some(Command::List) => list::run(format),
    }
}

fn check_as_data(statement: &std::path::Path, certificate: &std::path::Path) -> Result<Outcome, Failure> {
    let (data, verdict) = match check::examine(statement, certificate)? {
        Ok(theorem) => (
            serde_json::json!({
                "verdict": "VERIFIED",
                "claim": theorem.kind(),
                "theorem": theorem.sentence(),
                "statement": crate::report::json::statement(theorem.statement()),
            }),
            Verdict::Verified,
        ),
        Err(rejection) => {
            (serde_json::json!({ "verdict": "REJECTED", "reason": rejection }), Verdict::Rejected)
        }
    };
    Ok(Outcome { text: to_json(&data)?, verdict })
}
