//! Tilings of the sphere by congruent polygons, from the symmetry of the cube.

use itertools::{Itertools, iproduct};

use super::cube_face::Vector;
use super::polygon::Polygon;
use crate::algebra::{FieldElement, Integer, MultiquadraticField};

/// A polygon with a name, and the tiling it belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NamedPolygon {
    /// The name on the command line.
    pub name: &'static str,
    /// One line about it.
    pub about: &'static str,
    /// The field of the corners, and of the roots that symmetric patches need.
    radicands: &'static [u32],
    /// Directions of the corners.
    directions: &'static [[i64; 3]],
}

/// All of them. Corners in the order of the boundary, seen from outside to the left.
pub const POLYGONS: &[NamedPolygon] = &[
    NamedPolygon {
        name: "cube",
        about: "a face of the inscribed cube, 6 of them",
        radicands: &[2, 3],
        directions: &[[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]],
    },
    NamedPolygon {
        name: "rhombic-dodecahedron",
        about: "a rhomb between two 4-fold and two 3-fold axes of the cube, 12 of them",
        radicands: &[3],
        directions: &[[1, 0, 0], [1, 1, -1], [0, 1, 0], [1, 1, 1]],
    },
    NamedPolygon {
        name: "deltoidal-icositetrahedron",
        about: "a kite between a 4-fold, a 3-fold and two 2-fold axes of the cube, 24 of them",
        radicands: &[2, 3],
        directions: &[[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]],
    },
    NamedPolygon {
        name: "octant",
        about: "a triangle between three 4-fold axes of the cube, 8 of them",
        radicands: &[2],
        directions: &[[1, 0, 0], [0, 1, 0], [0, 0, 1]],
    },
];

/// A rotation of the cube: which coordinate goes where, and with which sign.
type Rotation = [(usize, i64); 3];

impl NamedPolygon {
    /// The polygon with this name.
    pub fn find(name: &str) -> Option<&'static NamedPolygon> {
        POLYGONS.iter().find(|polygon| polygon.name == name)
    }

    /// The polygon.
    pub fn polygon(&self) -> Polygon {
        self.turned(&[(0, 1), (1, 1), (2, 1)])
    }

    fn turned(&self, rotation: &Rotation) -> Polygon {
        let field = MultiquadraticField::new(self.radicands);
        let corners = self.directions.iter().map(|direction| unit(field, turn(rotation, direction)));
        Polygon::new(corners.collect()).expect("the corners are on the sphere, in the order of the boundary")
    }

    /// The polygons of the tiling, the first one first: its images under the rotations of the cube, each once.
    pub fn tiling(&self) -> Vec<Polygon> {
        let key = |rotation: &Rotation| -> Vec<[i64; 3]> {
            self.directions.iter().map(|direction| turn(rotation, direction)).sorted().collect()
        };
        let distinct = rotations().into_iter().unique_by(key);
        distinct.map(|rotation| self.turned(&rotation)).collect()
    }
}

fn turn(rotation: &Rotation, direction: &[i64; 3]) -> [i64; 3] {
    rotation.map(|(from, sign)| sign * direction[from])
}

/// The 24 rotations, the identity first.
fn rotations() -> Vec<Rotation> {
    let orders = (0..3).permutations(3);
    let all = orders.flat_map(|order| {
        iproduct!([1, -1], [1, -1], [1, -1])
            .map(move |(a, b, c)| [(order[0], a), (order[1], b), (order[2], c)])
    });
    let proper = |rotation: &Rotation| {
        let places = rotation.map(|(from, _)| from);
        let inversions = places.iter().array_combinations().filter(|[a, b]| a > b).count();
        let sign: i64 = rotation.iter().map(|(_, sign)| sign).product();
        (inversions % 2 == 0) == (sign == 1)
    };
    all.filter(proper).collect()
}

/// The point of the unit sphere in this direction.
fn unit(field: MultiquadraticField, direction: [i64; 3]) -> Vector {
    let square = direction.iter().map(|x| x * x).sum();
    let length: FieldElement = field.integer(square).square_root().expect("the field has this root");
    // √3 or −√3, as the root is found.
    let length = match length.sign() {
        crate::algebra::Sign::Negative => -&length,
        _ => length,
    };
    let inverse = length.inverse().expect("a direction is not zero");
    direction.map(|x| &field.rational(Integer::from(x), Integer::one()) * &inverse)
}
