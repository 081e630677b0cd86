//! `prove-cap table`: how good patches of the cap are, degree by degree, and how six of them fit together.

use super::arguments::TableOptions;
use super::control::under_control;
use super::outcome::{Format, Outcome};
use crate::commands::{self, Failure};
use crate::report::pages::Tabled;

pub(super) fn run(options: &TableOptions, format: Format) -> Result<Outcome, Failure> {
    under_control(&options.limits, ("table", format), |control| {
        Ok(Outcome::of(&Tabled(&commands::table(control)?), format)?)
    })
}
