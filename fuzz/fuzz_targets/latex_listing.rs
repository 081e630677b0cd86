//! LaTeX listings: read, evaluated, printed and read back.
#![no_main]

use libfuzzer_sys::fuzz_target;
use prove_cap::exact::{Radicands, Ring, Work};
use prove_cap::formats::listing::{Notation, Scope};
use prove_cap::report::latex::formula;

fuzz_target!(|text: &str| {
    let Ok(formulas) = Notation::Latex.read(text) else { return };
    let field = Radicands::new(vec![2, 3]).unwrap();
    let variables = vec!["w".to_owned(), "z".to_owned(), "w11".to_owned()];
    let scope = Scope::of(&field, &variables);
    let ring = Ring { field, variables };
    for read in formulas {
        let Ok(value) = read.expression.value(text, &scope, &mut Work::full()) else { continue };
        if value.term_count() > 200 {
            continue;
        }
        let printed = format!("a_1 = {}", formula(&ring, &value));
        let again = Notation::Latex.read(&printed).expect(&printed);
        let again = again[0].expression.value(&printed, &scope, &mut Work::full()).expect(&printed);
        assert_eq!(again, value, "{printed}");
    }
});
