//! `prove-cap expand NAME|FILE`: the coefficients of the surface condition.

use super::arguments::ExpandOptions;
use super::outcome::{Format, Outcome};
use super::source::find;
use crate::commands::{self, Failure};
use crate::control::Control;

pub(super) fn run(options: &ExpandOptions, format: Format) -> Result<Outcome, Failure> {
    let source = find(&options.source, &Control::default())?;
    Outcome::of(&commands::expand(source, options.basis.into())?, format)
}
