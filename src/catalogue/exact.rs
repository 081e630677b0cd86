//! The patch of bidegree (4,2) that covers the cap exactly, as a statement without unknowns.

use itertools::Itertools;

use super::cap::Cap;
use super::spell::spell;
use crate::geometry::{CubeFace, exact_cap};

/// The statement file.
pub(super) fn statement() -> String {
    let face = CubeFace::derive(Cap::field()).expect("the cap's geometry lies in its field");
    let net = exact_cap(&face).expect("and so do the roots that the exact patch needs");
    let point = |entries: &[crate::algebra::FieldElement; 4]| {
        format!("[{}]", entries.iter().map(|entry| format!("\"{}\"", spell(entry))).join(", "))
    };
    let row = |points: &Vec<_>| format!("  [\n    {},\n  ],\n", points.iter().map(point).join(",\n    "));
    format!(
        "# A positive control: the generalised stereographic image of a spinor of bidegree (2,1) whose edges run along great circles.\n\
         title = \"Spherical cap over a cube face, bidegree (4,2), exact\"\n\
         radicands = [2, 3]\n\
         unknowns = []\n\
         convention = \"homogeneous\"\n\
         bidegree = [4, 2]\n\
         surface = \"X^2 + Y^2 + Z^2 - W^2\"\n\n\
         net = [\n{}]\n",
        net.iter().map(row).join("")
    )
}
