//! `prove-cap expand` for people.

use std::fmt::Write as _;

use super::mathematics::{Notation, superscript};
use crate::expand::{Basis, Coefficient, grouped};
use crate::statement::{Statement, Subject};

/// `prove-cap expand` for people: a listing in plain notation, with comments, that `prove-cap audit` reads.
pub(super) fn expansion_text(
    statement: &Statement,
    basis: Basis,
    coefficients: Option<&[Coefficient]>,
) -> String {
    let notation = Notation::new(statement.ring());
    let mut text = format!("# {}\n\n", statement.title());
    let Some(list) = coefficients else {
        if let Subject::System(polynomials) = statement.subject() {
            for (number, polynomial) in (1..).zip(polynomials) {
                let _ = writeln!(text, "f[{number}] = {}", notation.polynomial(polynomial));
            }
        }
        return text;
    };
    let (last_r, last_s) = list.last().map_or((0, 0), |last| last.index);
    let (r, s) = match basis {
        Basis::Bernstein => {
            (format!("uʳ(1−u){}⁻ʳ", superscript_of(last_r)), format!("vˢ(1−v){}⁻ˢ", superscript_of(last_s)))
        }
        Basis::Monomial => ("uⁱ".to_owned(), "vʲ".to_owned()),
    };
    let letter = if basis == Basis::Bernstein { "c[r,s]" } else { "a[i,j]" };
    let surface = surface_text(statement);
    let _ = writeln!(text, "# F = {surface} = Σ {letter} {r} {s}");
    if list.iter().any(|coefficient| coefficient.name == "a1") {
        let _ = writeln!(
            text,
            "# a1, …, a16 are the coefficients of uⁱvʲ, i, j = 1, …, 4, row by row (the paper's Eq. 10)."
        );
    }
    let width = list.iter().filter(|c| !c.value.is_zero()).map(|c| c.name.len()).max().unwrap_or(0);
    text.push('\n');
    for coefficient in list.iter().filter(|coefficient| !coefficient.value.is_zero()) {
        let _ = writeln!(text, "{:<width$} = {}", coefficient.name, notation.polynomial(&coefficient.value));
    }
    let (distinct, zero) = grouped(list);
    let _ = writeln!(
        text,
        "\n# {} coefficients: {zero} zero, {} distinct among the others.",
        list.len(),
        distinct.len()
    );
    text
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
