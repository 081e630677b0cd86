//! `prove-cap approximate NAME|FILE`: the best values of the unknowns that are found, enclosed, and if asked for proved best.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::control::{Limits, under_control};
use super::files::{sealed_name, write_and_check};
use super::outcome::{Ended, Format, Outcome};
use super::plot::PlotOptions;
use super::source::find;
use super::values::{point, tolerance};
use crate::approximation::{Objective, Search};
use crate::certificate::Certificate;
use crate::commands::{self, Best, Failure, sensible};
use crate::control::Control;
use crate::report::pages::{Approximating, about};

#[derive(Debug, Args)]
pub(super) struct ApproximateOptions {
    /// A built-in statement (see `list`) or a statement file.
    #[arg(value_name = "NAME|FILE")]
    source: PathBuf,
    /// What is to be smallest.
    #[arg(long, value_enum, default_value_t = ObjectiveName::Minimax)]
    objective: ObjectiveName,
    /// For least squares: sample points each way.
    #[arg(long, value_name = "N", default_value_t = 101, value_parser = clap::value_parser!(u16).range(2..=1001))]
    points: u16,
    /// For least squares: a point of the square where the patch is to lie on the surface; may be repeated.
    #[arg(long, value_name = "U,V", value_parser = point)]
    pass: Vec<(f64, f64)>,
    /// How near the bounds are to the true extremes [default: 1e-12 for the radius; as many digits of F/Wᵉ].
    #[arg(long, value_name = "SIZE", value_parser = tolerance)]
    tolerance: Option<u32>,
    /// For minimax: prove that no values of the unknowns do better, up to a millionth of the error.
    #[arg(long)]
    prove_best: bool,
    /// Where the random starts of the search begin; the result hardly ever depends on it.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Where statement.toml and the certificates are written [default: proofs/NAME].
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    #[command(flatten)]
    plot: PlotOptions,
    #[command(flatten)]
    limits: Limits,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum ObjectiveName {
    /// The sum of (r² − 1)² over the sample points (the paper's Eq. 17).
    LeastSquares,
    /// The largest |r − 1|.
    Minimax,
    /// The largest r, with r ≥ 1 everywhere.
    Outer,
    /// The largest 1 − r, with r ≤ 1 everywhere.
    Inner,
    /// The largest r minus the smallest.
    Width,
}

impl From<ObjectiveName> for Objective {
    fn from(name: ObjectiveName) -> Self {
        match name {
            ObjectiveName::LeastSquares => Objective::LeastSquares,
            ObjectiveName::Minimax => Objective::Minimax,
            ObjectiveName::Outer => Objective::Outer,
            ObjectiveName::Inner => Objective::Inner,
            ObjectiveName::Width => Objective::Width,
        }
    }
}

pub(super) fn run(options: &ApproximateOptions, format: Format) -> Result<Outcome, Failure> {
    let name = options.source.to_string_lossy();
    under_control(&options.limits, (&name, format), |control| carried_out(options, format, control))
}

fn carried_out(options: &ApproximateOptions, format: Format, control: &Control) -> Result<Outcome, Ended> {
    let search = Search {
        objective: options.objective.into(),
        points: usize::from(options.points),
        pass: options.pass.clone(),
        places: options.tolerance,
        seed: options.seed,
    };
    let source = find(&options.source, control)?;
    commands::degree_of(&source.statement)?;
    sensible(&search, options.prove_best)?;
    let approximated = &commands::approximate(source, search, options.prove_best, control)?;
    // What was found is written and checked even where the time is over.
    let (source, unhurried) = (&approximated.source, &Control::default());
    let write = |kind: &str, certificate: &Certificate| {
        let text = certificate.write(&source.statement.ring());
        let name = sealed_name(kind, &text);
        write_and_check(source, options.output.as_deref(), (&text, &name), unhurried)
    };
    let enclosure = &approximated.found.enclosure;
    let files = write("bounds", &enclosure.certificate)?;
    let picture = options.plot.draw(source, enclosure, Some(&about(approximated)), unhurried)?;
    let barrier = match &approximated.best {
        Best::Proved(barrier, _) => Some(write("unreachable", &barrier.certificate)?),
        Best::NotAsked | Best::Open(_) => None,
    };
    Ok(Outcome::of(&Approximating { approximated, files, barrier, picture }, format)?)
}
