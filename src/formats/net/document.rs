//! Statements in JSON: what this program writes with `--format json`, and nets.

use std::fmt::Write as _;

use serde_json::Value;

use super::NetError;
use super::json::{from_json, wrong};
use crate::statement::Statement;

/// The statement file that a JSON document amounts to: its net, or else the statement it is about.
///
/// # Errors
/// [`NetError::Net`] with the place in the document and what was expected.
pub fn statement_from_json(text: &str) -> Result<String, NetError> {
    let document: Value =
        serde_json::from_str(text).map_err(|error| wrong("the file", &error.to_string()))?;
    let open = document["unknowns"].as_array().is_some_and(|unknowns| !unknowns.is_empty());
    match (document.get("net"), document.get("statement")) {
        (None, Some(statement)) => file(statement),
        _ if open || document.get("polynomials").is_some() => file(&document),
        _ => Ok(from_json(text)?.statement()),
    }
}

/// A statement file in TOML, with its hash compared where the document says it.
fn file(statement: &Value) -> Result<String, NetError> {
    let mut text = String::new();
    for key in ["title", "radicands", "unknowns", "nonzero", "convention", "bidegree", "surface"] {
        if let Some(value) = statement.get(key) {
            // What JSON writes for strings and lists of these is TOML.
            let _ = writeln!(text, "{key} = {value}");
        }
    }
    for key in ["net", "polynomials"] {
        let Some(value) = statement.get(key) else { continue };
        let rows = value.as_array().ok_or_else(|| wrong(&format!("statement.{key}"), "expected a list"))?;
        let _ = writeln!(text, "{key} = [");
        for row in rows {
            let _ = writeln!(text, "  {row},");
        }
        text.push_str("]\n");
    }
    let read = Statement::read(&text).map_err(|error| wrong("statement", &error.fault.to_string()))?;
    match statement.get("sha256").and_then(Value::as_str) {
        Some(hash) if hash != read.hash() => Err(wrong(
            "statement.sha256",
            "this is the hash of another statement: one of the two was changed; leave the key out if it was the statement",
        )),
        _ => Ok(text),
    }
}
