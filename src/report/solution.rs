//! A control net, or the solution of a system, exactly.

use super::mathematics::Notation;
use crate::checker::{Claim, ExactNet, Solution, Theorem};
use crate::document::{Block, Column, Document, Equations, Phrase, Table};
use crate::exact::Polynomial;
use crate::prove::Freedom;
use crate::statement::{COORDINATES, Statement, Subject};

/// The values of the unknowns and the net at them.
pub(super) fn solution(statement: &Statement, theorem: &Theorem, freedom: &Freedom) -> Document {
    let mut document = Document::new(statement.ring());
    let (values, net) = match theorem.claim() {
        Claim::Exact(ExactNet { values, net, .. }) => (values, Some(net)),
        Claim::Solution(Solution { values }) => (values, None),
        _ => return document,
    };
    if !values.is_empty() {
        document.heading("The unknowns");
        let width = statement.unknowns().iter().map(String::len).max().unwrap_or(0);
        let rows = (0..).zip(values).take(statement.unknowns().len()).map(|(unknown, value)| {
            let name = Phrase::default().formula(&Polynomial::variable(unknown));
            (name, Phrase::default().formula(value), String::new())
        });
        document.push(Block::Equations(Equations { indent: 3, width, rows: rows.collect() }));
        document.gap();
        choice(&mut document, statement, values, freedom);
    }
    let Some(net) = net else { return document };
    document.heading("The control net, premultiplied (X, Y, Z, W) = (wx, wy, wz, w)");
    let indices = [Column::right(0).at_least(2), Column::right(1).at_least(2)];
    let columns = [&indices[..], &[Column::right(3); 4]].concat();
    let mut table = Table::new(3, columns).headed(["i", "j"].into_iter().chain(COORDINATES));
    for (i, row) in net.iter().enumerate() {
        for (j, point) in row.iter().enumerate() {
            let place = [i, j].map(|index| Phrase::words(index.to_string()));
            table.row(place.into_iter().chain(point.iter().map(|entry| Phrase::default().formula(entry))));
        }
    }
    document.push(Block::Table(table));
    document.gap();
    document
}

/// What was free, and which values were chosen.
fn choice(document: &mut Document, statement: &Statement, values: &[Polynomial], freedom: &Freedom) {
    let notation = Notation::new(statement.ring());
    let named = |k: &usize| {
        Some(format!("{} = {}", statement.unknowns().get(*k)?, notation.polynomial(values.get(*k)?)))
    };
    if !freedom.chosen.is_empty() {
        let chosen: Vec<String> = freedom.chosen.iter().filter_map(|(k, _)| named(k)).collect();
        let verb = if chosen.len() == 1 { "was" } else { "were" };
        let of_many = if freedom.infinite { "One of infinitely many over the complex numbers: " } else { "" };
        document.paragraph(0, format!("{of_many}{} {verb} chosen.", chosen.join(", ")));
    }
    let equation = match statement.subject() {
        Subject::Patch(_) => "coefficient",
        Subject::System(_) => "equation",
    };
    for name in freedom.indifferent.iter().filter_map(|&k| statement.unknowns().get(k)) {
        document.line(0, format!("{name} occurs in no {equation}: with any value of it the equations hold."));
    }
    if !(freedom.chosen.is_empty() && freedom.indifferent.is_empty()) {
        document.gap();
    }
}
