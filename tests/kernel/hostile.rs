//! Files made to hurt: each is an error in bounded time and memory, never a verdict, never a panic.

use std::fs;
use std::time::{Duration, Instant};

use prove_cap::certificate::CertificateFault;
use prove_cap::checker::{CheckError, Place, check};
use prove_cap::exact::{Work, limits};
use prove_cap::statement::{Statement, StatementError, StatementFault};
use sha2::{Digest, Sha256};

/// Generous, for slow machines: what is meant is "does not hang".
const PATIENCE: Duration = Duration::from_secs(60);

fn in_time<T>(work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = work();
    assert!(start.elapsed() < PATIENCE, "took {:?}", start.elapsed());
    result
}

fn with_expression(expression: &str) -> String {
    format!(
        "title = \"t\"\nradicands = [2, 3, 5, 7]\nunknowns = [\"a\", \"b\", \"c\", \"d\"]\npolynomials = [\"{expression}\"]\n"
    )
}

fn refused(expression: &str) -> StatementFault {
    in_time(|| Statement::read(&with_expression(expression))).expect_err("a limit").fault
}

fn is_limit(fault: &StatementFault) -> bool {
    matches!(fault, StatementFault::Limit(_))
}

#[test]
fn expressions_that_explode() {
    assert!(is_limit(&refused("(a + b + c + d)^1000")));
    assert!(is_limit(&refused("x^1".replace('x', "((a + b + c + d + 1)^100)^100").as_str())));
    assert!(is_limit(&refused("a^1000000000000000000")));
    assert!(is_limit(&refused(
        "2^1000*3^1000*5^1000*7^1000*11^1000*13^1000*17^1000*19^1000*23^1000*29^1000"
    )));
    assert!(is_limit(&refused(&"(".repeat(100_000))));
    assert!(is_limit(&refused(&format!("1/{}", "7".repeat(100_000)))));
    let roots = "(1 + sqrt(2) + sqrt(3) + sqrt(5) + sqrt(7) + a)";
    assert!(is_limit(&refused(&format!("{roots}^1000"))));
}

#[test]
fn long_but_harmless_expressions_are_read() {
    let sum = vec!["a"; 100_000].join(" + ");
    assert!(in_time(|| Statement::read(&with_expression(&sum))).is_ok());
    let tower = format!("{}a{}", "(".repeat(60), ")".repeat(60));
    assert!(Statement::read(&with_expression(&tower)).is_ok());
}

#[test]
fn denominators_without_common_factors() {
    // Each is a legal number; their common denominator is not.
    let terms: Vec<String> =
        (0..400u64).map(|k| format!("a/{}", 10u128.pow(30) + u128::from(2 * k + 1))).collect();
    let polynomial = format!("({})*({})", terms.join(" + "), "b + 1");
    assert!(in_time(|| Statement::read(&with_expression(&polynomial))).is_err());
}

#[test]
fn toml_that_nests_or_never_ends() {
    let errors = |text: String| {
        in_time(|| Statement::read_bytes(text.as_bytes(), &mut Work::full())).expect_err("not a statement")
    };
    assert!(matches!(errors(format!("net = {}", "[".repeat(100_000))).fault, StatementFault::Toml(_)));
    assert!(matches!(errors(format!("net = {}", "{a=".repeat(100_000))).fault, StatementFault::Toml(_)));
    assert!(matches!(errors(vec!["a"; 100_000].join(".") + " = 1").fault, StatementFault::Toml(_)));
    let StatementError { fault, .. } = errors("#".repeat(limits::STATEMENT_BYTES.length() + 1));
    assert!(is_limit(&fault));
    let many: Vec<String> = (0..2000).map(|k| format!("\"x{k}\"")).collect();
    let many = format!("title = \"t\"\nradicands = []\nunknowns = [{}]\npolynomials = []\n", many.join(", "));
    assert!(is_limit(&errors(many).fault));
}

fn statement() -> Vec<u8> {
    std::fs::read("tests/data/reject/certificate/statement.toml").unwrap()
}

/// A certificate for that statement with these lines between the claim and the end.
fn certificate(lines: &str) -> String {
    let hash = Statement::read_bytes(&statement(), &mut Work::full()).unwrap().hash();
    format!("prove-cap certificate 1\nstatement sha256 {hash}\nclaim impossible\n{lines}")
}

fn complaint(certificate: &[u8]) -> CheckError {
    in_time(|| check(&statement(), certificate)).expect_err("hostile")
}

fn certificate_limit(error: &CheckError) -> bool {
    matches!(error, CheckError::Certificate(error) if matches!(error.fault, CertificateFault::Limit(_)))
}

#[test]
fn certificates_beyond_the_limits() {
    let line = certificate(&format!("step 1\nadd f[1] times {}\n", "x".repeat(10_000_000)));
    assert!(certificate_limit(&complaint(line.as_bytes())), "a line of 10 MB");
    let bytes = vec![b'\n'; limits::CERTIFICATE_BYTES.length() + 1];
    assert!(certificate_limit(&complaint(&bytes)), "17 million newlines");
    let steps: String = (1..=limits::STEPS.length() + 1)
        .map(|k| format!("step {k}\nadd f[1] times x\nconclude x\n"))
        .collect();
    assert!(certificate_limit(&complaint(certificate(&steps).as_bytes())), "too many steps");
}

#[test]
fn certificates_whose_steps_square() {
    // Each step would double the degree: the conclusions are lies, but finding that out must stay cheap.
    let mut lines = String::from("step 1\nadd f[2] times x^900\nconclude x^902\n");
    for k in 2..2000 {
        lines += &format!("step {k}\nadd step {} times x^900\nconclude x^902\n", k - 1);
    }
    assert!(matches!(complaint(certificate(&lines).as_bytes()), CheckError::Certificate(_)), "no end line");
    let error = complaint(certificate(&(lines + "end 1999\n")).as_bytes());
    assert!(matches!(error, CheckError::Rejected(_)), "{error:?}");
}

