//! What `bound` takes.

use std::path::PathBuf;

use clap::Args;

use super::limits::Limits;
use super::plot::PlotOptions;
use super::values::{interval, tolerance};

#[derive(Debug, Args)]
pub(in crate::cli) struct BoundOptions {
    /// A built-in statement (see `list`) or a statement file.
    #[arg(value_name = "NAME|FILE")]
    pub(in crate::cli) source: PathBuf,
    /// The value of an unknown, exactly: a decimal, a fraction, or an expression like 4*sqrt(3)/3; once for each unknown.
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub(in crate::cli) set: Vec<String>,
    /// How near the bounds are to the true extremes; the decimals that it takes are all right.
    #[arg(long, value_name = "SIZE", default_value = "1e-12", value_parser = tolerance)]
    pub(in crate::cli) tolerance: u32,
    /// Hold a printed interval against the truth: AGREES, or DIFFERS with a point of the patch outside.
    #[arg(long, value_name = "LOW,HIGH", value_parser = interval, allow_hyphen_values = true)]
    pub(in crate::cli) claim: Option<[String; 2]>,
    /// Where statement.toml and the certificate are written [default: proofs/NAME].
    #[arg(short, long, value_name = "DIR")]
    pub(in crate::cli) output: Option<PathBuf>,
    #[command(flatten)]
    pub(in crate::cli) plot: PlotOptions,
    #[command(flatten)]
    pub(in crate::cli) limits: Limits,
}
