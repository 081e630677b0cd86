//! `prove-cap bound NAME|FILE --set NAME=VALUE …`: a proved enclosure of the radius over the whole patch.

use super::arguments::BoundOptions;
use super::arguments::values;
use super::control::under_control;
use super::files::{sealed_name, write_and_check};
use super::outcome::{Ended, Format, Outcome};
use super::source::find;
use crate::commands::{self, Failure};
use crate::control::Control;
use crate::report::pages;

pub(super) fn run(options: &BoundOptions, format: Format) -> Result<Outcome, Failure> {
    let name = options.source.to_string_lossy();
    under_control(&options.limits, (&name, format), |control| carried_out(options, format, control))
}

fn carried_out(options: &BoundOptions, format: Format, control: &Control) -> Result<Outcome, Ended> {
    let source = find(&options.source, control)?;
    commands::degree_of(&source.statement)?;
    let values = values(&source.statement, &options.set)?;
    let (places, claim) = (options.tolerance, options.claim.clone());
    let bounded = &commands::bound(commands::Bounding { source, values, places, claim }, control)?;
    let (source, enclosure) = (&bounded.source, &bounded.enclosure);
    let certificate = enclosure.proof.text();
    let name = sealed_name("bounds", certificate);
    let files = write_and_check(source, options.output.as_deref(), (certificate, &name), control)?;
    let picture = options.plot.draw(source, enclosure, None, control)?;
    Ok(Outcome::of(&pages::Bounding { bounded, files, picture }, format)?)
}
