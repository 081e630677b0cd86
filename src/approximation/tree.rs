//! Trees of boxes on which Bernstein coefficients show a sign.

use super::boxes::{Coefficients, Part};
use crate::algebra::Integer;
use crate::certificate::Tree;
use crate::elimination::{Control, Interrupted};

/// Why there is no tree.
#[derive(Debug)]
pub(super) enum NoTree {
    /// The form is below zero at this corner (u, v) of a box, as numerators over 2^depths.
    Negative { corner: (Integer, Integer), depths: (u32, u32) },
    /// The boxes became too many.
    TooMany,
    /// Interrupted.
    Interrupted(Interrupted),
}

/// The tree in preorder whose boxes have no coefficient below `least`, each halved only if it has one.
pub(super) fn tree(
    form: Coefficients,
    least: &Integer,
    at_most: usize,
    control: &Control<'_>,
) -> Result<Tree, NoTree> {
    let mut open = vec![Part::whole([form])];
    let mut tree = Tree::new();
    while let Some(part) = open.pop() {
        let [form] = &part.forms;
        let low = |value: &Integer| value < least;
        if !form.values.iter().any(low) {
            tree.push(false);
            continue;
        }
        if let Some(number) = form.corners().iter().position(|&corner| low(&form.values[corner])) {
            return Err(NoTree::Negative { corner: part.corner(number), depths: part.depths() });
        }
        tree.push(true);
        if tree.len() + open.len() > at_most {
            return Err(NoTree::TooMany);
        }
        if tree.len().is_multiple_of(256) {
            control.check().map_err(NoTree::Interrupted)?;
        }
        let [first, second] = part.halves();
        open.push(second);
        open.push(first);
    }
    Ok(tree)
}
