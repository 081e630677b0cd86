//! Trees of boxes on which Bernstein coefficients show a sign.

use super::boxes::{Coefficients, Part};
use super::fixed::fixed;
use crate::algebra::{FieldElement, Integer};
use crate::certificate::Tree;
use crate::elimination::{Control, Interrupted};

/// Why there is no tree.
#[derive(Debug)]
pub enum NoTree {
    /// The form is below zero at this corner (u, v) of a box, as numerators over 2^depths.
    Negative {
        /// The numerators.
        corner: (Integer, Integer),
        /// The exponents.
        depths: (u32, u32),
    },
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

/// Bits after the point for forms whose coefficients are not small.
const BITS: u32 = 128;

/// The tree for a form of this bidegree that is positive on the square, from its Bernstein coefficients, row by row.
///
/// # Errors
/// [`NoTree`]
pub fn positive_tree(
    bidegree: (usize, usize),
    coefficients: &[FieldElement],
    at_most: usize,
    control: &Control<'_>,
) -> Result<Tree, NoTree> {
    let values = coefficients.iter().map(|value| fixed(value, BITS)).collect();
    tree(Coefficients { bidegree, values }, &Integer::one().shifted_left(BITS / 2), at_most, control)
}
