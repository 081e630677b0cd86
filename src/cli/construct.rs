//! `prove-cap construct [POLYGON] --bidegree M N`: an exact patch, verified.

use std::path::{Path, PathBuf};

use clap::Args;

use super::arguments::{Format, to_json};
use super::control::{Limits, under_control};
use super::files::{Unchecked, write_pair};
use super::outcome::{Failure, Outcome};
use super::polygon::{PolygonOptions, Shape, number_of};
use crate::commands::Verdict;
use crate::construction::{Construction, Refusal, construct, tile};
use crate::control::Control;
use crate::exact::Radicands;
use crate::report::Files;
use crate::report::construction::{
    constructed_data, constructed_text, impossible_text, tiled_data, tiled_text,
};
use crate::report::stopped::stopped_by;

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

fn carried_out(options: &ConstructOptions, format: Format, control: &Control) -> Result<Outcome, Failure> {
    let shape = Shape::find(&options.polygon)?;
    let bidegree = (options.bidegree[0], options.bidegree[1]);
    let centre = options.centre.as_deref().map(|text| {
        let field = shape.polygon.field();
        let trusted = Radicands::new(field.radicands().to_vec()).map_err(Failure::of)?;
        number_of(text, field, &trusted).map_err(|Failure(fault)| Failure(format!("--centre: {fault}")))
    });
    let centre = centre.transpose()?;
    if options.tiling {
        return tiling(options, &shape, bidegree, (format, control));
    }
    let made = match construct(&shape.polygon, &shape.name, bidegree, centre.as_ref(), control) {
        Ok(made) => made,
        Err(refusal) => return refused(&shape, bidegree, refusal, format),
    };
    let directory = options.output.clone().unwrap_or_else(|| default_directory(&shape, bidegree));
    let files = match write(&directory, &made, control) {
        Ok(files) => files,
        Err(unchecked) => return unchecked.outcome(&shape.name, format),
    };
    let text = match format {
        Format::Json => to_json(&constructed_data(&shape.name, &made, &files))?,
        _ => constructed_text(&shape.name, &shape.polygon, &made, &files).map_err(Failure::of)?,
    };
    Ok(Outcome { text, verdict: Verdict::Exact })
}

fn tiling(
    options: &ConstructOptions,
    shape: &Shape,
    bidegree: (u32, u32),
    (format, control): (Format, &Control),
) -> Result<Outcome, Failure> {
    let named = shape.named.expect("--corners excludes --tiling");
    let tiled = match tile(named, bidegree, control) {
        Ok(tiled) => tiled,
        Err(refusal) => return refused(shape, bidegree, refusal, format),
    };
    let directory = options.output.clone().unwrap_or_else(|| {
        let directory = default_directory(shape, bidegree);
        directory.with_file_name(format!("tiling-{}-{}x{}", shape.name, bidegree.0, bidegree.1))
    });
    for (number, face) in (1..).zip(&tiled.faces) {
        if let Err(unchecked) = write(&directory.join(format!("face-{number:02}")), face, control) {
            return unchecked.outcome(&shape.name, format);
        }
    }
    let whole =
        tiled.faces.iter().all(|face| face.cover.is_ok()) && tiled.seams.iter().all(|seam| seam.meets);
    let text = match format {
        Format::Json => to_json(&tiled_data(&shape.name, &tiled, whole))?,
        _ => tiled_text(&shape.name, bidegree, &tiled, whole, &directory),
    };
    Ok(Outcome { text, verdict: if whole { Verdict::Exact } else { Verdict::Undecided } })
}

fn default_directory(shape: &Shape, (m, n): (u32, u32)) -> PathBuf {
    Path::new("proofs").join(format!("construct-{}-{m}x{n}", shape.name))
}

/// The statement with both certificates.
pub(super) fn write(
    directory: &Path,
    made: &Construction,
    control: &Control,
) -> Result<Vec<Files>, Unchecked> {
    let ring = made.statement.ring();
    let exact = made.exact.0.write(&ring);
    let mut files = vec![write_pair(directory, &made.text, (&exact, "certificate.txt"), control)?];
    if let Ok((certificate, _)) = &made.cover {
        let cover = certificate.write(&ring);
        files.push(write_pair(directory, &made.text, (&cover, "cover.txt"), control)?);
    }
    Ok(files)
}

pub(super) fn refused(
    shape: &Shape,
    bidegree: (u32, u32),
    refusal: Refusal,
    format: Format,
) -> Result<Outcome, Failure> {
    let (text, verdict) = match &refusal {
        Refusal::Impossible(cell) => {
            (impossible_text(&shape.name, &shape.polygon, bidegree, *cell), Verdict::Nonexistent)
        }
        Refusal::Interrupted(_) | Refusal::Limit(_) | Refusal::NoneFound => {
            (format!("UNDECIDED  {}: {refusal}\n", shape.name), Verdict::Undecided)
        }
        _ => return Err(Failure(format!("{}: {refusal}", shape.name))),
    };
    let text = match format {
        Format::Json => {
            let (_, rest) = text.split_once("  ").unwrap_or((text.as_str(), ""));
            let stopped = match &refusal {
                Refusal::Interrupted(why) => Some(stopped_by(why.why)),
                _ => None,
            };
            to_json(&serde_json::json!({
                "verdict": verdict,
                "name": shape.name,
                "bidegree": bidegree,
                "reason": rest.trim(),
                "stopped": stopped,
            }))?
        }
        _ => text,
    };
    Ok(Outcome { text, verdict })
}
