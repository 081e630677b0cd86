//! `prove-cap bound NAME|FILE --set NAME=VALUE …`: a proved enclosure of the radius over the whole patch.

use std::path::PathBuf;

use clap::Args;

use super::control::{Limits, under_control};
use super::files::{sealed_name, write_and_check};
use super::outcome::{Ended, Format, Outcome};
use super::plot::PlotOptions;
use super::source::find;
use super::values::{interval, tolerance, values};
use crate::commands::{self, Failure};
use crate::control::Control;
use crate::report::pages;

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

fn carried_out(options: &BoundOptions, format: Format, control: &Control) -> Result<Outcome, Ended> {
    let source = find(&options.source, control)?;
    commands::degree_of(&source.statement)?;
    let values = values(&source.statement, &options.set)?;
    let (places, claim) = (options.tolerance, options.claim.clone());
    let bounded = &commands::bound(commands::Bounding { source, values, places, claim }, control)?;
    let (source, enclosure) = (&bounded.source, &bounded.enclosure);
    let certificate = enclosure.certificate.write(&source.statement.ring());
    let name = sealed_name("bounds", &certificate);
    let files = write_and_check(source, options.output.as_deref(), (&certificate, &name), control)?;
    let picture = options.plot.draw(source, enclosure, None, control)?;
    Ok(Outcome::of(&pages::Bounding { bounded, files, picture }, format)?)
}
