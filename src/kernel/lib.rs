//! The trusted part of `prove-cap`: what is claimed, how it is argued, and the checker that holds the argument
//! against the claim.
//!
//! A crate of its own, so that the compiler keeps the boundary: nothing here can name the prover. It stands on
//! integers, rationals, SHA-256 and a TOML reader, and is a program too, `prove-cap-check`. The modules are layers:
//! each uses those above it only.
//!
//! ```
//! use prove_cap_kernel::checker::{Claim, check};
//!
//! let statement = std::fs::read("../../proofs/cap-2x2/statement.toml")?;
//! let certificate = std::fs::read("../../proofs/cap-2x2/certificate.txt")?;
//! let theorem = check(&statement, &certificate).expect("the committed proof is right");
//! assert!(matches!(theorem.claim(), Claim::Impossible(_)));
//! println!("{}", theorem.sentence());
//! # Ok::<(), std::io::Error>(())
//! ```

pub mod exact;
pub mod statement;
mod text;
mod equations;
mod failure;
mod claims;
pub mod certificate;
pub mod checker;
pub mod outcome;
pub mod command;
