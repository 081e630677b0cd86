//! Nets in JSON: `{"title", "convention", "basis" or "radicands", "net"}`.
//!
//! What this program writes with `--format json` has title, radicands and surface in its `statement`.
//! A number is a string with an expression, an integer, or, where there is a `basis` such as `["1", "sqrt2"]`, the list
//! of its rational coordinates. The convention is the first word of `convention`.

use serde_json::Value;

use super::NetError;
use super::{Convention, PrintedNet};
use crate::exact::{Polynomial, Radicands, Work, limits};
use crate::formats::listing::{Expression, Scope};
use crate::statement::Statement;

/// Reads a net.
///
/// # Errors
/// [`NetError::Net`] with the place in the document and what was expected.
pub fn from_json(text: &str) -> Result<PrintedNet, NetError> {
    let document: Value =
        serde_json::from_str(text).map_err(|error| wrong("the file", &error.to_string()))?;
    // Of an answer without a net of its own the statement has it.
    if document.get("net").is_none() && document["statement"].get("net").is_some() {
        let text = super::statement_from_json(text)?;
        let statement =
            Statement::read(&text).map_err(|error| wrong("statement", &error.fault.to_string()))?;
        return PrintedNet::from_statement(&statement, Convention::Homogeneous);
    }
    let said = |key: &str| document.get(key).unwrap_or(&document["statement"][key]);
    let convention = document["convention"].as_str().unwrap_or_default();
    let word = convention.split(|c: char| !c.is_ascii_alphabetic()).next().unwrap_or_default();
    let convention = Convention::read(word).ok_or_else(|| {
        wrong("convention", "expected \"cartesian\" or \"homogeneous\" (premultiplied), as its first word")
    })?;
    let basis = match &document["basis"] {
        Value::Null => Vec::new(),
        Value::Array(names) => names
            .iter()
            .map(|name| {
                name.as_str().and_then(root_of).ok_or_else(|| wrong("basis", "expected \"1\", \"sqrt2\", …"))
            })
            .collect::<Result<Vec<u32>, _>>()?,
        _ => return Err(wrong("basis", "expected a list")),
    };
    let radicands = match said("radicands") {
        Value::Array(list) => list
            .iter()
            .map(|d| {
                d.as_u64()
                    .and_then(|d| u32::try_from(d).ok())
                    .ok_or_else(|| wrong("radicands", "expected primes"))
            })
            .collect::<Result<_, _>>()?,
        _ => prime_factors(&basis),
    };
    let field = Radicands::new(radicands).map_err(|error| wrong("radicands", &error.to_string()))?;
    let rows = document["net"].as_array().ok_or_else(|| wrong("net", "expected a list of rows"))?;
    let mut points = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        let row = row.as_array().ok_or_else(|| wrong(&format!("net[{i}]"), "expected a list of points"))?;
        let mut read = Vec::new();
        for (j, point) in row.iter().enumerate() {
            let place = format!("net[{i}][{j}]");
            let numbers = point.as_array().filter(|numbers| numbers.len() == 4);
            let numbers = numbers.ok_or_else(|| wrong(&place, "expected four numbers"))?;
            let mut entries: [Polynomial; 4] = Default::default();
            for (k, number) in numbers.iter().enumerate() {
                entries[k] =
                    entry(number, &basis, &field).map_err(|why| wrong(&format!("{place}[{k}]"), &why))?;
            }
            read.push(entries);
        }
        points.push(read);
    }
    check_shape(&points).map_err(|why| wrong("net", &why))?;
    let surface = match said("surface") {
        Value::Null => None,
        Value::String(surface) => Some(surface.clone()),
        _ => return Err(wrong("surface", "expected a polynomial in X, Y, Z, W in quotes")),
    };
    let title = said("title").as_str().unwrap_or("A printed net").to_owned();
    Ok(PrintedNet { title, field, convention, surface, points })
}

pub(super) fn wrong(place: &str, why: &str) -> NetError {
    NetError::Net(format!("{place}: {why}"))
}

/// Refuses nets that are not rectangular, or too large to be a patch.
pub(super) fn check_shape(points: &[Vec<[Polynomial; 4]>]) -> Result<(), String> {
    let columns = points.first().map_or(0, Vec::len);
    let at_most = limits::BIDEGREE as usize + 1;
    if let Some(row) = points.iter().position(|row| row.len() != columns) {
        return Err(format!("row {row} has {} points, row 0 has {columns}", points[row].len()));
    }
    if points.len() < 2 || columns < 2 || points.len() > at_most || columns > at_most {
        return Err(format!(
            "{} × {columns} points, expected from 2 × 2 to {at_most} × {at_most}",
            points.len()
        ));
    }
    Ok(())
}

/// 1 for `1`, 6 for `sqrt6` or `sqrt(6)`.
fn root_of(name: &str) -> Option<u32> {
    match name.strip_prefix("sqrt") {
        None => name.parse().ok().filter(|&one: &u32| one == 1),
        Some(number) => number.trim_matches(['(', ')']).parse().ok().filter(|&n| n > 1),
    }
}

/// The primes that divide these numbers.
pub(super) fn prime_factors(numbers: &[u32]) -> Vec<u32> {
    let mut primes = Vec::new();
    for &number in numbers {
        let (mut rest, mut d) = (number, 2);
        while rest > 1 && d <= rest / d {
            if rest % d == 0 {
                primes.push(d);
                rest /= d;
            } else {
                d += 1;
            }
        }
        if rest > 1 {
            primes.push(rest);
        }
    }
    primes.sort_unstable();
    primes.dedup();
    primes
}

fn entry(number: &Value, basis: &[u32], field: &Radicands) -> Result<Polynomial, String> {
    match number {
        Value::String(text) => expression(text, field),
        Value::Number(value) if value.is_i64() => expression(&value.to_string(), field),
        // A float has been rounded by whoever wrote it, and again by whoever reads it.
        Value::Number(_) => Err("expected an exact number: put decimals into quotes".to_owned()),
        Value::Array(coordinates) if coordinates.len() == basis.len() && !basis.is_empty() => {
            let mut summands = Vec::new();
            for (coordinate, root) in coordinates.iter().zip(basis) {
                let rational = match coordinate {
                    Value::String(text) => text.clone(),
                    Value::Number(value) if value.is_i64() => value.to_string(),
                    _ => return Err("expected rational coordinates in quotes".to_owned()),
                };
                let rational = expression(&rational, field)?;
                let root = expression(&format!("sqrt({root})"), field)?;
                let product = rational.multiply(&root, field, &mut Work::full());
                summands.push(product.map_err(|limit| limit.to_string())?);
            }
            Polynomial::sum(&summands, field, &mut Work::full()).map_err(|limit| limit.to_string())
        }
        _ => Err("expected an expression in quotes, an integer, or one coordinate for each basis element"
            .to_owned()),
    }
}

fn expression(text: &str, field: &Radicands) -> Result<Polynomial, String> {
    let scope = Scope::of(field, &[]);
    let read = Expression::read(text, 0..text.len()).and_then(|e| e.value(text, &scope, &mut Work::full()));
    read.map_err(|error| error.fault.to_string())
}
