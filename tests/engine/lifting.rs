//! Exact solutions by p-adic lifting, against the equations they are to solve.

use proptest::prelude::*;
use prove_cap::algebra::{FieldElement, Integer, MultiquadraticField, PrimeField, splitting_primes};
use prove_cap::control::Control;
use prove_cap::elimination::{Echelon, Inserted, SparseRow, solve};

/// Square, by columns: `matrix[k]` is row k of Σ xₖ · rowₖ = right.
type Matrix = Vec<Vec<FieldElement>>;

fn prime(field: MultiquadraticField) -> PrimeField {
    splitting_primes(field).next().unwrap()
}

/// The images of the rows modulo p, by decreasing column.
fn images(matrix: &Matrix, prime: &PrimeField) -> Vec<SparseRow> {
    let image = |row: &Vec<FieldElement>| {
        let entries =
            row.iter().enumerate().rev().map(|(at, value)| (at as u32, prime.reduce(value).unwrap()));
        entries.filter(|&(_, value)| value != 0).collect()
    };
    matrix.iter().map(image).collect()
}

fn solution(matrix: &Matrix, right: &[FieldElement]) -> Option<(Vec<FieldElement>, Integer)> {
    let field = right[0].field();
    let prime = prime(field);
    let nonzero = |value: &FieldElement| (!value.is_zero()).then(|| value.clone());
    let entry = |k: usize, column: u32| nonzero(&matrix[k][column as usize]);
    let right = |column: u32| nonzero(&right[column as usize]);
    solve(&images(matrix, &prime), entry, right, &prime, field, &Control::default()).unwrap()
}

fn element(field: MultiquadraticField) -> impl Strategy<Value = FieldElement> {
    let number = prop_oneof![3 => Just(0i64), 4 => -9i64..10, 1 => any::<i32>().prop_map(i64::from), 1 => any::<i64>()];
    (proptest::collection::vec(number, field.degree()), 1i64..12).prop_map(
        move |(numerators, denominator)| {
            field.element(numerators.into_iter().map(Integer::from).collect(), Integer::from(denominator))
        },
    )
}

fn system(radicands: &'static [u32]) -> impl Strategy<Value = (Matrix, Vec<FieldElement>)> {
    let field = MultiquadraticField::new(radicands);
    (1usize..7).prop_flat_map(move |size| {
        let row = move || proptest::collection::vec(element(field), size);
        (proptest::collection::vec(row(), size), row())
    })
}

fn check(matrix: &Matrix, right: &[FieldElement]) -> Result<(), TestCaseError> {
    let field = right[0].field();
    let prime = prime(field);
    let mut echelon = Echelon::new(prime.clone());
    let mut rank = 0;
    for (id, row) in (0..).zip(images(matrix, &prime)) {
        rank += usize::from(matches!(echelon.insert(id, &row, &Control::default()), Ok(Inserted::Pivot(_))));
    }
    let regular = rank == matrix.len();
    let Some((x, denominator)) = solution(matrix, right) else {
        prop_assert!(!regular, "a regular system has a solution");
        return Ok(());
    };
    prop_assert!(regular);
    let denominator = field.rational(denominator, Integer::one());
    for (column, value) in right.iter().enumerate() {
        let sum = matrix.iter().zip(&x).fold(field.zero(), |sum, (row, x)| &sum + &(&row[column] * x));
        prop_assert_eq!(sum, &denominator * value);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn over_the_rationals((matrix, right) in system(&[])) {
        check(&matrix, &right)?;
    }

    #[test]
    fn over_two_roots((matrix, right) in system(&[2, 3])) {
        check(&matrix, &right)?;
    }

    #[test]
    fn over_four_roots((matrix, right) in system(&[2, 3, 5, 7])) {
        check(&matrix, &right)?;
    }
}

/// Numbers of a thousand digits, beyond what fits in words.
#[test]
fn long_entries_are_lifted_too() {
    let field = MultiquadraticField::new(&[2]);
    let long = (0..100).fold(Integer::one(), |product, k| &product * &Integer::from(1_000_000_007i64 + k));
    let of = |a: &Integer, b: i64| field.element(vec![a.clone(), Integer::from(b)], Integer::one());
    let matrix = vec![
        vec![of(&long, 3), of(&Integer::from(2i64), 1)],
        vec![of(&Integer::from(5i64), -7), of(&long, 0)],
    ];
    let right = vec![field.integer(1), of(&long, 11)];
    check(&matrix, &right).unwrap();
}

#[test]
fn dependent_rows_are_refused() {
    let field = MultiquadraticField::new(&[3]);
    let row = |a: i64| vec![field.integer(a), field.integer(2 * a)];
    assert!(solution(&vec![row(1), row(5)], &[field.one(), field.one()]).is_none());
}
