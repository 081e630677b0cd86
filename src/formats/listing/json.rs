//! What `prove-cap expand --format json` writes, as a listing: coefficients by name, with the statement they belong to.

use std::ops::Range;

use serde::Deserialize;
use serde_json::value::RawValue;

use super::error::{ListingFault, Located};
use super::plain;
use super::table::file_fault;
use super::{Formula, Listing, ListingError, Symbol, grammar};
use crate::bezier::Basis;

#[derive(Deserialize)]
struct Document<'a> {
    #[serde(borrow)]
    statement: Subject<'a>,
    basis: Option<String>,
    #[serde(borrow)]
    coefficients: Option<Vec<Entry<'a>>>,
}

#[derive(Deserialize)]
struct Subject<'a> {
    title: String,
    #[serde(borrow)]
    polynomials: Option<Vec<&'a RawValue>>,
}

#[derive(Deserialize)]
struct Entry<'a> {
    #[serde(borrow)]
    name: &'a RawValue,
    #[serde(borrow)]
    value: &'a RawValue,
}

/// Whether a JSON document lists coefficients: of a net it does not.
pub fn is_expansion(text: &str) -> bool {
    let document: Option<serde_json::Value> = serde_json::from_str(text).ok();
    document.is_some_and(|document| document.get("coefficients").is_some() && document.get("basis").is_some())
}

impl Listing {
    /// Reads an expansion; places are those in the document.
    ///
    /// # Errors
    /// [`ListingError`] with the place.
    pub fn from_json(text: &str) -> Result<Self, ListingError> {
        read(text).map_err(|located| ListingError::at(text, located))
    }
}

fn read(text: &str) -> Result<Listing, Located> {
    let document: Document<'_> = serde_json::from_str(text).map_err(|error| {
        let line =
            text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum::<usize>();
        let at = (line + error.column()).min(text.len());
        file_fault(format!("not an expansion in JSON: {error}"), at..at)
    })?;
    let basis = match document.basis.as_deref() {
        None | Some("bernstein") => Basis::Bernstein,
        Some("monomial") => Basis::Monomial,
        Some(_) => {
            return Err(file_fault("`basis`: expected \"bernstein\" or \"monomial\"".into(), 0..0));
        }
    };
    let mut formulas = Vec::new();
    for entry in document.coefficients.iter().flatten() {
        let label = contents(text, entry.name)?;
        formulas.push(formula(text, Symbol::new(&text[label.clone()]), label, entry.value)?);
    }
    if document.coefficients.is_none() {
        for (number, value) in (1..).zip(document.statement.polynomials.iter().flatten()) {
            let label = contents(text, value)?;
            formulas.push(formula(text, Symbol::new(&format!("f[{number}]")), label, value)?);
        }
    }
    Ok(Listing {
        title: document.statement.title,
        source: String::new(),
        text: text.to_owned(),
        statement: None,
        basis,
        formulas,
        names: Vec::new(),
        labels: Vec::new(),
        claims: Vec::new(),
    })
}

fn formula(text: &str, label: Symbol, place: Range<usize>, value: &RawValue) -> Result<Formula, Located> {
    let tokens = plain::tokens(text, contents(text, value)?)?;
    Ok(Formula { labels: vec![(label, place)], expression: grammar::expression(text, &tokens)? })
}

/// Where the contents of a string stand in the document that it was borrowed from.
fn contents(text: &str, value: &RawValue) -> Result<Range<usize>, Located> {
    let spelled = value.get();
    let start = spelled.as_ptr() as usize - text.as_ptr() as usize;
    let whole = start..start + spelled.len();
    match spelled.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')) {
        Some(inside) if !inside.is_empty() && !inside.contains('\\') => Ok(start + 1..whole.end - 1),
        _ => {
            let expected = "a formula in quotes, without escapes";
            Err((ListingFault::Expected { expected, found: super::error::shown(spelled) }, whole))
        }
    }
}
