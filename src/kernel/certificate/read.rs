//! The strict reader: it accepts exactly the texts that the writer writes.

use std::str::Split;

use super::error::{CertificateError, CertificateFault as Fault};
use super::{Argument, Certificate, Premise, Step};
use crate::exact::{Limit, Polynomial, Ring, SpellingError, Work, limits};

impl Certificate {
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
        let text = check_text(bytes)?;
        let mut reader = Reader { ring, unknowns, text, lines: text.split('\n'), line: 0, work };
        let certificate = reader.certificate()?;
        // Belt and braces: the grammar above is meant to leave no second spelling.
        if certificate.write(ring) != text {
            return Err(reader.fail(1, Fault::NotCanonical));
        }
        Ok(certificate)
    }
}

/// Size, characters and line lengths, before anything is parsed.
fn check_text(bytes: &[u8]) -> Result<&str, CertificateError> {
    let error = |line, column, fault| CertificateError { line, column, fault };
    if bytes.is_empty() {
        return Err(error(1, 1, Fault::Empty));
    }
    if u64::try_from(bytes.len()).unwrap_or(u64::MAX) > limits::CERTIFICATE_BYTES {
        let limit = Limit::new("bytes in a certificate", limits::CERTIFICATE_BYTES);
        return Err(error(1, 1, limit.into()));
    }
    for (number, line) in (1usize..).zip(bytes.split(|&byte| byte == b'\n')) {
        if line.len() > limits::LINE_BYTES {
            return Err(error(number, 1, Limit::new("bytes in a line", 1 << 20).into()));
        }
        if let Some(at) = line.iter().position(|byte| !(b' '..=b'~').contains(byte)) {
            let carriage_return = line.get(at) == Some(&b'\r');
            let fault = if carriage_return { Fault::CarriageReturn } else { Fault::Character };
            return Err(error(number, at.saturating_add(1), fault));
        }
    }
    let lines = || bytes.iter().filter(|&&byte| byte == b'\n').count().saturating_add(1);
    std::str::from_utf8(bytes).map_err(|_| error(lines(), 1, Fault::Character))
}

pub(super) struct Reader<'a, 'w> {
    pub(super) ring: &'a Ring,
    pub(super) unknowns: usize,
    pub(super) text: &'a str,
    lines: Split<'a, char>,
    line: usize,
    work: &'w mut Work,
}

