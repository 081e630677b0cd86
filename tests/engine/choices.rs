//! Infinitely many zeros: one is chosen, the best patch first; and zeros over a larger field are named.

use prove_cap::bezier::Image;
use prove_cap::checker::{Claim, ExactNet};
use prove_cap::control::{Control, Why};
use prove_cap::elimination::Undecided;
use prove_cap::prove::{Attempt, Consistent, Freedom, Reason, image_of, prove};
use prove_cap::statement::Statement;

fn attempt(text: &str) -> (Statement, Attempt) {
    let statement = Statement::read(text).unwrap_or_else(|error| panic!("{error}"));
    let attempt = prove(&statement, &Control::default()).unwrap();
    (statement, attempt)
}

fn system(radicands: &str, unknowns: &[&str], nonzero: &[&str], polynomials: &[&str]) -> String {
    format!(
        "title = \"a system\"\nradicands = {radicands}\nunknowns = {unknowns:?}\nnonzero = {nonzero:?}\n\
         polynomials = {polynomials:?}\n"
    )
}

/// A patch of bidegree (2,1) on the cylinder X² + Y² = W², with these points along u.
fn cylinder(
    radicands: &str,
    unknowns: &[&str],
    nonzero: &[&str],
    points: [[&str; 3]; 3],
    top: &str,
) -> String {
    let row = |[x, y, w]: [&str; 3]| {
        format!("[[\"{x}\", \"{y}\", \"0\", \"{w}\"], [\"{x}\", \"{y}\", \"({top})*({w})\", \"{w}\"]]")
    };
    format!(
        "title = \"a cylinder\"\nradicands = {radicands}\nunknowns = {unknowns:?}\nnonzero = {nonzero:?}\n\
         convention = \"homogeneous\"\nbidegree = [2, 1]\nsurface = \"X^2 + Y^2 - W^2\"\nnet = [{}]\n",
        points.map(row).join(", ")
    )
}

/// The values, spelled, and what was free.
fn values(text: &str) -> (Vec<String>, Freedom) {
    let (statement, attempt) = attempt(text);
    let Attempt::Proved { proof, freedom, .. } = attempt else { panic!("{attempt:?}\n{text}") };
    let theorem = proof.theorem();
    let values = match theorem.claim() {
        Claim::Exact(exact) => &exact.values,
        Claim::Solution(solution) => &solution.values,
        other => panic!("{other:?}"),
    };
    (values.iter().map(|value| statement.ring().spell(value)).collect(), freedom)
}

fn undecided(text: &str) -> Consistent {
    match attempt(text).1 {
        Attempt::Undecided(Reason::Consistent(consistent)) => *consistent,
        other => panic!("{other:?}\n{text}"),
    }
}

fn exact(text: &str) -> (Statement, ExactNet) {
    let (statement, attempt) = attempt(text);
    let Attempt::Proved { proof, .. } = attempt else { panic!("{attempt:?}\n{text}") };
    let theorem = proof.theorem();
    let Claim::Exact(exact) = theorem.claim() else { panic!("{theorem:?}") };
    (statement, exact.clone())
}

#[test]
fn open_weights_are_chosen() {
    let quarter = [["a", "0", "a"], ["b", "b", "b"], ["0", "c", "c"]];
    let (found, freedom) = values(&cylinder("[]", &["a", "b", "c"], &[], quarter, "1"));
    assert_eq!(found, ["1", "1", "2"]);
    assert_eq!(freedom.chosen.iter().map(|(k, _)| *k).collect::<Vec<_>>(), [0, 1]);
    assert!(freedom.infinite && freedom.indifferent.is_empty());
    // The order of declaration, weights first, decides.
    let (found, freedom) = values(&cylinder("[]", &["h", "c", "b", "a"], &[], quarter, "h"));
    assert_eq!(found, ["1", "1", "1", "2"]);
    assert_eq!(freedom.indifferent, [0]);
}

#[test]
fn assumptions_hold_for_what_is_chosen() {
    let quarter = [["a", "0", "a"], ["b", "b", "b"], ["0", "c", "c"]];
    let (found, _) = values(&cylinder("[]", &["a", "b", "c"], &["a - 1", "b - 1"], quarter, "1"));
    assert!(found[0] != "1" && found[1] != "1", "{found:?}");
    let (found, _) = values(&system("[]", &["x", "y"], &["x - 1", "x"], &["x*y - 2"]));
    assert_eq!(found, ["2", "1"]);
}

