//! The last line of an argument by subdivision: how many boxes there are, and the hash of all that precedes.
//!
//! Many trees and many sums argue for the same bounds, so that unlike the steps of a refutation they do not check each
//! other. The hash is not evidence of anything: it makes sure that a file that was damaged is not read at all.

use sha2::{Digest, Sha256};

/// The line `end COUNT HASH` for the text before it.
pub(crate) fn seal(text: &str, count: usize) -> String {
    let digest = Sha256::digest(text.as_bytes());
    let hash: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
    format!("end {count} {hash}")
}
