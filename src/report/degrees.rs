//! The table of bidegrees, and the argument for each of its cells.

use serde::Serialize;

use super::attempt::Files;
use super::construction::{Numbers, corners, how_covered};
use crate::commands::{Degrees, Shape, Verdict};
use crate::construction::{Cell, Phase, classify, triple_products};
use crate::document::{Block, Column, Document, Table};
use crate::exact::Limit;
use crate::geometry::{Complex, Polygon};

/// What stands behind the lemmas.
pub(super) const ON_PAPER: &str = "The lemmas, with their hypotheses and proofs, are in proofs/STRUCTURE.md: mathematics on paper, which no program has \
     checked.";

/// `degrees`.
pub(super) fn classified(degrees: &Degrees, closing: Option<&Files>, nets: &[Vec<Files>]) -> Document {
    let Degrees { shape: Shape { name, polygon, .. }, phase, up_to, .. } = degrees;
    let (phase, up_to) = (*phase, *up_to);
    let mut document = Document::of_words();
    let condition = match phase {
        Phase::Open => "min(m,n) ≥ 2 and max(m,n) ≥ 4",
        Phase::Reversed => "min(m,n) ≥ 2 and max(m,n) ≥ 4; from (2,2) on with an edge the longer way round",
        Phase::None | Phase::Absorbed => "min(m,n) ≥ 2",
    };
    let sentence = format!("{name}: on the unit sphere bidegree (m,n) is exact if and only if {condition}");
    document.headline(Verdict::Classified.word(), sentence);
    document.gap();
    corners(&mut document, polygon);
    document.gap();
    holonomy(&mut document, 0, polygon);
    document.gap();
    document.push(Block::Table(cells(phase, up_to)));
    document.gap();
    let all: Vec<(u32, u32)> = (1..=up_to).flat_map(|m| (1..=up_to).map(move |n| (m, n))).collect();
    for (mark, meaning) in [
        ("·", "impossible: no surface (parity)"),
        ("×", "impossible: the phase does not close (parity and holonomy; certificate below)"),
        ("~", "edges in their great circles, but no net with all of them the shorter arcs (net below)"),
        ("E", "exact: constructed (net below, with what the independent checker has verified of it)"),
        ("e", "exact: a net above or to the left of it, with its degrees raised"),
    ] {
        if all.iter().any(|at| symbol(classify(phase, *at), *at) == mark) {
            document.line(3, format!("{mark}  {meaning}"));
        }
    }
    document.gap();
    document.line(
        0,
        "The argument for a cell: --explain M N. The lemmas, with their hypotheses and proofs, are in proofs/STRUCTURE.md:\n\
         mathematics on paper. The independent checker has verified the files that are named here.",
    );
    document.gap();
    let verified = Verdict::Verified;
    if let Some(files) = closing {
        let file = files.certificate.display();
        document.line(3, format!("×        the closing condition has no solution: {verified}  {file}"));
    }
    for (((m, n), made), files) in degrees.nets.iter().zip(nets) {
        let theorem = made.cover.as_ref().unwrap_or(&made.exact).theorem();
        let last = files.last().map_or_else(String::new, |files| files.certificate.display().to_string());
        let mark = symbol(classify(phase, (*m, *n)), (*m, *n));
        let shown = match theorem.kind() {
            "cover" => format!("covers the polygon{}", how_covered(theorem)),
            _ => "lies on the sphere".to_owned(),
        };
        document.line(3, format!("{mark} ({m},{n})  {shown}: {verified}  {last}"));
    }
    document
}

/// A mark for each bidegree, m downwards and n to the right.
fn cells(phase: Phase, up_to: u32) -> Table {
    let columns = vec![Column::right(0).at_least(4); up_to as usize + 2];
    let numbers = (1..=up_to).map(|n| n.to_string());
    let mut table = Table::new(0, columns).headed([String::new(), "n".to_owned()].into_iter().chain(numbers));
    table.row(["m"]);
    for m in 1..=up_to {
        let marks = (1..=up_to).map(|n| symbol(classify(phase, (m, n)), (m, n)).to_owned());
        table.row([m.to_string(), String::new()].into_iter().chain(marks));
    }
    table
}

