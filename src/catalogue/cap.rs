//! Statements about the cap over the cube face: standard edges from the geometry, interiors with unknowns.

use itertools::{Itertools, iproduct};

use super::parts;
use super::spell::spell;
use super::symmetry::{ALL, ROTATIONS, orbit};
use crate::algebra::{FieldElement, MultiquadraticField};
use crate::bezier::RationalArc;
use crate::geometry::CubeFace;

/// What is known of the inner control points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interior {
    /// Bidegree (2,2) only: the centre is (0, 0, z) with weight w, as in the paper.
    OnAxis,
    /// Nothing.
    Free,
    /// The net is mapped to itself by the rotations of the square.
    C4,
    /// The net is mapped to itself by the rotations and reflections of the square.
    D4,
}

/// A family of patches for the cap, bounded by the four arcs of great circles over the edges of the cube face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cap {
    /// (m, n).
    pub bidegree: (u32, u32),
    /// The interior.
    pub interior: Interior,
    /// Whether the corner (1,1) has the weight d², d ≠ 0 unknown, instead of 1; bidegree (2,2) only.
    pub corner_weight: bool,
}

/// The four numbers of a control point, as expressions.
type Entries = [String; 4];

impl Cap {
    /// The field of the cap.
    pub fn field() -> MultiquadraticField {
        MultiquadraticField::new(&[2, 3])
    }

    /// The statement file.
    pub fn statement(&self) -> String {
        let (m, n) = self.bidegree;
        let points: Vec<Vec<Entries>> = self.net();
        let words = points.iter().flatten().flatten().flat_map(|entry| {
            entry.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').filter(|word| *word != "sqrt")
        });
        let mut unknowns: Vec<String> = words
            .filter(|word| word.starts_with(|c: char| c.is_ascii_alphabetic()) && *word != "d")
            .map(str::to_owned)
            .unique()
            .collect();
        unknowns.sort_by_key(|name| (name[1..].to_owned(), "XYZWwz".find(&name[..1])));
        if self.corner_weight {
            unknowns.push("d".into());
        }
        let quoted = |names: &[String]| names.iter().map(|name| format!("\"{name}\"")).join(", ");

        let mut text = String::new();
        text += &format!("# {}\n", self.remark());
        text += &format!("title = \"{}\"\n", self.title());
        text += "radicands = [2, 3]\n";
        text += &format!("unknowns = [{}]\n", quoted(&unknowns));
        if self.corner_weight {
            text += "nonzero = [\"d\"]\n";
        }
        text +=
            &format!("convention = \"{}\"\n", if self.is_cartesian() { "cartesian" } else { "homogeneous" });
        text += &format!("bidegree = [{m}, {n}]\n");
        text += "surface = \"X^2 + Y^2 + Z^2 - W^2\"\n\n";
        text += &net_to_toml(&points);
        text
    }

    fn is_cartesian(&self) -> bool {
        self.interior == Interior::OnAxis
    }

    fn title(&self) -> String {
        let (m, n) = self.bidegree;
        let interior = match (self.interior, self.corner_weight) {
            (Interior::OnAxis, _) => "centre on the axis",
            (Interior::Free, false) => "interior unknown",
            (Interior::Free, true) => "interior and corner weights unknown",
            (Interior::C4, _) => "interior with the rotations of the square",
            (Interior::D4, _) => "interior with the symmetry of the square",
        };
        let edges = if self.corner_weight { "" } else { ", standard edges" };
        format!("Spherical cap over a cube face, bidegree ({m},{n}), {interior}{edges}")
    }

