//! Where the displayed formulas of a LaTeX text are.
//!
//! If the text has displays (`\[…\]`, `$$…$$`, `equation`, `align`, …), only these are read and all else is prose;
//! otherwise the whole text is one display.

use std::ops::Range;

use super::error::{ListingFault, Located};

/// Environments that open a display of their own.
pub(super) const DISPLAYS: [&str; 7] =
    ["equation", "align", "alignat", "gather", "multline", "eqnarray", "displaymath"];
/// The stretches of mathematics.
pub(super) fn displays(text: &str) -> Result<Vec<Range<usize>>, Located> {
    let mut found = Vec::new();
    let mut at = 0;
    while at < text.len() {
        let rest = &text[at..];
        let opened = if rest.starts_with('%') {
            at += rest.find('\n').unwrap_or(rest.len());
            continue;
        } else if rest.starts_with("$$") {
            Some((2, "$$".to_owned()))
        } else if rest.starts_with("\\[") {
            Some((2, "\\]".to_owned()))
        } else if let Some(name) = environment(rest, "\\begin{") {
            let display = DISPLAYS.contains(&name.trim_end_matches('*'));
            display.then(|| ("\\begin{}".len() + name.len(), format!("\\end{{{name}}}")))
        } else {
            None
        };
        match opened {
            Some((skip, close)) => {
                let start = at + skip;
                let Some(length) = find_uncommented(&text[start..], &close) else {
                    let expected = "the end of this display";
                    let found = "none in the text".to_owned();
                    return Err((ListingFault::Expected { expected, found }, at..start));
                };
                // The argument of alignat and the like is read with the display.
                let start = if skip > 2 { at } else { start };
                found.push(start..at + skip + length);
                at += skip + length + close.len();
            }
            // An escaped character, \\ and \$ among them, is passed over as one.
            None => {
                let skip = if rest.starts_with('\\') { 2 } else { 1 };
                at = ceil_boundary(text, at + skip);
            }
        }
    }
    if found.is_empty() {
        found.push(0..text.len());
    }
    Ok(found)
}

fn find_uncommented(text: &str, close: &str) -> Option<usize> {
    let mut at = 0;
    while at < text.len() {
        let rest = &text[at..];
        if rest.starts_with(close) {
            return Some(at);
        }
        if rest.starts_with('%') {
            at += rest.find('\n').unwrap_or(rest.len());
        } else if rest.starts_with("\\\\") || rest.starts_with("\\%") {
            at += 2;
        } else {
            at = ceil_boundary(text, at + 1);
        }
    }
    None
}

fn ceil_boundary(text: &str, at: usize) -> usize {
    (at..=text.len()).find(|&index| text.is_char_boundary(index)).unwrap_or(text.len())
}

/// The name in `\begin{name}` at the start of a text.
pub(super) fn environment<'a>(text: &'a str, command: &str) -> Option<&'a str> {
    let name = text.strip_prefix(command)?;
    name.get(..name.find('}')?)
}
