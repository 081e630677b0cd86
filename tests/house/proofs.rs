//! The committed proofs: complete, reproducible to the byte, and refused after the smallest change.

use std::fs;
use std::path::Path;

use proptest::prelude::*;
use prove_cap::catalogue::{self, ENTRIES};
use prove_cap::certificate::{Argument, Certificate, Premise};
use prove_cap::checker::{CheckError, Claim, ExactRejection, Rejection, check, check_read};
use prove_cap::control::Control;
use prove_cap::exact::{Arithmetic, Polynomial, Radicands, Work};
use prove_cap::prove::{Attempt, prove};
use prove_cap::statement::Statement;

fn committed(name: &str, file: &str) -> String {
    let path = Path::new("proofs").join(name).join(file);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn read(name: &str) -> (Statement, Certificate, String) {
    let statement = Statement::read(&committed(name, "statement.toml")).unwrap();
    let text = committed(name, "certificate.txt");
    let certificate =
        Certificate::read(text.as_bytes(), &statement.ring(), statement.unknowns().len(), &mut Work::full())
            .unwrap();
    (statement, certificate, text)
}

#[test]
fn every_built_in_statement_has_its_committed_proof() {
    for entry in ENTRIES {
        let text = entry.statement();
        assert_eq!(text, committed(entry.name, "statement.toml"), "{}: run prove-cap prove {0}", entry.name);
        let statement = Statement::read(&text).unwrap();
        for _ in 0..3 {
            let attempt = prove(&statement, &Control::default()).unwrap();
            let Attempt::Proved { proof, .. } = attempt else { panic!("{} is undecided", entry.name) };
            let certificate = proof.certificate();
            let theorem = proof.theorem();
            let written = certificate.write(&statement.ring());
            assert_eq!(written, committed(entry.name, "certificate.txt"), "{}", entry.name);
            let impossible = !entry.summary.starts_with("positive control");
            assert_eq!(matches!(theorem.claim(), Claim::Impossible(_)), impossible, "{}", entry.name);
        }
        let theorem = check(text.as_bytes(), committed(entry.name, "certificate.txt").as_bytes()).unwrap();
        assert!(theorem.sentence().contains(&statement.field().to_string()) || !entry.is_cap());
    }
}

#[test]
fn a_proof_is_refused_for_every_other_statement() {
    for entry in ENTRIES {
        for other in ENTRIES.iter().filter(|other| other.name != entry.name) {
            let (statement, certificate) = (other.statement(), committed(entry.name, "certificate.txt"));
            let result = check(statement.as_bytes(), certificate.as_bytes());
            assert!(
                matches!(result, Err(CheckError::Rejected(_) | CheckError::Certificate(_))),
                "{} for {}: {result:?}",
                entry.name,
                other.name
            );
        }
    }
}

/// Even with the right hash written into it, a refutation does not carry over to a statement that has a solution.
#[test]
fn a_forged_hash_helps_nothing() {
    let (_, certificate, _) = read("cap-2x2-centre");
    let consistent = Statement::read(&committed("octant", "statement.toml")).unwrap();
    let forged = Certificate { statement: consistent.hash(), ..certificate };
    let result = check_read(&consistent, &forged);
    assert!(matches!(result, Err(CheckError::Rejected(_) | CheckError::Certificate(_))), "{result:?}");
}

/// Each text that differs from a certificate in one byte (replaced, inserted or left out), for all printable bytes.
fn one_character_mutants_are_refused(name: &str) {
    let (statement, _, text) = read(name);
    let (ring, unknowns) = (statement.ring(), statement.unknowns().len());
    let bytes = text.as_bytes();
    let refused = |mutant: &[u8]| match Certificate::read(mutant, &ring, unknowns, &mut Work::full()) {
        Err(_) => true,
        Ok(certificate) => check_read(&statement, &certificate).is_err(),
    };
    let alphabet: Vec<u8> = (b' '..=b'~').chain([b'\n', b'\r', b'\t', 0, 0xC3]).collect();
    let try_at = |at: usize| {
        let (before, after) = bytes.split_at(at);
        for &byte in &alphabet {
            let inserted = [before, &[byte], after].concat();
            assert!(refused(&inserted), "{name}: {byte:?} inserted at {at}");
            if after.first().is_some_and(|&old| old != byte) {
                let replaced = [before, &[byte], &after[1..]].concat();
                assert!(refused(&replaced), "{name}: {byte:?} put at {at}");
            }
        }
        if !after.is_empty() {
            assert!(refused(&[before, &after[1..]].concat()), "{name}: byte {at} left out");
            assert!(refused(before), "{name}: cut at {at}");
        }
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for thread in 0..threads {
            let try_at = &try_at;
            scope.spawn(move || (thread..=bytes.len()).step_by(threads).for_each(try_at));
        }
    });
    println!("{name}: {} mutants refused", (bytes.len() + 1) * 2 * (alphabet.len() + 1));
}

#[test]
fn one_character_mutants_of_the_papers_proof_are_refused() {
    one_character_mutants_are_refused("cap-2x2");
    one_character_mutants_are_refused("stereographic");
}

