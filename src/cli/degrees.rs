//! `prove-cap degrees [POLYGON]`: which bidegrees are exact, each answer with something that can be checked.

use std::path::{Path, PathBuf};

use clap::Args;

use super::construct::write;
use super::control::{Limits, under_control};
use super::files::write_pair;
use super::outcome::{Ended, Format, Outcome};
use super::polygon::PolygonOptions;
use crate::commands::{self, Failure};
use crate::control::Control;
use crate::report::pages::{Classifying, Explained};

#[derive(Debug, Args)]
pub(super) struct DegreesOptions {
    #[command(flatten)]
    polygon: PolygonOptions,
    /// The largest degrees in the table.
    #[arg(long, value_name = "DEGREE", default_value_t = 6, value_parser = clap::value_parser!(u32).range(1..=32))]
    up_to: u32,
    /// The argument for one bidegree.
    #[arg(long, num_args = 2, value_names = ["M", "N"], value_parser = clap::value_parser!(u32).range(0..=32))]
    explain: Option<Vec<u32>>,
    /// Where what backs the table is written [default: proofs/degrees-POLYGON].
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    #[command(flatten)]
    limits: Limits,
}

pub(super) fn run(options: &DegreesOptions, format: Format) -> Result<Outcome, Failure> {
    under_control(&options.limits, ("degrees", format), |control| carried_out(options, format, control))
}

fn carried_out(options: &DegreesOptions, format: Format, control: &Control) -> Result<Outcome, Ended> {
    let shape = options.polygon.shape()?;
    if let Some(bidegree) = &options.explain {
        let bidegree = (bidegree[0], bidegree[1]);
        return Ok(Outcome::of(&Explained { shape, bidegree }, format)?);
    }
    let name = shape.name.clone();
    let directory = options.output.clone();
    let directory = directory.unwrap_or_else(|| Path::new("proofs").join(format!("degrees-{name}")));
    let degrees = &commands::degrees(shape, options.up_to, control)?;
    let closing = degrees.closing.as_ref().map(|closing| {
        let certificate = closing.certificate.write(&closing.statement.ring());
        let files = (certificate.as_str(), "certificate.txt");
        write_pair(&directory.join("closing"), (&name, &closing.text), files, control)
    });
    let closing = closing.transpose()?;
    let nets = degrees
        .nets
        .iter()
        .map(|((m, n), made)| write(&directory.join(format!("{m}x{n}")), (&name, made), control));
    let nets = nets.collect::<Result<Vec<_>, _>>()?;
    Ok(Outcome::of(&Classifying { degrees, closing, nets }, format)?)
}
