//! Proving and checking every built-in statement.
//!
//! `cargo bench --bench proofs`, with `--features gmp` for the other backend.

use prove_cap::catalogue::{ENTRIES, find};
use prove_cap::checker::check;
use prove_cap::control::Control;
use prove_cap::prove::{Attempt, prove};
use prove_cap::statement::Statement;

fn main() {
    divan::main();
}

fn names() -> impl Iterator<Item = &'static str> {
    ENTRIES.iter().map(|entry| entry.name)
}

fn text(name: &str) -> String {
    find(name).expect("a built-in name").statement()
}

#[divan::bench(args = names())]
fn proving(bencher: divan::Bencher, name: &str) {
    let statement = Statement::read(&text(name)).expect("well formed");
    bencher.bench(|| prove(&statement, &Control::default()));
}

/// From the bytes of both files to the theorem.
#[divan::bench(args = names())]
fn checking(bencher: divan::Bencher, name: &str) {
    let text = text(name);
    let statement = Statement::read(&text).expect("well formed");
    let Ok(Attempt::Proved { proof, .. }) = prove(&statement, &Control::default()) else { return };
    let certificate = proof.certificate();
    let certificate = certificate.write(&statement.ring());
    bencher.bench(|| check(text.as_bytes(), certificate.as_bytes()).expect("verified"));
}
