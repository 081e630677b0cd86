//! What `degrees` takes.

use std::path::PathBuf;

use clap::Args;

use super::limits::Limits;
use super::polygon::PolygonOptions;

#[derive(Debug, Args)]
pub(in crate::cli) struct DegreesOptions {
    #[command(flatten)]
    pub(in crate::cli) polygon: PolygonOptions,
    /// The largest degrees in the table.
    #[arg(long, value_name = "DEGREE", default_value_t = 6, value_parser = clap::value_parser!(u32).range(1..=32))]
    pub(in crate::cli) up_to: u32,
    /// The argument for one bidegree.
    #[arg(long, num_args = 2, value_names = ["M", "N"], value_parser = clap::value_parser!(u32).range(0..=32))]
    pub(in crate::cli) explain: Option<Vec<u32>>,
    /// Where what backs the table is written [default: proofs/degrees-POLYGON].
    #[arg(short, long, value_name = "DIR")]
    pub(in crate::cli) output: Option<PathBuf>,
    #[command(flatten)]
    pub(in crate::cli) limits: Limits,
}
