//! `prove-cap construct [POLYGON] --bidegree M N`: an exact patch, verified.

use std::path::{Path, PathBuf};

use clap::Args;

use super::control::{Limits, under_control};
use super::files::write_pair;
use super::outcome::{Ended, Format, Outcome};
use super::polygon::PolygonOptions;
use crate::commands::{self, Failure};
use crate::construction::Construction;
use crate::control::Control;
use crate::report::Files;
use crate::report::pages::{Constructing, Tiling};

#[derive(Debug, Args)]
pub(super) struct ConstructOptions {
    #[command(flatten)]
    polygon: PolygonOptions,
    /// The degrees in u and v.
    #[arg(long, num_args = 2, value_names = ["M", "N"], required = true, value_parser = clap::value_parser!(u32).range(1..=32))]
    bidegree: Vec<u32>,
    /// The number that is free at the centre of the patch with the symmetry of the square, from bidegree (4,4) on [default: 1].
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    centre: Option<String>,
    /// Cover the whole sphere by images of the polygon, and compute exactly whether neighbours meet point for point.
    #[arg(long, conflicts_with_all = ["corners", "centre"])]
    tiling: bool,
    /// Where statement.toml and the certificates are written [default: proofs/construct-POLYGON-MxN].
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    #[command(flatten)]
    limits: Limits,
}

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
    let ring = made.statement.ring();
    let exact = made.exact.0.write(&ring);
    let mut files = vec![write_pair(directory, (name, &made.text), (&exact, "certificate.txt"), control)?];
    if let Ok((certificate, _)) = &made.cover {
        let cover = certificate.write(&ring);
        files.push(write_pair(directory, (name, &made.text), (&cover, "cover.txt"), control)?);
    }
    Ok(files)
}
