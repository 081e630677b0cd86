//! Statements without unknowns: nets that are known exactly.

use itertools::Itertools;

use super::cap::Cap;
use crate::algebra::{FieldElement, spell};
use crate::geometry::{CubeFace, Moduli, Point, Polygon, quadrilateral};

/// The patch of bidegree (4,2) that covers the cap exactly, its corners of weight 1.
pub(super) fn statement() -> String {
    let face = CubeFace::derive(Cap::field()).expect("the cap's geometry lies in its field");
    let [[start, end], [start_far, end_far]] = face.corners;
    let cap = Polygon::new(vec![start, start_far, end_far, end]).expect("the corners of the face");
    let form = quadrilateral(&cap, &Moduli::standard(&cap)).expect("the field has the roots that are needed");
    net_statement(
        "Spherical cap over a cube face, bidegree (4,2), exact",
        "A positive control: the generalised stereographic image of a spinor of bidegree (2,1) whose edges run along great circles.",
        &normalised(&form.image()),
    )
}

/// The net with weight 1 at u = v = 0.
pub fn normalised(net: &[Vec<Point>]) -> Vec<Vec<Point>> {
    let unit = net[0][0][3].inverse().expect("a corner has a weight");
    net.iter().map(|row| row.iter().map(|point| point.each_ref().map(|x| x * &unit)).collect()).collect()
}

/// The statement file that this net, premultiplied by its weights, lies on the unit sphere.
pub fn net_statement(title: &str, remark: &str, net: &[Vec<Point>]) -> String {
    let field = net[0][0][0].field();
    let point = |entries: &[FieldElement; 4]| {
        format!("[{}]", entries.iter().map(|entry| format!("\"{}\"", spell(entry))).join(", "))
    };
    let row = |points: &Vec<Point>| format!("  [\n    {},\n  ],\n", points.iter().map(point).join(",\n    "));
    format!(
        "# {remark}\n\
         title = \"{title}\"\n\
         radicands = [{}]\n\
         unknowns = []\n\
         convention = \"homogeneous\"\n\
         bidegree = [{}, {}]\n\
         surface = \"X^2 + Y^2 + Z^2 - W^2\"\n\n\
         net = [\n{}]\n",
        field.radicands().iter().join(", "),
        net.len() - 1,
        net[0].len() - 1,
        net.iter().map(row).join("")
    )
}