#[test]
fn a_surface_comes_before_a_curve_and_a_curve_before_a_point() {
    // h = 0 would do as well, and so would a = b = 0.
    let quarter = [["a", "0", "a"], ["b", "b", "b"], ["0", "c", "c"]];
    let (statement, net) = exact(&cylinder("[]", &["a", "b", "c", "h"], &["h - 1"], quarter, "h"));
    assert!(net.weights_positive);
    assert_eq!(image_of(&statement, &net.net), Image::Surface);
    let shape = |points, top| {
        let (statement, net) = exact(&cylinder("[]", &[], &[], points, top));
        image_of(&statement, &net.net)
    };
    assert_eq!(shape([["1", "0", "1"], ["1", "1", "1"], ["0", "2", "2"]], "0"), Image::Curve);
    assert_eq!(shape([["1", "0", "1"], ["2", "0", "2"], ["3", "0", "3"]], "1"), Image::Curve);
    assert_eq!(shape([["1", "0", "1"], ["2", "0", "2"], ["3", "0", "3"]], "0"), Image::Point);
    assert_eq!(shape([["1", "0", "1"], ["1", "1", "1"], ["0", "2", "2"]], "1/1000000"), Image::Surface);
}

#[test]
fn equations_that_always_hold_are_exact() {
    let (found, freedom) = values(&system("[]", &["x", "y"], &[], &["x - x"]));
    assert_eq!((found, freedom.indifferent), (vec!["1".to_owned(), "1".to_owned()], vec![0, 1]));
}

#[test]
fn determined_unknowns_are_left_alone() {
    let (found, freedom) = values(&system("[2]", &["w", "x", "y"], &[], &["2*w^2 - 1", "x - y^2"]));
    assert_eq!(found, ["1/2*sqrt(2)", "1", "1"]);
    assert!(freedom.chosen.iter().all(|(k, _)| *k != 0));
    // No equation in x alone, and yet x is √3 or −√3 where y is not 0.
    let (found, _) = values(&system("[3]", &["x", "y"], &["y"], &["x^2*y - 3*y"]));
    assert_eq!(found[1], "1");
}

#[test]
fn what_was_tried_is_kept() {
    // A sum of two squares that is 0 or −1 has no rational zero but 0.
    let none = undecided(&system("[]", &["x", "y"], &[], &["x^2 + y^2 + 1"]));
    let tried = none.tried.unwrap();
    assert_eq!(tried.unknowns, [0, 1]);
    assert!(tried.choices > 0 && none.extension.is_none());
    // One of infinitely many over C, the only one over Q.
    let (found, _) = values(&system("[]", &["x", "y"], &[], &["x^2 + y^2"]));
    assert_eq!(found, ["0", "0"]);
}

#[test]
fn a_larger_field_is_named_where_it_has_a_zero() {
    let radicands = |text: &str| undecided(text).extension.map(|extension| extension.radicands);
    let one = |radicands, polynomials: &[&str]| system(radicands, &["x"], &[], polynomials);
    assert_eq!(radicands(&one("[]", &["2*x^2 - 1"])), Some(vec![2]));
    assert_eq!(radicands(&one("[3]", &["x^2 - x - 1"])), Some(vec![3, 5]));
    assert_eq!(radicands(&one("[]", &["x^2 - 6"])), Some(vec![2, 3]));
    assert_eq!(radicands(&one("[]", &["x^2 - 999983/49"])), Some(vec![999_983]));
    // (x² = 5·(1 + √2)², and a number that needs two roots)
    assert_eq!(radicands(&one("[2]", &["x^2 - 15 - 10*sqrt(2)"])), Some(vec![2, 5]));
    assert_eq!(radicands(&one("[]", &["x^4 - 10*x^2 + 1"])), Some(vec![2, 3]));
    assert_eq!(radicands(&one("[]", &["(x^2 - 7)*(x^3 - 2)"])), Some(vec![7]));
    // one coordinate after another
    let two = system("[]", &["x", "y"], &[], &["x^2 - 2", "y^2 - x - 4 - 3"]);
    assert_eq!(radicands(&two), None);
    let two = system("[]", &["x", "y"], &[], &["x^2 - 2", "x*y^2 - 3*x"]);
    assert_eq!(radicands(&two), Some(vec![2, 3]));
    // not real, of degree 3, too large a prime, a product of five primes
    for polynomial in ["x^2 + 2", "x^3 - 2", "x^2 - 1000003", "x^2 - 2310", "x^2 - 1 - sqrt(2)"] {
        assert_eq!(radicands(&one("[2]", &[polynomial])), None, "{polynomial}");
    }
}

#[test]
fn an_assumption_holds_in_the_larger_field_too() {
    let text = system("[]", &["x", "y"], &["x - y"], &["x^2 - 2", "y^2 - 2"]);
    assert_eq!(undecided(&text).extension.unwrap().radicands, [2]);
    assert!(matches!(
        attempt(&system("[]", &["x", "y"], &["x - y", "x + y"], &["x^2 - 2", "y^2 - 2"])).1,
        Attempt::Proved { proof, .. } if proof.theorem().kind() == "impossible"
    ));
}

#[test]
fn the_choice_of_values_can_be_interrupted() {
    let statement = Statement::read(&system("[]", &["x", "y"], &[], &["x*y - 1"])).unwrap();
    let control = Control::default();
    control.stop(Why::Interrupt);
    let Attempt::Undecided(Reason::Elimination(Undecided::Interrupted(stopped))) =
        prove(&statement, &control).unwrap()
    else {
        panic!("not interrupted")
    };
    assert_eq!(stopped.why, Why::Interrupt);
}
