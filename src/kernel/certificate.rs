//! How a claim is argued: the file that a checker is given beside the statement.
//!
//! A certificate never carries its axioms: its premises are *names* of polynomials that the checker derives
//! from the statement. Text form, grammar and limits: `proofs/FORMAT.md`. There is one spelling of each
//! certificate, and the reader accepts no other.

pub use crate::claims::{
    Argument, Bounds, Cover, EDGES, EdgeTree, End, Odds, Quantity, Region, Side, Step, Tree, Units,
    Unreachable, spell_decimal,
};
pub use crate::equations::Premise;
pub use crate::exact::decimal_value;
pub use crate::text::{CertificateError, CertificateFault};

use crate::claims::EXPECTED;
use crate::exact::{Ring, Work};
use crate::text::{Reader, check_text};

/// The first line, and the version in it.
const HEADERS: [(&str, u32); 2] = [("prove-cap certificate 1", 1), ("prove-cap certificate 2", 2)];

/// An argument for a claim about the statement with a certain hash.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Certificate {
    /// SHA-256 of the canonical statement, in lower-case hexadecimal.
    pub statement: String,
    /// The argument.
    pub argument: Argument,
}

impl Certificate {
    /// The text, spelled with the names of the statement's ring.
    pub fn write(&self, ring: &Ring) -> String {
        let version = format!("prove-cap certificate {}", self.argument.version());
        let first = vec![version, format!("statement sha256 {}", self.statement)];
        self.argument.write(ring, first)
    }

    /// The hash of the statement that a file says it is for, all that is looked at being its first two lines; `None` where
    /// they are not those of a certificate, of which [`read`](Certificate::read) has more to say.
    pub fn statement_of(bytes: &[u8]) -> Option<&str> {
        let mut lines = bytes.splitn(3, |&byte| byte == b'\n');
        let (header, line) = (lines.next()?, lines.next()?);
        let hash = std::str::from_utf8(line).ok()?.strip_prefix("statement sha256 ")?;
        let known = HEADERS.iter().any(|(text, _)| header == text.as_bytes());
        (known && is_hash(hash)).then_some(hash)
    }

    /// Reads a certificate, spelled with the names of `ring`.
    ///
    /// `unknowns` is how many of the ring's variables are unknowns of the statement (the others are
    /// Rabinowitsch variables): a claim `exact` gives a value to each of them.
    ///
    /// # Errors
    /// [`CertificateError`] with line and column.
    pub fn read(
        bytes: &[u8],
        ring: &Ring,
        unknowns: usize,
        work: &mut Work,
    ) -> Result<Certificate, CertificateError> {
        let text = check_text(bytes, work)?;
        let mut reader = Reader::new(text, ring, unknowns, work);
        let header = "`prove-cap certificate 1` or `prove-cap certificate 2`";
        let line = reader.next(header)?;
        let known = HEADERS.iter().find(|(text, _)| line == *text);
        let (_, version) = known.ok_or_else(|| unknown_version(&reader, line, header))?;
        reader.version = *version;
        let older = reader.unexpected(line, "`prove-cap certificate 1`");
        let expected = "`statement sha256 ` and 64 lower-case hexadecimal digits";
        let line = reader.next(expected)?;
        let hash = line.strip_prefix("statement sha256 ").filter(|hash| is_hash(hash));
        let statement = hash.ok_or_else(|| reader.unexpected(line, expected))?.to_owned();
        let line = reader.next(EXPECTED)?;
        // These have what is new in version 2.
        if reader.version == 2 && !["claim bounds", "claim unreachable"].contains(&line) {
            return Err(older);
        }
        let argument = line.strip_prefix("claim ").and_then(|keyword| Argument::read(keyword, &mut reader));
        let argument = argument.ok_or_else(|| reader.unexpected(line, EXPECTED))??;
        reader.finish()?;
        let certificate = Certificate { statement, argument };
        // Belt and braces: the grammar above is meant to leave no second spelling.
        if certificate.write(ring) != text {
            return Err(reader.fail(1, CertificateFault::NotCanonical));
        }
        Ok(certificate)
    }
}

/// Another first line: one of a version to come, or of no certificate.
fn unknown_version(reader: &Reader<'_, '_>, line: &str, header: &'static str) -> CertificateError {
    let number = line.strip_prefix("prove-cap certificate ").and_then(|number| reader.index(number).ok());
    match number.filter(|&number| number > 0) {
        Some(found) => reader.fail(1, CertificateFault::Version { found, known: "1 and 2" }),
        None => reader.unexpected(line, header),
    }
}

fn is_hash(text: &str) -> bool {
    text.len() == 64 && text.bytes().all(|byte| byte.is_ascii_digit() || (b'a'..=b'f').contains(&byte))
}
