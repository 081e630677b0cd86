//! What `approximate` takes.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::limits::Limits;
use super::plot::PlotOptions;
use super::values::{point, tolerance};
use crate::approximation::Objective;

#[derive(Debug, Args)]
pub(in crate::cli) struct ApproximateOptions {
    /// A built-in statement (see `list`) or a statement file.
    #[arg(value_name = "NAME|FILE")]
    pub(in crate::cli) source: PathBuf,
    /// What is to be smallest.
    #[arg(long, value_enum, default_value_t = ObjectiveName::Minimax)]
    pub(in crate::cli) objective: ObjectiveName,
    /// For least squares: sample points each way.
    #[arg(long, value_name = "N", default_value_t = 101, value_parser = clap::value_parser!(u16).range(2..=1001))]
    pub(in crate::cli) points: u16,
    /// For least squares: a point of the square where the patch is to lie on the surface; may be repeated.
    #[arg(long, value_name = "U,V", value_parser = point)]
    pub(in crate::cli) pass: Vec<(f64, f64)>,
    /// How near the bounds are to the true extremes [default: 1e-12 for the radius; as many digits of F/Wᵉ].
    #[arg(long, value_name = "SIZE", value_parser = tolerance)]
    pub(in crate::cli) tolerance: Option<u32>,
    /// For minimax: prove that no values of the unknowns do better, up to a millionth of the error.
    #[arg(long)]
    pub(in crate::cli) prove_best: bool,
    /// Where the random starts of the search begin; the result hardly ever depends on it.
    #[arg(long, default_value_t = 1)]
    pub(in crate::cli) seed: u64,
    /// Where statement.toml and the certificates are written [default: proofs/NAME].
    #[arg(short, long, value_name = "DIR")]
    pub(in crate::cli) output: Option<PathBuf>,
    #[command(flatten)]
    pub(in crate::cli) plot: PlotOptions,
    #[command(flatten)]
    pub(in crate::cli) limits: Limits,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum ObjectiveName {
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
