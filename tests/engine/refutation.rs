//! The engine on systems whose answer is known for another reason.

use std::sync::atomic::Ordering;

use prove_cap::checker::{Claim, ExactNet, Solution};
use prove_cap::control::{Control, Interrupted, Why};
use prove_cap::elimination::{Closure, Outcome, Undecided, eliminate};
use prove_cap::problem::Problem;
use prove_cap::prove::{Attempt, Reason, prove};
use prove_cap::statement::Statement;

use crate::stopping::stopping_at;

fn system(radicands: &str, unknowns: &str, nonzero: &str, polynomials: &[&str]) -> Statement {
    let names: Vec<&str> = unknowns.split_whitespace().collect();
    let assumed: Vec<&str> = nonzero.split(", ").filter(|text| !text.is_empty()).collect();
    let text = format!(
        "title = \"a system\"\nradicands = {radicands}\nunknowns = {names:?}\nnonzero = {assumed:?}\npolynomials = {polynomials:?}\n"
    );
    Statement::read(&text).unwrap_or_else(|error| panic!("{error}"))
}

#[derive(Debug, PartialEq)]
enum Answer {
    Impossible,
    Solution(Vec<String>),
    /// Dimension and number of zeros.
    Consistent(usize, Option<usize>),
    Other,
}

fn answer(statement: &Statement) -> Answer {
    match prove(statement, &Control::default()).unwrap() {
        Attempt::Proved { proof, .. } => match proof.theorem().claim() {
            Claim::Impossible(_) => Answer::Impossible,
            Claim::Solution(Solution { values }) => {
                Answer::Solution(values.iter().map(|value| statement.ring().spell(value)).collect())
            }
            _ => Answer::Other,
        },
        Attempt::Undecided(Reason::Consistent(consistent)) => counted(&consistent.closure),
        Attempt::Undecided(_) => Answer::Other,
    }
}

fn counted(closure: &Closure) -> Answer {
    assert!(closure.verified, "small bases are verified over K");
    Answer::Consistent(closure.dimension, closure.zeros)
}

/// What elimination says, before zeros in K are looked for.
fn zeros(statement: &Statement) -> Answer {
    match eliminate(&Problem::of(statement).system(&Control::default()).unwrap(), &Control::default()).1 {
        Outcome::Open(Undecided::Consistent(closure)) => counted(&closure),
        _ => Answer::Other,
    }
}

