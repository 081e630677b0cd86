//! Committed proofs, and damaged copies of them, for the tests of exports.

use std::fs;
use std::path::Path;

use prove_cap::certificate::{Argument, Certificate, Step};
use prove_cap::control::Control;
use prove_cap::exact::{Polynomial, Work};
use prove_cap::prove::{Attempt, prove};
use prove_cap::statement::Statement;

/// Says that a program is not installed. Where `PROVE_CAP_REQUIRE` names it (`coq,singular,…`), that is a failure.
pub(crate) fn not_run(program: &str) {
    let required = std::env::var("PROVE_CAP_REQUIRE").unwrap_or_default();
    assert!(!required.split(',').any(|name| name == program), "{program} is required and not installed");
    println!("not run: {program} is not installed");
}

/// The folder of the largest proof.
pub(crate) const LARGEST: &str = "cap-4x3";

/// A certificate's text for a statement.
pub(crate) fn parsed(statement: &Statement, text: &str) -> Certificate {
    let unknowns = statement.unknowns().len();
    Certificate::read(text.as_bytes(), &statement.ring(), unknowns, &mut Work::full()).unwrap()
}

/// The committed proof in a folder of proofs/.
pub(crate) fn committed(folder: impl AsRef<Path>) -> (Statement, Certificate) {
    let file = |name: &str| fs::read_to_string(Path::new("proofs").join(&folder).join(name)).unwrap();
    let statement = Statement::read(&file("statement.toml")).unwrap();
    let certificate = parsed(&statement, &file("certificate.txt"));
    (statement, certificate)
}

/// A statement's text, proved now.
pub(crate) fn proved(text: &str) -> (Statement, Certificate) {
    let statement = Statement::read(text).unwrap();
    let Ok(Attempt::Proved { proof, .. }) = prove(&statement, &Control::default()) else {
        panic!("not proved: {text}")
    };
    let certificate = proof.certificate();
    (statement, certificate.clone())
}

/// A refutation with something done to its steps.
pub(crate) fn damaged(certificate: &Certificate, damage: impl FnOnce(&mut Vec<Step>)) -> Certificate {
    let mut damaged = certificate.clone();
    let Argument::Impossible(steps) = &mut damaged.argument else { panic!("a refutation") };
    damage(steps);
    damaged
}

/// −p.
pub(crate) fn negated(polynomial: &Polynomial) -> Polynomial {
    Polynomial::from_terms(polynomial.terms().map(|(monomial, c)| (monomial.clone(), -c.clone())))
}

/// All folders of proofs/ that hold a statement, but that of the largest proof, whose exports are megabytes.
pub(crate) fn folders() -> Vec<String> {
    let mut found = Vec::new();
    let mut open = vec![String::new()];
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(Path::new("proofs").join(&folder)).unwrap() {
            let entry = entry.unwrap();
            let name = entry.file_name().into_string().unwrap();
            if entry.file_type().unwrap().is_dir() {
                open.push(if folder.is_empty() { name } else { format!("{folder}/{name}") });
            } else if name == "statement.toml" && folder != LARGEST {
                found.push(folder.clone());
            }
        }
    }
    found.sort();
    found
}

/// Of those the ones with a refutation.
pub(crate) fn refutations() -> Vec<String> {
    let refutes = |folder: &String| matches!(committed(folder).1.argument, Argument::Impossible(_));
    folders().into_iter().filter(refutes).collect()
}
