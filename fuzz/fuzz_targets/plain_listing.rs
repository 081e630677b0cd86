//! Plain listings and listing files.
#![no_main]

use libfuzzer_sys::fuzz_target;
use prove_cap::exact::{Radicands, Work};
use prove_cap::formats::listing::{Listing, Notation, Scope};

fuzz_target!(|text: &str| {
    let _ = Listing::from_toml(text);
    let Ok(formulas) = Notation::Plain.read(text) else { return };
    let scope = Scope::of(&Radicands::new(vec![2, 3]).unwrap(), &["w".to_owned(), "z".to_owned()]);
    for read in formulas {
        let _ = read.expression.value(text, &scope, &mut Work::full());
    }
});
