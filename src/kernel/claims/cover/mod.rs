//! Claim `cover`: a patch on the unit sphere covers the polygon between its corners.

mod ends;
mod vectors;
mod check;
mod text;

use std::fmt;

use super::exact::{self, spelled};
use super::subdivision::{self, Tree};
use super::wording;
use crate::exact::Polynomial;
use crate::statement::Statement;

pub(super) use check::verify;
pub(super) use text::{read, write};

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
    fn trees(&self) -> impl Iterator<Item = &Tree> {
        let of_edges = self.edges.iter().filter_map(|edge| match edge {
            EdgeTree::Arc(tree) => Some(tree),
            EdgeTree::Point => None,
        });
        [&self.denominator].into_iter().chain(of_edges).chain([&self.regular])
    }
}

/// At these values the patch lies on the unit sphere, W > 0 on the whole square, and the square is mapped one to one
/// and regularly onto the convex spherical polygon between its corners.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Covered {
    /// The value of each unknown, a constant of K.
    pub values: Vec<Polynomial>,
    /// The points (x, y, z) at (u, v) = (0,0), (1,0), (1,1), (0,1).
    pub corners: Vec<[Polynomial; 3]>,
    /// Whether the normal ∂/∂u × ∂/∂v points to the centre of the sphere.
    pub inward: bool,
    /// The edge that is a single point, so that the polygon is a triangle.
    pub point: Option<&'static str>,
    /// Boxes of all subdivisions.
    pub boxes: usize,
}

/// What is wrong with a cover.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(missing_docs, reason = "the fields are what the message prints")]
pub enum Rejection {
    /// The patch does not lie on its surface at the stated values.
    Exact(exact::Rejection),
    /// The subdivisions.
    Subdivision(subdivision::Rejection),
    /// An edge that is not what the certificate says: an arc of a great circle, or a point.
    Edge { edge: &'static str, expected: &'static str },
    /// More than one edge that is a point.
    Points { edge: &'static str },
}

impl Covered {
    /// `cover`.
    pub(super) fn kind(&self) -> &'static str {
        "cover"
    }

    /// What was proved.
    pub(super) fn sentence(&self, statement: &Statement) -> String {
        let image = match self.point {
            None => "it maps the square one to one and regularly onto the convex spherical quadrilateral between its \
                     corners, whose sides are the shorter arcs of great circles"
                .to_owned(),
            Some(edge) => format!(
                "it maps the square onto the convex spherical triangle between its corners, whose sides are the shorter \
                 arcs of great circles: the edge {} to one corner, and all else one to one and regularly onto the rest",
                edge.replace('=', " = ")
            ),
        };
        format!(
            "{}{} the patch lies on the unit sphere, its denominator W is positive on the whole square, and {image}.",
            wording::at_values(statement),
            wording::where_assumptions(statement)
        )
    }

    /// Lines under the sentence.
    pub(super) fn details(&self, statement: &Statement) -> Vec<String> {
        let mut lines = vec![format!("replayed   {} boxes", self.boxes)];
        lines.push(format!("normal     {}", if self.inward { "inward" } else { "outward" }));
        lines.extend(spelled(statement, &self.values));
        let ring = statement.ring();
        for (at, corner) in ["(0,0)", "(1,0)", "(1,1)", "(0,1)"].iter().zip(&self.corners) {
            let corner = corner.each_ref().map(|x| wording::written(&ring, x)).join(", ");
            lines.push(format!("corner     {at} → ({corner})"));
        }
        lines
    }
}

impl From<exact::Rejection> for Rejection {
    fn from(rejection: exact::Rejection) -> Self {
        Rejection::Exact(rejection)
    }
}

impl From<subdivision::Rejection> for Rejection {
    fn from(rejection: subdivision::Rejection) -> Self {
        Rejection::Subdivision(rejection)
    }
}

impl fmt::Display for Rejection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Rejection::Exact(rejection) => rejection.fmt(f),
            Rejection::Subdivision(rejection) => rejection.fmt(f),
            Rejection::Edge { edge, expected } => write!(f, "edge {edge}: it is not {expected}"),
            Rejection::Points { edge } => {
                write!(f, "edge {edge}: it is a point like another edge, which leaves no triangle")
            }
        }
    }
}
