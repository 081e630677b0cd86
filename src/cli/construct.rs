//! `prove-cap construct [POLYGON] --bidegree M N`: an exact patch, verified.

use std::path::Path;

use super::arguments::ConstructOptions;
use super::control::under_control;
use super::files::write_pair;
use super::outcome::{Ended, Format, Outcome};
use crate::commands::{self, Failure};
use crate::construction::Construction;
use crate::control::Control;
use crate::report::Files;
use crate::report::pages::{Constructing, Tiling};

pub(super) fn run(options: &ConstructOptions, format: Format) -> Result<Outcome, Failure> {
    under_control(&options.limits, ("construct", format), |control| carried_out(options, format, control))
}

fn carried_out(options: &ConstructOptions, format: Format, control: &Control) -> Result<Outcome, Ended> {
    let shape = options.polygon.shape()?;
    let bidegree = (options.bidegree[0], options.bidegree[1]);
    let what = if options.tiling { "tiling" } else { "construct" };
    let directory = options.output.clone().unwrap_or_else(|| {
        Path::new("proofs").join(format!("{what}-{}-{}x{}", shape.name, bidegree.0, bidegree.1))
    });
    let name = shape.name.clone();
    if options.tiling {
        let tiled = &commands::construct_tiling(shape, bidegree, control)?;
        for (number, face) in (1..).zip(&tiled.tiled.faces) {
            write(&directory.join(format!("face-{number:02}")), (&name, face), control)?;
        }
        return Ok(Outcome::of(&Tiling { tiled, directory: &directory }, format)?);
    }
    let centre = options.centre.as_deref().map(|text| shape.number(text)).transpose();
    let centre = centre.map_err(|fault| fault.after("--centre: "))?;
    let constructed = &commands::construct(shape, bidegree, centre.as_ref(), control)?;
    let files = write(&directory, (&name, &constructed.made), control)?;
    Ok(Outcome::of(&Constructing { constructed, files }, format)?)
}

/// The statement with both certificates.
pub(super) fn write(
    directory: &Path,
    (name, made): (&str, &Construction),
    control: &Control,
) -> Result<Vec<Files>, Ended> {
    let statement = (name, made.text.as_str());
    let mut files = vec![write_pair(directory, statement, (made.exact.text(), "certificate.txt"), control)?];
    if let Ok(cover) = &made.cover {
        files.push(write_pair(directory, statement, (cover.text(), "cover.txt"), control)?);
    }
    Ok(files)
}
