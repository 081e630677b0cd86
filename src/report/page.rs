//! What every answer is: a verdict, words, and data, printed in the format that was asked for.

use serde::Serialize;

use crate::commands::Verdict;
use crate::document::Document;
use crate::exact::Limit;

/// An answer that can be printed.
pub trait Page {
    /// What it is as data, without the verdict.
    type Data: Serialize;

    /// The verdict.
    fn verdict(&self) -> Verdict;

    /// In words, formulas and tables; the first word is the verdict's.
    ///
    /// # Errors
    /// Where a number exceeds what the formats allow.
    fn document(&self) -> Result<Document, Limit>;

    /// As data.
    ///
    /// # Errors
    /// Where a number exceeds what the formats allow.
    fn data(&self) -> Result<Self::Data, Limit>;
}

/// The data of an answer, the verdict first.
#[derive(Serialize)]
struct Answer<D> {
    verdict: Verdict,
    #[serde(flatten)]
    data: D,
}

/// For people at a terminal.
///
/// # Errors
/// As the page has them.
pub fn text(page: &impl Page) -> Result<String, Limit> {
    page.document().map(|document| super::text::print(&document))
}

/// As a LaTeX document.
///
/// # Errors
/// As the page has them.
pub fn latex(page: &impl Page) -> Result<String, Limit> {
    page.document().map(|document| super::latex::print(&document))
}

/// One JSON object on lines of its own, with the verdict's first word as its member `verdict`.
///
/// # Errors
/// As the page has them.
pub fn json(page: &impl Page) -> Result<String, Limit> {
    let answer = Answer { verdict: page.verdict(), data: page.data()? };
    let text = serde_json::to_string_pretty(&answer).expect("strings, numbers and lists of them under names");
    Ok(text + "\n")
}
