//! The text of claim `impossible`: FORMAT.md, "Certificates".

use super::Step;
use crate::equations::Premise;
use crate::exact::{Polynomial, Ring, count, limits};
use crate::text::{CertificateError, CertificateFault as Fault, Reader, column};

/// The lines after the claim.
pub(in crate::claims) fn write(steps: &[Step], ring: &Ring, lines: Vec<String>) -> String {
    let mut lines = lines;
    for (number, step) in (1u32..).zip(steps) {
        lines.push(format!("step {number}"));
        for (premise, multiplier) in &step.combination {
            lines.push(format!("add {premise} times {}", ring.spell(multiplier)));
        }
        lines.push(format!("conclude {}", ring.spell(&step.conclusion)));
    }
    lines.push(format!("end {}", steps.len()));
    lines.push(String::new());
    lines.join("\n")
}

/// Reads them.
pub(in crate::claims) fn read(reader: &mut Reader<'_, '_>) -> Result<Vec<Step>, CertificateError> {
    let mut steps = Vec::new();
    loop {
        let expected = "`step`, or `end` and the number of steps";
        let line = reader.next(expected)?;
        if reader.is_end(line, steps.len())? {
            return Ok(steps);
        }
        let number = line.strip_prefix("step ").ok_or_else(|| reader.unexpected(line, expected))?;
        let next = count(steps.len()).saturating_add(1);
        if number != next.to_string() {
            let found = line.chars().take(60).collect();
            return Err(reader.fail(1, Fault::StepNumber { expected: next, found }));
        }
        reader.limited(limits::STEPS.check(next))?;
        reader.keep(128)?;
        steps.push(step(reader, next)?);
    }
}

fn step(reader: &mut Reader<'_, '_>, number: u64) -> Result<Step, CertificateError> {
    let mut combination: Vec<(Premise, Polynomial)> = Vec::new();
    loop {
        let expected = if combination.is_empty() {
            "`add … times …`"
        } else {
            "`add … times …` or `conclude …`"
        };
        let line = reader.next(expected)?;
        if let Some(spelled) = line.strip_prefix("conclude ").filter(|_| !combination.is_empty()) {
            let conclusion = reader.polynomial(line, spelled)?;
            return Ok(Step { combination, conclusion });
        }
        let parts = line.strip_prefix("add ").and_then(|rest| rest.split_once(" times "));
        let (name, spelled) = parts.ok_or_else(|| reader.unexpected(line, expected))?;
        let premise = premise(reader, name)?;
        if let Premise::Step(step) = premise
            && u64::from(step) >= number
        {
            return Err(reader.fail(5, Fault::LaterStep { step: name.into() }));
        }
        if let Some((previous, _)) = combination.last().filter(|(previous, _)| *previous >= premise) {
            let previous = previous.to_string();
            return Err(reader.fail(5, Fault::PremiseOrder { premise: name.into(), previous }));
        }
        let multiplier = reader.polynomial(line, spelled)?;
        if multiplier.is_zero() {
            return Err(reader.fail(column(line, spelled), Fault::ZeroMultiplier));
        }
        reader.keep(128)?;
        combination.push((premise, multiplier));
    }
}

fn premise(reader: &Reader<'_, '_>, name: &str) -> Result<Premise, CertificateError> {
    let bracketed = |prefix: &str| name.strip_prefix(prefix)?.strip_suffix(']');
    if let Some((r, s)) = bracketed("c[").and_then(|pair| pair.split_once(',')) {
        return Ok(Premise::Coefficient(reader.index(r)?, reader.index(s)?));
    }
    if let Some(k) = bracketed("f[") {
        return Ok(Premise::Equation(reader.index(k)?));
    }
    if let Some(k) = bracketed("nonzero[") {
        return Ok(Premise::Nonzero(reader.index(k)?));
    }
    match name.strip_prefix("step ") {
        Some(k) => Ok(Premise::Step(reader.index(k)?)),
        None => {
            let expected = "a premise c[r,s], f[k], nonzero[k] or step k";
            Err(reader.fail(5, Fault::Line { expected, found: name.chars().take(60).collect() }))
        }
    }
}
