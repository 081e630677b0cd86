//! What a unit of work costs: 10⁹ units of every kind that is dear, and the longest proof.
//!
//! `cargo bench -p prove-cap-kernel`. The slowest line but the last two, times 15, is how long the whole
//! allowance lasts.
#![allow(
    clippy::arithmetic_side_effects,
    clippy::as_conversions,
    clippy::expect_used,
    reason = "a benchmark"
)]

use divan::Bencher;
use prove_cap_kernel::checker::{CheckError, Theorem, check_within};
use prove_cap_kernel::exact::Work;
use prove_cap_kernel::statement::Statement;
use sha2::{Digest, Sha256};

fn main() {
    divan::main();
}

const UNITS: u64 = 1_000_000_000;

/// A statement with a certificate that asks for more than 10⁹ units.
struct Case {
    statement: String,
    certificate: String,
}

impl Case {
    fn check(&self) -> Result<Theorem, CheckError> {
        let mut work = Work::full().at_most(UNITS);
        check_within(self.statement.as_bytes(), self.certificate.as_bytes(), &mut work)
    }
}

/// A system with these unknowns and this polynomial.
fn system(radicands: &str, polynomial: &str) -> Case {
    let statement = format!(
        "title = \"t\"\nradicands = [{radicands}]\nunknowns = [\"a\", \"b\", \"c\", \"d\"]\npolynomials = [\"{polynomial}\"]\n"
    );
    Case { statement, certificate: "-".to_owned() }
}

fn digits(count: usize) -> String {
    (0..count).map(|k| char::from(b'1' + (k * k % 9) as u8)).collect()
}

/// Exclusions in one unknown, the other lines of an `unreachable` being these.
fn sealed(x: &str, lines: &[String]) -> Case {
    let statement = format!(
        "title = \"t\"\nradicands = []\nunknowns = [\"x\"]\nconvention = \"homogeneous\"\nsurface = \"X\"\nbidegree = [1, 1]\n\
         net = [[[\"{x}\", 0, 0, 1], [0, 0, 0, 1]], [[0, 0, 0, 1], [0, 0, 0, 1]]]\n"
    );
    let hash = Statement::read(&statement).expect("well formed").hash();
    let boxes = lines.iter().filter(|line| line.starts_with("exclude")).count();
    let text = format!(
        "prove-cap certificate 1\nstatement sha256 {hash}\nclaim unreachable\nquantity ratio 0\nbetween 0 1\nrange 1\n\
         sample 1 at 0 0\n{}\n",
        lines.join("\n")
    );
    let digest: String = Sha256::digest(&text).iter().map(|byte| format!("{byte:02x}")).collect();
    Case { statement, certificate: format!("{text}end {boxes} {digest}\n") }
}

#[divan::bench(sample_count = 10)]
fn terms_of_a_power(bencher: Bencher) {
    let case = system("", "(a + b + c + d)^1000");
    bencher.bench(|| case.check().expect_err("a limit"));
}

#[divan::bench(sample_count = 10)]
fn terms_with_roots(bencher: Bencher) {
    let case = system("2, 3, 5, 7", "(1 + sqrt(2) + sqrt(3) + sqrt(5) + sqrt(7) + a)^1000");
    bencher.bench(|| case.check().expect_err("a limit"));
}

#[divan::bench(sample_count = 10)]
fn common_divisors(bencher: Bencher) {
    let quotients: Vec<String> = (0..50).map(|k| format!("a/{}{}", digits(4000), 2 * k + 1)).collect();
    let case = system("", &quotients.join(" + "));
    bencher.bench(|| case.check().expect_err("a limit"));
}

#[divan::bench(sample_count = 10)]
fn products_of_long_numbers(bencher: Bencher) {
    let case = system("", &format!("({}*a + {}*b + c)^99", digits(40), digits(39)));
    bencher.bench(|| case.check().expect_err("a limit"));
}

/// What is put for a variable of degree 1000.
#[divan::bench(sample_count = 10)]
fn substitutions(bencher: Bencher) {
    let mut lines = vec!["chart 1".to_owned()];
    lines.extend(vec!["halve".to_owned(); 4]);
    lines.extend(vec!["exclude 1*lower[1]".to_owned(); 5]);
    for chart in [2, 3] {
        lines.extend([format!("chart {chart}"), "exclude 1*lower[1]".to_owned()]);
    }
    let case = sealed("-x^1000", &lines);
    bencher.bench(|| case.check().expect_err("a limit"));
}

#[divan::bench(sample_count = 10)]
fn small_boxes(bencher: Bencher) {
    let mut lines = vec!["chart 1".to_owned()];
    lines.extend(vec!["halve".to_owned(); 100_000]);
    lines.extend(vec!["exclude 1*lower[1]".to_owned(); 100_001]);
    for chart in [2, 3] {
        lines.extend([format!("chart {chart}"), "exclude 1*lower[1]".to_owned()]);
    }
    let case = sealed("-x^2", &lines);
    bencher.bench(|| case.check().expect_err("a limit"));
}

/// Reading alone: 3·10⁸ units.
#[divan::bench(sample_count = 10)]
fn toml(bencher: Bencher) {
    let statement = format!("title = \"t\"\nnet = [{}]\n", vec!["[]"; 160_000].join(","));
    let case = Case { statement, certificate: String::new() };
    bencher.bench(|| case.check().expect_err("no patch"));
}

/// No unit's price but a whole check: of the longest proof there is.
#[divan::bench(sample_count = 10)]
fn the_longest_proof(bencher: Bencher) {
    let read = |name| std::fs::read(format!("../../proofs/cap-4x3/{name}")).expect("committed");
    let (statement, certificate) = (read("statement.toml"), read("certificate.txt"));
    bencher.bench(|| check_within(&statement, &certificate, &mut Work::full()).expect("verified"));
}
