//! `prove-cap approximate NAME|FILE`: the best values of the unknowns that are found, enclosed, and if asked for proved best.

use super::arguments::ApproximateOptions;
use super::control::under_control;
use super::files::{sealed_name, write_and_check};
use super::outcome::{Ended, Format, Outcome};
use super::source::find;
use crate::approximation::Search;
use crate::commands::{self, Best, Failure, sensible};
use crate::control::Control;
use crate::proof::Proof;
use crate::report::pages::{Approximating, about};

pub(super) fn run(options: &ApproximateOptions, format: Format) -> Result<Outcome, Failure> {
    let name = options.source.to_string_lossy();
    under_control(&options.limits, (&name, format), |control| carried_out(options, format, control))
}

fn carried_out(options: &ApproximateOptions, format: Format, control: &Control) -> Result<Outcome, Ended> {
    let search = Search {
        objective: options.objective.into(),
        points: usize::from(options.points),
        pass: options.pass.clone(),
        places: options.tolerance,
        seed: options.seed,
    };
    let source = find(&options.source, control)?;
    commands::degree_of(&source.statement)?;
    sensible(&search, options.prove_best)?;
    let approximated = &commands::approximate(source, search, options.prove_best, control)?;
    // What was found is written and checked even where the time is over.
    let (source, unhurried) = (&approximated.source, &Control::default());
    let write = |kind: &str, proof: &Proof| {
        let name = sealed_name(kind, proof.text());
        write_and_check(source, options.output.as_deref(), (proof.text(), &name), unhurried)
    };
    let enclosure = &approximated.found.enclosure;
    let files = write("bounds", &enclosure.proof)?;
    let picture = options.plot.draw(source, enclosure, Some(&about(approximated)), unhurried)?;
    let barrier = match &approximated.best {
        Best::Proved(barrier, _) => Some(write("unreachable", &barrier.proof)?),
        Best::NotAsked | Best::Zero | Best::Open(_) => None,
    };
    Ok(Outcome::of(&Approximating { approximated, files, barrier, picture }, format)?)
}
