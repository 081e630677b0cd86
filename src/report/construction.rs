//! Exact patches and tilings, for people and as data.

use std::path::Path;

use super::attempt::{Files, verdict_of_checker};
use super::degrees::{ON_PAPER, argument};
use super::mathematics::Notation;
use crate::algebra::{FieldElement, Polynomial as Computed, polynomial_to_exact};
use crate::audit::decimal;
use crate::checker::{Claim, Covered, Theorem};
use crate::commands::{Constructed, Nonexistent, Shape, Tiled, Verdict};
use crate::construction::How;
use crate::document::{Block, Column, Document, Table};
use crate::exact::{Limit, Radicands, Ring};
use crate::geometry::{Point, Polygon, Split};

/// Decimals of a printed coordinate.
const PLACES: u32 = 17;

/// Numbers of a field as people write them.
pub(super) struct Numbers {
    notation: Notation,
    field: Radicands,
}

impl Numbers {
    pub(super) fn new(polygon: &Polygon) -> Self {
        let field = Radicands::new(polygon.field().radicands().to_vec()).expect("the field of a polygon");
        Numbers { notation: Notation::new(Ring { field: field.clone(), variables: vec![] }), field }
    }

    pub(super) fn exact(&self, value: &FieldElement) -> String {
        let value = polynomial_to_exact(&Computed::constant(value.clone()));
        value.map_or_else(|limit| limit.to_string(), |value| self.notation.polynomial(&value))
    }

    /// In brackets where it is a sum or negative.
    pub(super) fn factor(&self, value: &FieldElement) -> String {
        let text = self.exact(value);
        if text.contains(' ') || text.starts_with('−') { format!("({text})") } else { text }
    }

    /// In the canonical spelling.
    pub(super) fn spelled(&self, value: &FieldElement) -> Result<String, Limit> {
        let ring = Ring { field: self.field.clone(), variables: vec![] };
        Ok(ring.spell(&polynomial_to_exact(&Computed::constant(value.clone()))?))
    }

    fn decimal(&self, value: &FieldElement) -> Result<String, Limit> {
        decimal(&polynomial_to_exact(&Computed::constant(value.clone()))?, PLACES, &self.field)
    }
}

/// (x, y, z) of the corners.
pub(super) fn corners(document: &mut Document, polygon: &Polygon) {
    document.heading("Corners, in the order of the boundary");
    let numbers = Numbers::new(polygon);
    for (number, corner) in (1..).zip(polygon.corners()) {
        let [x, y, z] = corner.each_ref().map(|x| numbers.exact(x));
        document.line(3, format!("{number}  ({x}, {y}, {z})"));
    }
}

/// `construct`.
///
/// # Errors
/// Where a number exceeds what the formats allow.
pub(super) fn constructed(answer: &Constructed, files: &[Files]) -> Result<Document, Limit> {
    let Constructed { shape: Shape { name, polygon, .. }, made } = answer;
    let (m, n) = (made.net.len() - 1, made.net[0].len() - 1);
    let mut document = Document::of_words();
    let sentence = match &made.cover {
        Ok(proof) => format!(
            "{name}: a patch of bidegree ({m},{n}) on the unit sphere covers the polygon{}",
            how_covered(proof.theorem())
        ),
        Err(_) => format!(
            "{name}: a patch of bidegree ({m},{n}) lies on the unit sphere; that it covers the polygon is not shown"
        ),
    };
    document.headline(Verdict::Exact.word(), sentence);
    if let Err(why) = &made.cover {
        document.line(7, why.to_string());
    }
    document.gap();
    corners(&mut document, polygon);
    document.gap();
    document.heading("Construction");
    document.paragraph(3, how_text(polygon, &made.how));
    document.gap();
    let numbers = Numbers::new(polygon);
    let cartesian = |[x, y, z, w]: &Point| -> Point {
        let inverse = w.inverse();
        let over =
            |value: &FieldElement| inverse.as_ref().map_or_else(|| value.clone(), |inverse| value * inverse);
        [over(x), over(y), over(z), w.clone()]
    };
    let infinite = made.net.iter().flatten().any(|point| point[3].is_zero());
    if infinite {
        document.line(0, "Some weights are 0: there is no Cartesian net.");
    } else {
        document.heading("Control points, Cartesian, with weights; rows i along u, points j along v");
        document.push(net_table(&numbers, &made.net, ["x", "y", "z", "w"], cartesian)?);
    }
    document.gap();
    document.heading("Control points, homogeneous, premultiplied by their weights");
    document.push(net_table(&numbers, &made.net, ["X", "Y", "Z", "W"], Clone::clone)?);
    document.gap();
    let theorem = made.cover.as_ref().unwrap_or(&made.exact).theorem();
    verdict_of_checker(&mut document, &theorem.sentence());
    document.push(Block::Files {
        statement: files.first().map(|files| files.statement.clone()),
        certificates: files.iter().map(|files| files.certificate.clone()).collect(),
    });
    Ok(document)
}

/// `, once and regularly`, as far as the checker has verified it: at an edge that is a point no map is regular.
pub(super) fn how_covered(theorem: &Theorem) -> String {
    match theorem.claim() {
        Claim::Cover(Covered { point: Some(edge), .. }) => {
            format!(" once, and regularly but for the edge {}, which is one corner", edge.replace('=', " = "))
        }
        _ => ", once and regularly".to_owned(),
    }
}