impl<'a> Reader<'a, '_> {
    pub(super) fn fail(&self, column: usize, fault: Fault) -> CertificateError {
        CertificateError { line: self.line, column, fault }
    }

    /// The next line; `expected` says which one is missing if there is none.
    pub(super) fn next(&mut self, expected: &'static str) -> Result<&'a str, CertificateError> {
        self.line = self.line.saturating_add(1);
        match self.lines.next() {
            // What follows the last newline is not a line.
            Some(line) if !(line.is_empty() && self.lines.clone().next().is_none()) => Ok(line),
            _ => Err(self.fail(1, Fault::Truncated { expected })),
        }
    }

    pub(super) fn unexpected(&self, line: &str, expected: &'static str) -> CertificateError {
        self.fail(1, Fault::Line { expected, found: line.chars().take(60).collect() })
    }

    fn certificate(&mut self) -> Result<Certificate, CertificateError> {
        let header = "`prove-cap certificate 1`";
        let line = self.next(header)?;
        if line != "prove-cap certificate 1" {
            return Err(self.unexpected(line, header));
        }
        let expected = "`statement sha256 ` and 64 lower-case hexadecimal digits";
        let line = self.next(expected)?;
        let hash = line.strip_prefix("statement sha256 ").filter(|hash| is_hash(hash));
        let statement = hash.ok_or_else(|| self.unexpected(line, expected))?.to_owned();
        let expected = "`claim ` and `impossible`, `exact`, `bounds`, `unreachable` or `cover`";
        let argument = match self.next(expected)? {
            "claim impossible" => self.steps()?,
            "claim exact" => self.exact()?,
            "claim bounds" => Argument::Bounds(self.bounds()?),
            "claim cover" => Argument::Cover(self.cover()?),
            "claim unreachable" => Argument::Unreachable(self.unreachable()?),
            other => return Err(self.unexpected(other, expected)),
        };
        match (self.lines.next(), self.lines.next()) {
            (Some(""), None) => Ok(Certificate { statement, argument }),
            (None, _) => Err(self.fail(1, Fault::NoFinalNewline)),
            _ => {
                self.line = self.line.saturating_add(1);
                Err(self.fail(1, Fault::AfterEnd))
            }
        }
    }

    fn steps(&mut self) -> Result<Argument, CertificateError> {
        let mut steps = Vec::new();
        loop {
            let expected = "`step`, or `end` and the number of steps";
            let line = self.next(expected)?;
            if self.is_end(line, steps.len())? {
                return Ok(Argument::Impossible(steps));
            }
            let number = line.strip_prefix("step ").ok_or_else(|| self.unexpected(line, expected))?;
            let next = count(steps.len()).saturating_add(1);
            if number != next.to_string() {
                let found = line.chars().take(60).collect();
                return Err(self.fail(1, Fault::StepNumber { expected: next, found }));
            }
            if steps.len() >= limits::STEPS {
                return Err(self.fail(1, Limit::new("steps", 100_000).into()));
            }
            steps.push(self.step(next)?);
        }
    }

    fn is_end(&self, line: &str, length: usize) -> Result<bool, CertificateError> {
        match line.strip_prefix("end ") {
            Some(number) if number == length.to_string() => Ok(true),
            Some(_) => {
                let found = line.chars().take(60).collect();
                Err(self.fail(1, Fault::Count { expected: count(length), found }))
            }
            None => Ok(false),
        }
    }

    fn step(&mut self, number: u64) -> Result<Step, CertificateError> {
        let mut combination: Vec<(Premise, Polynomial)> = Vec::new();
        loop {
            let expected = if combination.is_empty() {
                "`add … times …`"
            } else {
                "`add … times …` or `conclude …`"
            };
            let line = self.next(expected)?;
            if let Some(spelled) = line.strip_prefix("conclude ").filter(|_| !combination.is_empty()) {
                let conclusion = self.polynomial(line, spelled)?;
                return Ok(Step { combination, conclusion });
            }
            let parts = line.strip_prefix("add ").and_then(|rest| rest.split_once(" times "));
            let (name, spelled) = parts.ok_or_else(|| self.unexpected(line, expected))?;
            let premise = self.premise(name)?;
            if let Premise::Step(step) = premise
                && u64::from(step) >= number
            {
                return Err(self.fail(5, Fault::LaterStep { step: name.into() }));
            }
            if let Some((previous, _)) = combination.last().filter(|(previous, _)| *previous >= premise) {
                let previous = previous.to_string();
                return Err(self.fail(5, Fault::PremiseOrder { premise: name.into(), previous }));
            }
            let multiplier = self.polynomial(line, spelled)?;
            if multiplier.is_zero() {
                return Err(self.fail(column(line, spelled), Fault::ZeroMultiplier));
            }
            combination.push((premise, multiplier));
        }
    }

    fn premise(&self, name: &str) -> Result<Premise, CertificateError> {
        let bracketed = |prefix: &str| name.strip_prefix(prefix)?.strip_suffix(']');
        if let Some((r, s)) = bracketed("c[").and_then(|pair| pair.split_once(',')) {
            return Ok(Premise::Coefficient(self.index(r)?, self.index(s)?));
        }
        if let Some(k) = bracketed("f[") {
            return Ok(Premise::Equation(self.index(k)?));
        }
        if let Some(k) = bracketed("nonzero[") {
            return Ok(Premise::Nonzero(self.index(k)?));
        }
        match name.strip_prefix("step ") {
            Some(k) => Ok(Premise::Step(self.index(k)?)),
            None => {
                let expected = "a premise c[r,s], f[k], nonzero[k] or step k";
                Err(self.fail(5, Fault::Line { expected, found: name.chars().take(60).collect() }))
            }
        }
    }

    /// A canonical decimal number. What does not fit 32 bits names nothing a statement could have.
    pub(super) fn index(&self, digits: &str) -> Result<u32, CertificateError> {
        let decimal =
            !digits.is_empty() && digits.len() <= 10 && digits.bytes().all(|byte| byte.is_ascii_digit());
        let canonical = decimal && (digits == "0" || !digits.starts_with('0'));
        digits.parse().ok().filter(|_| canonical).ok_or_else(|| {
            let found = digits.chars().take(24).collect();
            self.fail(5, Fault::Index { found })
        })
    }

    fn exact(&mut self) -> Result<Argument, CertificateError> {
        let values = self.values()?;
        let expected = "`end` and the number of unknowns";
        let line = self.next(expected)?;
        match self.is_end(line, values.len())? {
            true => Ok(Argument::Exact(values)),
            false => Err(self.unexpected(line, expected)),
        }
    }

    /// A line for each unknown, in order.
    pub(super) fn values(&mut self) -> Result<Vec<Polynomial>, CertificateError> {
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

    pub(super) fn polynomial(&mut self, line: &str, spelled: &str) -> Result<Polynomial, CertificateError> {
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
pub(super) fn column(line: &str, tail: &str) -> usize {
    line.len().saturating_sub(tail.len()).saturating_add(1)
}

fn count(length: usize) -> u64 {
    u64::try_from(length).unwrap_or(u64::MAX)
}

fn is_hash(text: &str) -> bool {
    text.len() == 64 && text.bytes().all(|byte| byte.is_ascii_digit() || (b'a'..=b'f').contains(&byte))
}
