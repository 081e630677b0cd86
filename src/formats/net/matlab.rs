//! Nets in MATLAB's notation.
//!
//! ```text
//! s = sqrt(3);                                  % scalars
//! c(:,:,1) = [x0, x1, x2; y0, ...; z0, ...; w0, ...];   % the points of v-index j = 0, as in nurbs.coefs
//! P(1,1,:) = [x, y, z, w];                      % or point by point
//! ```
//! Entries are separated by commas, or by blanks as MATLAB has it: in `[a -b]` there are two, in `[a - b]` one.

use std::collections::BTreeMap;
use std::ops::Range;

use super::NetError;
use super::json::{check_shape, prime_factors};
use super::{Convention, PrintedNet};
use crate::exact::{Polynomial, Radicands, Work, limits};
use crate::formats::listing::{Expression, ListingError, ListingFault, Scope, Symbol};
use crate::statement::Place;

/// Reads a net; MATLAB files do not say which convention they follow.
///
/// # Errors
/// With line, column and what was expected.
pub fn from_matlab(text: &str, title: &str, convention: Convention) -> Result<PrintedNet, NetError> {
    let clean = without_comments(text);
    let field = Radicands::new(prime_factors(&roots_in(&clean)))
        .map_err(|error| NetError::Net(format!("the square roots of the file: {error}")))?;
    let mut reader = Reader {
        text,
        clean: &clean,
        scope: Scope::of(&field, &[]),
        work: Work::full(),
        points: BTreeMap::new(),
    };
    for statement in statements(&clean) {
        reader.statement(statement)?;
    }
    let rows = reader.points.keys().map(|&(i, _)| i + 1).max().unwrap_or(0);
    let columns = reader.points.keys().map(|&(_, j)| j + 1).max().unwrap_or(0);
    let mut points = Vec::new();
    for i in 0..rows {
        let mut row = Vec::new();
        for j in 0..columns {
            let missing = || NetError::Net(format!("control point ({}, {}) is missing", i + 1, j + 1));
            row.push(reader.points.remove(&(i, j)).ok_or_else(missing)?);
        }
        points.push(row);
    }
    check_shape(&points).map_err(NetError::Net)?;
    Ok(PrintedNet { title: title.to_owned(), field, convention, surface: None, points })
}

/// Comments and continuation dots blanked; every byte stays where it was.
fn without_comments(text: &str) -> String {
    let mut clean = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        let code = line.find('%').unwrap_or(line.len());
        let code = line[..code].find("...").unwrap_or(code);
        let continued = line[code..].starts_with("...");
        clean.push_str(&line[..code]);
        for byte in line[code..].bytes() {
            clean.push(if byte == b'\n' && !continued { '\n' } else { ' ' });
        }
    }
    clean
}

/// The integers under square roots.
fn roots_in(text: &str) -> Vec<u32> {
    let arguments = text.split("sqrt(").skip(1).filter_map(|rest| rest.split(')').next());
    let numbers = arguments.flat_map(|argument| argument.split(|c: char| !c.is_ascii_digit()));
    numbers
        .filter_map(|digits| digits.parse().ok())
        .filter(|&n: &u32| n > 1 && n <= limits::RADICAND)
        .collect()
}

/// The statements: cut at `;` and line ends outside brackets.
fn statements(text: &str) -> Vec<Range<usize>> {
    let (mut depth, mut start, mut found) = (0i32, 0, Vec::new());
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            ';' | '\n' if depth <= 0 => {
                found.push(start..at);
                start = at + 1;
            }
            _ => {}
        }
    }
    found.push(start..text.len());
    found.retain(|range| !text[range.clone()].trim().is_empty());
    found
}

struct Reader<'a> {
    text: &'a str,
    clean: &'a str,
    scope: Scope,
    work: Work,
    points: BTreeMap<(usize, usize), [Polynomial; 4]>,
}

