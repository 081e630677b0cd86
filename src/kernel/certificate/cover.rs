//! Arguments that a patch on the unit sphere covers the polygon between its corners.

use super::bounds::Tree;
use crate::exact::Polynomial;

/// The names of the four edges, in the order of a certificate.
pub const EDGES: [&str; 4] = ["u=0", "u=1", "v=0", "v=1"];

/// What a certificate says of an edge.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum EdgeTree {
    /// It runs along the shorter arc between its ends: boxes on which it is seen not to leave the side of the arc's middle.
    Arc(Tree),
    /// It is a single point.
    Point,
}

/// At these values the patch lies on the unit sphere, W > 0, the edges are arcs of great circles and the map is regular.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cover {
    /// A constant of K for each unknown.
    pub values: Vec<Polynomial>,
    /// Boxes on each of which the Bernstein coefficients of W are positive.
    pub denominator: Tree,
    /// The edges u = 0, u = 1, v = 0, v = 1.
    pub edges: [EdgeTree; 4],
    /// Whether det[P, ∂P/∂u, ∂P/∂v] is negative.
    pub inward: bool,
    /// Boxes on each of which its Bernstein coefficients have its sign.
    pub regular: Tree,
}

impl Cover {
    /// All trees, in the order of a certificate.
    pub(super) fn trees(&self) -> impl Iterator<Item = &Tree> {
        let of_edges = self.edges.iter().filter_map(|edge| match edge {
            EdgeTree::Arc(tree) => Some(tree),
            EdgeTree::Point => None,
        });
        [&self.denominator].into_iter().chain(of_edges).chain([&self.regular])
    }
}
