//! Whole tilings: one exact patch for each polygon, and that neighbours meet point for point.

use itertools::Itertools;

use super::search::{Construction, Refusal, construct};
use crate::algebra::{FieldElement, Polynomial};
use crate::bezier::BernsteinForm;
use crate::control::Control;
use crate::geometry::{NamedPolygon, Point, Vector};

/// Patches that cover the sphere.
#[derive(Debug)]
pub struct Tiled {
    /// A patch for each polygon.
    pub faces: Vec<Construction>,
    /// Where they meet.
    pub seams: Vec<Seam>,
}

/// An edge that two patches share.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Seam {
    /// The faces, from 0.
    pub faces: [usize; 2],
    /// Whether both run through it in the same way: the same point at the same parameter, or the parameter reversed.
    pub meets: bool,
}

/// Covers the sphere. Every edge belongs to two faces, and there both patches have the same points at the same parameters.
///
/// # Errors
/// [`Refusal`]
pub fn tile(named: &NamedPolygon, bidegree: (u32, u32), control: &Control) -> Result<Tiled, Refusal> {
    let mut faces = Vec::new();
    for (number, polygon) in (1..).zip(named.tiling()) {
        let title = format!("{}, face {number}", named.name);
        faces.push(construct(&polygon, &title, bidegree, None, control)?);
    }
    let mut seams = Vec::new();
    for [(first, made), (second, other)] in faces.iter().enumerate().array_combinations() {
        control.check()?;
        for ((from, to), curve) in edges(made) {
            for ((start, end), opposite) in edges(other) {
                let same = (&from, &to) == (&start, &end);
                if same || (&from, &to) == (&end, &start) {
                    let opposite = if same { opposite } else { opposite.into_iter().rev().collect() };
                    seams.push(Seam { faces: [first, second], meets: coincide(&curve, &opposite) });
                }
            }
        }
    }
    Ok(Tiled { faces, seams })
}

/// The edges that are not points, with the corners at their ends.
fn edges(made: &Construction) -> Vec<((Vector, Vector), Vec<Point>)> {
    let corners = made.placed.corners();
    let at = |k: usize| match (made.placed.is_triangle(), k) {
        (true, 2) => corners[1].clone(),
        (true, 3) => corners[2].clone(),
        _ => corners[k].clone(),
    };
    let (net, m, n) = (&made.net, made.net.len() - 1, made.net[0].len() - 1);
    let column = |j: usize| net.iter().map(|row| row[j].clone()).collect_vec();
    let all = [
        ((at(0), at(3)), net[0].clone()),
        ((at(1), at(2)), net[m].clone()),
        ((at(0), at(1)), column(0)),
        ((at(3), at(2)), column(n)),
    ];
    all.into_iter().filter(|((from, to), _)| from != to).collect()
}

/// Whether two curves have the same point at each parameter: all 2×2 minors of their coordinates vanish identically.
fn coincide(a: &[Point], b: &[Point]) -> bool {
    let form = |curve: &[Point], k: usize| {
        let degree = curve.len() as u32 - 1;
        BernsteinForm::from_bernstein(curve[0][0].field(), (degree, 0), |i, _| {
            Polynomial::constant(curve[i][k].clone())
        })
    };
    let minus = BernsteinForm::constant(a[0][0].field().integer(-1));
    (0..4).array_combinations().all(|[k, l]| {
        let minor = form(a, k).multiply(&form(b, l)).add(&minus.multiply(&form(a, l).multiply(&form(b, k))));
        minor.constants().iter().all(FieldElement::is_zero)
    })
}