fn symbol(cell: Cell, at: (u32, u32)) -> &'static str {
    match cell {
        Cell::NoSurface => "·",
        Cell::NoClosure => "×",
        Cell::LongerWay => "~",
        Cell::Exact(base) if base == at => "E",
        Cell::Exact(_) => "e",
    }
}

/// Z and its imaginary part.
fn holonomy(document: &mut Document, indent: usize, polygon: &Polygon) {
    let numbers = Numbers::new(polygon);
    if polygon.is_triangle() {
        document.line(indent, "A triangle: the edge that is a point takes up any phase.");
        return;
    }
    let (products, sum) = triple_products(polygon);
    document.line(indent, "Triple products [123] + [234] + [341] + [412], a positive multiple of Im Z");
    let spelled: Vec<String> = products.iter().map(|product| numbers.factor(product)).collect();
    document.line(indent + 3, format!("{} = {}", spelled.join(" + "), numbers.exact(&sum)));
    if let Some(Complex { re, im }) = polygon.holonomy().direction() {
        document.line(
            indent + 3,
            format!(
                "Z/|Z| = {} + i·{}, whose argument is half the solid angle",
                numbers.exact(&re),
                numbers.factor(&im)
            ),
        );
    }
}

/// `degrees --explain M N`.
pub(super) fn explain(name: &str, polygon: &Polygon, bidegree: (u32, u32)) -> Document {
    let cell = classify(Phase::of(polygon), bidegree);
    let (m, n) = bidegree;
    let verdict = match cell {
        Cell::NoSurface | Cell::NoClosure => "no exact patch",
        Cell::LongerWay => "no exact patch with all edges the shorter arcs",
        Cell::Exact(_) => "exact patches",
    };
    let mut document = Document::of_words();
    let sentence = format!("{name}: on the unit sphere bidegree ({m},{n}) has {verdict}");
    document.headline(Verdict::Classified.word(), sentence);
    document.gap();
    argument(&mut document, polygon, bidegree, cell);
    document.gap();
    document.paragraph(3, ON_PAPER);
    document
}

/// A part of an argument.
enum Part {
    /// A paragraph.
    Words(String),
    /// Z and its imaginary part, for this polygon.
    Holonomy,
}

/// The argument for one cell, for people.
pub(super) fn argument(document: &mut Document, polygon: &Polygon, bidegree: (u32, u32), cell: Cell) {
    for (k, part) in parts(polygon, bidegree, cell).into_iter().enumerate() {
        if k > 0 {
            document.gap();
        }
        match part {
            Part::Words(words) => document.paragraph(3, words),
            Part::Holonomy => holonomy(document, 3, polygon),
        }
    }
}

/// The same as data.
#[derive(Debug, Serialize)]
pub(super) struct ArgumentData {
    #[serde(skip_serializing_if = "Option::is_none")]
    lemma: Option<&'static str>,
    /// Paragraphs.
    argument: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    holonomy: Option<HolonomyData>,
    /// Where the lemmas are.
    on_paper: &'static str,
}

/// Z of the polygon.
#[derive(Debug, Serialize)]
struct HolonomyData {
    /// [123], [234], [341], [412]: their sum is a positive multiple of Im Z.
    triple_products: Vec<String>,
    sum: String,
    /// Z/|Z|, where it is in the field: real and imaginary part.
    direction: Option<[String; 2]>,
}

impl ArgumentData {
    pub(super) fn of(polygon: &Polygon, bidegree: (u32, u32), cell: Cell) -> Result<Self, Limit> {
        let (mut paragraphs, mut holonomy) = (Vec::new(), None);
        for part in parts(polygon, bidegree, cell) {
            match part {
                Part::Words(words) => paragraphs.push(words),
                Part::Holonomy => holonomy = Some(HolonomyData::of(polygon)?),
            }
        }
        let lemma = match cell {
            Cell::NoSurface => Some("parity"),
            Cell::NoClosure | Cell::LongerWay => Some("holonomy"),
            Cell::Exact(_) => None,
        };
        Ok(ArgumentData { lemma, argument: paragraphs, holonomy, on_paper: "proofs/STRUCTURE.md" })
    }
}

