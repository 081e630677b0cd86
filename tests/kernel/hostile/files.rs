//! Files made to hurt that do not grow: the limit that each of them runs into.

use std::fs;

use prove_cap_kernel::certificate::CertificateFault;
use prove_cap_kernel::checker::{CheckError, Place, check};
use prove_cap_kernel::exact::{Limit, Work, limits};
use prove_cap_kernel::statement::{Statement, StatementFault};

use super::attack::{Attack, FEW, statement};
use super::measure::alone;

fn read(text: &str) -> Result<Statement, StatementFault> {
    Statement::read_bytes(text.as_bytes(), &mut Work::full().at_most(FEW)).map_err(|error| error.fault)
}

fn with_expression(expression: &str) -> Result<Statement, StatementFault> {
    let unknowns = ["a", "b", "c", "d"].map(String::from);
    read(&statement("2, 3, 5, 7", &unknowns, &format!("polynomials = [\"{expression}\"]")))
}

fn limit(read: Result<Statement, StatementFault>) -> Limit {
    match read {
        Err(StatementFault::Limit(limit)) => limit,
        other => panic!("{other:?}"),
    }
}

#[test]
fn expressions_that_explode() {
    let _alone = alone();
    assert_eq!(limit(with_expression("a^1000000000000000000")), limits::EXPONENT);
    assert_eq!(limit(with_expression("(a^1000)^2")), limits::DEGREE);
    let primes = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29].map(|p| format!("{p}^1000")).join("*");
    assert_eq!(limit(with_expression(&primes)), limits::DIGITS);
    assert_eq!(limit(with_expression(&"(".repeat(100_000))), limits::NESTING);
    assert_eq!(limit(with_expression(&format!("1/{}", "7".repeat(100_000)))), limits::DIGITS);
}

#[test]
fn deep_but_harmless_expressions_are_read() {
    let _alone = alone();
    assert!(with_expression(&format!("{}a{}", "(".repeat(60), ")".repeat(60))).is_ok());
}

#[test]
fn toml_that_nests_or_never_ends() {
    let _alone = alone();
    for text in [
        format!("net = {}", "[".repeat(100_000)),
        format!("net = {}", "{a=".repeat(100_000)),
        vec!["a"; 100_000].join(".") + " = 1",
    ] {
        assert!(matches!(read(&text), Err(StatementFault::Toml(_))), "{}", &text[..20]);
    }
    assert_eq!(limit(read(&"#".repeat(limits::STATEMENT_BYTES.length() + 1))), limits::STATEMENT_BYTES);
    let many = super::attack::names(2000);
    assert_eq!(limit(read(&statement("", &many, "polynomials = []"))), limits::UNKNOWNS);
}

/// A certificate for x·y = 1, x = 0 with these lines after its claim.
fn judged(lines: &str) -> Result<(), CheckError> {
    let text = fs::read_to_string("../../tests/data/reject/certificate/statement.toml").unwrap();
    let Attack { statement, certificate } =
        Attack::new(text, &["claim impossible".to_owned(), lines.to_owned()]);
    check(statement.as_bytes(), certificate.as_bytes()).map(|_| ())
}

fn certificate_limit(result: &Result<(), CheckError>) -> Option<Limit> {
    match result {
        Err(CheckError::Certificate(error)) => match error.fault {
            CertificateFault::Limit(limit) => Some(limit),
            _ => None,
        },
        _ => None,
    }
}

#[test]
fn certificates_beyond_the_limits() {
    let _alone = alone();
    let line = judged(&format!("step 1\nadd f[1] times {}", "x".repeat(10_000_000)));
    assert_eq!(certificate_limit(&line), Some(limits::LINE_BYTES));
    let bytes = judged(&"\n".repeat(limits::CERTIFICATE_BYTES.length()));
    assert_eq!(certificate_limit(&bytes), Some(limits::CERTIFICATE_BYTES));
    let step = |k| format!("step {k}\nadd f[1] times x\nconclude x\n");
    let steps: String = (1..=limits::STEPS.length() + 1).map(step).collect();
    assert_eq!(certificate_limit(&judged(&steps)), Some(limits::STEPS));
}

#[test]
fn certificates_whose_steps_square() {
    let _alone = alone();
    // Each step would double the degree: the conclusions are lies, and the first sum shows it.
    let mut lines = String::from("step 1\nadd f[2] times x^900\nconclude x^902\n");
    for k in 2..2000 {
        lines += &format!("step {k}\nadd step {} times x^900\nconclude x^902\n", k - 1);
    }
    let unended = judged(&lines);
    assert!(matches!(unended, Err(CheckError::Certificate(_))) && certificate_limit(&unended).is_none());
    let told = judged(&(lines + "end 1999")).unwrap_err().to_string();
    assert!(told.starts_with("step 1: the conclusion is wrong"), "{told}");
    // If they were none, the second step would run into the limit on degrees.
    let right = "step 1\nadd f[2] times x^900\nconclude x^902 - 4*x^900\nstep 2\nadd step 1 times x^900\nconclude x\nend 2";
    let error = judged(right).unwrap_err();
    let expected = CheckError::Limited { place: Place::Step(2), limit: limits::DEGREE };
    assert_eq!(error, expected, "{error}");
}
