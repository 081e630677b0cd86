//! `prove-cap list`: the built-in statements.

use super::outcome::{Format, Outcome};
use crate::commands::{self, Failure};
use crate::report::pages::Listing;

pub(super) fn run(format: Format) -> Result<Outcome, Failure> {
    Outcome::of(&Listing(commands::list()?), format)
}
