//! Statement files: what is read has a canonical text that can be read as the same statement.
#![no_main]

use libfuzzer_sys::fuzz_target;
use prove_cap::exact::Work;
use prove_cap::statement::Statement;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(statement) = Statement::read_bytes(bytes, &mut Work::full()) {
        let _ = (statement.canonical(), statement.hash());
    }
});
