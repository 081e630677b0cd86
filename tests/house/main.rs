//! The house: committed proofs, documents, the order of the modules, what the crates stand on.

mod dependencies;
mod documents;
mod layering;
mod proofs;
