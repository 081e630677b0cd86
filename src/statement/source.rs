//! From byte offsets in the file to lines, columns and excerpts.

use std::ops::Range;

use super::error::{StatementError, StatementFault};

/// A fault with the bytes of the file it concerns.
pub(super) type Located = (StatementFault, Range<usize>);

/// How much of a long line an error shows.
const EXCERPT: usize = 100;
/// How much of it stands in front of the offending text.
const LEAD: usize = 40;

/// Finds the place of a fault.
pub(super) fn locate(text: &str, (fault, span): Located) -> StatementError {
    let start = floor_boundary(text, span.start);
    let (before, after) = text.split_at(start);
    let head = before.rsplit('\n').next().unwrap_or("");
    let tail = after.split('\n').next().unwrap_or("").trim_end_matches('\r');
    let offending = tail.chars().take(text.get(span).map_or(1, |bad| bad.chars().count())).count();

    let lead: Vec<char> = head.chars().rev().take(LEAD).collect();
    let clean = |c: char| if is_unprintable(c) { ' ' } else { c };
    let excerpt = lead.iter().rev().copied().chain(tail.chars().take(EXCERPT)).map(clean);
    StatementError {
        line: before.matches('\n').count().saturating_add(1),
        column: head.chars().count().saturating_add(1),
        width: offending.max(1),
        excerpt: excerpt.collect(),
        excerpt_column: lead.len(),
        fault,
    }
}

/// Control characters, and the invisible ones that reorder or hide text on a terminal.
pub(super) fn is_unprintable(c: char) -> bool {
    let invisible = ['\u{ad}', '\u{61c}', '\u{180e}', '\u{feff}'];
    c.is_control()
        || invisible.contains(&c)
        || ('\u{200b}'..='\u{200f}').contains(&c)
        || ('\u{2028}'..='\u{202e}').contains(&c)
        || ('\u{2060}'..='\u{206f}').contains(&c)
        || ('\u{fff9}'..='\u{fffb}').contains(&c)
        || ('\u{e0000}'..='\u{e007f}').contains(&c)
}

fn floor_boundary(text: &str, at: usize) -> usize {
    let at = at.min(text.len());
    (0..=at).rev().find(|&index| text.is_char_boundary(index)).unwrap_or(0)
}
