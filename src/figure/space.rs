//! Pictures in space: the deviation as a surface over the square, and the patch with its control net.

use itertools::iproduct;

use super::canvas::{Anchor, Canvas, SIZE};
use super::scale::Scale;
use super::{Grid, Scene};

type Vector = [f64; 3];

/// Orthographic: x and y of the screen, and how far towards the eye.
struct View {
    right: Vector,
    up: Vector,
    eye: Vector,
    centre: (f64, f64),
    scale: f64,
    /// What is drawn in the middle.
    middle: Vector,
}

impl View {
    /// From an azimuth and an elevation in degrees.
    fn new(azimuth: f64, elevation: f64, scale: f64, middle: Vector, centre: (f64, f64)) -> Self {
        let ((sa, ca), (se, ce)) = (azimuth.to_radians().sin_cos(), elevation.to_radians().sin_cos());
        View {
            right: [-sa, ca, 0.0],
            up: [-ca * se, -sa * se, ce],
            eye: [ca * ce, sa * ce, se],
            centre,
            scale,
            middle,
        }
    }

    fn place(&self, point: Vector) -> (f64, f64) {
        let moved: Vector = std::array::from_fn(|k| point[k] - self.middle[k]);
        (
            self.centre.0 + self.scale * dot(moved, self.right),
            self.centre.1 - self.scale * dot(moved, self.up),
        )
    }

    fn depth(&self, point: Vector) -> f64 {
        dot(point, self.eye)
    }
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Quadrilaterals of a surface, those that are farther from the eye first, edged by a mesh if there is to be one.
fn paint(
    canvas: &mut Canvas,
    view: &View,
    n: usize,
    point: &dyn Fn(f64, f64) -> Vector,
    colour: &dyn Fn(f64, f64) -> String,
    mesh: Option<&str>,
) {
    let at = |i: usize| i as f64 / n as f64;
    let mut faces: Vec<(f64, [Vector; 4], String)> = iproduct!(0..n, 0..n)
        .map(|(i, j)| {
            let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| point(at(i), at(j)));
            let depth = corners.iter().map(|corner| view.depth(*corner)).sum::<f64>();
            (depth, corners, colour(at(i) + 0.5 / n as f64, at(j) + 0.5 / n as f64))
        })
        .collect();
    faces.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (_, corners, colour) in faces {
        canvas.polygon(&corners.map(|corner| view.place(corner)), &colour, mesh.unwrap_or(&colour), 0.5);
    }
}

/// Parameter lines of a surface that hides none of them.
fn lines(canvas: &mut Canvas, view: &View, point: &dyn Fn(f64, f64) -> Vector, stroke: &str) {
    let at = |i: usize| i as f64 / 48.0;
    for k in (0..=48).step_by(6) {
        let along: Vec<_> = (0..=48).map(|i| view.place(point(at(i), at(k)))).collect();
        canvas.polyline(&along, stroke, 0.5);
        let across: Vec<_> = (0..=48).map(|i| view.place(point(at(k), at(i)))).collect();
        canvas.polyline(&across, stroke, 0.5);
    }
}

