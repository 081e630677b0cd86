//! `prove-cap`: can a rational Bézier patch lie exactly on a sphere, or another algebraic surface, for any values
//! of its unknown weights and control points?
//!
//! The answer is **impossible**, with a certificate (polynomials g with Σ g·c = 1 over the coefficients c that
//! would have to vanish); **exact**, with a control net whose identity is verified; or **undecided**.
//!
//! The modules are layers: each uses those above it only, and `tests/layering.rs` sees to it. The first four are
//! trusted and small; they are all there is without the feature `prover`. A bug below them can lose a proof but
//! never make a false one.
//!
//! ```
//! # #[cfg(feature = "prover")] {
//! use prove_cap::{catalogue, elimination::Control, prove::{Attempt, prove}, statement::Statement};
//!
//! let text = catalogue::find("cap-2x2").unwrap().statement();
//! let statement = Statement::read(&text).unwrap();
//! let Ok(Attempt::Proved { certificate, theorem }) = prove(&statement, &Control::default()) else { panic!() };
//! println!("{theorem}\n{}", certificate.write(&statement.ring()));
//! # }
//! ```

// Trusted.
pub mod exact;
pub mod statement;
pub mod certificate;
pub mod checker;

// Untrusted: whatever comes out of these is judged by the checker.
#[cfg(feature = "prover")]
pub mod algebra;
#[cfg(feature = "prover")]
pub mod bezier;
#[cfg(feature = "prover")]
pub mod geometry;
#[cfg(feature = "prover")]
pub mod elimination;
#[cfg(feature = "prover")]
pub mod catalogue;
#[cfg(feature = "prover")]
pub mod prove;
#[cfg(feature = "prover")]
pub mod approximation;
#[cfg(feature = "prover")]
pub mod construction;
#[cfg(feature = "prover")]
pub mod expand;
#[cfg(feature = "prover")]
pub mod listing;
#[cfg(feature = "prover")]
pub mod audit;
#[cfg(feature = "prover")]
pub mod figure;
#[cfg(feature = "prover")]
pub mod report;
#[cfg(feature = "prover")]
pub mod export;

pub mod cli;
