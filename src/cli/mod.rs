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
mod polygon;
mod prove;
mod source;
mod table;
mod values;

pub use arguments::run;
