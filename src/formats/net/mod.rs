//! Control nets as other programs print them.

mod document;
mod json;
mod matlab;
mod printed;

pub use crate::statement::Convention;
pub use document::statement_from_json;
pub use json::from_json;
pub use matlab::from_matlab;
pub use printed::{PrintedNet, premultiplied};

use crate::exact::Limit;
use crate::formats::listing::ListingError;

/// Why a net cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum NetError {
    /// In words, with the place.
    #[error("{0}")]
    Net(String),
    /// An expression in it.
    #[error("{0}")]
    Expression(#[from] ListingError),
    /// A number exceeds what the formats allow.
    #[error("{0}")]
    Limit(#[from] Limit),
}
