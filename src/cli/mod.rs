//! The command line: one file for each subcommand, and the only place that prints or exits.

mod approximate;
mod arguments;
mod audit;
mod bound;
mod check;
mod construct;
mod control;
mod degrees;
mod expand;
mod export;
mod files;
mod list;
pub mod outcome;
mod plot;
mod prove;
mod run;
mod source;
mod table;

pub use run::run;
