//! Exact patches and tilings, for people and as data.

use std::fmt::Write as _;
use std::path::Path;

use super::attempt::{Files, wrapped_at};
use super::degrees::{ON_PAPER, argument_text};
use super::mathematics::Notation;
use crate::algebra::{FieldElement, Polynomial as Computed, polynomial_to_exact};
use crate::audit::decimal;
use crate::checker::{Claim, Covered, Theorem};
use crate::commands::{Nonexistent, Tiled, Verdict};
use crate::construction::{Construction, How};
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
pub(super) fn corners_text(polygon: &Polygon) -> String {
    let numbers = Numbers::new(polygon);
    let mut text = String::new();
    for (number, corner) in (1..).zip(polygon.corners()) {
        let [x, y, z] = corner.each_ref().map(|x| numbers.exact(x));
        let _ = writeln!(text, "   {number}  ({x}, {y}, {z})");
    }
    text
}

/// `construct`.
///
/// # Errors
/// Where a number exceeds what the formats allow.
pub(super) fn constructed_text(
    name: &str,
    polygon: &Polygon,
    made: &Construction,
    files: &[Files],
) -> Result<String, Limit> {
    let (m, n) = (made.net.len() - 1, made.net[0].len() - 1);
    let word = Verdict::Exact;
    let mut text = String::new();
    let _ = match &made.cover {
        Ok(proof) => writeln!(
            text,
            "{word}  {name}: a patch of bidegree ({m},{n}) on the unit sphere covers the polygon{}\n",
            how_covered(proof.theorem())
        ),
        Err(why) => writeln!(
            text,
            "{word}  {name}: a patch of bidegree ({m},{n}) lies on the unit sphere; that it covers the polygon is not shown\n       {why}\n"
        ),
    };
    let _ = writeln!(text, "Corners, in the order of the boundary\n{}", corners_text(polygon));
    let _ = writeln!(text, "Construction\n{}\n", wrapped_at(&how_text(polygon, &made.how), 3));
    let numbers = Numbers::new(polygon);
    let cartesian = |[x, y, z, w]: &Point| -> Point {
        let inverse = w.inverse();
        let over =
            |value: &FieldElement| inverse.as_ref().map_or_else(|| value.clone(), |inverse| value * inverse);
        [over(x), over(y), over(z), w.clone()]
    };
    let infinite = made.net.iter().flatten().any(|point| point[3].is_zero());
    if infinite {
        text += "Some weights are 0: there is no Cartesian net.\n\n";
    } else {
        text += "Control points, Cartesian, with weights; rows i along u, points j along v\n";
        text += &net_text(&numbers, &made.net, ["x", "y", "z", "w"], cartesian)?;
        text.push('\n');
    }
    text += "Control points, homogeneous, premultiplied by their weights\n";
    text += &net_text(&numbers, &made.net, ["X", "Y", "Z", "W"], Clone::clone)?;
    text.push('\n');
    text += "Verdict of the independent checker, on the files below\n";
    let theorem = made.cover.as_ref().unwrap_or(&made.exact).theorem();
    let _ = writeln!(text, "{}\n", wrapped_at(&format!("VERIFIED. {}", theorem.sentence()), 3));
    for (number, files) in files.iter().enumerate() {
        if number == 0 {
            let _ = writeln!(text, "Statement    {}", files.statement.display());
        }
        let _ = writeln!(text, "Certificate  {}", files.certificate.display());
    }
    Ok(text)
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

/// How many characters stand before the point.
fn whole(decimal: &str) -> usize {
    decimal.chars().take_while(|c| *c != '.').count()
}

fn net_text(
    numbers: &Numbers,
    net: &[Vec<Point>],
    names: [&str; 4],
    seen: impl Fn(&Point) -> Point,
) -> Result<String, Limit> {
    let mut lines: Vec<(String, &str, String, String)> = Vec::new();
    for (i, row) in net.iter().enumerate() {
        for (j, point) in row.iter().enumerate() {
            for (k, value) in seen(point).iter().enumerate() {
                let place = if k == 0 { format!("({i},{j})") } else { String::new() };
                lines.push((place, names[k], numbers.exact(value), numbers.decimal(value)?));
            }
        }
    }
    let width = lines.iter().map(|(.., exact, _)| exact.chars().count()).max().unwrap_or(0);
    let before = lines.iter().map(|(.., decimal)| whole(decimal)).max().unwrap_or(0);
    let mut text = String::new();
    for (place, name, exact, decimal) in &lines {
        let pad = width - exact.chars().count();
        let shift = before - whole(decimal);
        let _ = writeln!(text, "   {place:<7}{name} = {exact}{:pad$}   {:shift$}{decimal}", "", "");
    }
    Ok(text)
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
pub(super) fn impossible_text(none: &Nonexistent) -> String {
    format!(
        "{}  {}: {}\n\n{}\n\n{}\n",
        Verdict::Nonexistent,
        none.name,
        impossible_headline(none.bidegree),
        argument_text(&none.polygon, none.bidegree, none.cell),
        wrapped_at(ON_PAPER, 3)
    )
}

/// `construct --tiling`.
pub(super) fn tiled_text(answer: &Tiled, directory: &Path) -> String {
    let Tiled { shape, bidegree: (m, n), tiled } = answer;
    let name = &shape.name;
    let meets = tiled.seams.iter().filter(|seam| seam.meets).count();
    let covers = tiled.faces.iter().filter(|face| face.cover.is_ok()).count();
    let count = tiled.faces.len();
    let word = answer.verdict();
    let verdict = match answer.whole() {
        true => format!("{word}  {name}: {count} patches of bidegree ({m},{n}) cover the unit sphere"),
        false => format!(
            "{word}  {name}: that {count} patches of bidegree ({m},{n}) cover the unit sphere is not shown"
        ),
    };
    let degenerate =
        |theorem: &Theorem| matches!(theorem.claim(), Claim::Cover(Covered { point: Some(_), .. }));
    let points = tiled
        .faces
        .iter()
        .filter_map(|face| face.cover.as_ref().ok())
        .any(|proof| degenerate(proof.theorem()));
    let regularly = if points { "regularly but for an edge that is one corner" } else { "regularly" };
    format!(
        "{verdict}\n\n   \
         {covers} of {count} cover their polygons, once and {regularly} (verified by the independent checker)\n   \
         {meets} of {} edges are met by both neighbours point for point, at the same parameter or the reversed one\n   \
         (computed exactly: all 2×2 minors of the two curves' coordinates vanish identically)\n\n\
         Statements and certificates  {}\n",
        tiled.seams.len(),
        directory.display()
    )
}
