//! Enclosures of the radius by the digits asked for, the checker alone, and the best values of the paper's patch.

use divan::Bencher;
use prove_cap::approximation::{Objective, Search, approximate, enclose};
use prove_cap::catalogue;
use prove_cap::checker::check_read;
use prove_cap::control::Control;
use prove_cap::exact::{Polynomial, Work};
use prove_cap::statement::Statement;

fn main() {
    divan::main();
}

fn paper() -> (Statement, Vec<Polynomial>) {
    let statement = Statement::read(&catalogue::find("cap-2x2").unwrap().statement()).unwrap();
    let value = |text| Statement::read_constant(text, statement.field(), &mut Work::full()).unwrap();
    let values = ["0.467959158138040", "2.370695072453977"].map(value).to_vec();
    (statement, values)
}

#[divan::bench(args = [6, 12, 24, 48, 96], sample_count = 10)]
fn enclosure(bencher: Bencher<'_, '_>, places: u32) {
    let (statement, values) = paper();
    bencher.bench(|| enclose(&statement, &values, places, &Control::default()).unwrap());
}

#[divan::bench(args = [6, 12, 24, 48, 96], sample_count = 10)]
fn check_of_an_enclosure(bencher: Bencher<'_, '_>, places: u32) {
    let (statement, values) = paper();
    let enclosure = enclose(&statement, &values, places, &Control::default()).unwrap();
    bencher.bench(|| check_read(&statement, enclosure.proof.certificate()).unwrap());
}

#[divan::bench(sample_count = 3)]
fn best_minimax() {
    let (statement, _) = paper();
    let search =
        Search { objective: Objective::Minimax, points: 101, pass: vec![], places: Some(12), seed: 1 };
    approximate(&statement, &search, &Control::default()).unwrap();
}
