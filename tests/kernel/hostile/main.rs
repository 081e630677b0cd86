//! Files made to hurt: each ends with a limit or a verdict, within the units and the memory of the format,
//! never a panic.
//!
//! An attack is a statement with a certificate, made for a size. Nothing is timed: what is done is held
//! against what was paid, by counting what was allocated.
#![allow(
    missing_docs,
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "tests"
)]
#![allow(
    clippy::arithmetic_side_effects,
    clippy::as_conversions,
    clippy::disallowed_methods,
    reason = "tests"
)]
#![allow(clippy::disallowed_macros, clippy::string_slice, reason = "tests")]

mod attack;
mod bounds;
mod cover;
mod exact;
mod files;
mod impossible;
mod measure;
mod statements;
mod unreachable;
