//! `prove-cap degrees [POLYGON]`: which bidegrees are exact, each answer with something that can be checked.

use std::path::{Path, PathBuf};

use clap::Args;

use super::arguments::{Format, to_json};
use super::construct::{refused, write};
use super::control::{Limits, under_control};
use super::files::write_pair;
use super::outcome::{Failure, Outcome};
use super::polygon::{PolygonOptions, Shape};
use crate::certificate::Certificate;
use crate::checker::{CheckError, check_read_within};
use crate::commands::Verdict;
use crate::construction::{
    Cell, Phase, Refusal, classify, closing_certificate, closing_statement, construct,
};
use crate::control::Control;
use crate::report::{Backing, degrees_data, degrees_text, explain};
use crate::statement::Statement;

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

/// The statement that the phase closes, and its refutation, which the checker has accepted.
fn closing(shape: &Shape, text: &str, control: &Control) -> Result<(Statement, Certificate), Refusal> {
    let statement = Statement::read(text).map_err(CheckError::from)?;
    let certificate = closing_certificate(&shape.polygon, &statement).map_err(Refusal::Limit)?;
    let certificate = certificate.ok_or(Refusal::NoneFound)?;
    check_read_within(&statement, &certificate, &mut control.work())
        .map_err(|error| control.unless_stopped(Refusal::from(error)))?;
    Ok((statement, certificate))
}

pub(super) fn run(options: &DegreesOptions, format: Format) -> Result<Outcome, Failure> {
    under_control(&options.limits, ("degrees", format), |control| carried_out(options, format, control))
}

fn carried_out(options: &DegreesOptions, format: Format, control: &Control) -> Result<Outcome, Failure> {
    let shape = Shape::find(&options.polygon)?;
    if let Some(bidegree) = &options.explain {
        let text = explain(&shape.name, &shape.polygon, (bidegree[0], bidegree[1]));
        let text = match format {
            Format::Json => {
                to_json(&serde_json::json!({ "name": shape.name, "bidegree": bidegree, "argument": text }))?
            }
            _ => text,
        };
        return Ok(Outcome { text, verdict: Verdict::Classified });
    }
    let directory =
        options.output.clone().unwrap_or_else(|| Path::new("proofs").join(format!("degrees-{}", shape.name)));
    let phase = Phase::of(&shape.polygon);
    let mut backing = Backing::default();
    if phase == Phase::Open {
        let title = format!("Closing condition of the quadrilateral {}", shape.name);
        let text = closing_statement(&shape.polygon, &title);
        let (statement, certificate) = match closing(&shape, &text, control) {
            Ok(refutation) => refutation,
            Err(refusal) => return refused(&shape, (2, 2), refusal, format),
        };
        let certificate = (&*certificate.write(&statement.ring()), "certificate.txt");
        backing.closing = match write_pair(&directory.join("closing"), &text, certificate, control) {
            Ok(files) => Some(files),
            Err(unchecked) => return unchecked.outcome(&shape.name, format),
        };
    }
    let bases = [(2, 2), (4, 2), (2, 4)].into_iter().filter(|base| match classify(phase, *base) {
        Cell::Exact(from) => from == *base,
        Cell::LongerWay => true,
        _ => false,
    });
    let bases: Vec<(u32, u32)> = bases.filter(|(m, n)| *m.max(n) <= options.up_to).collect();
    for base in bases {
        let made = match construct(&shape.polygon, &shape.name, base, None, control) {
            Ok(made) => made,
            Err(refusal) => return refused(&shape, base, refusal, format),
        };
        match write(&directory.join(format!("{}x{}", base.0, base.1)), &made, control) {
            Ok(files) => backing.nets.push((base, made, files)),
            Err(unchecked) => return unchecked.outcome(&shape.name, format),
        }
    }
    let text = match format {
        Format::Json => to_json(&degrees_data(&shape.name, &shape.polygon, options.up_to, &backing))?,
        _ => degrees_text(&shape.name, &shape.polygon, options.up_to, &backing),
    };
    Ok(Outcome { text, verdict: Verdict::Classified })
}
