//! Pictures of a patch and of its deviation from the surface, as SVG and PNG.
//!
//! Drawn from floating-point values, for looking at; nothing rests on them.

mod canvas;
mod contours;
mod scale;
mod space;

use std::path::Path;
use std::sync::Arc;

use itertools::iproduct;
use resvg::{tiny_skia, usvg};

use canvas::{Anchor, Canvas, SIZE};
use scale::Scale;

/// What is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Figure {
    /// The deviation as a contour map over the (u, v) square.
    Contours,
    /// The deviation as a surface over the (u, v) square.
    Surface,
    /// The patch in space, with its control net.
    Cap,
}

/// An extreme to be marked.
#[derive(Debug, Clone, Copy)]
pub struct Extreme {
    /// The parameter u.
    pub u: f64,
    /// The parameter v.
    pub v: f64,
    /// The deviation there.
    pub value: f64,
    /// Whether it is a maximum.
    pub maximum: bool,
}

/// What is to be seen.
pub struct Scene<'a> {
    /// One line above the picture.
    pub title: &'a str,
    /// What the deviation is called: `r − 1`.
    pub symbol: &'a str,
    /// The deviation over the unit square.
    pub deviation: &'a dyn Fn(f64, f64) -> f64,
    /// The point of the patch.
    pub point: &'a dyn Fn(f64, f64) -> [f64; 3],
    /// Whether the surface is the unit sphere, whose outline is then drawn.
    pub unit_sphere: bool,
    /// The Cartesian control points, rows along u.
    pub net: &'a [Vec<[f64; 3]>],
    /// The extremes to be marked.
    pub extremes: &'a [Extreme],
}

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// Another kind of file.
    #[error("{0}: a picture is a file that ends in .svg or .png")]
    Ending(String),
    /// The drawing could not be made into pixels.
    #[error("the picture could not be made: {0}")]
    Raster(String),
}

/// Intervals of the grid of values.
const INTERVALS: usize = 120;
/// Pixels of a PNG for each unit of the drawing.
const ZOOM: f32 = 2.0;

/// The deviation on a grid.
pub(crate) struct Grid {
    intervals: usize,
    values: Vec<f64>,
}

impl Grid {
    fn at(&self, i: usize, j: usize) -> f64 {
        self.values[i * (self.intervals + 1) + j]
    }
}

/// The bytes of a picture, of the kind that the file's name says. The same every time.
///
/// # Errors
/// [`FigureError`]
pub fn draw(figure: Figure, scene: &Scene<'_>, file: &Path) -> Result<Vec<u8>, FigureError> {
    let ending = file.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    match ending.as_deref() {
        Some("svg") => Ok(svg(figure, scene).into_bytes()),
        Some("png") => png(&svg(figure, scene)),
        _ => Err(FigureError::Ending(file.display().to_string())),
    }
}

fn svg(figure: Figure, scene: &Scene<'_>) -> String {
    let at = |i: usize| i as f64 / INTERVALS as f64;
    let values = iproduct!(0..=INTERVALS, 0..=INTERVALS).map(|(i, j)| (scene.deviation)(at(i), at(j)));
    let grid = Grid { intervals: INTERVALS, values: values.collect() };
    let extremes = scene.extremes.iter().map(|extreme| extreme.value);
    let scale = Scale::of(grid.values.iter().copied().chain(extremes));
    let mut canvas = Canvas::default();
    canvas.text((SIZE.0 / 2.0, 34.0), 17.0, Anchor::Middle, false, scene.title);
    match figure {
        Figure::Contours => contours::draw(&mut canvas, scene, &grid, &scale),
        Figure::Surface => space::surface(&mut canvas, scene, &grid, &scale),
        Figure::Cap => space::cap(&mut canvas, scene, &scale),
    }
    let value = |maximum: bool| scene.extremes.iter().find(|e| e.maximum == maximum).map(|e| e.value);
    scale.bar(&mut canvas, scene.symbol, value(false).zip(value(true)));
    canvas.svg(scene.title)
}

/// In pixels, with fonts that are compiled in: no machine's own fonts are looked for.
fn png(svg: &str) -> Result<Vec<u8>, FigureError> {
    let failed = |error: &dyn std::fmt::Display| FigureError::Raster(error.to_string());
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_font_data(dejavu::sans::regular().to_vec());
    let options = usvg::Options { fontdb: Arc::new(fonts), ..usvg::Options::default() };
    let tree = usvg::Tree::from_str(svg, &options).map_err(|error| failed(&error))?;
    let (width, height) = ((SIZE.0 as f32 * ZOOM) as u32, (SIZE.1 as f32 * ZOOM) as u32);
    let mut pixels =
        tiny_skia::Pixmap::new(width, height).ok_or_else(|| failed(&"no memory for the pixels"))?;
    resvg::render(&tree, tiny_skia::Transform::from_scale(ZOOM, ZOOM), &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| failed(&error))
}
