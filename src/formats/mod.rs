//! Every foreign text: what is read of other programs and of papers, and what is written for them.

pub mod export;
pub mod listing;
pub mod net;
pub mod statement_file;
