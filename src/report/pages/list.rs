//! `list`, and `--help`.

use serde::Serialize;

use crate::catalogue::FAMILY;
use crate::commands::{Listed, Verdict};
use crate::document::{Block, Column, Document, Table};
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

    fn document(&self) -> Result<Document, Limit> {
        let columns = [Column::left(0), Column::right(2), Column::left(2)];
        let mut table = Table::new(0, columns).headed(["name", "unknowns", "about"]);
        for Listed { name, summary, statement } in &self.0 {
            table.row([(*name).to_owned(), statement.unknowns().len().to_string(), (*summary).to_owned()]);
        }
        let mut document = Document::of_words();
        document.push(Block::Table(table));
        document.gap();
        document.line(0, format!("Caps of other degrees: {FAMILY}, M and N from 2."));
        Ok(document)
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

    fn document(&self) -> Result<Document, Limit> {
        let mut document = Document::of_words();
        document.source(0, self.help.as_str());
        Ok(document)
    }

    fn data(&self) -> Result<Help, Limit> {
        Ok(Help { help: self.help.clone() })
    }
}