/// Each coordinate, exactly and as a decimal.
fn net_table(
    numbers: &Numbers,
    net: &[Vec<Point>],
    names: [&str; 4],
    seen: impl Fn(&Point) -> Point,
) -> Result<Block, Limit> {
    let place = Column::left(0).at_least(7);
    let columns = [place, Column::left(0), Column::left(1), Column::left(1), Column::point(3)];
    let mut table = Table::new(3, columns);
    for (i, row) in net.iter().enumerate() {
        for (j, point) in row.iter().enumerate() {
            for (k, value) in seen(point).iter().enumerate() {
                let place = if k == 0 { format!("({i},{j})") } else { String::new() };
                let (name, sign) = (names[k].to_owned(), "=".to_owned());
                table.row([place, name, sign, numbers.exact(value), numbers.decimal(value)?]);
            }
        }
    }
    Ok(Block::Table(table))
}

fn how_text(polygon: &Polygon, how: &How) -> String {
    let numbers = Numbers::new(polygon);
    match how {
        How::Bilinear => "The image of a bilinear spinor; higher degrees by raising them.".to_owned(),
        How::Biquartic(centre) => format!(
            "The image of a spinor of bidegree (2,2) with the symmetry of the square: a quarter of the phase on each edge; \
             the spinor at the centre is {} times those at the middles of the edges. Higher degrees by raising them.",
            numbers.exact(centre)
        ),
        How::Linear { moduli, transposed, tried } => {
            let edges = match (transposed, moduli.rotation) {
                (false, 0) => "v = 0 and v = 1",
                (true, 0) => "u = 0 and u = 1",
                (false, _) => "v = 0 and v = 1 (of the polygon counted from corner 2)",
                (true, _) => "u = 0 and u = 1 (of the polygon counted from corner 4)",
            };
            let split = match moduli.split {
                Split::Even => format!("half of the phase on each of the edges {edges}"),
                Split::Low => format!("the whole phase on the first of the edges {edges}"),
                Split::High => format!("the whole phase on the second of the edges {edges}"),
            };
            let scales: Vec<String> = moduli.scales.iter().map(|scale| numbers.exact(scale)).collect();
            let scales = match moduli.scales.iter().all(FieldElement::is_one) {
                true => "all corners with the same scale".to_owned(),
                false => format!("scales {} of the corners' spinors", scales.join(", ")),
            };
            let bidegree = if *transposed { "(1,2)" } else { "(2,1)" };
            format!(
                "The image of a spinor of bidegree {bidegree}: {split}; {scales}{}. Higher degrees by raising them.",
                match tried {
                    0 => String::new(),
                    tried => format!(" (the first {tried} choices of these did not cover the polygon)"),
                }
            )
        }
    }
}

/// `no patch of bidegree (2,2) on the unit sphere covers the polygon exactly`.
pub(super) fn impossible_headline((m, n): (u32, u32)) -> String {
    format!("no patch of bidegree ({m},{n}) on the unit sphere covers the polygon exactly")
}

/// `construct` where there is no patch.
pub(super) fn impossible(none: &Nonexistent) -> Document {
    let mut document = Document::of_words();
    let sentence = format!("{}: {}", none.name, impossible_headline(none.bidegree));
    document.headline(Verdict::Nonexistent.word(), sentence);
    document.gap();
    argument(&mut document, &none.polygon, none.bidegree, none.cell);
    document.gap();
    document.paragraph(3, ON_PAPER);
    document
}

/// `construct --tiling`.
pub(super) fn tiling(answer: &Tiled, directory: &Path) -> Document {
    let Tiled { shape: Shape { name, .. }, bidegree: (m, n), tiled } = answer;
    let meets = tiled.seams.iter().filter(|seam| seam.meets).count();
    let covers = tiled.faces.iter().filter(|face| face.cover.is_ok()).count();
    let count = tiled.faces.len();
    let patches = format!("{count} patches of bidegree ({m},{n}) cover the unit sphere");
    let sentence = match answer.whole() {
        true => format!("{name}: {patches}"),
        false => format!("{name}: that {patches} is not shown"),
    };
    let degenerate =
        |theorem: &Theorem| matches!(theorem.claim(), Claim::Cover(Covered { point: Some(_), .. }));
    let points = tiled
        .faces
        .iter()
        .filter_map(|face| face.cover.as_ref().ok())
        .any(|proof| degenerate(proof.theorem()));
    let regularly = if points { "regularly but for an edge that is one corner" } else { "regularly" };
    let mut document = Document::of_words();
    document.headline(answer.verdict().word(), sentence);
    document.gap();
    document.line(
        3,
        format!(
            "{covers} of {count} cover their polygons, once and {regularly} (verified by the independent checker)"
        ),
    );
    document.line(
        3,
        format!(
            "{meets} of {} edges are met by both neighbours point for point, at the same parameter or the reversed one\n\
             (computed exactly: all 2×2 minors of the two curves' coordinates vanish identically)",
            tiled.seams.len()
        ),
    );
    document.gap();
    document.field("Statements and certificates", 29, directory.display().to_string());
    document
}
