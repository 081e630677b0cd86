//! `prove-cap expand` for people.

use super::mathematics::{Notation, superscript};
use crate::document::{Block, Document, Equations, Phrase};
use crate::expand::{Basis, Coefficient, grouped};
use crate::statement::{Statement, Subject};

/// `prove-cap expand` for people: a listing in plain notation, with comments, that `prove-cap audit` reads.
pub(super) fn expansion(
    statement: &Statement,
    basis: Basis,
    coefficients: Option<&[Coefficient]>,
) -> Document {
    let mut document = Document::new(statement.ring());
    document.push(Block::Comment(statement.title().into()));
    document.gap();
    let formula = |polynomial| Phrase::default().formula(polynomial);
    let Some(list) = coefficients else {
        if let Subject::System(polynomials) = statement.subject() {
            let rows = (1..).zip(polynomials).map(|(number, polynomial)| {
                (Phrase::default().label(format!("f[{number}]")), formula(polynomial), String::new())
            });
            let rows = rows.collect();
            document.push(Block::Equations(Equations { indent: 0, width: 0, rows }));
        }
        return document;
    };
    let (last_r, last_s) = list.last().map_or((0, 0), |last| last.index);
    let (r, s) = match basis {
        Basis::Bernstein => {
            (format!("uʳ(1−u){}⁻ʳ", superscript_of(last_r)), format!("vˢ(1−v){}⁻ˢ", superscript_of(last_s)))
        }
        Basis::Monomial => ("uⁱ".to_owned(), "vʲ".to_owned()),
    };
    let letter = if basis == Basis::Bernstein { "c[r,s]" } else { "a[i,j]" };
    let sum = format!("F = {} = Σ {letter} {r} {s}", surface_text(statement));
    document.push(Block::Comment(sum.into()));
    if list.iter().any(|coefficient| coefficient.name == "a1") {
        let paper =
            "a1, …, a16 are the coefficients of uⁱvʲ, i, j = 1, …, 4, row by row (the paper's Eq. 10).";
        document.push(Block::Comment(paper.into()));
    }
    document.gap();
    let nonzero: Vec<&Coefficient> = list.iter().filter(|c| !c.value.is_zero()).collect();
    let width = nonzero.iter().map(|c| c.name.len()).max().unwrap_or(0);
    let rows = nonzero.iter().map(|c| (Phrase::default().label(&c.name), formula(&c.value), String::new()));
    document.push(Block::Equations(Equations { indent: 0, width, rows: rows.collect() }));
    let (distinct, zero) = grouped(list);
    document.gap();
    let count =
        format!("{} coefficients: {zero} zero, {} distinct among the others.", list.len(), distinct.len());
    document.push(Block::Comment(count.into()));
    document
}

pub(super) fn superscript_of(number: u32) -> String {
    if number == 1 { "¹".into() } else { superscript(number) }
}

/// The surface polynomial as mathematics.
pub(super) fn surface_text(statement: &Statement) -> String {
    match statement.subject() {
        Subject::Patch(patch) => Notation::new(statement.coordinate_ring()).polynomial(&patch.surface),
        Subject::System(_) => String::new(),
    }
}
