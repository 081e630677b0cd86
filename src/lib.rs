//! `prove-cap`: can a rational Bézier patch lie exactly on a sphere, or another algebraic surface, for any values
//! of its unknown weights and control points?
//!
//! The answer is **impossible**, with a certificate (polynomials g with Σ g·c = 1 over the coefficients c that
//! would have to vanish); **exact**, with a control net whose identity is verified; or **undecided**.
//!
//! What is believed is the crate `prove_cap_kernel`, re-exported here: [`exact`], [`statement`], [`certificate`] and
//! [`checker`]. The modules of this crate are layers: each uses those above it only, and `tests/house/layering.rs` sees to
//! it. A bug in them can lose a proof but never make a false one.
//!
//! ```
//! use prove_cap::{catalogue, control::Control, prove::{Attempt, prove}, statement::Statement};
//!
//! let text = catalogue::find("cap-2x2").unwrap().statement();
//! let statement = Statement::read(&text).unwrap();
//! let Ok(Attempt::Proved { proof, .. }) = prove(&statement, &Control::default()) else { panic!() };
//! println!("{}\n{}", proof.theorem(), proof.text());
//! ```

// Trusted: a crate of its own, below src/kernel.
pub use prove_cap_kernel::{certificate, checker, exact, statement};

// Untrusted: whatever comes out of these is judged by the checker.
pub mod control;
pub mod proof;
pub mod algebra;
pub mod bezier;
pub mod geometry;
pub mod formats;
pub mod elimination;
pub mod problem;
pub mod catalogue;
pub mod prove;
pub mod approximation;
pub mod construction;
pub mod expand;
pub mod document;
pub mod audit;
#[cfg(feature = "figures")]
pub mod figure;
pub mod commands;
pub mod report;

#[cfg(feature = "cli")]
pub mod cli;
