//! Arguments by subdivision: boxes on each of which the coefficients of a form have one sign.

mod quantity;
mod along;
mod signs;
mod table;
mod form;
mod square;
mod text;

use std::fmt;

pub use along::Side;
pub(super) use along::{Along, subject};
pub(super) use form::Form;
pub use quantity::{Quantity, Units, spell_decimal};
pub(super) use quantity::{on_ratio, threshold};
pub(super) use signs::Signs;
pub(super) use square::{NOT_NEGATIVE, POSITIVE, UnitSquare};
pub(super) use table::Interval;
pub(super) use text::{leaves, quantity, sealed, spelled};

/// A binary tree in preorder: `true` for a box that is halved, `false` for one that is not.
pub type Tree = Vec<bool>;

/// What is wrong with a subdivision.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(missing_docs, reason = "the fields are what the message prints")]
pub enum Rejection {
    /// Bounds for a bare system.
    NotAPatch,
    /// A radius along a patch whose surface is another than X² + Y² + Z² − W² = 0.
    NotTheUnitSphere,
    /// A negative bound on a radius.
    NegativeRadius,
    /// Not a binary tree in preorder.
    Tree { tree: &'static str },
    /// A box on which the coefficients do not have the sign that is claimed.
    Sign { tree: &'static str, node: usize },
    /// A box that is halved though its coefficients have the sign that is claimed.
    NeedlessHalving { tree: &'static str, node: usize },
}

impl fmt::Display for Rejection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Rejection::NotAPatch => {
                write!(f, "the claim is about a patch, but the statement is a system of equations")
            }
            Rejection::NotTheUnitSphere => {
                write!(
                    f,
                    "the claim is about the unit sphere X² + Y² + Z² − W² = 0, but the surface is another"
                )
            }
            Rejection::NegativeRadius => write!(f, "a bound on a radius is negative"),
            Rejection::Tree { tree } => write!(f, "{tree}: not a binary tree in preorder"),
            Rejection::Sign { tree, node } => {
                write!(
                    f,
                    "{tree}: on box {node} of the tree, the coefficients do not have the sign that is claimed"
                )
            }
            Rejection::NeedlessHalving { tree, node } => {
                write!(f, "{tree}: box {node} of the tree is halved, but need not be")
            }
        }
    }
}
