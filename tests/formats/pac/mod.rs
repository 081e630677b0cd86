//! A strict reader of the three files of the practical algebraic calculus, and what a replay of them comes to.

use std::collections::{BTreeMap, BTreeSet};

use num_bigint::BigInt;
use num_traits::Zero;

/// Power product, as sorted names with exponents, to coefficient.
pub(crate) type Sum = BTreeMap<Vec<(String, u32)>, BigInt>;

#[derive(Debug, PartialEq)]
pub(crate) enum Verdict {
    Checked,
    NotInferred,
    /// The number of the first rule that does not come to what it says.
    Refused(usize),
}

pub(crate) fn parse(text: &str) -> Sum {
    let mut sum = Sum::new();
    let spaced = text.replace('-', " -").replace('+', " +");
    for term in spaced.split_whitespace().filter(|_| text != "0") {
        let (sign, product) = match term.strip_prefix('-') {
            Some(rest) => (-1, rest),
            None => (1, term.strip_prefix('+').unwrap_or(term)),
        };
        let (mut coefficient, mut powers) = (BigInt::from(sign), BTreeMap::<String, u32>::new());
        for (position, factor) in product.split('*').enumerate() {
            if factor.starts_with(|c: char| c.is_ascii_digit()) {
                assert_eq!(position, 0, "a number inside a term: {term}");
                coefficient *= factor.parse::<BigInt>().unwrap();
                continue;
            }
            let (name, exponent) = factor.split_once('^').unwrap_or((factor, "1"));
            assert!(name.len() >= 2 && name[1..].bytes().all(|b| b.is_ascii_digit()), "{term}");
            let exponent: u32 = exponent.parse().unwrap();
            assert!((1..=9).contains(&exponent), "pacheck cannot read {term}");
            *powers.entry(name.to_owned()).or_default() += exponent;
        }
        *sum.entry(powers.into_iter().collect()).or_default() += coefficient;
    }
    sum.retain(|_, coefficient| !coefficient.is_zero());
    sum
}

fn add(a: &Sum, b: &Sum) -> Sum {
    let mut sum = a.clone();
    for (powers, coefficient) in b {
        *sum.entry(powers.clone()).or_default() += coefficient;
    }
    sum.retain(|_, coefficient| !coefficient.is_zero());
    sum
}

fn multiply(a: &Sum, b: &Sum) -> Sum {
    let mut product = Sum::new();
    for (p, x) in a {
        for (q, y) in b {
            let mut powers: BTreeMap<String, u32> = p.iter().cloned().collect();
            for (name, exponent) in q {
                *powers.entry(name.clone()).or_default() += exponent;
            }
            *product.entry(powers.into_iter().collect()).or_default() += x * y;
        }
    }
    product.retain(|_, coefficient| !coefficient.is_zero());
    product
}

/// Replays the three files; whatever is not of their form is a panic, whatever is false a verdict.
pub(crate) fn replay(files: &[(&str, String); 3]) -> Verdict {
    let [(_, axioms), (_, proof), (_, target)] = files;
    let mut lines: BTreeMap<usize, Sum> = BTreeMap::new();
    for line in axioms.lines() {
        let (number, polynomial) = line.strip_suffix(';').unwrap().split_once(' ').unwrap();
        assert!(lines.insert(number.parse().unwrap(), parse(polynomial)).is_none(), "{line}");
    }
    let name = |c: char| !c.is_ascii_alphanumeric();
    let known: BTreeSet<&str> = axioms.split(name).filter(|word| word.parse::<BigInt>().is_err()).collect();
    let target = parse(target.trim_end().strip_suffix(';').unwrap());
    assert!(
        target.keys().all(Vec::is_empty) && target.len() == 1,
        "the target is a number and not 0: {target:?}"
    );
    let mut inferred = false;
    for line in proof.lines() {
        let words: Vec<&str> = line.strip_suffix(';').unwrap().splitn(3, ' ').collect();
        let [number, operation, rest] = words[..] else { panic!("{line}") };
        let [first, second, stated] = rest.split(", ").collect::<Vec<_>>()[..] else { panic!("{line}") };
        let number: usize = number.parse().unwrap();
        let first = &lines[&first.parse().unwrap()];
        let result = match operation {
            "*" => {
                let factor = parse(second);
                let mut names = factor.keys().flatten().map(|(name, _)| name.as_str());
                assert!(names.all(|name| known.contains(name)), "pacheck knows no such variable: {line}");
                multiply(first, &factor)
            }
            "+" => add(first, &lines[&second.parse().unwrap()]),
            _ => panic!("{line}"),
        };
        if result != parse(stated) {
            return Verdict::Refused(number);
        }
        inferred |= result == target;
        assert!(lines.insert(number, result).is_none(), "{line}");
    }
    if inferred { Verdict::Checked } else { Verdict::NotInferred }
}
