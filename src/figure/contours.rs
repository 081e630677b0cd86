//! The deviation as a contour map over the square of the parameters.

use itertools::iproduct;

use super::canvas::{Anchor, Canvas};
use super::scale::Scale;
use super::{Grid, Scene};

const LEFT: f64 = 110.0;
const TOP: f64 = 70.0;
const SIDE: f64 = 580.0;

pub(super) fn draw(canvas: &mut Canvas, scene: &Scene<'_>, grid: &Grid, scale: &Scale) {
    let place = |u: f64, v: f64| (LEFT + SIDE * u, TOP + SIDE * (1.0 - v));
    let n = grid.intervals;
    // Cells of one shade side by side are one rectangle.
    let cell = SIDE / n as f64;
    for j in 0..n {
        let colours: Vec<String> = (0..n)
            .map(|i| {
                scale.colour((scene.deviation)((i as f64 + 0.5) / n as f64, (j as f64 + 0.5) / n as f64))
            })
            .collect();
        let mut start = 0;
        while start < n {
            let end = (start..n).find(|&i| colours[i] != colours[start]).unwrap_or(n);
            let corner = (LEFT + cell * start as f64, TOP + SIDE - cell * (j + 1) as f64);
            canvas.rectangle(corner, (cell * (end - start) as f64, cell + 0.4), &colours[start]);
            start = end;
        }
    }
    for level in scale.ticks(8.0) {
        // Light lines on dark ground and the other way round.
        let stroke = if scale.position(level) < 0.5 { "white" } else { "black" };
        for segment in segments(grid, level) {
            canvas.polyline(&segment.map(|(u, v)| place(u, v)), stroke, 0.9);
        }
    }
    let corners = [place(0.0, 0.0), place(1.0, 0.0), place(1.0, 1.0), place(0.0, 1.0)];
    canvas.polygon(&corners, "none", "black", 1.2);
    for k in 0..=5 {
        let (t, label) = (f64::from(k) / 5.0, format!("{}", f64::from(k) / 5.0));
        let (x, y) = place(t, 0.0);
        canvas.polyline(&[(x, y), (x, y + 6.0)], "black", 1.0);
        canvas.text((x, y + 24.0), 15.0, Anchor::Middle, false, &label);
        let (x, y) = place(0.0, t);
        canvas.polyline(&[(x - 6.0, y), (x, y)], "black", 1.0);
        canvas.text((x - 11.0, y + 5.0), 15.0, Anchor::End, false, &label);
    }
    canvas.text((LEFT + SIDE / 2.0, TOP + SIDE + 50.0), 18.0, Anchor::Middle, false, "u");
    canvas.text((LEFT - 60.0, TOP + SIDE / 2.0), 18.0, Anchor::Middle, false, "v");
    for extreme in scene.extremes.iter().filter(|_| !scale.constant()) {
        canvas.marker(place(extreme.u, extreme.v), extreme.maximum);
    }
}

/// The pieces of a level line, cell by cell (marching squares; in a saddle the mean of the corners decides).
fn segments(grid: &Grid, level: f64) -> Vec<[(f64, f64); 2]> {
    let n = grid.intervals;
    let mut found = Vec::new();
    for (i, j) in iproduct!(0..n, 0..n) {
        let corner = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
        let value = corner.map(|(i, j)| grid.at(i, j) - level);
        let point = corner.map(|(i, j)| (i as f64 / n as f64, j as f64 / n as f64));
        let mut crossings = Vec::new();
        for k in 0..4 {
            let l = (k + 1) % 4;
            if (value[k] > 0.0) != (value[l] > 0.0) {
                let part = value[k] / (value[k] - value[l]);
                let mix = |a: f64, b: f64| a + (b - a) * part;
                crossings.push((mix(point[k].0, point[l].0), mix(point[k].1, point[l].1)));
            }
        }
        match crossings[..] {
            [a, b] => found.push([a, b]),
            [a, b, c, d] => {
                let mean_is_high = value.iter().sum::<f64>() > 0.0;
                let pairs =
                    if mean_is_high == (value[0] > 0.0) { [[a, b], [c, d]] } else { [[d, a], [b, c]] };
                found.extend(pairs);
            }
            _ => {}
        }
    }
    found
}