    fn remark(&self) -> &'static str {
        match (self.corner_weight, self.interior, self.bidegree) {
            (true, ..) => {
                "Scaling the patch and reparametrising u -> au/(1-u+au), v likewise, makes three corner weights 1.\n\
                 # The fourth is d^2 > 0, and an edge between weights p and q has the middle weight sqrt(2/3)*sqrt(p*q)."
            }
            (_, Interior::OnAxis, _) => {
                "Rows i = 0, 1, 2 along u (y increasing), points j = 0, 1, 2 along v (x increasing): [x, y, z, w].\n\
                 # Corners of the cube inscribed in the unit sphere; tangents of the edges meet in the middle points."
            }
            (_, _, (2, 2)) => "Rows along u (y increasing), points along v (x increasing): [wx, wy, wz, w].",
            _ => {
                "Rows along u (y increasing), points along v (x increasing): [wx, wy, wz, w].\n\
                 # The edges are the rational quadratic arcs of the inscribed cube, raised in degree."
            }
        }
    }

    fn net(&self) -> Vec<Vec<Entries>> {
        let (m, n) = self.bidegree;
        let face = CubeFace::derive(Cap::field()).expect("the cube's side lies in Q(√2,√3)");
        let along_u = [0, 1]
            .map(|v| face.edge_along_u(v).expect("its weight lies in Q(√2,√3)").to_curve().elevated_to(m));
        let along_v = [0, 1]
            .map(|u| face.edge_along_v(u).expect("its weight lies in Q(√2,√3)").to_curve().elevated_to(n));
        let mut net = vec![vec![Entries::default(); n as usize + 1]; m as usize + 1];
        for (i, j) in iproduct!(0..=m, 0..=n) {
            let edge = |curves: &[RationalArc; 2], which: u32, at: u32| {
                self.entries(&curves[which as usize].points[at as usize], i, j)
            };
            net[i as usize][j as usize] = match (i, j) {
                (0, _) => edge(&along_v, 0, j),
                (_, 0) => edge(&along_u, 0, i),
                (i, j) if i == m => edge(&along_v, 1, j),
                (i, j) if j == n => edge(&along_u, 1, i),
                _ => self.inner(i, j),
            };
        }
        net
    }

    /// A point of an edge, with the power of d that a free corner weight brings.
    fn entries(&self, point: &[FieldElement; 4], i: u32, j: u32) -> Entries {
        if self.is_cartesian() {
            let [.., w] = point;
            let inverse = w.inverse().expect("weights of the edges are not zero");
            return std::array::from_fn(|k| spell(&if k < 3 { &point[k] * &inverse } else { w.clone() }));
        }
        let factor = match (self.corner_weight, i, j) {
            (true, 2, 2) => "d^2",
            (true, 1, 2) | (true, 2, 1) => "d",
            _ => "",
        };
        std::array::from_fn(|k| match (spell(&point[k]).as_str(), factor) {
            (number, "") | (number @ "0", _) => number.to_owned(),
            ("1", factor) => factor.to_owned(),
            (number, factor) => format!("{number}*{factor}"),
        })
    }

    fn inner(&self, i: u32, j: u32) -> Entries {
        let group = match self.interior {
            Interior::OnAxis => return ["0", "0", "z", "w"].map(String::from),
            Interior::Free => return parts::entries(self.bidegree, i, j),
            Interior::C4 => &ROTATIONS[..],
            Interior::D4 => &ALL[..],
        };
        let ((a, b), [x, y]) = orbit(self.bidegree.0, group, i, j);
        let index = if a < 10 && b < 10 { format!("{a}{b}") } else { format!("{a}_{b}") };
        let signed = |coordinate: Option<(i32, char)>| match coordinate {
            None => "0".to_owned(),
            Some((sign, letter)) => format!("{}{letter}{index}", if sign < 0 { "-" } else { "" }),
        };
        [signed(x), signed(y), format!("Z{index}"), format!("W{index}")]
    }
}

fn net_to_toml(points: &[Vec<Entries>]) -> String {
    let widths: [usize; 4] =
        std::array::from_fn(|k| points.iter().flatten().map(|point| point[k].len()).max().unwrap_or(0));
    let mut text = String::from("net = [\n");
    for row in points {
        text += "  [\n";
        for point in row {
            let quoted = point.iter().zip(widths).enumerate().map(|(k, (entry, width))| {
                let comma = if k < 3 { "," } else { "" };
                // Padding stands outside the quotes.
                format!("\"{entry}\"{comma}{}", " ".repeat(width - entry.len()))
            });
            text += &format!("    [{}],\n", quoted.collect::<Vec<_>>().join(" ").trim_end());
        }
        text += "  ],\n";
    }
    text + "]\n"
}
