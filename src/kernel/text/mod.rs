//! The text of certificates: lines, numbers and the hash that seals some of them. What the lines mean is for the claims.

mod error;
mod reader;
mod seal;

pub use error::{CertificateError, CertificateFault};
pub(crate) use reader::{Reader, check_text, column};
pub(crate) use seal::seal;
