//! How well a patch approximates its surface: best values of the unknowns, and proved bounds.
//!
//! Optimisation is done in floating point and guesses. Whatever is said to be proved is a certificate that the checker
//! has accepted.

mod best;
mod boxes;
mod chart;
mod claim;
mod contact;
mod descent;
mod enclosure;
mod end;
mod exactly;
mod extreme;
mod extremes;
mod fixed;
mod frame;
mod levenberg;
mod linear;
mod model;
mod normal;
mod objective;
mod point;
mod polish;
mod progress;
mod recognise;
mod scene;
mod seam;
mod size;
mod start;
mod touch;
mod tree;
mod unreachable;

pub use best::{Approximation, ApproximationError, BestSoFar, Decimals, Search, approximate, error_of};
pub use claim::{EndVerdict, Finding, judge};
pub(crate) use enclosure::around;
pub use enclosure::{Enclosure, EnclosureError, enclose, patch_at, quantity_of};
pub use extremes::{Place, local_extremes};
pub use fixed::fixed;
pub use model::{Deviation, Fitted, Model};
pub use objective::Objective;
pub use point::compare_at;
pub use seam::{FloatPatch, Seams};
pub use tree::{NoTree, positive_tree};
pub use unreachable::{Barrier, UnreachableError, exclude};
