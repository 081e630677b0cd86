//! What `table` takes.

use clap::Args;

use super::limits::Limits;

#[derive(Debug, Args)]
pub(in crate::cli) struct TableOptions {
    #[command(flatten)]
    pub(in crate::cli) limits: Limits,
}