#[test]
#[ignore = "two million mutants take minutes"]
fn one_character_mutants_of_every_proof_are_refused() {
    for entry in ENTRIES.iter().filter(|entry| committed(entry.name, "certificate.txt").len() <= 20_000) {
        one_character_mutants_are_refused(entry.name);
    }
}

/// A structural change: a multiplier, a premise, a conclusion, the order or the number of steps.
fn changed(
    field: &Radicands,
    certificate: &Certificate,
    kind: u8,
    step: usize,
    place: usize,
    by: i32,
) -> Certificate {
    let mut changed = certificate.clone();
    let Argument::Impossible(steps) = &mut changed.argument else { panic!("a refutation") };
    let step = step % steps.len();
    let nudge = |polynomial: &Polynomial, by: i32| {
        let summands = [polynomial.clone(), Polynomial::integer(by)];
        Arithmetic::new(field, &mut Work::full()).sum(&summands).unwrap()
    };
    let length = steps[step].combination.len();
    match kind {
        0 => {
            let multiplier = &mut steps[step].combination[place % length].1;
            *multiplier = nudge(multiplier, by);
        }
        1 => steps[step].conclusion = nudge(&steps[step].conclusion, by),
        2 => drop(steps[step].combination.remove(place % length)),
        3 => {
            steps[step].combination[place % length].0 =
                Premise::Coefficient(place as u32 % 9, by.unsigned_abs() % 9);
        }
        4 => steps[step].combination[place % length].0 = Premise::Step(by.unsigned_abs() % 6),
        5 => drop(steps.remove(step)),
        6 => {
            let other = place % steps.len();
            steps.swap(step, other);
        }
        _ => {
            let copy = steps[step].clone();
            steps.insert(step, copy);
        }
    }
    changed
}

/// Whether two steps are always used together with the same multiplier: exchanged, they are another proof.
/// (Steps 12 and 16 of cap-4x2 are.)
fn are_interchangeable(certificate: &Certificate, step: usize, place: usize) -> bool {
    let Argument::Impossible(steps) = &certificate.argument else { panic!("a refutation") };
    let names = [step, place].map(|index| Premise::Step((index % steps.len()) as u32 + 1));
    steps.iter().all(|user| {
        let multiplier = |name| user.combination.iter().find(|(premise, _)| *premise == name).map(|(_, p)| p);
        multiplier(names[0]) == multiplier(names[1])
    })
}

fn structural_mutants_are_refused(name: &str, kind: u8, step: usize, place: usize, by: i32) {
    let (statement, certificate, _) = read(name);
    let mutant = changed(statement.field(), &certificate, kind, step, place, by);
    if mutant != certificate && !(kind == 6 && are_interchangeable(&certificate, step, place)) {
        assert!(
            check_read(&statement, &mutant).is_err(),
            "{name}: kind {kind}, step {step}, place {place}, by {by}"
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    #[test]
    fn structural_mutants_of_the_caps_are_refused(
        which in 0usize..9, kind in 0u8..8, step in 0usize..40, place in 0usize..40,
        by in prop_oneof![-9i32..0, 1i32..10],
    ) {
        let caps: Vec<_> = ENTRIES.iter().filter(|entry| entry.is_cap()).collect();
        structural_mutants_are_refused(caps[which % caps.len()].name, kind, step, place, by);
    }
}

#[test]
fn an_exact_claim_with_a_changed_value_is_refused() {
    for name in ["octant", "stereographic"] {
        let (statement, certificate, _) = read(name);
        let Argument::Exact(original) = &certificate.argument else { panic!("a net") };
        for k in 0..original.len() {
            let mut values = original.clone();
            let summands = [values[k].clone(), Polynomial::integer(1)];
            values[k] = Arithmetic::new(statement.field(), &mut Work::full()).sum(&summands).unwrap();
            let forged = Certificate { argument: Argument::Exact(values), ..certificate.clone() };
            let result = check_read(&statement, &forged);
            assert!(matches!(result, Err(CheckError::Rejected(_))), "{name}, value {k}: {result:?}");
        }
    }
}

/// One wrong sign in Cobb's net, at each of its entries in turn, and a coefficient that does not vanish is named.
#[test]
fn a_flipped_sign_in_cobbs_net_is_found() {
    let text = committed("cobb", "statement.toml");
    let start = text.find("net = [").unwrap();
    let quotes: Vec<usize> = text[start..].match_indices('"').map(|(at, _)| start + at).collect();
    for pair in quotes.chunks(2).step_by(7) {
        let entry = &text[pair[0] + 1..pair[1]];
        if entry == "0" {
            continue;
        }
        let flipped = format!("{}\"-({entry})\"{}", &text[..pair[0]], &text[pair[1] + 1..]);
        let statement = Statement::read(&flipped).unwrap();
        let claim = Certificate { statement: statement.hash(), argument: Argument::Exact(Vec::new()) };
        let result = check_read(&statement, &claim);
        assert!(
            matches!(result, Err(CheckError::Rejected(Rejection::Exact(ExactRejection::NotAZero { .. })))),
            "{entry}: {result:?}"
        );
    }
}

#[test]
fn names_are_unique_and_found() {
    for entry in ENTRIES {
        assert_eq!(catalogue::find(entry.name).unwrap().summary, entry.summary);
    }
    assert!(catalogue::find("cap-1x1").is_none());
}
