//! What `construct` takes.

use std::path::PathBuf;

use clap::Args;

use super::limits::Limits;
use super::polygon::PolygonOptions;

#[derive(Debug, Args)]
pub(in crate::cli) struct ConstructOptions {
    #[command(flatten)]
    pub(in crate::cli) polygon: PolygonOptions,
    /// The degrees in u and v.
    #[arg(long, num_args = 2, value_names = ["M", "N"], required = true, value_parser = clap::value_parser!(u32).range(1..=32))]
    pub(in crate::cli) bidegree: Vec<u32>,
    /// The number that is free at the centre of the patch with the symmetry of the square, from bidegree (4,4) on [default: 1].
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    pub(in crate::cli) centre: Option<String>,
    /// Cover the whole sphere by images of the polygon, and compute exactly whether neighbours meet point for point.
    #[arg(long, conflicts_with_all = ["corners", "centre"])]
    pub(in crate::cli) tiling: bool,
    /// Where statement.toml and the certificates are written [default: proofs/construct-POLYGON-MxN].
    #[arg(short, long, value_name = "DIR")]
    pub(in crate::cli) output: Option<PathBuf>,
    #[command(flatten)]
    pub(in crate::cli) limits: Limits,
}
