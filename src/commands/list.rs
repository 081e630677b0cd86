//! `list`: the built-in statements.

use super::Failure;
use crate::catalogue::ENTRIES;
use crate::statement::Statement;

/// A built-in statement.
#[derive(Debug)]
pub struct Listed {
    /// Its name.
    pub name: &'static str,
    /// What it is about.
    pub summary: &'static str,
    /// The statement.
    pub statement: Statement,
}

/// All built-in statements.
///
/// # Errors
/// Where one of them cannot be read: a fault of this program.
pub fn list() -> Result<Vec<Listed>, Failure> {
    let listed = ENTRIES.iter().map(|entry| {
        let statement =
            Statement::read(&entry.statement()).map_err(|error| Failure::at(entry.name, &error))?;
        Ok(Listed { name: entry.name, summary: entry.summary, statement })
    });
    listed.collect()
}
