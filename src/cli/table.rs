//! `prove-cap table`: how good patches of the cap are, degree by degree, and how six of them fit together.

use clap::Args;

use super::control::{Limits, under_control};
use super::outcome::{Format, Outcome};
use crate::commands::{self, Failure};
use crate::report::pages::Tabled;

#[derive(Debug, Args)]
pub(super) struct TableOptions {
    #[command(flatten)]
    limits: Limits,
}

pub(super) fn run(options: &TableOptions, format: Format) -> Result<Outcome, Failure> {
    under_control(&options.limits, ("table", format), |control| {
        Ok(Outcome::of(&Tabled(&commands::table(control)?), format)?)
    })
}