/// The deviation over the square.
pub(super) fn surface(canvas: &mut Canvas, scene: &Scene<'_>, grid: &Grid, scale: &Scale) {
    let height = |value: f64| if scale.constant() { 0.0 } else { 0.62 * scale.position(value) };
    let view = View::new(-58.0, 28.0, 430.0, [0.5, 0.5, 0.25], (390.0, 375.0));
    let floor = |u: f64, v: f64| view.place([u, v, 0.0]);
    let corners = [floor(0.0, 0.0), floor(1.0, 0.0), floor(1.0, 1.0), floor(0.0, 1.0)];
    canvas.polygon(&corners, "#f4f4f4", "#999999", 1.0);
    // The back walls.
    for wall in [[[0.0, 0.0], [0.0, 1.0]], [[0.0, 1.0], [1.0, 1.0]]] {
        let [[a, b], [c, d]] = wall;
        let points = [[a, b, 0.0], [c, d, 0.0], [c, d, 0.62], [a, b, 0.62]].map(|point| view.place(point));
        canvas.polygon(&points, "#fafafa", "#999999", 1.0);
    }
    let n = grid.intervals;
    let point = |u: f64, v: f64| {
        let nearest = |x: f64| (x * n as f64).round() as usize;
        [u, v, height(grid.at(nearest(u), nearest(v)))]
    };
    paint(canvas, &view, n / 2, &point, &|u, v| scale.colour((scene.deviation)(u, v)), Some("#00000030"));
    for k in 0..=4 {
        let t = f64::from(k) / 4.0;
        let label = format!("{t}");
        let (x, y) = floor(t, 0.0);
        canvas.polyline(&[(x, y), floor(t, -0.03)], "black", 1.0);
        canvas.text((x - 8.0, y + 26.0), 14.0, Anchor::End, false, &label);
        let (x, y) = floor(1.0, t);
        canvas.polyline(&[(x, y), floor(1.03, t)], "black", 1.0);
        canvas.text((x + 12.0, y + 22.0), 14.0, Anchor::Start, false, &label);
    }
    let (x, y) = floor(0.5, -0.2);
    canvas.text((x, y), 18.0, Anchor::Middle, false, "u");
    let (x, y) = floor(1.2, 0.5);
    canvas.text((x, y), 18.0, Anchor::Middle, false, "v");
    if !scale.constant() {
        for tick in scale.ticks(6.0) {
            let (x, y) = view.place([0.0, 0.0, height(tick)]);
            canvas.polyline(&[(x - 6.0, y), (x, y)], "black", 1.0);
            canvas.text((x - 11.0, y + 5.0), 14.0, Anchor::End, false, &scale.spell(tick, 3));
        }
        let (top, foot) = (view.place([0.0, 0.0, 0.62]), view.place([0.0, 0.0, 0.0]));
        canvas.polyline(&[top, foot], "black", 1.0);
        for extreme in scene.extremes {
            let point = [extreme.u, extreme.v, height(extreme.value)];
            // Towards the eye the surface must not rise above the line of sight.
            let hidden = (1..200).any(|k| {
                let [u, v, z]: Vector =
                    std::array::from_fn(|i| point[i] + view.eye[i] * f64::from(k) / 100.0);
                let inside = (0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v);
                inside && height((scene.deviation)(u, v)) > z
            });
            if !hidden {
                canvas.marker(view.place(point), extreme.maximum);
            }
        }
    }
}

/// The patch and its control net; for the unit sphere its outline too, for other surfaces in a size of their own.
pub(super) fn cap(canvas: &mut Canvas, scene: &Scene<'_>, scale: &Scale) {
    let middle = (scene.point)(0.5, 0.5);
    // The sphere is seen with the patch, any other surface's patch by itself.
    let towards = if scene.unit_sphere { 0.6 } else { 1.0 };
    let from = if scene.unit_sphere { middle.map(|x| 0.5 * x) } else { middle };
    let reach = scene.net.iter().flatten().flat_map(|point| (0..3).map(|k| (point[k] - from[k]).abs()));
    let reach = reach.filter(|x| x.is_finite());
    let reach =
        if scene.unit_sphere { reach.fold(1.0f64, f64::max).min(4.0) } else { reach.fold(0.0, f64::max) };
    let reach = if reach > 0.0 { reach } else { 1.0 };
    let view =
        View::new(-50.0, 30.0, 290.0 / reach, middle.map(|x| towards * x), (370.0, SIZE.1 / 2.0 + 20.0));
    if scene.unit_sphere {
        canvas.circle(view.place([0.0; 3]), view.scale, "none", "#999999");
    }
    paint(canvas, &view, 48, scene.point, &|u, v| scale.colour((scene.deviation)(u, v)), None);
    lines(canvas, &view, scene.point, "#ffffff66");
    let rows = scene.net.iter().map(|row| row.iter().map(|point| view.place(*point)).collect::<Vec<_>>());
    let rows: Vec<_> = rows.collect();
    for row in &rows {
        canvas.polyline(row, "#b00020", 1.6);
    }
    for j in 0..rows.first().map_or(0, Vec::len) {
        let column: Vec<_> = rows.iter().map(|row| row[j]).collect();
        canvas.polyline(&column, "#b00020", 1.6);
    }
    for place in rows.iter().flatten() {
        canvas.circle(*place, 4.5, "white", "#b00020");
    }
    for extreme in scene.extremes.iter().filter(|_| !scale.constant()) {
        canvas.marker(view.place((scene.point)(extreme.u, extreme.v)), extreme.maximum);
    }
    let corner = (95.0, 640.0);
    for (axis, name) in [([1.0, 0.0, 0.0], "x"), ([0.0, 1.0, 0.0], "y"), ([0.0, 0.0, 1.0], "z")] {
        let tip = (corner.0 + 55.0 * dot(axis, view.right), corner.1 - 55.0 * dot(axis, view.up));
        canvas.polyline(&[corner, tip], "black", 1.4);
        let beyond = (corner.0 + 72.0 * dot(axis, view.right), corner.1 - 72.0 * dot(axis, view.up) + 5.0);
        canvas.text(beyond, 16.0, Anchor::Middle, false, name);
    }
}
