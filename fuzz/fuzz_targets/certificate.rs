//! Certificates, held against the paper's statement: none but the committed one is accepted.
#![no_main]

use libfuzzer_sys::fuzz_target;
use prove_cap::checker::check;

fuzz_target!(|bytes: &[u8]| {
    const STATEMENT: &[u8] = include_bytes!("../../proofs/cap-2x2/statement.toml");
    const PROOF: &[u8] = include_bytes!("../../proofs/cap-2x2/certificate.txt");
    // Another proof of the same theorem is no bug, but nothing short of a miracle in random bytes.
    assert!(check(STATEMENT, bytes).is_err() || bytes == PROOF);
});
