//! `prove-cap degrees [POLYGON]`: which bidegrees are exact, each answer with something that can be checked.

use std::path::Path;

use super::arguments::DegreesOptions;
use super::construct::write;
use super::control::under_control;
use super::files::write_pair;
use super::outcome::{Ended, Format, Outcome};
use crate::commands::{self, Failure};
use crate::control::Control;
use crate::report::pages::{Classifying, Explained};

pub(super) fn run(options: &DegreesOptions, format: Format) -> Result<Outcome, Failure> {
    under_control(&options.limits, ("degrees", format), |control| carried_out(options, format, control))
}

fn carried_out(options: &DegreesOptions, format: Format, control: &Control) -> Result<Outcome, Ended> {
    let shape = options.polygon.shape()?;
    if let Some(bidegree) = &options.explain {
        let bidegree = (bidegree[0], bidegree[1]);
        return Ok(Outcome::of(&Explained { shape, bidegree }, format)?);
    }
    let name = shape.name.clone();
    let directory = options.output.clone();
    let directory = directory.unwrap_or_else(|| Path::new("proofs").join(format!("degrees-{name}")));
    let degrees = &commands::degrees(shape, options.up_to, control)?;
    let closing = degrees.closing.as_ref().map(|closing| {
        let files = (closing.refutation.text(), "certificate.txt");
        write_pair(&directory.join("closing"), (&name, &closing.text), files, control)
    });
    let closing = closing.transpose()?;
    let nets = degrees
        .nets
        .iter()
        .map(|((m, n), made)| write(&directory.join(format!("{m}x{n}")), (&name, made), control));
    let nets = nets.collect::<Result<Vec<_>, _>>()?;
    Ok(Outcome::of(&Classifying { degrees, closing, nets }, format)?)
}
