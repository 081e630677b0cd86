//! Polynomials in Coq: as people read them, and as the data that the replay computes with.
//!
//! `spelled` in terms.v turns the data into what is read, symbol for symbol: Coq holds one against the other by mere conversion. So the two
//! functions here must agree with it; where they do not, the file does not compile.

use itertools::Itertools;
use num_bigint::BigInt;
use num_traits::{One, Signed};

use crate::exact::{Monomial, Polynomial, Radicands};

/// `8 * sqrt 3 / 3 * w * z - 4 / 3`, a real number.
pub(super) fn expression(polynomial: &Polynomial, field: &Radicands, names: &[String]) -> String {
    let mut text = String::new();
    for (monomial, value) in polynomial.terms() {
        let size = size(monomial, &value.abs(), field, names);
        match (text.is_empty(), value.is_negative()) {
            (true, false) => text = size,
            (true, true) if size.bytes().all(|c| c.is_ascii_digit()) => text = format!("-{size}"),
            (true, true) => text = format!("-({size})"),
            (false, false) => text.push_str(&format!(" + {size}")),
            (false, true) => text.push_str(&format!(" - {size}")),
        }
    }
    if text.is_empty() { "0".into() } else { text }
}

fn size(
    monomial: &Monomial,
    value: &num_rational::BigRational,
    field: &Radicands,
    names: &[String],
) -> String {
    let root = (monomial.mask() != 0).then(|| format!("sqrt {}", field.under_root(monomial.mask())));
    let above: Vec<String> =
        (!value.numer().is_one()).then(|| value.numer().to_string()).into_iter().chain(root).collect();
    let number = match (above.is_empty(), value.denom().is_one()) {
        (true, true) => None,
        (false, true) => Some(above.join(" * ")),
        (true, false) => Some(format!("1 / {}", value.denom())),
        (false, false) => Some(format!("{} / {}", above.join(" * "), value.denom())),
    };
    let power = |&(variable, exponent): &(u16, u32)| match exponent {
        1 => names[usize::from(variable)].clone(),
        _ => format!("{} ^ {exponent}", names[usize::from(variable)]),
    };
    let factors: Vec<String> = number.into_iter().chain(monomial.powers().iter().map(power)).collect();
    if factors.is_empty() { "1".into() } else { factors.join(" * ") }
}

/// The expression as an argument of a function.
pub(super) fn argument(polynomial: &Polynomial, field: &Radicands, names: &[String]) -> String {
    let text = expression(polynomial, field, names);
    if text.contains([' ', '-']) { format!("({text})") } else { text }
}

/// `[Term 8 3 [false; true] [(0, 1); (1, 1)]; Term (-4) 3 [] []]`, a list of terms.
pub(super) fn terms(polynomial: &Polynomial) -> String {
    let term = |(monomial, value): (&Monomial, &num_rational::BigRational)| {
        let roots =
            (0..8 - monomial.mask().leading_zeros()).map(|bit| (monomial.mask() >> bit & 1 == 1).to_string());
        let powers = monomial.powers().iter().map(|(variable, exponent)| format!("({variable}, {exponent})"));
        format!(
            "Term {} {} [{}] [{}]",
            integer(value.numer()),
            integer(value.denom()),
            roots.collect::<Vec<_>>().join("; "),
            powers.collect::<Vec<_>>().join("; ")
        )
    };
    list(polynomial.terms().map(term))
}

/// An integer as an argument; a long one in groups of digits, which Coq reads ten times faster.
pub(super) fn integer(value: &BigInt) -> String {
    const GROUP: usize = 18;
    let digits = value.magnitude().to_string();
    let size = if digits.len() <= 2 * GROUP {
        digits
    } else {
        let (first, rest) = digits.split_at(digits.len() % GROUP);
        let rest = rest.as_bytes().chunks(GROUP).map(|group| String::from_utf8_lossy(group).into_owned());
        let groups = [first.to_owned()].into_iter().chain(rest).filter(|group| !group.is_empty());
        format!("Replay.long {}%Z", list(groups))
    };
    match (value.is_negative(), size.contains(' ')) {
        (true, true) => format!("(- {size})"),
        (true, false) => format!("(-{size})"),
        (false, true) => format!("({size})"),
        (false, false) => size,
    }
}

/// `[a; b; c]`.
pub(super) fn list(items: impl IntoIterator<Item = String>) -> String {
    format!("[{}]", items.into_iter().join("; "))
}

/// A list with one item on a line.
pub(super) fn lines(items: impl IntoIterator<Item = String>) -> String {
    format!("[{}]", items.into_iter().join(";\n   "))
}

/// A list of lists, an item on a line.
pub(super) fn rows(rows: impl IntoIterator<Item = Vec<String>>) -> String {
    lines(rows.into_iter().map(|row| format!("[{}]", row.join(";\n    "))))
}
