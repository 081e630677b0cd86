//! `prove-cap bound NAME|FILE --set NAME=VALUE …`: a proved enclosure of the radius over the whole patch.

use std::path::PathBuf;

use clap::Args;

use super::arguments::{Format, to_json};
use super::control::{Limits, under_control};
use super::files::{sealed_name, write_and_check};
use super::outcome::{Failure, Outcome};
use super::plot::PlotOptions;
use super::source::Source;
use super::values::{interval, tolerance, values};
use crate::approximation::{EnclosureError, EndVerdict, Finding, enclose, judge};
use crate::commands::Verdict;
use crate::control::Control;
use crate::report::bounds::{
    checked_text, enclosure_data, enclosure_details, enclosure_text, symbol, verdict_data, verdict_text,
};
use crate::report::stopped::stopped_by;
use crate::report::surface_equation;
use crate::statement::{Statement, Subject};

#[derive(Debug, Args)]
pub(super) struct BoundOptions {
    /// A built-in statement (see `list`) or a statement file.
    #[arg(value_name = "NAME|FILE")]
    source: PathBuf,
    /// The value of an unknown, exactly: a decimal, a fraction, or an expression like 4*sqrt(3)/3; once for each unknown.
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    set: Vec<String>,
    /// How near the bounds are to the true extremes; the decimals that it takes are all right.
    #[arg(long, value_name = "SIZE", default_value = "1e-12", value_parser = tolerance)]
    tolerance: u32,
    /// Hold a printed interval against the truth: AGREES, or DIFFERS with a point of the patch outside.
    #[arg(long, value_name = "LOW,HIGH", value_parser = interval, allow_hyphen_values = true)]
    claim: Option<[String; 2]>,
    /// Where statement.toml and the certificate are written [default: proofs/NAME].
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    #[command(flatten)]
    plot: PlotOptions,
    #[command(flatten)]
    limits: Limits,
}

pub(super) fn run(options: &BoundOptions, format: Format) -> Result<Outcome, Failure> {
    let name = options.source.to_string_lossy();
    under_control(&options.limits, (&name, format), |control| carried_out(options, format, control))
}

fn carried_out(options: &BoundOptions, format: Format, control: &Control) -> Result<Outcome, Failure> {
    let source = Source::find_within(&options.source, control)?;
    let statement = &source.statement;
    let degree = degree_of(statement)?;
    let values = values(statement, &options.set)?;
    let enclosure = match enclose(statement, &values, options.tolerance, control) {
        Ok(enclosure) => enclosure,
        Err(error) => return undecided(&source.name, &error, format),
    };
    let certificate = enclosure.certificate.write(&statement.ring());
    let name = sealed_name("bounds", &certificate);
    let written = write_and_check(&source, options.output.as_deref(), (&certificate, &name), control);
    let files = match written {
        Ok(files) => files,
        Err(unchecked) => return unchecked.outcome(&source.name, format),
    };
    let picture = options.plot.draw(&source, degree, &enclosure, None, control)?;
    let verdicts = options.claim.as_ref().map(|claim| judge(statement, &enclosure, claim)).transpose();
    let verdicts = verdicts.map_err(Failure::of)?;
    let fails = |verdict: &EndVerdict| matches!(verdict.finding, Finding::Fails { .. });
    let open = |verdict: &EndVerdict| matches!(verdict.finding, Finding::Open);
    let verdict = match &verdicts {
        None => Verdict::Enclosed,
        Some(verdicts) if verdicts.iter().any(fails) => Verdict::Differs,
        Some(verdicts) if verdicts.iter().any(open) => Verdict::Undecided,
        Some(_) => Verdict::Agrees,
    };
    if format == Format::Json {
        let mut data = enclosure_data((verdict, &source.name), statement, &enclosure, &files);
        data["claim"] = verdicts.as_deref().map_or(serde_json::Value::Null, verdict_data);
        return Ok(Outcome { text: to_json(&data)?, verdict });
    }
    let enclosed = enclosure_text(&enclosure.bounds, degree);
    let surface = format!("Surface: {}", surface_equation(statement));
    let mut text = match (&verdicts, &options.claim) {
        (Some(verdicts), Some([low, high])) => {
            let holds = match verdict {
                Verdict::Agrees => "holds",
                Verdict::Undecided => "is not decided",
                _ => "does not hold",
            };
            let symbol = symbol(enclosure.bounds.quantity, degree);
            format!(
                "{verdict}  {}: the printed interval [{low}, {high}] {holds}\n{surface}\n\n{}\nProved: {enclosed} on the whole patch\n",
                source.name,
                verdict_text(verdicts, &symbol)
            )
        }
        _ => format!("{verdict}  {}: {enclosed} on the whole patch\n{surface}\n", source.name),
    };
    text += &format!("\n{}\n\n", statement.title());
    text += &enclosure_details(statement, &enclosure, degree);
    text += &checked_text(&enclosure.theorem, &files);
    text += &picture;
    Ok(Outcome { text, verdict })
}

/// e, the degree of the surface.
pub(super) fn degree_of(statement: &Statement) -> Result<u32, Failure> {
    match statement.subject() {
        Subject::Patch(patch) => Ok(patch.surface.degree()),
        Subject::System(_) => Err(Failure(EnclosureError::NotAPatch.to_string())),
    }
}

/// What a search that ended without an enclosure comes to.
pub(super) fn undecided(name: &str, error: &EnclosureError, format: Format) -> Result<Outcome, Failure> {
    match error {
        EnclosureError::Interrupted(_)
        | EnclosureError::TooFine(_)
        | EnclosureError::NearZero(_)
        | EnclosureError::Unsettled { .. }
        | EnclosureError::Limit(_) => {
            let text = match format {
                Format::Json => {
                    let stopped = match error {
                        EnclosureError::Interrupted(why) => Some(stopped_by(why.why)),
                        _ => None,
                    };
                    to_json(&serde_json::json!({
                        "verdict": "UNDECIDED", "name": name, "reason": error.to_string(), "stopped": stopped,
                    }))?
                }
                _ => format!("UNDECIDED  {name}: {error}\n"),
            };
            Ok(Outcome { text, verdict: Verdict::Undecided })
        }
        error => Err(Failure(format!("{name}: {error}"))),
    }
}
