//! Foreign texts: printed formulas and nets that are read, proofs that are written for other programs.

mod audit;
mod export_coq;
mod export_lean;
mod export_pac;
mod export_scripts;
mod lean;
mod listing;
mod nets;
mod pac;
#[path = "../support/mod.rs"]
mod support;
