//! Six patches around the cube: how they fit where they meet, in floating point.

use super::EnclosureError;
use super::enclosure::patch_at;
use super::frame::Frame;
use super::normal::rounded;
use super::size::scaled;
use crate::algebra::polynomial_from_exact;
use crate::exact::Polynomial;
use crate::problem::field_of;
use crate::statement::Statement;

/// Samples along an edge.
const SAMPLES: usize = 1000;

type Vector = [f64; 3];

/// A patch without unknowns, in floating point.
#[derive(Debug, Clone)]
pub struct FloatPatch {
    bidegree: (usize, usize),
    /// Homogeneous, row by row.
    net: Vec<[f64; 4]>,
}

/// How the patch meets its mirror images in the planes between the faces.
#[derive(Debug, Clone, Copy)]
pub struct Seams {
    /// The largest distance of an edge from the plane through the origin and its ends: 0 if the neighbours have the same edge.
    pub gap: f64,
    /// The largest angle between the tangent planes of neighbours, in degrees.
    pub kink: f64,
}

impl FloatPatch {
    /// The patch of a statement at these values.
    pub fn at(statement: &Statement, values: &[Polynomial]) -> Result<Self, EnclosureError> {
        let patch = patch_at(statement, values)?;
        let field = field_of(statement);
        // Homogeneous coordinates of any size: they are divided by that of the weights before they are rounded.
        let unit = rounded(Frame::of(field, &patch).weight);
        let number = |entry: &Polynomial| {
            polynomial_from_exact(field, entry).as_constant().map_or(f64::NAN, |value| scaled(&value, -unit))
        };
        let net = patch.net.iter().flatten().map(|point| point.each_ref().map(number)).collect();
        Ok(FloatPatch { bidegree: (patch.bidegree.0 as usize, patch.bidegree.1 as usize), net })
    }

    /// (m, n).
    pub fn bidegree(&self) -> (usize, usize) {
        self.bidegree
    }

    /// The Cartesian control points, rows i = 0..m along u.
    pub fn control_points(&self) -> Vec<Vec<Vector>> {
        let rows = self.net.chunks(self.bidegree.1 + 1);
        rows.map(|row| row.iter().map(|&[x, y, z, w]| [x / w, y / w, z / w]).collect()).collect()
    }

    /// The point, and the derivatives by u and v.
    pub fn jet(&self, u: f64, v: f64) -> [Vector; 3] {
        let (m, n) = self.bidegree;
        let (basis_u, slope_u) = bernstein(m, u);
        let (basis_v, slope_v) = bernstein(n, v);
        let sum = |a: &[f64], b: &[f64]| -> [f64; 4] {
            let mut sum = [0.0; 4];
            for (point, (i, j)) in self.net.iter().zip(itertools::iproduct!(0..=m, 0..=n)) {
                sum.iter_mut().zip(point).for_each(|(to, x)| *to += a[i] * b[j] * x);
            }
            sum
        };
        let h = sum(&basis_u, &basis_v);
        let by = |d: [f64; 4]| std::array::from_fn(|k| (d[k] - h[k] / h[3] * d[3]) / h[3]);
        [std::array::from_fn(|k| h[k] / h[3]), by(sum(&slope_u, &basis_v)), by(sum(&basis_u, &slope_v))]
    }

    /// How the patch meets its mirror images at all four edges.
    pub fn seams(&self) -> Seams {
        let (mut gap, mut kink) = (0.0f64, 0.0f64);
        let edges: [fn(f64) -> (f64, f64); 4] = [|t| (t, 0.0), |t| (t, 1.0), |t| (0.0, t), |t| (1.0, t)];
        for edge in edges {
            let end = |t: f64| self.jet(edge(t).0, edge(t).1)[0];
            let mirror = unit(cross(end(0.0), end(1.0)));
            for k in 0..=SAMPLES {
                let (u, v) = edge(k as f64 / SAMPLES as f64);
                let [point, by_u, by_v] = self.jet(u, v);
                gap = gap.max(dot(point, mirror).abs());
                // The normal would lie in the mirror plane if the two tangent planes were one.
                let sine = dot(unit(cross(by_u, by_v)), mirror).abs();
                kink = kink.max(2.0 * sine.min(1.0).asin().to_degrees());
            }
        }
        Seams { gap, kink }
    }
}

/// B_i^n(x) and their derivatives.
fn bernstein(n: usize, x: f64) -> (Vec<f64>, Vec<f64>) {
    let binomial = |n: usize, k: usize| (0..k).fold(1.0, |c, i| c * (n - i) as f64 / (i + 1) as f64);
    let value = |n: usize, i: usize| binomial(n, i) * x.powi(i as i32) * (1.0 - x).powi((n - i) as i32);
    let slope = |i: usize| {
        let before = if i > 0 { value(n - 1, i - 1) } else { 0.0 };
        let after = if i < n { value(n - 1, i) } else { 0.0 };
        n as f64 * (before - after)
    };
    ((0..=n).map(|i| value(n, i)).collect(), (0..=n).map(slope).collect())
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: Vector) -> Vector {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}
