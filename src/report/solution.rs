//! A control net, or the solution of a system, exactly.

use std::fmt::Write as _;

use super::attempt::wrapped_at;
use super::mathematics::Notation;
use crate::checker::{Claim, ExactNet, Solution, Theorem};
use crate::exact::Polynomial;
use crate::prove::Freedom;
use crate::statement::{COORDINATES, Statement, Subject};

/// The values of the unknowns and the net at them.
pub(super) fn solution(statement: &Statement, theorem: &Theorem, freedom: &Freedom) -> String {
    let notation = Notation::new(statement.ring());
    let mut text = String::new();
    let (values, net) = match theorem.claim() {
        Claim::Exact(ExactNet { values, net, .. }) => (values, Some(net)),
        Claim::Solution(Solution { values }) => (values, None),
        _ => return text,
    };
    if !values.is_empty() {
        let _ = writeln!(text, "The unknowns");
        let width = statement.unknowns().iter().map(String::len).max().unwrap_or(0);
        for (name, value) in statement.unknowns().iter().zip(values) {
            let _ = writeln!(text, "   {name:<width$} = {}", notation.polynomial(value));
        }
        text.push('\n');
        text += &choice(statement, &notation, values, freedom);
    }
    let Some(net) = net else { return text };
    let _ = writeln!(text, "The control net, premultiplied (X, Y, Z, W) = (wx, wy, wz, w)");
    let cells = net
        .iter()
        .map(|row| row.iter().map(|point| point.each_ref().map(|entry| notation.polynomial(entry))));
    let cells: Vec<Vec<[String; 4]>> = cells.map(Iterator::collect).collect();
    let widths: [usize; 4] = std::array::from_fn(|k| {
        let entries = cells.iter().flatten().map(|point| point[k].chars().count());
        entries.max().unwrap_or(0).max(COORDINATES[k].len())
    });
    let header: Vec<String> =
        COORDINATES.iter().zip(widths).map(|(name, width)| format!("{name:>width$}")).collect();
    let _ = writeln!(text, "    i  j   {}", header.join("   "));
    for (i, row) in cells.iter().enumerate() {
        for (j, point) in row.iter().enumerate() {
            let padded: Vec<String> =
                point.iter().zip(widths).map(|(entry, width)| format!("{entry:>width$}")).collect();
            let _ = writeln!(text, "   {i:>2} {j:>2}   {}", padded.join("   "));
        }
    }
    text.push('\n');
    text
}

/// What was free, and which values were chosen.
fn choice(statement: &Statement, notation: &Notation, values: &[Polynomial], freedom: &Freedom) -> String {
    let named = |k: &usize| {
        Some(format!("{} = {}", statement.unknowns().get(*k)?, notation.polynomial(values.get(*k)?)))
    };
    let mut text = String::new();
    if !freedom.chosen.is_empty() {
        let chosen: Vec<String> = freedom.chosen.iter().filter_map(|(k, _)| named(k)).collect();
        let verb = if chosen.len() == 1 { "was" } else { "were" };
        let of_many = if freedom.infinite { "One of infinitely many over the complex numbers: " } else { "" };
        let _ =
            writeln!(text, "{}", wrapped_at(&format!("{of_many}{} {verb} chosen.", chosen.join(", ")), 0));
    }
    let equation = match statement.subject() {
        Subject::Patch(_) => "coefficient",
        Subject::System(_) => "equation",
    };
    for name in freedom.indifferent.iter().filter_map(|&k| statement.unknowns().get(k)) {
        let _ = writeln!(text, "{name} occurs in no {equation}: with any value of it the equations hold.");
    }
    if !text.is_empty() {
        text.push('\n');
    }
    text
}