#[test]
fn a_product_of_two_long_polynomials_is_counted_before_it_is_made() {
    let dense: Vec<String> = (0..=999)
        .rev()
        .flat_map(|x| (0..20u32).rev().filter(move |y| x + y <= 999 && x > 1).map(move |y| (x, y)))
        .map(|(x, y)| match (x, y) {
            (x, 0) => format!("x^{x}"),
            (x, 1) => format!("x^{x}*y"),
            (x, y) => format!("x^{x}*y^{y}"),
        })
        .collect();
    // Sorted by degree, then by the exponent of x.
    let mut sorted = dense;
    let degree = |term: &str| -> u32 {
        term.split('*').map(|p| p.split_once('^').map_or(1, |(_, e)| e.parse().unwrap())).sum()
    };
    let exponent = |term: &str| -> u32 { term[2..].split('*').next().unwrap().parse().unwrap() };
    sorted.sort_by_key(|term| std::cmp::Reverse((degree(term), exponent(term))));
    let long = sorted.join(" + ");
    assert!(long.len() < limits::LINE_BYTES.length());
    let lines = format!(
        "step 1\nadd f[1] times {long}\nconclude {long}\nstep 2\nadd step 1 times {long}\nconclude 1\nend 2\n"
    );
    let error = complaint(certificate(&lines).as_bytes());
    assert!(matches!(error, CheckError::Rejected(_) | CheckError::Limited { .. }), "{error:?}");
}

/// A certificate by subdivision of the paper's patch, sealed.
fn sealed(lines: &[String], boxes: usize) -> String {
    let statement = fs::read_to_string("proofs/cap-2x2/statement.toml").unwrap();
    let hash = Statement::read(&statement).unwrap().hash();
    let head = format!("prove-cap certificate 1\nstatement sha256 {hash}\n");
    let text = format!("{head}{}\n", lines.join("\n"));
    let digest: String = Sha256::digest(&text).iter().map(|byte| format!("{byte:02x}")).collect();
    format!("{text}end {boxes} {digest}\n")
}

fn judged(text: &str) -> CheckError {
    let statement = fs::read("proofs/cap-2x2/statement.toml").unwrap();
    in_time(|| check(&statement, text.as_bytes())).expect_err("a limit or a rejection")
}

/// Halved again and again at one corner.
fn deep(depth: usize) -> String {
    "h".repeat(depth) + &".".repeat(depth + 1)
}

#[test]
fn deep_trees() {
    let lines = |tree: &str, denominator: &str| {
        [
            "claim bounds",
            "value w = -3",
            "value z = 2",
            "quantity radius 1",
            &format!("denominator {denominator}"),
            &format!("lower 0.0 at 0 0 over {tree}"),
            "upper 9.0 at 0 0 over .",
        ]
        .map(String::from)
    };
    let text = sealed(&lines(".", &deep(400_000)), 400_003);
    assert!(
        matches!(judged(&text), CheckError::Limited { place: Place::Node(..), .. } | CheckError::Rejected(_)),
        "{}",
        judged(&text)
    );
    let text = sealed(&lines(".", &deep(1_000_001)), 1_000_004);
    assert!(
        matches!(judged(&text), CheckError::Certificate(error) if matches!(error.fault, CertificateFault::Limit(_)))
    );
    let mut charts =
        vec!["claim unreachable", "quantity radius 1", "between 0.9 1.1", "range 8", "sample 1 at 1 1"];
    charts.push("chart 1");
    charts.extend(vec!["halve"; 400_000]);
    charts.extend(vec!["exclude 1*lower[1]"; 400_001]);
    for chart in ["chart 2", "chart 3", "chart 4", "chart 5"] {
        charts.extend([chart, "exclude 1*lower[1]"]);
    }
    let charts: Vec<String> = charts.into_iter().map(String::from).collect();
    let error = judged(&sealed(&charts, 400_005));
    assert!(matches!(error, CheckError::Limited { place: Place::Node(..), .. }), "{error}");
}

#[test]
fn long_numbers_in_arguments_by_subdivision() {
    let digits = "7".repeat(limits::DIGITS.length());
    let mut lines: Vec<String> =
        ["claim unreachable", "quantity radius 1", "between 0.9 1.1"].map(String::from).to_vec();
    lines.push(format!("range {digits}"));
    lines.push(format!("sample 1 at {digits}/{} {digits}*h", "8".repeat(limits::DIGITS.length() - 1) + "1"));
    for chart in 1..=5 {
        lines.extend([format!("chart {chart}"), "exclude 1*lower[1] + 1*upper[1]".to_owned()]);
    }
    let error = judged(&sealed(&lines, 5));
    assert!(
        matches!(
            error,
            CheckError::Limited { place: Place::Node(..), .. }
                | CheckError::Rejected(_)
                | CheckError::Certificate(_)
        ),
        "{error}"
    );
    let places = format!("{}.{}", "1".repeat(limits::DIGITS.length()), "0".repeat(1000));
    let lines = [
        "claim bounds",
        "value w = 1/2",
        "value z = 2",
        "quantity radius 1000",
        "denominator .",
        &format!("lower 0.{} at 0 0 over .", "0".repeat(1000)),
        &format!("upper {places} at 0 0 over ."),
    ]
    .map(String::from);
    assert!(matches!(judged(&sealed(&lines, 3)), CheckError::Certificate(_)));
}
