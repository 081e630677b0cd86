//! A listing file: what was printed, where, and what it is held against.

use std::ops::Range;

use super::claim::{self, Claim};
use super::error::{ListingFault, Located};
use super::expression::{Expression, Formula};
use super::table::{Table, file_fault, naturals, parse, string};
use super::token::Symbol;
use super::{ListingError, Notation as Reader};
use crate::bezier::Basis;

const KEYS: [&str; 9] =
    ["title", "source", "statement", "notation", "basis", "formulas", "names", "labels", "claim"];

/// How formulas are spelled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Notation {
    /// LaTeX.
    Latex,
    /// Plain text.
    Plain,
}

/// What a name of a listing means.
#[derive(Debug, Clone)]
pub struct Meaning {
    /// The name.
    pub name: Symbol,
    /// An expression in the unknowns of the statement.
    pub expression: Expression,
    /// Where that is said.
    pub span: Range<usize>,
}

/// A printed listing.
#[derive(Debug, Clone)]
pub struct Listing {
    /// What the listing is from.
    pub title: String,
    /// Its number there ("Eq. 11"), or empty.
    pub source: String,
    /// The text that all places refer to.
    pub text: String,
    /// The statement it is to be held against: a built-in name or a file; none if the user says so elsewhere.
    pub statement: Option<String>,
    /// The basis of the coefficients, where labels do not tell.
    pub basis: Basis,
    /// What is printed.
    pub formulas: Vec<Formula>,
    /// What the listing's names mean.
    pub names: Vec<Meaning>,
    /// Labels with the indices of their coefficients.
    pub labels: Vec<(Symbol, Vec<u32>)>,
    /// Other claims of the same source.
    pub claims: Vec<Claim>,
}

impl Listing {
    /// A listing that is nothing but formulas.
    ///
    /// # Errors
    /// As [`Notation::read`].
    pub fn from_formulas(title: &str, text: &str, notation: Notation) -> Result<Self, ListingError> {
        Ok(Listing {
            title: title.to_owned(),
            source: String::new(),
            text: text.to_owned(),
            statement: None,
            basis: Basis::Monomial,
            formulas: notation.read_any(text).map_err(|located| ListingError::at(text, located))?,
            names: Vec::new(),
            labels: Vec::new(),
            claims: Vec::new(),
        })
    }

    /// Reads a listing file (TOML; the keys are described in `docs/listings.md`).
    ///
    /// # Errors
    /// [`ListingError`] with the place.
    pub fn from_toml(text: &str) -> Result<Self, ListingError> {
        parse(text, |table| Listing::read(text, table))
    }

    fn read(text: &str, table: Table<'_, '_>) -> Result<Self, Located> {
        table.check_keys(&KEYS)?;
        let title = string(table.required("title", "what the listing is from")?, "title")?.to_owned();
        let notation = match table.required("notation", "\"latex\" or \"plain\"")? {
            value if string(value, "notation")? == "latex" => Reader::Latex,
            value if string(value, "notation")? == "plain" => Reader::Plain,
            value => {
                return Err(file_fault("`notation`: expected \"latex\" or \"plain\"".into(), value.span()));
            }
        };
        let basis = match table.get("basis") {
            None => Basis::Monomial,
            Some(value) if string(value, "basis")? == "monomial" => Basis::Monomial,
            Some(value) if string(value, "basis")? == "bernstein" => Basis::Bernstein,
            Some(value) => {
                let message = "`basis`: expected \"monomial\" or \"bernstein\"".to_owned();
                return Err(file_fault(message, value.span()));
            }
        };
        // What makes claims need not list anything.
        let formulas = match (table.get("formulas"), table.get("claim")) {
            (None, Some(_)) => Vec::new(),
            _ => table.formulas(table.required("formulas", "the formulas between '''")?, notation)?,
        };
        let mut names = Vec::new();
        if let Some(entries) = table.table("names")? {
            for (key, value) in entries.entries() {
                let expression = entries.expression(value, key.get_ref())?;
                names.push(Meaning { name: Symbol::new(key.get_ref()), expression, span: value.span() });
            }
        }
        let mut labels = Vec::new();
        if let Some(entries) = table.table("labels")? {
            for (key, value) in entries.entries() {
                labels.push((Symbol::new(key.get_ref()), naturals(value, key.get_ref())?));
            }
        }
        let claims = table.tables("claim")?.into_iter().map(claim::read).collect::<Result<_, _>>()?;
        Ok(Listing {
            title,
            source: table.string("source")?.unwrap_or("").to_owned(),
            text: text.to_owned(),
            statement: table.string("statement")?.map(str::to_owned),
            basis,
            formulas,
            names,
            labels,
            claims,
        })
    }

    /// Adds the meaning of a name: `w_{11}=w`.
    ///
    /// # Errors
    /// Where that is not one name and one expression.
    pub fn map_name(&mut self, mapping: &str) -> Result<(), ListingError> {
        let wrong = |fault: ListingFault| ListingError::at(mapping, (fault, 0..mapping.len()));
        let formulas = Reader::Plain.read(mapping)?;
        match <[Formula; 1]>::try_from(formulas) {
            Ok([formula]) if formula.labels.len() == 1 => {
                let name = formula.labels[0].0.clone();
                self.names.push(Meaning { name, expression: formula.expression, span: 0..0 });
                Ok(())
            }
            _ => {
                let expected = "NAME=EXPRESSION, as in w_{11}=w";
                Err(wrong(ListingFault::Expected { expected, found: format!("`{mapping}`") }))
            }
        }
    }

    /// Adds the indices of a label: `a_{14}=4,2`.
    ///
    /// # Errors
    /// Where that is not a label and its indices.
    pub fn map_label(&mut self, mapping: &str) -> Result<(), ListingError> {
        let split = mapping.split_once('=').and_then(|(label, indices)| {
            let indices: Option<Vec<u32>> =
                indices.split(',').map(|index| index.trim().parse().ok()).collect();
            Some((Symbol::new(label), indices?)).filter(|(label, _)| !label.as_str().is_empty())
        });
        match split {
            Some(entry) => {
                self.labels.push(entry);
                Ok(())
            }
            None => {
                let expected = "LABEL=I,J, as in a_{14}=4,2";
                let fault = ListingFault::Expected { expected, found: format!("`{mapping}`") };
                Err(ListingError::at(mapping, (fault, 0..mapping.len())))
            }
        }
    }
}
