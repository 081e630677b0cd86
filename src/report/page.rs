//! What every answer is: a verdict, words, and data, printed in the format that was asked for.

use serde::Serialize;

use crate::commands::Verdict;
use crate::exact::Limit;

/// An answer that can be printed.
pub trait Page {
    /// What it is as data, without the verdict.
    type Data: Serialize;

    /// The verdict.
    fn verdict(&self) -> Verdict;

    /// For people; the first word is the verdict's.
    ///
    /// # Errors
    /// Where a number exceeds what the formats allow.
    fn text(&self) -> Result<String, Limit>;

    /// As a LaTeX document, if there is one.
    fn latex(&self) -> Option<String> {
        None
    }

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

/// For people.
///
/// # Errors
/// As the page has them.
pub fn text(page: &impl Page) -> Result<String, Limit> {
    page.text()
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
