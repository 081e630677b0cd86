//! What the program can be asked: one function for each command, from a request to a result.
//!
//! No command line, no files and no printing here: other front doors, such as a library for another language, call the
//! same. A result knows its [`Verdict`]; that there is none is a [`NoAnswer`], which knows its own.

mod approximate;
mod audit;
mod bound;
mod check;
mod construct;
mod degrees;
mod expand;
mod export;
mod failure;
mod list;
mod no_answer;
#[cfg(feature = "figures")]
mod picture;
mod polygon;
mod printed;
mod prove;
mod source;
mod table;
mod values;
mod verdict;

pub use approximate::{Approximated, Best, Gap, approximate, sensible};
pub use audit::{AuditedListing, AuditedNet, audit_listing, audit_net, mapped};
pub use bound::{Bounded, Bounding, bound, degree_of};
pub use check::{Checked, Named, canonical, check};
pub use construct::{Constructed, Tiled, construct, construct_tiling};
pub use degrees::{Closing, Degrees, degrees};
pub use expand::{Expanded, expand};
pub use export::{Division, Exported, Which, export};
pub use failure::{Failure, Location, Placed};
pub use list::{Listed, list};
pub use no_answer::{NoAnswer, Nonexistent, Rejected, Undecided};
#[cfg(feature = "figures")]
pub use picture::picture;
pub use polygon::Shape;
pub use printed::{FileKind, JSON_BYTES, Printed};
pub use prove::{Proved, prove};
pub use source::Source;
pub use table::{Line, ROWS, Row, Table, Unfinished, Values, table};
pub use values::{ValuesError, values};
pub use verdict::Verdict;
