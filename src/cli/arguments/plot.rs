//! `--plot` and `--figure`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use crate::figure::Figure;

#[derive(Debug, Args)]
pub(in crate::cli) struct PlotOptions {
    /// Draw r − 1 into this file, .svg or .png.
    #[arg(long, value_name = "FILE", value_parser = picture)]
    pub(in crate::cli) plot: Option<PathBuf>,
    /// What --plot draws.
    #[arg(long, value_enum, default_value_t = FigureName::Contours, requires = "plot")]
    pub(in crate::cli) figure: FigureName,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum FigureName {
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

impl From<FigureName> for Figure {
    fn from(name: FigureName) -> Self {
        match name {
            FigureName::Contours => Figure::Contours,
            FigureName::Surface => Figure::Surface,
            FigureName::Cap => Figure::Cap,
        }
    }
}
