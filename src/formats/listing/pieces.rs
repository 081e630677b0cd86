//! Where one formula ends and the next begins.

use super::token::{Kind, Token};

/// Cuts after each separator and in front of each row that has an `=`; drops pieces without content.
pub(super) fn pieces(tokens: &[Token]) -> Vec<&[Token]> {
    let mut cuts = vec![0];
    let mut row_start = 0;
    let mut depth = 0u32;
    for (index, token) in tokens.iter().enumerate() {
        match token.kind {
            Kind::Separator if depth == 0 => {
                cuts.push(index);
                row_start = index + 1;
            }
            Kind::Row => row_start = index,
            Kind::Open(_) => depth += 1,
            Kind::Close(_) => depth = depth.saturating_sub(1),
            Kind::Equals if cuts.last().is_none_or(|&last| last < row_start) => {
                // A second `=` of the same row belongs to the same formula.
                cuts.push(row_start);
                depth = 0;
            }
            _ => {}
        }
    }
    cuts.push(tokens.len());
    let content = |token: &Token| !token.kind.is_layout() && token.kind != Kind::Separator;
    let pieces = cuts.windows(2).map(|pair| &tokens[pair[0]..pair[1]]);
    pieces.filter(|piece| piece.iter().any(content)).collect()
}
