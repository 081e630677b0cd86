//! Attacks that grow, and what they are held to.

use prove_cap_kernel::checker::{CheckError, Claim};
use prove_cap_kernel::exact::{Limit, Work, limits};
use prove_cap_kernel::statement::Statement;
use sha2::{Digest, Sha256};

use super::measure::{Measured, alone, measured};

/// A statement with a certificate.
pub(crate) struct Attack {
    pub(crate) statement: String,
    pub(crate) certificate: String,
}

impl Attack {
    /// These lines after the hash, `CLAIM` first.
    pub(crate) fn new(statement: String, lines: &[String]) -> Self {
        let certificate = format!("{}{}\n", head(&statement, 1), lines.join("\n"));
        Attack { statement, certificate }
    }

    /// The same with the last line of an argument by subdivision.
    pub(crate) fn sealed(version: u32, statement: String, lines: &[String], boxes: usize) -> Self {
        let text = format!("{}{}\n", head(&statement, version), lines.join("\n"));
        let digest: String = Sha256::digest(&text).iter().map(|byte| format!("{byte:02x}")).collect();
        Attack { statement, certificate: format!("{text}end {boxes} {digest}\n") }
    }

    /// A statement that is all of the attack.
    pub(crate) fn of_statement(statement: String) -> Self {
        let certificate = format!("prove-cap certificate 1\nstatement sha256 {}\n", "0".repeat(64));
        Attack { statement, certificate }
    }
}

fn head(statement: &str, version: u32) -> String {
    let read = Statement::read_bytes(statement.as_bytes(), &mut Work::full()).unwrap();
    format!("prove-cap certificate {version}\nstatement sha256 {}\n", read.hash())
}

/// How an attack ends.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum End {
    Verified,
    /// With these first words.
    Rejected(&'static str),
    /// No file of the format, with these words in the message.
    Refused(&'static str),
    Limit(Limit),
    /// Out of units, however many there are.
    OutOfWork,
}

/// Sizes, and the units that the check may take; where all are taken, how large they are makes no difference.
pub(crate) const FEW: u64 = 300_000_000;
pub(crate) const ALL: u64 = 4_000_000_000;

/// Makes the attack in each size, and checks what it comes to: at the last size, to this.
pub(crate) fn ends(name: &str, sizes: &[usize], units: u64, end: &End, made: impl Fn(usize) -> Attack) {
    let _alone = alone();
    for size in sizes {
        let Attack { statement, certificate } = made(*size);
        let measured = measured(statement.as_bytes(), certificate.as_bytes(), units);
        let place = format!("{name} of size {size}: {}", told(&measured));
        obeys_the_laws(&place, &measured, (statement.len(), certificate.len()), units);
        if Some(size) == sizes.last() {
            assert!(is(&measured, end), "{place}, expected {end:?}");
        }
    }
}

fn told(measured: &Measured) -> String {
    let Measured { result, units, held, peak, allocated } = measured;
    let end = match result {
        Ok(theorem) => format!("VERIFIED {}", theorem.kind()),
        Err(error) => error.to_string().chars().take(120).collect(),
    };
    let text = format!("{units} units, {held} bytes held, {peak} at most, {allocated} in all: {end}");
    if std::env::var_os("PROVE_CAP_SHOW").is_some() {
        eprintln!("{text}");
    }
    text
}

/// The bytes that files of this length make beside what is metered: the texts, read and written again.
fn of_files((statement, certificate): (usize, usize)) -> u64 {
    6 * certificate as u64 + 2 * statement as u64 + 200_000
}

/// No memory that was not paid for; nothing is done that was not paid for, as far as it allocates; and all
/// within the format.
fn obeys_the_laws(place: &str, measured: &Measured, files: (usize, usize), units: u64) {
    assert!(measured.units <= units, "{place}");
    assert!(measured.peak <= measured.held + of_files(files), "{place}: memory that nobody paid for");
    assert!(measured.peak <= 1 << 30, "{place}: more than 1 GiB");
    assert!(
        measured.allocated <= 2 * measured.units + 8 * of_files(files),
        "{place}: work that nobody paid for"
    );
}

fn is(measured: &Measured, end: &End) -> bool {
    match (&measured.result, end) {
        (Ok(theorem), End::Verified) => {
            !matches!(theorem.claim(), Claim::Cover(covered) if covered.boxes == 0)
        }
        (Err(CheckError::Rejected(rejection)), End::Rejected(words)) => {
            rejection.to_string().starts_with(words)
        }
        (Err(error @ (CheckError::Statement(_) | CheckError::Certificate(_))), End::Refused(words)) => {
            error.limit().is_none() && error.to_string().contains(words)
        }
        (Err(error), End::OutOfWork) => error.limit().is_some_and(|limit| limit.what == limits::WORK.what),
        (Err(error), End::Limit(limit)) => error.limit() == Some(limit),
        _ => false,
    }
}

pub(crate) const OUT_OF_WORK: End = End::OutOfWork;
pub(crate) const OUT_OF_MEMORY: End = End::Limit(limits::MEMORY);

/// Numbers without common factors, of so many digits.
pub(crate) fn long_number(digits: usize, seed: usize) -> String {
    let mut state = seed as u64 * 2 + 1;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        char::from(b'1' + (state >> 33) as u8 % 9)
    };
    let mut number: String = (1..digits).map(|_| next()).collect();
    number.push(['1', '3', '7', '9'][seed % 4]);
    number
}

/// The names `x0`, `x1`, …
pub(crate) fn names(count: usize) -> Vec<String> {
    (0..count).map(|k| format!("x{k}")).collect()
}

/// A statement with these names and lines.
pub(crate) fn statement(radicands: &str, unknowns: &[String], lines: &str) -> String {
    let quoted: Vec<String> = unknowns.iter().map(|name| format!("\"{name}\"")).collect();
    format!("title = \"t\"\nradicands = [{radicands}]\nunknowns = [{}]\n{lines}\n", quoted.join(", "))
}
