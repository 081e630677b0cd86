//! Elements of K as people write them in a statement: `-sqrt(3)/3`, `1 - 2*sqrt(2)/3`.

use super::field::FieldElement;
use super::integer::Integer;

/// An expression of the statement language for this element.
pub fn spell(value: &FieldElement) -> String {
    let mut text = String::new();
    for (subset, numerator) in value.numerators().iter().enumerate().filter(|(_, n)| !n.is_zero()) {
        text.push_str(match (text.is_empty(), numerator.is_negative()) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        });
        let divisor = numerator.gcd(value.denominator());
        let (above, below) =
            (numerator.abs().exact_quotient(&divisor), value.denominator().exact_quotient(&divisor));
        let root = format!("sqrt({})", value.field().under_root(subset));
        text.push_str(&match (subset, above == Integer::one()) {
            (0, _) => above.to_string(),
            (_, true) => root,
            (_, false) => format!("{above}*{root}"),
        });
        if !below.is_one() {
            text.push_str(&format!("/{below}"));
        }
    }
    if text.is_empty() { "0".into() } else { text }
}
