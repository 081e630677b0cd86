//! `--plot FILE`: pictures of a patch at the values that were enclosed.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::files::write_atomically;
use crate::approximation::Enclosure;
use crate::commands::{self, Failure, Source};
use crate::control::Control;
use crate::figure::Figure;
use crate::report::pages::{Picture, caption};

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
    /// Draws the picture, if one is asked for: what is proved stands without it.
    pub(super) fn draw(
        &self,
        source: &Source,
        enclosure: &Enclosure,
        about: Option<&str>,
        control: &Control,
    ) -> Result<Option<Picture>, Failure> {
        let Some(file) = &self.plot else { return Ok(None) };
        if let Err(why) = control.check() {
            return Ok(Some(Picture::NotDrawn(why)));
        }
        let figure = match self.figure {
            FigureName::Contours => Figure::Contours,
            FigureName::Surface => Figure::Surface,
            FigureName::Cap => Figure::Cap,
        };
        let (title, symbol) = caption(source, enclosure, about);
        let bytes =
            commands::picture((figure, file), &source.statement, enclosure, (&title, &symbol), control)?;
        Ok(Some(match bytes {
            Ok(bytes) => {
                write_atomically(file, &bytes)?;
                Picture::Drawn(file.clone())
            }
            Err(why) => Picture::NotDrawn(why),
        }))
    }
}
