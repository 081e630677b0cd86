//! `list`, and `--help`.

use std::fmt::Write as _;

use serde::Serialize;

use crate::catalogue::FAMILY;
use crate::commands::{Listed, Verdict};
use crate::exact::Limit;
use crate::report::json::{StatementData, statement};
use crate::report::page::Page;

/// The built-in statements.
#[derive(Debug)]
pub struct Listing(pub Vec<Listed>);

/// The same as data.
#[derive(Debug, Serialize)]
pub struct ListingData {
    statements: Vec<ListedData>,
    family: &'static str,
}

#[derive(Debug, Serialize)]
struct ListedData {
    name: &'static str,
    summary: &'static str,
    statement: StatementData,
}

impl Page for Listing {
    type Data = ListingData;

    fn verdict(&self) -> Verdict {
        Verdict::Shown
    }

    fn text(&self) -> Result<String, Limit> {
        let width = self.0.iter().map(|entry| entry.name.len()).max().unwrap_or(0);
        let mut text = format!("{:<width$}  unknowns  about\n", "name");
        for Listed { name, summary, statement } in &self.0 {
            let _ = writeln!(text, "{name:<width$}  {:>8}  {summary}", statement.unknowns().len());
        }
        let _ = writeln!(text, "\nCaps of other degrees: {FAMILY}, M and N from 2.");
        Ok(text)
    }

    fn data(&self) -> Result<ListingData, Limit> {
        let entries = self.0.iter().map(|entry| ListedData {
            name: entry.name,
            summary: entry.summary,
            statement: statement(&entry.statement),
        });
        Ok(ListingData { statements: entries.collect(), family: FAMILY })
    }
}

/// How the program is used.
#[derive(Debug, Serialize)]
pub struct Help {
    /// What is printed.
    pub help: String,
}

impl Page for Help {
    type Data = Help;

    fn verdict(&self) -> Verdict {
        Verdict::Shown
    }

    fn text(&self) -> Result<String, Limit> {
        Ok(self.help.clone())
    }

    fn data(&self) -> Result<Help, Limit> {
        Ok(Help { help: self.help.clone() })
    }
}
