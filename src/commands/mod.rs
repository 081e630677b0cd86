//! What the program can be asked: one function for each command, from a request to a result.
//!
//! No command line, no files and no printing here: other front doors, such as a library for another language, call the same.

mod verdict;

pub use verdict::Verdict;
