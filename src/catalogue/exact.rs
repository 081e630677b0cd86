//! Statements without unknowns: nets that are known exactly.

use super::cap::Cap;
use crate::algebra::spell;
use crate::formats::statement_file::{Draft, DraftSubject, Layout};
use crate::geometry::{CubeFace, Moduli, Point, Polygon, quadrilateral};
use crate::statement::{Convention, UNIT_SPHERE};

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
    let points = |row: &Vec<Point>| row.iter().map(|point| point.each_ref().map(spell)).collect();
    let subject = DraftSubject::Patch {
        convention: Convention::Homogeneous,
        surface: Some(UNIT_SPHERE.to_owned()),
        net: net.iter().map(points).collect(),
        layout: Layout::Points,
    };
    let draft = Draft {
        remark: vec![remark.to_owned()],
        title: title.to_owned(),
        radicands: net[0][0][0].field().radicands().to_vec(),
        unknowns: Vec::new(),
        nonzero: Vec::new(),
        subject,
        define: Vec::new(),
    };
    draft.text()
}
