//! Local extremes of the deviation over the unit square, in floating point.

use itertools::iproduct;

use super::model::Fitted;

/// A point with the deviation there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// The parameter u.
    pub u: f64,
    /// The parameter v.
    pub v: f64,
    /// The deviation.
    pub value: f64,
}

/// The local maxima and minima on a grid of so many intervals each way, each moved to the extreme nearby.
pub fn local_extremes(fitted: &Fitted<'_>, intervals: usize) -> Vec<Place> {
    let at = |i: usize| i as f64 / intervals as f64;
    let width = intervals + 1;
    let grid: Vec<f64> = iproduct!(0..width, 0..width).map(|(i, j)| fitted.value(at(i), at(j))).collect();
    let mut places = Vec::new();
    for (i, j) in iproduct!(0..width, 0..width) {
        let value = grid[i * width + j];
        let near = |i: usize| i.saturating_sub(1)..(i + 2).min(width);
        let neighbours = iproduct!(near(i), near(j)).filter(|&(k, l)| (k, l) != (i, j));
        for sign in [1.0, -1.0] {
            if neighbours.clone().all(|(k, l)| sign * grid[k * width + l] <= sign * value) {
                places.push(climb(fitted, (at(i), at(j)), 0.5 / intervals as f64, sign));
                break;
            }
        }
    }
    distinct(places)
}

/// Each place once: those on a ridge, or found from several sides, climb to the same one.
fn distinct(mut places: Vec<Place>) -> Vec<Place> {
    let near = |x: f64| (x * 1e4).round() as i64;
    let mut seen = std::collections::HashSet::new();
    places.retain(|place| seen.insert((near(place.u), near(place.v))));
    places
}

/// Compass search, with a parabola at the end: the largest sign·value near a point.
fn climb(fitted: &Fitted<'_>, from: (f64, f64), step: f64, sign: f64) -> Place {
    let height = |u: f64, v: f64| sign * fitted.value(u, v);
    let (mut u, mut v, mut step) = (from.0, from.1, step);
    let mut best = height(u, v);
    while step > 1e-5 {
        let moves = [(step, 0.0), (-step, 0.0), (0.0, step), (0.0, -step)];
        let inside = moves.map(|(du, dv)| ((u + du).clamp(0.0, 1.0), (v + dv).clamp(0.0, 1.0)));
        let tried = inside.map(|(u, v)| (height(u, v), u, v));
        let (value, to_u, to_v) = tried.into_iter().fold((best, u, v), |a, b| if b.0 > a.0 { b } else { a });
        if value > best {
            (best, u, v) = (value, to_u, to_v);
        } else {
            step /= 2.0;
        }
    }
    // Newton's method with differences: the height is flat at the top, so that the values are known far better than the place.
    let h = 1e-3;
    for _ in 0..3 {
        if u < 2.0 * h || u > 1.0 - 2.0 * h || v < 2.0 * h || v > 1.0 - 2.0 * h {
            break;
        }
        let f = |du: f64, dv: f64| height(u + du * h, v + dv * h);
        let (gu, gv) = ((f(1.0, 0.0) - f(-1.0, 0.0)) / 2.0, (f(0.0, 1.0) - f(0.0, -1.0)) / 2.0);
        let centre = f(0.0, 0.0);
        let (huu, hvv) =
            (f(1.0, 0.0) - 2.0 * centre + f(-1.0, 0.0), f(0.0, 1.0) - 2.0 * centre + f(0.0, -1.0));
        let huv = (f(1.0, 1.0) - f(1.0, -1.0) - f(-1.0, 1.0) + f(-1.0, -1.0)) / 4.0;
        let determinant = huu * hvv - huv * huv;
        if huu >= 0.0 || determinant <= 0.0 {
            break;
        }
        let (du, dv) = ((huv * gv - hvv * gu) / determinant, (huv * gu - huu * gv) / determinant);
        let (to_u, to_v) = ((u + du * h).clamp(0.0, 1.0), (v + dv * h).clamp(0.0, 1.0));
        if du.abs().max(dv.abs()) > 2.0 || height(to_u, to_v) < best - 1e-18 {
            break;
        }
        (u, v, best) = (to_u, to_v, height(to_u, to_v));
    }
    Place { u, v, value: sign * best }
}
