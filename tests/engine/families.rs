//! The families of caps by name: what their nets say, and names that are refused.

use prove_cap::bezier::BernsteinForm;
use prove_cap::catalogue::{Cap, cap};
use prove_cap::control::Control;
use prove_cap::problem::Problem;
use prove_cap::statement::Statement;

fn condition(statement: &Statement) -> BernsteinForm {
    let problem = Problem::of(statement);
    problem.condition(&Control::default()).unwrap().unwrap().clone()
}

fn family(name: &str) -> Cap {
    cap(name).unwrap_or_else(|| panic!("{name}")).unwrap_or_else(|fault| panic!("{fault}"))
}

fn statement(name: &str) -> Statement {
    Statement::read(&family(name).statement()).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn refusal(name: &str) -> String {
    cap(name).unwrap_or_else(|| panic!("{name}")).unwrap_err()
}

/// The entries of the net as they are written, row by row.
fn entries(name: &str) -> Vec<Vec<Vec<String>>> {
    let cap = family(name);
    let text = cap.statement();
    // One point to a line, each entry in quotes.
    let points = text.lines().filter(|line| line.starts_with("    ["));
    let point = |line: &str| line.split('"').skip(1).step_by(2).map(str::to_owned).collect();
    let points: Vec<Vec<String>> = points.map(point).collect();
    points.chunks(cap.bidegree.1 as usize + 1).map(<[Vec<String>]>::to_vec).collect()
}

/// The rank modulo a prime of integer rows; never more than over Q.
fn rank(mut rows: Vec<Vec<i64>>) -> usize {
    const P: i64 = 1_000_003;
    let power = |base: i64, exponent: i64| {
        (0..exponent.ilog2() + 1).rev().fold(1, |result, bit| {
            let square = result * result % P;
            if exponent >> bit & 1 == 1 { square * base % P } else { square }
        })
    };
    let width = rows.first().map_or(0, Vec::len);
    let mut rank = 0;
    for column in 0..width {
        let Some(pivot) = (rank..rows.len()).find(|&row| rows[row][column] % P != 0) else { continue };
        rows.swap(rank, pivot);
        let inverse = power(rows[rank][column].rem_euclid(P), P - 2);
        let pivot_row = rows[rank].clone();
        for row in &mut rows[rank + 1..] {
            let factor = row[column] * inverse % P;
            for (value, of_pivot) in row.iter_mut().zip(&pivot_row) {
                *value = (*value - factor * of_pivot) % P;
            }
        }
        rank += 1;
    }
    rank
}

/// Without symmetry the parts are only other coordinates: every interior whatever is of that form.
#[test]
fn without_symmetry_the_inner_numbers_are_independent() {
    for name in ["cap-2x2", "cap-3x2", "cap-3x3", "cap-4x2", "cap-2x4", "cap-4x3", "cap-4x4", "cap-5x3"] {
        let statement = statement(name);
        let net = entries(name);
        let inner = net[1..net.len() - 1].iter().flat_map(|row| &row[1..row.len() - 1]).flatten();
        let rows: Vec<Vec<i64>> = inner
            .map(|entry| {
                let signed = entry.replace("- ", "-");
                let terms: Vec<&str> = signed.split([' ', '+']).filter(|term| !term.is_empty()).collect();
                let coefficient = |unknown: &String| {
                    terms
                        .iter()
                        .map(|term| i64::from(term == unknown) - i64::from(*term == format!("-{unknown}")))
                        .sum()
                };
                statement.unknowns().iter().map(coefficient).collect()
            })
            .collect();
        assert_eq!(rows.len(), statement.unknowns().len(), "{name}");
        assert_eq!(rank(rows), statement.unknowns().len(), "{name}");
    }
}

/// What the symmetry of a net means for the condition: mirror images of a coefficient are equal.
#[test]
fn symmetric_nets_have_symmetric_coefficients() {
    type Image = fn(u32, u32, u32, u32) -> (u32, u32);
    let half_turn: Image = |m, n, r, s| (2 * m - r, 2 * n - s);
    let reflection: Image = |m, _, r, s| (2 * m - r, s);
    let quarter_turn: Image = |m, _, r, s| (s, 2 * m - r);
    let cases: &[(&str, &[Image], &[Image])] = &[
        ("cap-3x2", &[], &[half_turn, reflection]),
        ("cap-3x2-c2", &[half_turn], &[reflection]),
        ("cap-4x3-c2", &[half_turn], &[reflection]),
        ("cap-4x3-d2", &[half_turn, reflection], &[]),
        ("cap-3x3-d2", &[half_turn, reflection], &[quarter_turn]),
        ("cap-3x3-c4", &[half_turn, quarter_turn], &[reflection]),
        ("cap-4x4-d4", &[half_turn, quarter_turn, reflection], &[]),
        ("cap-3x3-c2-weights", &[half_turn], &[reflection, quarter_turn]),
        ("cap-3x2-weights", &[], &[half_turn, reflection]),
    ];
    for (name, kept, broken) in cases {
        let statement = statement(name);
        let form = condition(&statement);
        let (m, n) = (form.bidegree().0 / 2, form.bidegree().1 / 2);
        let holds = |image: &Image| {
            form.coefficients().all(|(r, s, value)| {
                let (a, b) = image(m, n, r, s);
                form.coefficient(a, b) == value
            })
        };
        assert!(kept.iter().all(holds), "{name}");
        assert!(!broken.iter().any(holds), "{name}");
    }
}

#[test]
fn with_all_weights_1_the_edges_are_the_standard_ones() {
    for (weights, standard) in [("cap-3x3-weights", "cap-3x3"), ("cap-4x3-c2-weights", "cap-4x3-c2")] {
        let text = family(weights).statement();
        // d becomes 1, and is no unknown any more.
        let fixed =
            text.replace(", \"d\"]", "]").replace("nonzero = [\"d\"]\n", "") + "\n[define]\nd = \"1\"\n";
        let fixed = Statement::read(&fixed).unwrap_or_else(|error| panic!("{weights}: {error}"));
        let (a, b) = (condition(&fixed), condition(&statement(standard)));
        assert!(a.coefficients().eq(b.coefficients()), "{weights}");
    }
}

#[test]
fn names_that_are_refused() {
    let made = "caps are called cap-MxN[-c2|-d2|-c4|-d4][-weights], M and N from 2";
    let cases = [
        ("cap-", "expected the bidegree, such as 4x3"),
        ("cap-3", "expected the bidegree, such as 4x3"),
        ("cap-3x", "expected the bidegree, such as 4x3"),
        ("cap-+3x3", "expected the bidegree, such as 4x3"),
        ("cap-99999999999x3", "expected the bidegree, such as 4x3"),
        ("cap-1x3", "the edges have degree 2, the patch cannot have less"),
        ("cap-33x3", "degrees above 32 are too large for the checker"),
        ("cap-3x3-d3", "`d3` is neither a symmetry nor `weights`, or out of order"),
        ("cap-3x3-weights-c2", "`c2` is neither a symmetry nor `weights`, or out of order"),
        ("cap-3x3-", "`` is neither a symmetry nor `weights`, or out of order"),
        ("cap-4x3-d4", "rotations by 90° need the same degree in u and v"),
        ("cap-4x4-d2-weights", "with this symmetry all corner weights are equal"),
    ];
    for (name, fault) in cases {
        assert_eq!(refusal(name), format!("`{name}`: {fault}; {made}"));
    }
    assert!(cap("cobb").is_none());
}
