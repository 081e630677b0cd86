//! The sentences that a completed check comes to, word for word, and what they hold back.

use prove_cap::certificate::{Argument, Certificate, Premise, Step};
use prove_cap::checker::{CheckError, Claim, ExactNet, Theorem, check_read};
use prove_cap::exact::{Arithmetic, Polynomial};
use prove_cap::statement::Statement;

fn proved(text: &str, argument: Argument) -> Theorem {
    let statement = Statement::read(text).unwrap_or_else(|error| panic!("{error}"));
    let certificate = Certificate { statement: statement.hash(), argument };
    check_read(&statement, &certificate).unwrap_or_else(|error| panic!("{error}"))
}

/// One step: c[0,0] or f[1], times 1/value, is 1.
fn one_step(premise: Premise, inverse: i32) -> Argument {
    let combination = vec![(premise, Polynomial::integer(inverse))];
    Argument::Impossible(vec![Step { combination, conclusion: Polynomial::integer(1) }])
}

/// A bilinear patch in the plane Z = 0 with these weights, of which the first may be an unknown.
fn plane(unknowns: &str, nonzero: &str, weights: [&str; 4]) -> String {
    let [a, b, c, d] = weights;
    format!(
        "title = \"a plane\"\nradicands = [2]\nunknowns = [{unknowns}]\nnonzero = [{nonzero}]\n\
         convention = \"homogeneous\"\nbidegree = [1, 1]\nsurface = \"Z\"\n\
         net = [[[\"0\", \"0\", \"0\", \"{a}\"], [\"0\", \"1\", \"0\", \"{b}\"]],\n\
         [[\"1\", \"0\", \"0\", \"{c}\"], [\"1\", \"1\", \"0\", \"{d}\"]]]\n"
    )
}

#[test]
fn impossible_patches() {
    let off =
        |unknowns: &str, nonzero: &str| plane(unknowns, nonzero, ["1"; 4]).replace("\"Z\"", "\"W - X + X\"");
    let step = || one_step(Premise::Coefficient(0, 0), 1);
    let theorem = proved(&off("", ""), step());
    assert_eq!(theorem.kind(), "impossible");
    assert_eq!(
        theorem.to_string(),
        "This rational Bézier patch of bidegree (1,1) does not lie on the surface W = 0: its 4 coefficients c[r,s] \
         are not all zero."
    );
    assert_eq!(
        proved(&off("\"p\"", ""), step()).to_string(),
        "For no value of p, real or complex, does this rational Bézier patch of bidegree (1,1) lie on the surface \
         W = 0: its 4 coefficients c[r,s] have no common zero over any field containing Q(√2)."
    );
    assert_eq!(
        proved(&off("\"p\", \"q\"", "\"p\", \"q - 1\""), step()).to_string(),
        "For no values of p, q with p ≠ 0, q − 1 ≠ 0, real or complex, does this rational Bézier patch of bidegree \
         (1,1) lie on the surface W = 0: its 4 coefficients c[r,s] have no common zero over any field containing \
         Q(√2) with p ≠ 0, q − 1 ≠ 0."
    );
}

#[test]
fn coefficients_are_counted_for_the_degree_of_the_surface() {
    let text = plane("", "", ["1"; 4]).replace("\"Z\"", "\"W^3\"");
    let sentence = proved(&text, one_step(Premise::Coefficient(0, 0), 1)).to_string();
    assert!(sentence.contains("its 16 coefficients"), "{sentence}");
}

#[test]
fn impossible_systems() {
    let system = |polynomials: &str| {
        format!("title = \"t\"\nradicands = []\nunknowns = [\"x\"]\npolynomials = [{polynomials}]\n")
    };
    let step = || one_step(Premise::Equation(1), 1);
    let one = proved(&system("\"1\""), step()).to_string();
    assert_eq!(one, "The system of 1 polynomial has no zero over any field containing Q.");
    let two = proved(&system("\"1\", \"x\""), step()).to_string();
    assert_eq!(two, "The system of 2 polynomials has no zero over any field containing Q.");
}

#[test]
fn positive_weights_are_claimed_only_where_all_are() {
    let exact = |weights: [&str; 4]| {
        let theorem = proved(&plane("", "", weights), Argument::Exact(Vec::new()));
        assert_eq!(theorem.kind(), "exact");
        let Claim::Exact(ExactNet { weights_positive, .. }) = theorem.claim() else { panic!("{theorem:?}") };
        (*weights_positive, theorem.to_string())
    };
    let (positive, sentence) = exact(["1", "sqrt(2) - 1", "3 - 2*sqrt(2)", "1/7"]);
    assert!(positive);
    assert_eq!(
        sentence,
        "As it stands every point of the patch whose denominator is not zero lies on the surface Z = 0. Every weight \
         is positive, so the patch is defined on the whole square."
    );
    // One weight is zero, or negative by little, at each place in turn.
    for bad in ["0", "-1", "7 - 5*sqrt(2)", "1 - sqrt(2)"] {
        for place in 0..4 {
            let mut weights = ["1"; 4];
            weights[place] = bad;
            let (positive, sentence) = exact(weights);
            assert!(!positive, "{weights:?}");
            assert!(sentence.ends_with("is not claimed."), "{sentence}");
        }
    }
}

#[test]
fn solutions() {
    let text = "title = \"t\"\nradicands = [2]\nunknowns = [\"x\"]\nnonzero = [\"x\"]\npolynomials = [\"x^2 - x\"]\n";
    let theorem = proved(text, Argument::Exact(vec![Polynomial::integer(1)]));
    assert_eq!(theorem.kind(), "solution");
    assert_eq!(theorem.to_string(), "The stated values in Q(√2) solve the system, with x ≠ 0.");
    let statement = Statement::read(text).unwrap();
    for (value, right) in [(0, false), (1, true), (2, false)] {
        let argument = Argument::Exact(vec![Polynomial::integer(value)]);
        let result = check_read(&statement, &Certificate { statement: statement.hash(), argument });
        assert_eq!(result.is_ok(), right, "x = {value}");
        assert!(right || matches!(result, Err(CheckError::Rejected(_))));
    }
}

/// A certificate built in memory is held to what the reader accepts: constants for values, roots of the field.
#[test]
fn ill_formed_certificates_in_memory_prove_nothing() {
    let text = "title = \"t\"\nradicands = []\nunknowns = [\"x\", \"y\"]\nnonzero = [\"x - y - 1\"]\npolynomials = [\"x^2 - y\"]\n";
    let statement = Statement::read(text).unwrap();
    let refused = |argument: Argument| {
        let result = check_read(&statement, &Certificate { statement: statement.hash(), argument });
        assert!(matches!(result, Err(CheckError::Certificate(_))), "{result:?}");
    };
    let x = Polynomial::variable(0);
    let mut work = prove_cap::exact::Work::full();
    let square = Arithmetic::new(statement.field(), &mut work).product(&x, &x).unwrap();
    refused(Argument::Exact(vec![x.clone(), square]));
    refused(Argument::Exact(vec![Polynomial::integer(1)]));
    let root = Polynomial::term(
        num_rational::BigRational::from_integer(1.into()),
        prove_cap::exact::Monomial::radical(2),
    );
    let step = Step { combination: vec![(Premise::Equation(1), root)], conclusion: x };
    refused(Argument::Impossible(vec![step]));
}
