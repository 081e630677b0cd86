//! Polynomials as a geometer writes them: `(8√3/3)·w·z − 8·w − 4/3`.

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use crate::exact::{Monomial, Polynomial, Radicands, Ring};

/// Writes polynomials with the names of a ring.
#[derive(Debug, Clone)]
pub struct Notation {
    ring: Ring,
}

/// The coefficients in front of one power product: (number under the root, rational), not empty.
pub(super) type Coefficient = Vec<(BigInt, BigRational)>;

impl Notation {
    /// The notation of a ring.
    pub fn new(ring: Ring) -> Self {
        Notation { ring }
    }

    /// The polynomial, terms of one power product collected.
    pub fn polynomial(&self, polynomial: &Polynomial) -> String {
        let collected = collected(&self.ring.field, polynomial);
        let mut text = String::new();
        for (powers, coefficient) in &collected {
            // A sum in front of a power product goes into brackets, its sign with it.
            let negative = coefficient.len() == 1 && coefficient[0].1.is_negative();
            text.push_str(match (text.is_empty(), negative) {
                (true, false) => "",
                (true, true) => "−",
                (false, false) => " + ",
                (false, true) => " − ",
            });
            text.push_str(&self.term(powers, coefficient, collected.len() == 1));
        }
        if text.is_empty() { "0".into() } else { text }
    }

    fn term(&self, powers: &Monomial, coefficient: &[(BigInt, BigRational)], alone: bool) -> String {
        let names = powers.powers().iter().map(|&(variable, exponent)| {
            format!("{}{}", self.ring.variables[usize::from(variable)], superscript(exponent))
        });
        let powers = names.collect::<Vec<_>>().join("·");
        match coefficient {
            [(root, value)] => {
                let number = monomial_number(root, &value.abs());
                match (powers.is_empty(), number.as_str()) {
                    (true, _) => number,
                    (false, "1") => powers,
                    (false, _) if number.contains('/') => format!("({number})·{powers}"),
                    (false, _) => format!("{number}·{powers}"),
                }
            }
            sum if powers.is_empty() && alone => sum_of_roots(sum),
            sum if powers.is_empty() => format!("({})", sum_of_roots(sum)),
            sum => format!("({})·{powers}", sum_of_roots(sum)),
        }
    }

    /// Like [`Notation::polynomial`], with brackets around a sum, to stand as a factor.
    pub fn factor(&self, polynomial: &Polynomial) -> String {
        let text = self.polynomial(polynomial);
        if text.contains(' ') || text.contains('/') && !text.starts_with('(') {
            format!("({text})")
        } else {
            text
        }
    }

    /// The polynomial if it is short, otherwise its first terms and how many there are.
    pub fn shortened(&self, polynomial: &Polynomial, characters: usize) -> String {
        shorten(self.polynomial(polynomial), characters)
    }
}

/// The terms of a polynomial by power product, in the order of spelling.
pub(super) fn collected(field: &Radicands, polynomial: &Polynomial) -> BTreeMap<Monomial, Coefficient> {
    let mut collected: BTreeMap<Monomial, Coefficient> = BTreeMap::new();
    for (monomial, value) in polynomial.terms() {
        let powers = Monomial::new(0, monomial.powers().to_vec()).and_then(Result::ok);
        let root = field.under_root(monomial.mask()).cloned().unwrap_or_else(BigInt::one);
        collected.entry(powers.unwrap_or_else(Monomial::one)).or_default().push((root, value.clone()));
    }
    collected
}

/// Cuts a long formula between two of its terms, never inside a number or a bracket.
pub(super) fn shorten(text: String, characters: usize) -> String {
    if text.chars().count() <= characters {
        return text;
    }
    let (mut depth, mut terms, mut cut) = (0i32, 1, 0);
    for (count, (at, c)) in text.char_indices().enumerate() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            ' ' if depth == 0 && (text[at..].starts_with(" + ") || text[at..].starts_with(" − ")) => {
                terms += 1;
                cut = if count <= characters { at } else { cut };
            }
            _ => {}
        }
    }
    match cut {
        0 => format!("[{} characters, {terms} terms]", text.chars().count()),
        _ => format!("{} + … [{terms} terms in all]", &text[..cut]),
    }
}

fn sum_of_roots(sum: &[(BigInt, BigRational)]) -> String {
    let mut text = String::new();
    for (root, value) in sum {
        text.push_str(match (text.is_empty(), value.is_negative()) {
            (true, false) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (false, true) => " − ",
        });
        text.push_str(&monomial_number(root, &value.abs()));
    }
    text
}

/// value·√root for a positive value: `8√3/3`.
fn monomial_number(root: &BigInt, value: &BigRational) -> String {
    let numerator = match (root.is_one(), value.numer().is_one()) {
        (true, _) => value.numer().to_string(),
        (false, true) => format!("√{root}"),
        (false, false) => format!("{}√{root}", value.numer()),
    };
    if value.denom().is_one() { numerator } else { format!("{numerator}/{}", value.denom()) }
}

/// `²`, `¹⁰`; nothing for 1.
pub(super) fn superscript(exponent: u32) -> String {
    if exponent == 1 {
        return String::new();
    }
    let digit = |c: char| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(c as usize - '0' as usize).unwrap_or(c);
    exponent.to_string().chars().map(digit).collect()
}