impl Reader<'_> {
    fn wrong(&self, span: Range<usize>, expected: &'static str) -> NetError {
        let found: String = self.clean[span.clone()].trim().chars().take(30).collect();
        let fault = ListingFault::Expected { expected, found: format!("`{}`", found.escape_debug()) };
        ListingError { place: Place::of(self.text, span), fault }.into()
    }

    fn statement(&mut self, span: Range<usize>) -> Result<(), NetError> {
        let Some(equals) = self.clean[span.clone()].find('=').map(|at| span.start + at) else {
            return Err(self.wrong(span, "an assignment"));
        };
        let left = self.clean[span.start..equals].trim();
        let right = trimmed(self.clean, equals + 1..span.end);
        let name: String = left.chars().take_while(|c| c.is_ascii_alphanumeric() || *c == '_').collect();
        let indices = left[name.len()..].trim();
        if name.is_empty() || !name.starts_with(|c: char| c.is_ascii_alphabetic()) {
            return Err(self.wrong(span.start..equals, "a name"));
        }
        if indices.is_empty() {
            // The declaration of an array.
            if self.clean[right.clone()].starts_with("zeros(") {
                return Ok(());
            }
            let value = self.value(right)?;
            self.scope.names.insert(Symbol::new(&name), Some(value));
            return Ok(());
        }
        let inside = indices.strip_prefix('(').and_then(|rest| rest.strip_suffix(')'));
        let parts: Vec<&str> = inside.unwrap_or_default().split(',').map(str::trim).collect();
        let number = |part: &str| {
            part.parse::<usize>().ok().filter(|&n| n > 0 && n <= limits::BIDEGREE as usize + 1).map(|n| n - 1)
        };
        match parts.as_slice() {
            [":", ":", j] if number(j).is_some() => {
                let j = number(j).unwrap_or_default();
                let rows = self.matrix(right.clone())?;
                let columns = rows.first().map_or(0, Vec::len);
                let [x, y, z, w] = rows.as_slice() else {
                    return Err(self.wrong(right, "four rows: x, y, z and w"));
                };
                if rows.iter().any(|row| row.len() != columns) {
                    return Err(self.wrong(right, "four rows of one length"));
                }
                for i in 0..columns {
                    let point = [x[i].clone(), y[i].clone(), z[i].clone(), w[i].clone()];
                    self.points.insert((i, j), point);
                }
                Ok(())
            }
            [i, j, ":"] if number(i).is_some() && number(j).is_some() => {
                let entries: Vec<Polynomial> = self.matrix(right.clone())?.into_iter().flatten().collect();
                let Ok(point) = <[Polynomial; 4]>::try_from(entries) else {
                    return Err(self.wrong(right, "four numbers: x, y, z and w"));
                };
                self.points.insert((number(i).unwrap_or_default(), number(j).unwrap_or_default()), point);
                Ok(())
            }
            _ => {
                Err(self
                    .wrong(span.start..equals, "a name, NAME(:,:,j) or NAME(i,j,:), indices from 1 to 33"))
            }
        }
    }

    fn value(&mut self, span: Range<usize>) -> Result<Polynomial, NetError> {
        let expression = Expression::read(self.clean, span)?;
        expression.value(self.text, &self.scope, &mut self.work).map_err(NetError::from)
    }

    /// `[a, b; c, d]`.
    fn matrix(&mut self, span: Range<usize>) -> Result<Vec<Vec<Polynomial>>, NetError> {
        let text = &self.clean[span.clone()];
        if !text.starts_with('[') || !text.ends_with(']') || text.len() < 2 {
            return Err(self.wrong(span, "a matrix in [ ]"));
        }
        let mut rows = Vec::new();
        for row in entries(self.clean, span.start + 1..span.end - 1) {
            let mut values = Vec::new();
            for entry in row {
                values.push(self.value(entry)?);
            }
            rows.push(values);
        }
        Ok(rows)
    }
}

fn trimmed(text: &str, span: Range<usize>) -> Range<usize> {
    let part = &text[span.clone()];
    let start = span.start + part.len() - part.trim_start().len();
    start..start + part.trim().len()
}

/// The entries of a matrix, row by row.
fn entries(text: &str, inside: Range<usize>) -> Vec<Vec<Range<usize>>> {
    let (mut rows, mut row) = (Vec::new(), Vec::new());
    let (mut depth, mut start, mut at) = (0i32, inside.start, inside.start);
    let operator = |c: &u8| b"+-*/^".contains(c);
    let bytes = &text.as_bytes()[..inside.end];
    let close = |row: &mut Vec<Range<usize>>, entry: Range<usize>| {
        let entry = trimmed(text, entry);
        if !entry.is_empty() {
            row.push(entry);
        }
    };
    while at < inside.end {
        let blanks = bytes[at..].iter().take_while(|c| matches!(c, b' ' | b'\t' | b'\r')).count();
        match bytes[at] {
            b'(' => depth += 1,
            b')' => depth -= 1,
            b',' | b';' | b'\n' if depth == 0 => {
                close(&mut row, start..at);
                start = at + 1;
                if bytes[at] != b',' && !row.is_empty() {
                    rows.push(std::mem::take(&mut row));
                }
            }
            _ if blanks > 0 && depth == 0 => {
                let rest = &bytes[at + blanks..];
                // A sign with a number right behind it starts a new entry.
                let unary = matches!(rest, [b'+' | b'-', after, ..] if !after.is_ascii_whitespace());
                let complete = at > start && !operator(&bytes[at - 1]);
                if complete && (unary || rest.first().is_some_and(|c| !operator(c) && !b",;\n".contains(c))) {
                    close(&mut row, start..at);
                    start = at + blanks;
                }
            }
            _ => {}
        }
        at += blanks.max(1);
    }
    close(&mut row, start..inside.end);
    if !row.is_empty() {
        rows.push(row);
    }
    rows
}
