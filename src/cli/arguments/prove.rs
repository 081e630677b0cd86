//! What `prove` takes.

use std::path::PathBuf;

use clap::Args;

use super::limits::Limits;

#[derive(Debug, Args)]
pub(in crate::cli) struct ProveOptions {
    /// Where statement.toml and certificate.txt are written [default: proofs/NAME].
    #[arg(short, long, value_name = "DIR")]
    pub(in crate::cli) output: Option<PathBuf>,
    /// Add radicands to the statement where its values lie in a larger field.
    #[arg(long)]
    pub(in crate::cli) extend: bool,
    #[command(flatten)]
    pub(in crate::cli) limits: Limits,
}
