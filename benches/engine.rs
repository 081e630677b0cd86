//! The engine's kernels: products in K, elimination modulo p, exact lifting.
//!
//! `cargo bench --bench engine`, with `--features gmp` for the other backend.

use prove_cap::algebra::{FieldElement, Integer, MultiquadraticField, PrimeField, splitting_primes};
use prove_cap::control::Control;
use prove_cap::elimination::{Echelon, SparseRow, solve};

fn main() {
    divan::main();
}

/// Numbers that do not repeat (Knuth, TAOCP 2, section 3.3.4).
fn numbers() -> impl FnMut() -> u64 {
    let mut state = 1u64;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        state >> 33
    }
}

fn element(field: MultiquadraticField, words: usize, next: &mut impl FnMut() -> u64) -> FieldElement {
    let word = Integer::from(1i64 << 31);
    let numerators = (0..field.degree()).map(|_| {
        (0..words).fold(Integer::zero(), |value, _| &(&value * &word) + &Integer::from((next() >> 1) as i64))
    });
    field.element(numerators.collect(), Integer::one())
}

/// Two elements of Q(√2,√3) with coordinates of so many 31-bit words.
#[divan::bench(args = [1, 4, 16, 64, 256])]
fn product_in_k(bencher: divan::Bencher, words: usize) {
    let field = MultiquadraticField::new(&[2, 3]);
    let mut next = numbers();
    let (a, b) = (element(field, words, &mut next), element(field, words, &mut next));
    bencher.bench(|| divan::black_box(&a) * divan::black_box(&b));
}

/// Sparse rows, 20 entries each, of a regular square matrix.
fn rows(size: usize, prime: &PrimeField) -> Vec<SparseRow> {
    let mut next = numbers();
    let row = |k: usize| {
        let mut row: SparseRow = vec![(k as u32, 1)];
        row.extend((0..20).map(|_| ((next() % size as u64) as u32, next() % prime.modulus())));
        row.sort_by_key(|&(column, _)| std::cmp::Reverse(column));
        row.dedup_by_key(|&mut (column, _)| column);
        row.retain(|&(_, value)| value != 0);
        row
    };
    (0..size).map(row).collect()
}

#[divan::bench(args = [250, 500, 1000, 2000], sample_count = 10)]
fn echelon_modulo_p(bencher: divan::Bencher, size: usize) {
    let prime = splitting_primes(MultiquadraticField::new(&[2, 3])).next().expect("there are many");
    let rows = rows(size, &prime);
    bencher.bench(|| {
        let mut echelon = Echelon::new(prime.clone());
        for (id, row) in (0..).zip(&rows) {
            let _ = echelon.insert(id, row, &Control::default()).expect("nobody stops it");
        }
        echelon.pivots().count()
    });
}

/// Entries a + b√2 + c√3 + d√6 of up to 17 bits, the size of the caps' coefficients.
#[divan::bench(args = [25, 50, 100, 200], sample_count = 5)]
fn exact_solution(bencher: divan::Bencher, size: usize) {
    let field = MultiquadraticField::new(&[2, 3]);
    let prime = splitting_primes(field).next().expect("there are many");
    let mut next = numbers();
    let exact: Vec<Vec<(u32, FieldElement)>> = rows(size, &prime)
        .iter()
        .map(|row| {
            let mut entry = || {
                let coordinates = (0..4).map(|_| Integer::from((next() % (1 << 17)) as i64)).collect();
                field.element(coordinates, Integer::one())
            };
            row.iter().map(|&(column, _)| (column, entry())).collect()
        })
        .collect();
    let images: Vec<SparseRow> = exact
        .iter()
        .map(|row| {
            row.iter().map(|(column, value)| (*column, prime.reduce(value).expect("integral"))).collect()
        })
        .collect();
    let entry = |k: usize, column: u32| {
        exact[k].iter().find(|&&(at, _)| at == column).map(|(_, value)| value.clone())
    };
    bencher.bench(|| {
        solve(&images, entry, |_| Some(field.one()), &prime, field, &Control::default())
            .expect("not interrupted")
    });
}
