//! Control nets in JSON and in MATLAB's notation.
#![no_main]

use libfuzzer_sys::fuzz_target;
use prove_cap::formats::net::{Convention, from_json, from_matlab};

fuzz_target!(|text: &str| {
    let _ = from_json(text);
    let _ = from_matlab(text, "fuzz", Convention::Cartesian);
});
