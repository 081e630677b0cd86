//! The strict reader of lines: each claim says which ones it expects.

use std::str::Split;

use super::error::{CertificateError, CertificateFault as Fault};
use crate::exact::{Limit, Polynomial, Ring, SpellingError, Work, count, limits};

/// Size, characters and line lengths, before anything is parsed.
pub(crate) fn check_text<'a>(bytes: &'a [u8], work: &mut Work) -> Result<&'a str, CertificateError> {
    let error = |line, column, fault| CertificateError { line, column, fault };
    if bytes.is_empty() {
        return Err(error(1, 1, Fault::Empty));
    }
    limits::CERTIFICATE_BYTES.check(bytes.len()).map_err(|limit| error(1, 1, limit.into()))?;
    // Reading it, writing it again, and the seal.
    work.charge_text(bytes.len()).map_err(|limit| error(1, 1, limit.into()))?;
    for (number, line) in (1usize..).zip(bytes.split(|&byte| byte == b'\n')) {
        limits::LINE_BYTES.check(line.len()).map_err(|limit| error(number, 1, limit.into()))?;
        if let Some(at) = line.iter().position(|byte| !(b' '..=b'~').contains(byte)) {
            let carriage_return = line.get(at) == Some(&b'\r');
            let fault = if carriage_return { Fault::CarriageReturn } else { Fault::Character };
            return Err(error(number, at.saturating_add(1), fault));
        }
    }
    let lines = || bytes.iter().filter(|&&byte| byte == b'\n').count().saturating_add(1);
    std::str::from_utf8(bytes).map_err(|_| error(lines(), 1, Fault::Character))
}

/// The lines of a certificate, one after another, spelled with the names of `ring`.
pub(crate) struct Reader<'a, 'w> {
    pub(crate) ring: &'a Ring,
    /// How many of the ring's variables are unknowns of the statement; the others are Rabinowitsch variables.
    pub(crate) unknowns: usize,
    pub(crate) text: &'a str,
    /// Which version the first line names.
    pub(crate) version: u32,
    lines: Split<'a, char>,
    line: usize,
    work: &'w mut Work,
}

impl<'a, 'w> Reader<'a, 'w> {
    pub(crate) fn new(text: &'a str, ring: &'a Ring, unknowns: usize, work: &'w mut Work) -> Self {
        Reader { ring, unknowns, text, version: 1, lines: text.split('\n'), line: 0, work }
    }

    pub(crate) fn fail(&self, column: usize, fault: Fault) -> CertificateError {
        CertificateError { line: self.line, column, fault }
    }

    /// A limit reached in this line.
    pub(crate) fn limited(&self, result: Result<(), Limit>) -> Result<(), CertificateError> {
        result.map_err(|limit| self.fail(1, limit.into()))
    }

    /// Memory for what is read.
    pub(crate) fn keep(&mut self, bytes: u64) -> Result<(), CertificateError> {
        let kept = self.work.keep(bytes);
        self.limited(kept)
    }

    /// Numbers of so many digits.
    pub(crate) fn charge_digits(&mut self, digits: usize) -> Result<(), CertificateError> {
        let charged = self.work.charge_digits(digits);
        self.limited(charged)
    }

    /// A look through so many names.
    pub(crate) fn charge_search(&mut self, names: usize) -> Result<(), CertificateError> {
        let charged = self.work.charge_search(names);
        self.limited(charged)
    }

    /// The next line; `expected` says which one is missing if there is none.
    pub(crate) fn next(&mut self, expected: &'static str) -> Result<&'a str, CertificateError> {
        self.line = self.line.saturating_add(1);
        // What it becomes, and the line once more, in lists that may have room for twice as many.
        self.keep(160)?;
        match self.lines.next() {
            // What follows the last newline is not a line.
            Some(line) if !(line.is_empty() && self.lines.clone().next().is_none()) => Ok(line),
            _ => Err(self.fail(1, Fault::Truncated { expected })),
        }
    }

    pub(crate) fn unexpected(&self, line: &str, expected: &'static str) -> CertificateError {
        self.fail(1, Fault::Line { expected, found: line.chars().take(60).collect() })
    }

    /// The end of the text: nothing follows.
    pub(crate) fn finish(&mut self) -> Result<(), CertificateError> {
        match (self.lines.next(), self.lines.next()) {
            (Some(""), None) => Ok(()),
            (None, _) => Err(self.fail(1, Fault::NoFinalNewline)),
            _ => {
                self.line = self.line.saturating_add(1);
                Err(self.fail(1, Fault::AfterEnd))
            }
        }
    }

    /// Whether the line is `end` with this number.
    pub(crate) fn is_end(&self, line: &str, length: usize) -> Result<bool, CertificateError> {
        match line.strip_prefix("end ") {
            Some(number) if number == length.to_string() => Ok(true),
            Some(_) => {
                let found = line.chars().take(60).collect();
                Err(self.fail(1, Fault::Count { expected: count(length), found }))
            }
            None => Ok(false),
        }
    }

    /// A canonical decimal number. What does not fit 32 bits names nothing a statement could have.
    pub(crate) fn index(&self, digits: &str) -> Result<u32, CertificateError> {
        let decimal =
            !digits.is_empty() && digits.len() <= 10 && digits.bytes().all(|byte| byte.is_ascii_digit());
        let canonical = decimal && (digits == "0" || !digits.starts_with('0'));
        digits.parse().ok().filter(|_| canonical).ok_or_else(|| {
            let found = digits.chars().take(24).collect();
            self.fail(5, Fault::Index { found })
        })
    }

    /// A line for each unknown, in order.
    pub(crate) fn values(&mut self) -> Result<Vec<Polynomial>, CertificateError> {
        let mut values = Vec::new();
        let names: Vec<&String> = self.ring.variables.iter().take(self.unknowns).collect();
        for name in names {
            let expected = "`value`, the next unknown of the statement, ` = ` and its value";
            let line = self.next(expected)?;
            let rest = line.strip_prefix("value ").and_then(|rest| rest.strip_prefix(name.as_str()));
            let spelled = rest.and_then(|rest| rest.strip_prefix(" = "));
            let spelled = spelled.ok_or_else(|| self.unexpected(line, expected))?;
            let value = self.polynomial(line, spelled)?;
            if !value.is_constant() {
                return Err(self.fail(column(line, spelled), Fault::NotConstant));
            }
            values.push(value);
        }
        Ok(values)
    }

    pub(crate) fn polynomial(&mut self, line: &str, spelled: &str) -> Result<Polynomial, CertificateError> {
        self.ring.read(spelled, self.work).map_err(|error| {
            let column = column(line, spelled).saturating_add(error.at());
            match error {
                SpellingError::Limit { limit, .. } => self.fail(column, limit.into()),
                expected @ SpellingError::Expected { .. } => self.fail(column, Fault::Spelling(expected)),
            }
        })
    }
}

/// The column, from 1, at which `tail`, the end of `line`, starts.
pub(crate) fn column(line: &str, tail: &str) -> usize {
    line.len().saturating_sub(tail.len()).saturating_add(1)
}
