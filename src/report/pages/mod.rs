//! One file for each command: its result as words and as data.

mod approximate;
mod audit;
mod bound;
mod check;
mod construct;
mod degrees;
mod expand;
mod export;
mod list;
mod no_answer;
mod picture;
mod prove;
mod table;

pub use approximate::{Approximating, about};
pub use bound::Bounding;
pub use check::{Canonical, Checking};
pub use construct::{Constructing, Tiling};
pub use degrees::{Classifying, Explained};
pub use export::{ExportShown, ExportWritten};
pub use list::{Help, Listing};
pub use no_answer::Unchecked;
pub use picture::{Picture, caption};
pub use prove::Proving;
pub use table::Tabled;
