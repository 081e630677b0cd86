//! Polynomials and labels in LaTeX.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use crate::exact::{Polynomial, Ring};
use crate::report::mathematics::{Notation, collected};

/// Power products on one line of a display.
const TERMS: usize = 4;

/// In brackets if it is a sum.
pub(super) fn factor(ring: &Ring, polynomial: &Polynomial) -> String {
    match polynomial.term_count() > 1 {
        true => format!("\\left({}\\right)", formula(ring, polynomial)),
        false => formula(ring, polynomial),
    }
}

/// The first terms, where what is printed of them at a terminal is longer than so many characters.
pub(super) fn shortened(ring: &Ring, polynomial: &Polynomial, characters: usize) -> String {
    let terms = terms(ring, polynomial);
    let long = Notation::new(ring.clone()).polynomial(polynomial).chars().count() > characters;
    if long && terms.len() > TERMS {
        let (shown, all) = (terms[..TERMS].concat(), terms.len());
        return format!("{shown} + \\ldots\\ \\text{{[{all} terms in all]}}");
    }
    terms.concat()
}

/// A formula, broken into lines after some power products.
pub(super) fn display(ring: &Ring, polynomial: &Polynomial) -> String {
    let terms = terms(ring, polynomial);
    let lines: Vec<String> = terms.chunks(TERMS).map(<[String]>::concat).collect();
    lines.join(" \\\\\n&\\quad ")
}

/// A formula on one line.
pub fn formula(ring: &Ring, polynomial: &Polynomial) -> String {
    terms(ring, polynomial).concat()
}

/// The terms by power product, each with its sign.
fn terms(ring: &Ring, polynomial: &Polynomial) -> Vec<String> {
    let collected = collected(&ring.field, polynomial);
    let mut terms: Vec<String> = Vec::new();
    for (powers, coefficient) in &collected {
        let names: Vec<String> = powers
            .powers()
            .iter()
            .map(|&(variable, exponent)| {
                let name = symbol(&ring.variables[usize::from(variable)]);
                if exponent == 1 { name } else { format!("{name}^{{{exponent}}}") }
            })
            .collect();
        let powers = names.join(" ");
        let first = terms.is_empty();
        terms.push(match coefficient.as_slice() {
            [(root, value)] => {
                let number = number(root, &value.abs());
                let number = if number == "1" && !powers.is_empty() { String::new() } else { number };
                format!("{}{}", sign(first, value.is_negative()), joined(&number, &powers))
            }
            sum => {
                let mut inside = String::new();
                for (root, value) in sum {
                    inside += sign(inside.is_empty(), value.is_negative());
                    inside += &number(root, &value.abs());
                }
                let alone = powers.is_empty() && collected.len() == 1;
                let bracketed = if alone { inside } else { format!("\\left({inside}\\right)") };
                format!("{}{}", sign(first, false), joined(&bracketed, &powers))
            }
        });
    }
    if terms.is_empty() { vec!["0".to_owned()] } else { terms }
}

fn sign(first: bool, negative: bool) -> &'static str {
    match (first, negative) {
        (true, false) => "",
        (true, true) => "-",
        (false, false) => " + ",
        (false, true) => " - ",
    }
}

fn joined(number: &str, powers: &str) -> String {
    let space = if number.is_empty() || powers.is_empty() { "" } else { " " };
    format!("{number}{space}{powers}")
}

/// value·√root for a positive value.
fn number(root: &BigInt, value: &BigRational) -> String {
    let rational = match value.denom().is_one() {
        true => value.numer().to_string(),
        false => format!("\\frac{{{}}}{{{}}}", value.numer(), value.denom()),
    };
    match (root.is_one(), value.is_one()) {
        (true, _) => rational,
        (false, true) => format!("\\sqrt{{{root}}}"),
        (false, false) => format!("{rational}\\sqrt{{{root}}}"),
    }
}

/// The name of an unknown: `w11` is w with the subscript 11.
fn symbol(name: &str) -> String {
    let mut characters = name.chars();
    let letter = characters.next().unwrap_or('x');
    let rest = characters.as_str();
    match rest {
        "" => letter.to_string(),
        _ if rest.chars().all(|c| c.is_ascii_digit()) => format!("{letter}_{{{rest}}}"),
        _ => format!("\\mathrm{{{}}}", name.replace('_', "\\_")),
    }
}

/// The label of a coefficient: `a14`, `a1,4`, `c[1,4]`.
pub(super) fn label(name: &str) -> String {
    let name = name.replace(['[', ']'], "");
    let letters = name.find(|c: char| c.is_ascii_digit()).unwrap_or(name.len());
    let (letters, indices) = name.split_at(letters);
    let base = if letters.len() == 1 { letters.to_owned() } else { format!("\\mathrm{{{letters}}}") };
    if indices.is_empty() { base } else { format!("{base}_{{{indices}}}") }
}

#[cfg(test)]
mod tests {
    use super::{label, symbol};

    #[test]
    fn names_keep_their_subscripts() {
        assert_eq!(symbol("w11"), "w_{11}");
        assert_eq!(symbol("w_1"), "\\mathrm{w\\_1}");
        assert_eq!(symbol("z"), "z");
    }

    #[test]
    fn labels_keep_their_indices() {
        assert_eq!(label("a14"), "a_{14}");
        assert_eq!(label("c[1,4]"), "c_{1,4}");
        assert_eq!(label("nonzero[1]"), "\\mathrm{nonzero}_{1}");
    }
}
