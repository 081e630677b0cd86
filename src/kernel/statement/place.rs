//! From byte offsets in a text to lines, columns and excerpts.

use std::fmt;
use std::ops::Range;

/// How much of a long line an error shows.
const EXCERPT: usize = 100;
/// How much of it stands in front of the offending text.
const LEAD: usize = 40;

/// A place in a text, as people are shown it. Lines and columns count from 1, columns in characters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// The line.
    pub line: usize,
    /// The first column of the marked text.
    pub column: usize,
    /// How many characters of the line are marked (at least 1).
    pub width: usize,
    /// The line itself, shortened around the marked text; unprintable characters blanked.
    pub excerpt: String,
    /// Where in `excerpt` the marked text starts, in characters from 0.
    pub excerpt_column: usize,
}

impl Place {
    /// The place of these bytes of a text.
    pub fn of(text: &str, span: Range<usize>) -> Self {
        let start = floor_boundary(text, span.start);
        let (before, after) = text.split_at(start);
        let head = before.rsplit('\n').next().unwrap_or("");
        let tail = after.split('\n').next().unwrap_or("").trim_end_matches('\r');
        let marked = tail.chars().take(text.get(span).map_or(1, |bad| bad.chars().count())).count();

        let lead: Vec<char> = head.chars().rev().take(LEAD).collect();
        let clean = |c: char| if is_unprintable(c) { ' ' } else { c };
        let excerpt = lead.iter().rev().copied().chain(tail.chars().take(EXCERPT)).map(clean);
        Place {
            line: before.matches('\n').count().saturating_add(1),
            column: head.chars().count().saturating_add(1),
            width: marked.max(1),
            excerpt: excerpt.collect(),
            excerpt_column: lead.len(),
        }
    }
}

impl fmt::Display for Place {
    /// The line and, under it, carets below the marked text.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{:>5} | {}", self.line, self.excerpt)?;
        let shown = self.excerpt.chars().count().saturating_sub(self.excerpt_column);
        let width = self.width.clamp(1, shown.max(1));
        write!(f, "      | {}{}", " ".repeat(self.excerpt_column), "^".repeat(width))
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