/// Pairs that differ in one constraint: the first has no zero, the second has.
#[test]
fn of_twins_only_the_inconsistent_one_is_refuted() {
    type Twins = (&'static str, &'static str, &'static str, &'static [&'static str], &'static [&'static str]);
    let twins: &[Twins] = &[
        // a line and a parallel; a line and another line
        ("[]", "x y", "", &["x + y - 1", "2*x + 2*y - 3"], &["x + y - 1", "2*x + 3*y - 3"]),
        // x² = 2 and x = √2, and the wrong root of 3
        ("[2, 3]", "x", "", &["x^2 - 2", "x - sqrt(3)"], &["x^2 - 2", "x - sqrt(2)"]),
        // a circle and a line that misses it over C: only at infinity could they meet
        ("[]", "x y", "", &["x^2 + y^2 - 1", "x^2 + y^2 - 2"], &["x^2 + y^2 - 1", "x^2 - y^2 - 2"]),
        // zero divisors
        ("[]", "x y", "x, y", &["x*y"], &["x*y - 1"]),
        // saturation
        ("[]", "x y", "x", &["x^2*y", "x*y - x"], &["x^2*y - x^2", "x*y - x"]),
        // the equation x² + 1 has a complex zero, x⁴ + 1 with x² = 1 has none
        ("[]", "x", "", &["x^4 + 1", "x^2 - 1"], &["x^4 - 1", "x^2 - 1"]),
        // nilpotent: x² = 0 and x ≠ 0
        ("[]", "x", "x", &["x^2"], &["x^2 - x"]),
        // a colouring of K₄ and of K₃ with the three cube roots of unity
        (
            "[]",
            "a b c d",
            "",
            &[
                "a^3-1",
                "b^3-1",
                "c^3-1",
                "d^3-1",
                "a^2+a*b+b^2",
                "a^2+a*c+c^2",
                "a^2+a*d+d^2",
                "b^2+b*c+c^2",
                "b^2+b*d+d^2",
                "c^2+c*d+d^2",
            ],
            &[
                "a^3-1",
                "b^3-1",
                "c^3-1",
                "d^3-1",
                "a^2+a*b+b^2",
                "a^2+a*c+c^2",
                "a^2+a*d+d^2",
                "b^2+b*c+c^2",
                "b^2+b*d+d^2",
            ],
        ),
        // conjugates: √2 and −√2 are told apart
        (
            "[2]",
            "x y",
            "",
            &["x - sqrt(2)", "y + sqrt(2)", "x*y - 2"],
            &["x - sqrt(2)", "y + sqrt(2)", "x*y + 2"],
        ),
        // four radicands
        (
            "[2, 3, 5, 7]",
            "x",
            "",
            &["x - sqrt(2)*sqrt(3)", "x^2*sqrt(5)*sqrt(7) - 6*sqrt(35) - 1"],
            &["x - sqrt(2)*sqrt(3)", "x^2*sqrt(5)*sqrt(7) - 6*sqrt(35)"],
        ),
        // cyclic-3 and a contradiction to it: xyz = 1 and z = 0
        ("[]", "x y z", "", &["x+y+z", "x*y+y*z+z*x", "x*y*z-1", "z"], &["x+y+z", "x*y+y*z+z*x", "x*y*z-1"]),
        // katsura-2 and a contradiction
        (
            "[]",
            "x y z",
            "",
            &["x+2*y+2*z-1", "x^2+2*y^2+2*z^2-x", "2*x*y+2*y*z-y", "x*y*z - 100"],
            &["x+2*y+2*z-1", "x^2+2*y^2+2*z^2-x", "2*x*y+2*y*z-y"],
        ),
    ];
    for (radicands, unknowns, nonzero, inconsistent, consistent) in twins {
        let first = answer(&system(radicands, unknowns, nonzero, inconsistent));
        assert_eq!(first, Answer::Impossible, "{inconsistent:?}");
        let second = answer(&system(radicands, unknowns, nonzero, consistent));
        assert!(!matches!(second, Answer::Impossible | Answer::Other), "{consistent:?}: {second:?}");
    }
}

#[test]
fn complex_zeros_are_no_proof_of_anything() {
    assert_eq!(answer(&system("[]", "x", "", &["x^2 + 1"])), Answer::Consistent(0, Some(2)));
    assert_eq!(answer(&system("[]", "x y", "", &["x^2 + y^2 + 1"])), Answer::Consistent(1, None));
}

#[test]
fn infinitely_many_zeros_are_counted_by_dimension() {
    assert_eq!(zeros(&system("[]", "x y z", "", &["x*y - 1"])), Answer::Consistent(2, None));
    assert_eq!(zeros(&system("[]", "x y z", "", &[])), Answer::Consistent(3, None));
    assert_eq!(zeros(&system("[]", "x y", "", &["x - y"])), Answer::Consistent(1, None));
    // The twisted cubic and a plane curve.
    assert_eq!(zeros(&system("[]", "x y z", "", &["y - x^2", "z - x^3"])), Answer::Consistent(1, None));
    assert_eq!(
        zeros(&system("[]", "x y z", "", &["x*z - y^2", "x^3 - y*z", "z^2 - x^2*y"])),
        Answer::Consistent(1, None)
    );
}

/// Numbers of zeros as published: cyclic-3 has 6, katsura-2 has 4, and Bézout's 9 for two plane cubics.
#[test]
fn zeros_are_counted_with_multiplicity() {
    let cyclic = ["x+y+z", "x*y+y*z+z*x", "x*y*z-1"];
    assert_eq!(zeros(&system("[]", "x y z", "", &cyclic)), Answer::Consistent(0, Some(6)));
    let katsura = ["x+2*y+2*z-1", "x^2+2*y^2+2*z^2-x", "2*x*y+2*y*z-y"];
    assert_eq!(zeros(&system("[]", "x y z", "", &katsura)), Answer::Consistent(0, Some(4)));
    let cubics = ["x^3 + y^3 - x*y - 1", "x^3 - 2*y^3 + x - y + 5"];
    assert_eq!(zeros(&system("[]", "x y", "", &cubics)), Answer::Consistent(0, Some(9)));
    assert_eq!(zeros(&system("[]", "x", "", &["x^4 + 2*x^2 + 1"])), Answer::Consistent(0, Some(4)));
}

#[test]
fn a_determined_system_is_solved() {
    let solved = |values: &[&str]| Answer::Solution(values.iter().map(ToString::to_string).collect());
    let statement = system("[2]", "x y", "", &["sqrt(2)*x + y - 3", "x - sqrt(2)*y"]);
    assert_eq!(answer(&statement), solved(&["sqrt(2)", "1"]));
    // Linear only after a substitution, and determined only through an assumption.
    let statement = system("[]", "x y", "", &["x - 2", "x*y - 6", "y^2 - 9"]);
    assert_eq!(answer(&statement), solved(&["2", "3"]));
    assert_eq!(answer(&system("[]", "x", "x", &["x^2 - x"])), solved(&["1"]));
    assert_eq!(answer(&system("[]", "", "", &["0"])), solved(&[]));
}

#[test]
fn isolated_zeros_in_the_field_are_found() {
    let solved = |values: &[&str]| Answer::Solution(values.iter().map(ToString::to_string).collect());
    assert_eq!(answer(&system("[2]", "x", "", &["2*x^2 - 1"])), solved(&["1/2*sqrt(2)"]));
    assert_eq!(
        answer(&system("[2, 3]", "x", "", &["x^2 - 5 - 2*sqrt(6)", "x^4 - 10*x^2 + 1"])),
        solved(&["sqrt(2) + sqrt(3)"])
    );
    assert_eq!(answer(&system("[]", "x", "", &["x^2 - 2*x + 1"])), solved(&["1"]));
    // Two conics through four points, two of them rational and two not: x² = 1 or x² = 3.
    let conics = ["x^2 + y^2 - 2", "x^2 - 2*y^2 + 1"];
    assert!(matches!(answer(&system("[]", "x y", "", &conics)), Answer::Solution(_)));
    // √3 is not in Q(√2), and x² = −1 has no root in any real field.
    assert_eq!(answer(&system("[2]", "x", "", &["x^2 - 3"])), Answer::Consistent(0, Some(2)));
}

/// A quarter of a cylinder whose middle weight is open: of ±√2/2 the one that gives positive weights.
#[test]
fn of_two_nets_the_one_with_positive_weights_is_given() {
    let text = std::fs::read_to_string("tests/data/sessions/files/cylinder.toml").unwrap();
    let attempt = prove(&Statement::read(&text).unwrap(), &Control::default()).unwrap();
    let Attempt::Proved { proof, .. } = attempt else { panic!("{attempt:?}") };
    let theorem = proof.theorem();
    let Claim::Exact(ExactNet { values, weights_positive: true, .. }) = theorem.claim() else {
        panic!("{theorem:?}")
    };
    assert_eq!(theorem.statement().ring().spell(&values[0]), "1/2*sqrt(2)");
}

#[test]
fn constants_among_the_equations() {
    assert_eq!(answer(&system("[]", "x", "", &["1"])), Answer::Impossible);
    assert_eq!(answer(&system("[]", "x", "", &["x", "5"])), Answer::Impossible);
    assert_eq!(answer(&system("[2]", "x", "", &["sqrt(2) - 1", "x"])), Answer::Impossible);
    assert_eq!(answer(&system("[]", "x", "", &["5", "1", "1"])), Answer::Impossible);
}

#[test]
fn a_patch_without_a_denominator_is_not_exact() {
    let text = std::fs::read_to_string("tests/data/reject/certificate/NoDenominator.toml").unwrap();
    let attempt = prove(&Statement::read(&text).unwrap(), &Control::default()).unwrap();
    assert!(!matches!(attempt, Attempt::Proved { .. }), "{attempt:?}");
}

/// A statement that the checker cannot expand is undecided before the prover, which has no limits, starts on it.
#[test]
fn what_the_checker_cannot_expand_is_not_attempted() {
    let point = |i: usize, j: usize| format!("[\"{i}\", \"{j}\", \"{}\", \"1\"]", i * j + 1);
    let row = |i: usize| format!("[{}]", (0..33).map(|j| point(i, j)).collect::<Vec<_>>().join(", "));
    let net = (0..33).map(row).collect::<Vec<_>>().join(",\n");
    let text = format!(
        "title = \"large\"\nradicands = []\nunknowns = []\nconvention = \"homogeneous\"\nbidegree = [32, 32]\n\
         surface = \"X^8 + Y^8 + Z^8 - W^8\"\nnet = [{net}]\n"
    );
    let attempt = prove(&Statement::read(&text).unwrap(), &Control::default()).unwrap();
    assert!(matches!(attempt, Attempt::Undecided(Reason::Limited { found: false, .. })), "{attempt:?}");
}

#[test]
fn time_and_the_user_stop_the_work() {
    // Too hard to finish at once: dense quadratics in many unknowns.
    let names: Vec<String> = (0..9).map(|k| format!("x{k}")).collect();
    let equations: Vec<String> = (0..12)
        .map(|k| {
            let products = (0..9)
                .flat_map(|i| (i..9).map(move |j| format!("{}*x{i}*x{j}", (k * 7 + i * 5 + j * 3) % 11 + 1)));
            products.collect::<Vec<_>>().join(" + ") + &format!(" + x{} - {}", k % 9, k + 1)
        })
        .collect();
    let equations: Vec<&str> = equations.iter().map(String::as_str).collect();
    let statement = system("[]", &names.join(" "), "", &equations);
    let stopped = |control: &Control| match prove(&statement, control).unwrap() {
        Attempt::Undecided(Reason::Elimination(Undecided::Interrupted(stopped))) => stopped,
        other => panic!("{other:?}"),
    };
    // A clock that has run out when it is looked at for the n-th time; then nobody looks again.
    let mut told = None;
    for n in [1, 10, 100, 1000, 10_000] {
        let (control, looks) = stopping_at(n);
        let late = stopped(&control);
        assert_eq!(late.why, Why::Time);
        // Two threads may look at once.
        assert!((n..n + 8).contains(&looks.load(Ordering::Relaxed)), "{n}: {looks:?}");
        told = late.reached;
    }
    assert!(told.is_some_and(|told| !told.is_empty()), "where it was");
    let control = Control::default();
    control.stop(Why::Interrupt);
    control.stop(Why::Memory);
    assert_eq!(stopped(&control), Interrupted { why: Why::Interrupt, reached: None });
}
