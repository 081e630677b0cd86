//! The geometry of the cap over the cube face, line by line (the paper's sections 2.1, 2.2 and Appendix A).

use super::mathematics::Notation;
use crate::algebra::{FieldElement, Polynomial, polynomial_to_exact};
use crate::catalogue::Cap;
use crate::document::{Block, Column, Document, Table};
use crate::exact::{self, Limit, Radicands, Ring};
use crate::geometry::{CubeFace, dot};
use crate::statement::{Patch, Statement};

/// The lines that lead from the cube to the control points of an edge. Every value printed is computed here.
pub(super) fn cube_face(document: &mut Document, statement: &Statement, patch: &Patch) -> Result<(), Limit> {
    let field = Cap::field();
    let face = CubeFace::derive(field).expect("the cube's side lies in Q(√2,√3)");
    let arc = face.edge_along_v(0).expect("the weight lies in Q(√2,√3)");
    let radicands = Radicands::new(field.radicands().to_vec()).expect("2 and 3 are primes");
    let notation = Notation::new(Ring { field: radicands, variables: Vec::new() });
    let number = |value: &FieldElement| -> Result<String, Limit> {
        Ok(notation.polynomial(&polynomial_to_exact(&Polynomial::constant(value.clone()))?))
    };
    let point = |p: &[FieldElement; 3]| -> Result<String, Limit> {
        Ok(format!("({}, {}, {})", number(&p[0])?, number(&p[1])?, number(&p[2])?))
    };
    let side_squared = &face.side * &face.side;
    let middle_squared = dot(&arc.middle_of_chord, &arc.middle_of_chord);
    // Each line with the paper's number for it.
    let lines = [
        ("The unit sphere, R = 1, and the face z > 0 of the inscribed cube of side a:".to_owned(), ""),
        (
            format!("a²/2 + a²/4 = R², so a² = {} and a = {}", number(&side_squared)?, number(&face.side)?),
            "A-3, 1",
        ),
        (format!("A = {}, B = {}, …", point(&arc.start)?, point(&arc.end)?), "3"),
        (
            format!("M = (A+B)/2 = {}, |OM|² = {}", point(&arc.middle_of_chord)?, number(&middle_squared)?),
            "A-1, A-2",
        ),
        (format!("The tangents at A and B meet in P = M/(M·A) = {}", point(&arc.tangents_meet)?), "A-10"),
        (format!("Its weight is cos(α/2) = |OM|/R = {}; A and B have weight 1", number(&arc.weight)?), "A-8"),
        ("The other three edges likewise. (Numbers on the right are the paper's.)".to_owned(), ""),
    ];
    let mut table = Table::new(3, [Column::left(0), Column::left(3)]);
    for (line, equation) in lines {
        let number = if equation.is_empty() { String::new() } else { format!("({equation})") };
        table.row([line, number]);
    }
    document.push(Block::Table(table));
    let (m, n) = patch.bidegree;
    if m.max(n) > 2 {
        let raised =
            format!("The edges are raised in degree to {m} along u and {n} along v; the arcs stay the same.");
        document.line(3, raised);
    }
    if !statement.nonzero().is_empty() {
        let [.., corner] = &patch.net[m as usize][n as usize];
        let one = exact::Polynomial::integer(1);
        // With the half-turn the corner (1,1) is the image of (0,0), and has its weight.
        let which = if *corner == one {
            "Scaling and reparametrising the patch makes two opposite corner weights 1; the others are d², and an"
        } else {
            "Scaling and reparametrising the patch makes three corner weights 1; the fourth is d², and an"
        };
        document
            .line(3, format!("{which}\nedge between weights p and q has the middle weight cos(α/2)·√(pq)."));
    }
    let mut odd = statement.unknowns().iter().filter(|name| name.ends_with(['u', 'v']));
    let half_turn = odd.clone().all(|name| name.ends_with("uv"));
    if let Some(name) = odd.next() {
        let whole = name.trim_end_matches(['u', 'v']);
        let signs = if half_turn {
            format!("{whole}uv changes sign under both. Every interior with the half-turn is such a sum.")
        } else {
            format!(
                "{whole}u changes sign under the first, {whole}v under the second, {whole}uv under both. Every interior\nis such a sum."
            )
        };
        document.line(
            3,
            format!(
                "The inner points are sums of their parts under the reflections u → 1−u and v → 1−v of the cap:\n{signs}"
            ),
        );
    }
    Ok(())
}
