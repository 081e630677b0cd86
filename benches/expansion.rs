//! Expansion of the sphere condition for bidegree (m,m) with all inner control points unknown.
//!
//! `cargo bench --bench expansion`, with `--features gmp` for the other backend.

use prove_cap::bezier::surface_condition;
use prove_cap::catalogue::{Cap, Interior, Symmetry};
use prove_cap::problem::field_of;
use prove_cap::statement::{Statement, Subject};

fn main() {
    divan::main();
}

/// The cap's statement of bidegree (m,m): 4(m−1)² unknowns.
fn statement(m: u32) -> Statement {
    let cap = Cap { bidegree: (m, m), interior: Interior::Free(Symmetry::None), corner_weight: false };
    Statement::read(&cap.statement()).expect("a generated statement is well formed")
}

#[divan::bench(args = [2, 3, 4, 6, 8, 12, 16])]
fn expand(bencher: divan::Bencher, m: u32) {
    let statement = statement(m);
    let Subject::Patch(patch) = statement.subject() else { return };
    bencher.bench(|| surface_condition(field_of(&statement), patch));
}

#[divan::bench(args = [2, 3, 4, 6, 8, 12, 16])]
fn expand_in_the_checker(bencher: divan::Bencher, m: u32) {
    let statement = statement(m);
    bencher.bench(|| prove_cap::checker::Equations::of(&statement, &mut prove_cap::exact::Work::full()));
}