impl HolonomyData {
    fn of(polygon: &Polygon) -> Result<Self, Limit> {
        let numbers = Numbers::new(polygon);
        let (products, sum) = triple_products(polygon);
        let products: Result<_, _> = products.iter().map(|product| numbers.spelled(product)).collect();
        let direction = polygon
            .holonomy()
            .direction()
            .map(|Complex { re, im }| Ok::<_, Limit>([numbers.spelled(&re)?, numbers.spelled(&im)?]));
        Ok(HolonomyData {
            triple_products: products?,
            sum: numbers.spelled(&sum)?,
            direction: direction.transpose()?,
        })
    }
}

/// The argument for one cell.
fn parts(polygon: &Polygon, (m, n): (u32, u32), cell: Cell) -> Vec<Part> {
    let parity = "Parity. Let X, Y, Z, W be without common factor and X² + Y² + Z² = W². In C[u,v], which has unique factorisation, \
         (X + iY)(X − iY) = (W + Z)(W − Z) makes W + Z = 2|α|², W − Z = 2|β|², X + iY = 2ᾱβ up to one sign, and the \
         degrees of W in u and in v are twice those of the spinor (α, β). A common factor moves no point; without it the degrees are even.";
    let words = |text: &str| Part::Words(text.to_owned());
    let even = (m - m % 2, n - n % 2);
    match cell {
        Cell::NoSurface => vec![
            words(parity),
            Part::Words(format!(
                "Here bidegree ({m},{n}) leaves at most ({},{}): the patch does not depend on {}, and two corners coincide.",
                even.0,
                even.1,
                if even.0 == 0 { "u" } else { "v" }
            )),
        ],
        Cell::NoClosure | Cell::LongerWay => {
            let mut parts = vec![];
            if even != (m, n) {
                parts.push(words(parity));
                parts.push(Part::Words(format!(
                    "Here bidegree ({m},{n}) leaves at most ({},{}), a bilinear spinor.",
                    even.0, even.1
                )));
            } else {
                parts.push(Part::Words(format!("{parity} Here the spinor is bilinear.")));
            }
            parts.push(words(
                "Holonomy. Along an edge the spinor runs linearly from a to b. Its image lies in a great circle, and a and b belong to \
                 different points that are not antipodal: then ⟨a,b⟩ is real. Around the quadrilateral, the product of the four \
                 products, Π|c|²·Z, would be real, with Z = ⟨s₁,s₂⟩⟨s₂,s₃⟩⟨s₃,s₄⟩⟨s₄,s₁⟩ for any spinors s of the corners.",
            ));
            parts.push(Part::Holonomy);
            parts.push(words(match cell {
                Cell::NoClosure => "It is not 0, so that Z is not real: there is no such patch, whatever its weights and control \
                     points. (As equations in the corners' factors c, with a certificate: `degrees` writes it.)",
                _ => "It is 0, and Z is negative: the four products are real, but an odd number of them is negative, and such an edge \
                     runs the longer way round.",
            }));
            parts
        }
        Cell::Exact(base) => {
            let from = match (base == (m, n), base) {
                (true, _) => String::new(),
                (false, (a, b)) => {
                    format!(" Raising degrees takes ({a},{b}) to ({m},{n}) and changes no point.")
                }
            };
            let how = match (polygon.is_triangle(), base) {
                (true, _) => {
                    "The edge that is a single point may have any spinor of that point, times a linear complex factor: \
                     the phase closes, and a bilinear spinor is enough."
                }
                (false, (2, 2)) => {
                    "Z is positive: the corners' spinors can be put in phase all around, and a bilinear spinor is enough."
                }
                _ => {
                    "A linear complex factor f on two opposite edges makes up for the phase that is missing: |f|²·δ(s) is the same point. \
                     The spinor then has degree 2 along these edges and 1 across."
                }
            };
            vec![Part::Words(format!(
                "Construction. {how}{from} `construct --bidegree {m} {n}` gives the net, verified."
            ))]
        }
    }
}
