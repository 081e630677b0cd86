//! Statements about the cap over the cube face: standard edges from the geometry, interiors with unknowns.

use itertools::{Itertools, iproduct};

use super::parts;
use super::symmetry::{ALL, ROTATIONS, orbit};
use super::weighted::WeightedArc;
use crate::algebra::MultiquadraticField;
use crate::formats::statement_file::{Draft, DraftSubject, Layout};
use crate::geometry::CubeFace;
use crate::statement::{Convention, UNIT_SPHERE};

/// The motions of the square that map the net to itself (Schönflies notation).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Symmetry {
    /// None but the identity.
    None,
    /// The half-turn.
    C2,
    /// The two reflections u → 1−u and v → 1−v, and so the half-turn.
    D2,
    /// The rotations; bidegree (m,m) only.
    C4,
    /// The rotations and reflections; bidegree (m,m) only.
    D4,
}

/// What is known of the inner control points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interior {
    /// Bidegree (2,2) only: the centre is (0, 0, z) with weight w, as in the paper.
    OnAxis,
    /// Nothing but the symmetry.
    Free(Symmetry),
}

/// A family of patches for the cap, bounded by the four arcs of great circles over the edges of the cube face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cap {
    /// (m, n).
    pub bidegree: (u32, u32),
    /// The interior.
    pub interior: Interior,
    /// Whether one corner has the weight d², d ≠ 0 unknown, instead of 1: the corner u = v = 1, and with the half-turn
    /// both that it does not map to each other otherwise. Larger symmetries make all corner weights equal.
    pub corner_weight: bool,
}

/// The four numbers of a control point, as expressions.
pub(super) type Entries = [String; 4];

impl Cap {
    /// The field of the cap.
    pub fn field() -> MultiquadraticField {
        MultiquadraticField::new(&[2, 3])
    }

    /// The statement file.
    pub fn statement(&self) -> String {
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
        let convention = if self.is_cartesian() { Convention::Cartesian } else { Convention::Homogeneous };
        let surface = Some(UNIT_SPHERE.to_owned());
        let draft = Draft {
            remark: self.remark().iter().map(|line| (*line).to_owned()).collect(),
            title: self.title(),
            radicands: vec![2, 3],
            unknowns,
            nonzero: if self.corner_weight { vec!["d".to_owned()] } else { Vec::new() },
            subject: DraftSubject::Patch { convention, surface, net: points, layout: Layout::Columns },
            define: Vec::new(),
        };
        draft.text()
    }

    fn is_cartesian(&self) -> bool {
        self.interior == Interior::OnAxis
    }

    fn title(&self) -> String {
        let (m, n) = self.bidegree;
        let interior = match (self.interior, self.corner_weight) {
            (Interior::OnAxis, _) => "centre on the axis",
            (Interior::Free(Symmetry::None), false) => "interior unknown",
            (Interior::Free(Symmetry::None), true) => "interior and corner weights unknown",
            (Interior::Free(Symmetry::C2), false) => "interior with the half-turn",
            (Interior::Free(Symmetry::C2), true) => "interior with the half-turn, corner weights unknown",
            (Interior::Free(Symmetry::D2), _) => "interior with two reflections",
            (Interior::Free(Symmetry::C4), _) => "interior with the rotations of the square",
            (Interior::Free(Symmetry::D4), _) => "interior with the symmetry of the square",
        };
        let edges = if self.corner_weight { "" } else { ", standard edges" };
        format!("Spherical cap over a cube face, bidegree ({m},{n}), {interior}{edges}")
    }

    fn remark(&self) -> Vec<&'static str> {
        let rows = "Rows along u (y increasing), points along v (x increasing): [wx, wy, wz, w].";
        let edges = "The edges are the rational quadratic arcs of the inscribed cube, raised in degree.";
        match (self.corner_weight, self.interior, self.bidegree) {
            (true, Interior::Free(Symmetry::None), (2, 2)) => vec![
                "Scaling the patch and reparametrising u -> au/(1-u+au), v likewise, makes three corner weights 1.",
                "The fourth is d^2 > 0, and an edge between weights p and q has the middle weight sqrt(2/3)*sqrt(p*q).",
            ],
            (true, ..) => vec![
                rows,
                edges,
                "Scaling the patch and reparametrising u -> au/(1-u+au), v likewise, makes all corner weights 1",
                "but one, or with the half-turn but an opposite pair. Such a weight is d^2 > 0.",
            ],
            (_, Interior::OnAxis, _) => vec![
                "Rows i = 0, 1, 2 along u (y increasing), points j = 0, 1, 2 along v (x increasing): [x, y, z, w].",
                "Corners of the cube inscribed in the unit sphere; tangents of the edges meet in the middle points.",
            ],
            (_, _, (2, 2)) => vec![rows],
            (_, Interior::Free(Symmetry::None | Symmetry::C2), _) => vec![
                rows,
                edges,
                "The interior is the sum of its parts: X11 keeps its sign under the reflections u -> 1-u, y -> -y and",
                "v -> 1-v, x -> -x of the cap; X11u, X11v, X11uv change it under the first, the second, both.",
            ],
            _ => vec![rows, edges],
        }
    }

    fn net(&self) -> Vec<Vec<Entries>> {
        let (m, n) = self.bidegree;
        let face = CubeFace::derive(Cap::field()).expect("the cube's side lies in Q(√2,√3)");
        // The corner (i, j) has the weight d^power.
        let power = |i: usize, j: usize| match (self.corner_weight, self.interior) {
            (true, Interior::Free(Symmetry::C2)) => 2 * u32::from(i != j),
            (true, _) => 2 * u32::from(i == 1 && j == 1),
            (false, _) => 0,
        };
        let along_u = [0, 1].map(|v| {
            let arc = face.edge_along_u(v).expect("its weight lies in Q(√2,√3)").to_curve();
            WeightedArc::new(&arc, [power(0, v), power(1, v)]).elevated_to(m)
        });
        let along_v = [0, 1].map(|u| {
            let arc = face.edge_along_v(u).expect("its weight lies in Q(√2,√3)").to_curve();
            WeightedArc::new(&arc, [power(u, 0), power(u, 1)]).elevated_to(n)
        });
        let mut net = vec![vec![Entries::default(); n as usize + 1]; m as usize + 1];
        for (i, j) in iproduct!(0..=m, 0..=n) {
            let edge = |curves: &[WeightedArc; 2], which: u32, at: u32| {
                curves[which as usize].entries(at as usize, self.is_cartesian())
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

    fn inner(&self, i: u32, j: u32) -> Entries {
        let group = match self.interior {
            Interior::OnAxis => return ["0", "0", "z", "w"].map(String::from),
            Interior::Free(Symmetry::C4) => &ROTATIONS[..],
            Interior::Free(Symmetry::D4) => &ALL[..],
            Interior::Free(symmetry) => return parts::entries(self.bidegree, symmetry, i, j),
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
