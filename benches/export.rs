//! What it costs to write a proof in another language, for the bicubic cap and the largest committed proof. What it costs to verify it there
//! is told by `scripts/outside`.

use divan::Bencher;
use prove_cap::certificate::Certificate;
use prove_cap::exact::Work;
use prove_cap::formats::export::{Case, Target, export};
use prove_cap::statement::Statement;

fn main() {
    divan::main();
}

const CASES: [&str; 2] = ["cap-3x3", "cap-4x3"];

fn write(bencher: Bencher, name: &str, target: Target) {
    let file = |file: &str| std::fs::read_to_string(format!("proofs/{name}/{file}")).unwrap();
    let statement = Statement::read(&file("statement.toml")).unwrap();
    let unknowns = statement.unknowns().len();
    let certificate = file("certificate.txt");
    let certificate =
        Certificate::read(certificate.as_bytes(), &statement.ring(), unknowns, &mut Work::full()).unwrap();
    let case = Case::new(&statement, &certificate).unwrap();
    bencher.bench(|| export(&case, target).unwrap());
}

#[divan::bench(args = CASES)]
fn coq(bencher: Bencher, name: &str) {
    write(bencher, name, Target::Coq);
}

#[divan::bench(args = CASES)]
fn singular(bencher: Bencher, name: &str) {
    write(bencher, name, Target::Singular);
}

#[divan::bench(args = CASES)]
fn pac(bencher: Bencher, name: &str) {
    write(bencher, name, Target::Pac);
}

#[divan::bench(args = CASES)]
fn lean(bencher: Bencher, name: &str) {
    write(bencher, name, Target::Lean);
}
