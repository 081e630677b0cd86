//! `--plot FILE`: pictures of a patch at the values that were enclosed.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use num_traits::ToPrimitive;

use super::files::write_atomically;
use super::outcome::Failure;
use super::source::Source;
use crate::approximation::{Enclosure, FloatPatch, Model, Place, local_extremes};
use crate::certificate::Quantity;
use crate::control::{Control, Interrupted};
use crate::figure::{Extreme, Figure, Scene, draw};
use crate::report::bounds::{symbol, value_text};

/// Extremes that are marked at most; if there are more, only the two that the bounds name.
const MARKED: usize = 16;

#[derive(Debug, Args)]
pub(super) struct PlotOptions {
    /// Draw r − 1 into this file, .svg or .png.
    #[arg(long, value_name = "FILE", value_parser = picture)]
    plot: Option<PathBuf>,
    /// What --plot draws.
    #[arg(long, value_enum, default_value_t = FigureName::Contours, requires = "plot")]
    figure: FigureName,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum FigureName {
    /// A contour map over the square of the parameters.
    Contours,
    /// A surface over the square of the parameters.
    Surface,
    /// The patch in space with its control net.
    Cap,
}

/// A file name that says what kind of picture it is: known before the work begins.
fn picture(text: &str) -> Result<PathBuf, String> {
    let file = PathBuf::from(text);
    let ending = file.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    match ending.as_deref() {
        Some("svg" | "png") => Ok(file),
        _ => Err("expected a file that ends in .svg or .png".to_owned()),
    }
}

impl PlotOptions {
    /// Draws the picture, if one is asked for; the line that tells of it.
    pub(super) fn draw(
        &self,
        source: &Source,
        degree: u32,
        enclosure: &Enclosure,
        about: Option<&str>,
        control: &Control,
    ) -> Result<String, Failure> {
        let Some(file) = &self.plot else { return Ok(String::new()) };
        // What is proved stands without a picture.
        let undrawn = |why: Interrupted| Ok(format!("Picture      not drawn: {why}\n"));
        if let Err(why) = control.check() {
            return undrawn(why);
        }
        let statement = &source.statement;
        let bounds = &enclosure.bounds;
        let model = Model::at_values(statement, &bounds.values).map_err(Failure::of)?;
        let fitted = model.at(&[]);
        let patch = FloatPatch::at(statement, &bounds.values).map_err(Failure::of)?;
        let named = [(&bounds.lower, false), (&bounds.upper, true)].map(|(end, maximum)| {
            let [u, v] = end.at.each_ref().map(|x| x.to_f64().unwrap_or(f64::NAN));
            Extreme { u, v, value: fitted.value(u, v), maximum }
        });
        // Those that are as far out, by symmetry or because the optimum makes them so.
        let size = named[1].value - named[0].value;
        let as_far = |place: &Place| {
            let [low, high] = named.map(|extreme| (place.value - extreme.value).abs() < 1e-6 * size);
            let Place { u, v, value } = *place;
            (low || high).then_some(Extreme { u, v, value, maximum: high })
        };
        let all: Vec<Extreme> = local_extremes(&fitted, 64).iter().filter_map(as_far).collect();
        let extremes = if (1..=MARKED).contains(&all.len()) { all } else { named.to_vec() };
        let settings = statement.unknowns().iter().zip(&bounds.values);
        let settings: Vec<String> =
            settings.map(|(name, value)| format!("{name} = {}", value_text(statement, value))).collect();
        let name = about.map_or(source.name.clone(), |about| format!("{}, {about}", source.name));
        let mut title = [vec![name], settings].concat().join(", ");
        if title.chars().count() > 90 {
            title = title.chars().take(88).chain(" …".chars()).collect();
        }
        let name = match bounds.quantity {
            Quantity::Radius => "r − 1".to_owned(),
            Quantity::Ratio => symbol(bounds.quantity, degree),
        };
        let net = patch.control_points();
        let scene = Scene {
            title: &title,
            symbol: &name,
            deviation: &|u, v| fitted.value(u, v),
            point: &|u, v| patch.jet(u, v)[0],
            unit_sphere: bounds.quantity == Quantity::Radius,
            net: &net,
            extremes: &extremes,
        };
        let figure = match self.figure {
            FigureName::Contours => Figure::Contours,
            FigureName::Surface => Figure::Surface,
            FigureName::Cap => Figure::Cap,
        };
        if let Err(why) = control.check() {
            return undrawn(why);
        }
        write_atomically(file, &draw(figure, &scene, file).map_err(Failure::of)?)?;
        Ok(format!("Picture      {}\n", file.display()))
    }
}
