//! The text of claim `cover`: FORMAT.md, "Certificates by subdivision".

use super::{Cover, EDGES, EdgeTree};
use crate::claims::exact::value_lines;
use crate::claims::subdivision::{leaves, sealed, spelled};
use crate::exact::Ring;
use crate::text::{CertificateError, Reader};

/// The lines after the claim.
pub(in crate::claims) fn write(cover: &Cover, ring: &Ring, lines: Vec<String>) -> String {
    let mut lines = lines;
    lines.extend(value_lines(&cover.values, ring));
    lines.push(format!("denominator {}", spelled(&cover.denominator)));
    for (name, edge) in EDGES.iter().zip(&cover.edges) {
        lines.push(match edge {
            EdgeTree::Arc(tree) => format!("edge {name} arc {}", spelled(tree)),
            EdgeTree::Point => format!("edge {name} point"),
        });
    }
    let direction = if cover.inward { "inward" } else { "outward" };
    lines.push(format!("regular {direction} {}", spelled(&cover.regular)));
    sealed(lines, boxes(cover))
}

/// Reads them.
pub(in crate::claims) fn read(reader: &mut Reader<'_, '_>) -> Result<Cover, CertificateError> {
    let values = reader.values()?;
    let denominator = reader.named_tree("denominator ", "`denominator ` and a tree of `h` and `.`")?;
    let mut edges = EDGES.map(|_| EdgeTree::Point);
    for (name, edge) in EDGES.iter().zip(&mut edges) {
        let expected = "`edge `, the next of u=0, u=1, v=0, v=1, and `point` or `arc TREE`";
        let line = reader.next(expected)?;
        let rest = line.strip_prefix("edge ").and_then(|rest| rest.strip_prefix(name));
        match rest.ok_or_else(|| reader.unexpected(line, expected))? {
            " point" => {}
            rest => {
                let tree = rest.strip_prefix(" arc ").ok_or_else(|| reader.unexpected(line, expected))?;
                *edge = EdgeTree::Arc(reader.tree(line, tree)?);
            }
        }
    }
    let expected = "`regular outward ` or `regular inward ` and a tree of `h` and `.`";
    let line = reader.next(expected)?;
    let (inward, tree) = match line.strip_prefix("regular ").and_then(|rest| rest.split_once(' ')) {
        Some(("inward", tree)) => (true, tree),
        Some(("outward", tree)) => (false, tree),
        _ => return Err(reader.unexpected(line, expected)),
    };
    let regular = reader.tree(line, tree)?;
    let cover = Cover { values, denominator, edges, inward, regular };
    reader.sealed(boxes(&cover))?;
    Ok(cover)
}

/// The boxes of all trees.
fn boxes(cover: &Cover) -> usize {
    cover.trees().fold(0, |sum, tree| leaves(tree).saturating_add(sum))
}
