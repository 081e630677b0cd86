//! Values of unknowns, tolerances, intervals and points on the command line.

use crate::commands::{self, Failure, ValuesError};
use crate::exact::Polynomial;
use crate::statement::Statement;

/// The decimal places that the checker's limits allow within reason.
const PLACES: u32 = 100;

/// The value of each unknown, from `NAME=VALUE`, in the statement's order.
pub(in crate::cli) fn values(statement: &Statement, set: &[String]) -> Result<Vec<Polynomial>, Failure> {
    let pairs = set.iter().map(|text| {
        let expected = || Failure::new(format!("--set {text}: expected NAME=VALUE, as in w=0.5"));
        text.split_once('=').ok_or_else(expected)
    });
    let pairs: Vec<(&str, &str)> = pairs.collect::<Result<_, _>>()?;
    commands::values(statement, &pairs).map_err(|error| match error {
        ValuesError::Wrong { .. } => Failure::new(format!("--set {error}")),
        ValuesError::Missing(_) => Failure::new(format!("{error}: give it with --set NAME=VALUE")),
    })
}

/// A tolerance as decimal places: 1e-12 is 12.
pub(in crate::cli) fn tolerance(text: &str) -> Result<u32, String> {
    let size: f64 = text.parse().map_err(|_| "expected a number such as 1e-12".to_owned())?;
    let digits = text.split(['e', 'E']).next().unwrap_or_default();
    if size == 0.0 && digits.contains(|c: char| ('1'..='9').contains(&c)) {
        return Err(format!("the checker's limits allow 1e-{PLACES} and more"));
    }
    if !(size > 0.0 && size < 1.0) {
        return Err("expected a number between 0 and 1, such as 1e-12".to_owned());
    }
    // 1e-12 is a little more or less than 10⁻¹² in binary.
    let places = (-size.log10() - 1e-9).ceil() as u32;
    match places {
        1..=PLACES => Ok(places),
        0 => Ok(1),
        _ => Err(format!("the checker's limits allow 1e-{PLACES} and more")),
    }
}

/// An interval of two printed decimals, `0.9,1.1`, as they are printed; with a true minus, and in brackets, too.
pub(in crate::cli) fn interval(text: &str) -> Result<[String; 2], String> {
    let expected = || "expected two decimals, LOW,HIGH, as in 0.99,1.01".to_owned();
    let text = text.trim().replace('−', "-");
    let inside = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
    let text = inside.unwrap_or(&text);
    let (low, high) = text.split_once(',').ok_or_else(expected)?;
    let is_decimal = |text: &str| {
        let digits = text.strip_prefix('-').unwrap_or(text);
        let (whole, decimals) = digits.split_once('.').unwrap_or((digits, "0"));
        let all = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
        all(whole) && all(decimals) && text.len() <= 200
    };
    let pair = [low.trim(), high.trim()];
    if pair.iter().all(|text| is_decimal(text)) { Ok(pair.map(str::to_owned)) } else { Err(expected()) }
}

/// A point (u, v) of the square, `0.5,0.5`.
pub(in crate::cli) fn point(text: &str) -> Result<(f64, f64), String> {
    let expected = || "expected a point U,V of the unit square, as in 0.5,0.5".to_owned();
    let (u, v) = text.split_once(',').ok_or_else(expected)?;
    let read = |text: &str| text.trim().parse::<f64>().ok().filter(|x| (0.0..=1.0).contains(x));
    read(u).zip(read(v)).ok_or_else(expected)
}
