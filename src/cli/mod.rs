//! The command line: one file for each subcommand, and the only place that prints or exits.

pub mod check;
pub mod outcome;

#[cfg(feature = "prover")]
mod approximate;
#[cfg(feature = "prover")]
mod arguments;
#[cfg(feature = "prover")]
mod audit;
#[cfg(feature = "prover")]
mod bound;
#[cfg(not(feature = "prover"))]
mod checker_only;
#[cfg(feature = "prover")]
mod construct;
#[cfg(feature = "prover")]
mod control;
#[cfg(feature = "prover")]
mod degrees;
#[cfg(feature = "prover")]
mod expand;
#[cfg(feature = "prover")]
mod export;
#[cfg(feature = "prover")]
mod files;
#[cfg(feature = "prover")]
mod list;
#[cfg(feature = "prover")]
mod plot;
#[cfg(feature = "prover")]
mod polygon;
#[cfg(feature = "prover")]
mod prove;
#[cfg(feature = "prover")]
mod source;
#[cfg(feature = "prover")]
mod table;
#[cfg(feature = "prover")]
mod values;

#[cfg(feature = "prover")]
pub use arguments::run;
#[cfg(not(feature = "prover"))]
pub use checker_only::run;
