//! The planes in which the edges of an exact patch lie.

use std::fmt;

use itertools::Itertools;
use num_bigint::BigInt;
use num_rational::BigRational;

use crate::exact::{Monomial, Polynomial, Radicands, Work, combination};
use crate::statement::{HomogeneousPoint, Patch};

/// An edge of the parameter square.
pub(super) struct Edge {
    /// The parameter that is fixed: `u` or `v`.
    pub fixed: &'static str,
    /// Its value, 0 or 1.
    pub at: u32,
    /// The plane, a linear form in X, Y, Z, W, if there is exactly one.
    pub plane: Option<Polynomial>,
}

impl Edge {
    /// The name of the plane in Coq.
    pub(super) fn plane_name(&self) -> String {
        format!("plane_{}{}", self.fixed, self.at)
    }
}

impl fmt::Display for Edge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = {}", self.fixed, self.at)
    }
}

/// The planes of the four edges.
pub(super) fn planes(field: &Radicands, patch: &Patch) -> [Edge; 4] {
    let edge = |fixed, at: u32| {
        let of_row = |row: &Vec<HomogeneousPoint>| if at == 0 { row.first() } else { row.last() }.cloned();
        let points: Vec<HomogeneousPoint> = match fixed {
            "u" => (if at == 0 { patch.net.first() } else { patch.net.last() }).cloned().unwrap_or_default(),
            _ => patch.net.iter().filter_map(of_row).collect(),
        };
        Edge { fixed, at, plane: plane(field, &points) }
    };
    [edge("u", 0), edge("u", 1), edge("v", 0), edge("v", 1)]
}

/// The only plane through all points, its first coefficient 1.
fn plane(field: &Radicands, points: &[HomogeneousPoint]) -> Option<Polynomial> {
    let mut work = Work::full();
    let normal = points.iter().array_combinations().find_map(|[a, b, c]| {
        let normal = normal(field, [a, b, c], &mut work)?;
        normal.iter().any(|entry| !entry.is_zero()).then_some(normal)
    })?;
    let first = normal.iter().find(|entry| !entry.is_zero())?.inverse(field, &mut work).ok()??;
    let mut terms = Vec::new();
    for (variable, entry) in (0u16..).zip(&normal) {
        let entry = entry.multiply(&first, field, &mut work).ok()?;
        terms.push(entry.multiply(&Polynomial::variable(variable), field, &mut work).ok()?);
    }
    for point in points {
        let pairs: Vec<(&Polynomial, &Polynomial)> = normal.iter().zip(point).collect();
        if !combination(&pairs, field, &mut work).ok()?.is_zero() {
            return None;
        }
    }
    Polynomial::sum(&terms, field, &mut work).ok()
}

/// The 3 × 3 minors of three points with alternating signs: what is orthogonal to all three.
fn normal(field: &Radicands, points: [&HomogeneousPoint; 3], work: &mut Work) -> Option<[Polynomial; 4]> {
    let mut minors = [const { None }; 4];
    for (left_out, minor) in minors.iter_mut().enumerate() {
        let columns: Vec<usize> = (0..4).filter(|&column| column != left_out).collect();
        let mut summands = Vec::new();
        for (sign, order) in [
            (1, [0, 1, 2]),
            (1, [1, 2, 0]),
            (1, [2, 0, 1]),
            (-1, [0, 2, 1]),
            (-1, [1, 0, 2]),
            (-1, [2, 1, 0]),
        ] {
            let sign = if left_out % 2 == 0 { sign } else { -sign };
            let mut product =
                Polynomial::term(BigRational::from_integer(BigInt::from(sign)), Monomial::one());
            for (point, column) in points.iter().zip(order) {
                product = product.multiply(&point[columns[column]], field, work).ok()?;
            }
            summands.push(product);
        }
        *minor = Some(Polynomial::sum(&summands, field, work).ok()?);
    }
    let [a, b, c, d] = minors;
    Some([a?, b?, c?, d?])
}
