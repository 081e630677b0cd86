//! Words that several sentences share: formulas as people write them, the surface, what is assumed.

use crate::exact::{Polynomial, Ring};
use crate::statement::{Patch, Statement};

/// A polynomial as people write it, `8/3·√3·w²·z − 4/3`: the canonical spelling in other characters. Nothing reads it.
pub fn written(ring: &Ring, polynomial: &Polynomial) -> String {
    mathematics(&ring.spell(polynomial))
}

/// A number or polynomial in its canonical spelling, in the characters of mathematics.
pub(in crate::claims) fn mathematics(spelling: &str) -> String {
    let mut text = String::with_capacity(spelling.len());
    // Between `^` and the end of an exponent; between `sqrt(` and its bracket, which holds digits only.
    let (mut raised, mut under_root) = (false, false);
    for c in spelling.replace("sqrt(", "√").chars() {
        raised &= c.is_ascii_digit();
        match c {
            '^' => raised = true,
            '√' => {
                under_root = true;
                text.push(c);
            }
            ')' if under_root => under_root = false,
            '-' => text.push('−'),
            '*' => text.push('·'),
            digit if raised => text.push(superscript(digit)),
            other => text.push(other),
        }
    }
    text
}

fn superscript(digit: char) -> char {
    "0123456789"
        .chars()
        .zip("⁰¹²³⁴⁵⁶⁷⁸⁹".chars())
        .find(|(plain, _)| *plain == digit)
        .map_or(digit, |(_, up)| up)
}

/// A natural number as an exponent; nothing for 1.
pub(in crate::claims) fn exponent(number: u32) -> String {
    if number == 1 { String::new() } else { number.to_string().chars().map(superscript).collect() }
}

/// `the unit sphere X² + Y² + Z² − W² = 0` or `the surface … = 0`.
pub(in crate::claims) fn surface(statement: &Statement, patch: &Patch) -> String {
    let kind = if patch.is_on_unit_sphere() { "unit sphere" } else { "surface" };
    format!("the {kind} {} = 0", written(&statement.coordinate_ring(), &patch.surface))
}

/// `d ≠ 0, p − 1 ≠ 0`: what the statement assumes of its unknowns; `None` where that is nothing.
pub(in crate::claims) fn assumptions(statement: &Statement) -> Option<String> {
    // Of constants there is nothing to assume: the reader has refused 0.
    let ring = statement.ring();
    let assumed = statement.nonzero().iter().filter(|polynomial| !polynomial.is_constant());
    let written: Vec<String> =
        assumed.map(|polynomial| format!("{} ≠ 0", written(&ring, polynomial))).collect();
    if written.is_empty() { None } else { Some(written.join(", ")) }
}

/// `As it stands`, `At the stated values`.
pub(in crate::claims) fn at_values(statement: &Statement) -> &'static str {
    if statement.unknowns().is_empty() { "As it stands" } else { "At the stated values" }
}

/// ` with d ≠ 0`, or nothing.
pub(in crate::claims) fn with_assumptions(statement: &Statement) -> String {
    assumptions(statement).map_or_else(String::new, |assumed| format!(" with {assumed}"))
}

/// `, where d ≠ 0,`, or nothing.
pub(in crate::claims) fn where_assumptions(statement: &Statement) -> String {
    assumptions(statement).map_or_else(String::new, |assumed| format!(", where {assumed},"))
}
