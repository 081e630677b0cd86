//! The text of claim `unreachable`: FORMAT.md, "Certificates by subdivision".

use num_bigint::BigInt;
use num_traits::Signed;

use super::{Odds, Region, Unreachable};
use crate::claims::subdivision::{Side, quantity, sealed, spell_decimal};
use crate::exact::{Polynomial, Ring, count, limits, read_natural};
use crate::text::{CertificateError, CertificateFault as Fault, Reader};

/// The lines after the claim.
pub(in crate::claims) fn write(argument: &Unreachable, ring: &Ring, lines: Vec<String>) -> String {
    let decimal = |units| spell_decimal(units, argument.places);
    let name = |index: u16| ring.variables.get(usize::from(index)).cloned().unwrap_or_default();
    let mut lines = lines;
    lines.push(quantity(argument.quantity, argument.places));
    lines.push(format!("between {} {}", decimal(&argument.lower), decimal(&argument.upper)));
    lines.extend(argument.products.iter().map(|&(z, w)| format!("product {}*{}", name(z), name(w))));
    lines.extend(argument.forms.iter().map(|(x, form)| format!("put {} = {}", name(*x), ring.spell(form))));
    lines.push(format!("range {}", argument.range));
    let odds =
        |odds: &Odds| if odds.shrinking { format!("{}*h", odds.value) } else { odds.value.to_string() };
    for (number, [u, v]) in (1usize..).zip(&argument.samples) {
        lines.push(format!("sample {number} at {} {}", odds(u), odds(v)));
    }
    let mut boxes = 0usize;
    for (number, chart) in (1usize..).zip(&argument.charts) {
        lines.push(format!("chart {number}"));
        for region in chart {
            lines.push(match region {
                Region::Halved => "halve".to_owned(),
                Region::Excluded(sum) => {
                    boxes = boxes.saturating_add(1);
                    let terms = sum
                        .iter()
                        .map(|(factor, side, sample)| format!("{factor}*{}[{sample}]", side.name()));
                    format!("exclude {}", terms.collect::<Vec<_>>().join(" + "))
                }
            });
        }
    }
    sealed(lines, boxes)
}

/// Reads them.
pub(in crate::claims) fn read(reader: &mut Reader<'_, '_>) -> Result<Unreachable, CertificateError> {
    let (quantity, places) = reader.quantity()?;
    let expected = "`between ` and two decimals";
    let line = reader.next(expected)?;
    let pair = line.strip_prefix("between ").and_then(|rest| rest.split_once(' '));
    let (low, high) = pair.ok_or_else(|| reader.unexpected(line, expected))?;
    let (lower, upper) = (reader.decimal(low, places)?, reader.decimal(high, places)?);
    // In version 2 something is put for an unknown, in version 1 nothing is.
    let newer = reader.version > 1;
    let expected = if newer { "`product` or `put`" } else { "`product` or `range`" };
    let mut line = reader.next(expected)?;
    let mut products = Vec::new();
    while let Some(text) = line.strip_prefix("product ") {
        reader.charge_search(reader.unknowns.saturating_mul(2))?;
        let pair = text.split_once('*').and_then(|(z, w)| Some((unknown(reader, z)?, unknown(reader, w)?)));
        let pair = pair.filter(|(z, w)| z != w && products.len() < reader.unknowns);
        products.push(pair.ok_or_else(|| reader.unexpected(line, "`product ` and two unknowns, z*w"))?);
        line = reader.next(expected)?;
    }
    let mut forms: Vec<(u16, Polynomial)> = Vec::new();
    if newer && !line.starts_with("put ") {
        return Err(reader.unexpected(line, expected));
    }
    while let Some(text) = line.strip_prefix("put ").filter(|_| newer) {
        reader.charge_search(reader.unknowns)?;
        let form = form(reader, line, text, forms.last().map(|(before, _)| *before))?;
        forms.push(form);
        line = reader.next("`put` or `range`")?;
    }
    reader.charge_digits(line.len().min(limits::DIGITS.length()).saturating_mul(2))?;
    let range = line.strip_prefix("range ").filter(|digits| limits::DIGITS.allows(digits.len()));
    let range = range
        .and_then(|digits| read_natural(digits).ok())
        .filter(|(range, rest)| rest.is_empty() && range.is_positive());
    let (range, _) = range.ok_or_else(|| reader.unexpected(line, "`range ` and a positive integer"))?;
    let (samples, charts) = charts(reader)?;
    Ok(Unreachable { quantity, places, lower, upper, products, forms, range, samples, charts })
}

/// `z = 500*z + 3*w`: in the order of the unknowns, each once; its form is not the unknown alone, but contains it.
fn form(
    reader: &mut Reader<'_, '_>,
    line: &str,
    text: &str,
    before: Option<u16>,
) -> Result<(u16, Polynomial), CertificateError> {
    let expected = "`put`, a later unknown than before, ` = ` and another form of degree 1 with rational \
                    coefficients in the unknowns, which contains this one";
    let parts = text.split_once(" = ").and_then(|(name, form)| Some((unknown(reader, name)?, form)));
    let (unknown, spelled) = parts
        .filter(|(unknown, _)| before.is_none_or(|before| before < *unknown))
        .ok_or_else(|| reader.unexpected(line, expected))?;
    let form = reader.polynomial(line, spelled)?;
    let is_unknown = |&(k, _): &(u16, u32)| usize::from(k) < reader.unknowns;
    let affine = form.terms().all(|(monomial, _)| {
        monomial.mask() == 0 && monomial.degree() <= 1 && monomial.powers().iter().all(is_unknown)
    });
    let contains = form.terms().any(|(monomial, _)| monomial.exponent(unknown) == 1);
    match affine && contains && form != Polynomial::variable(unknown) {
        true => Ok((unknown, form)),
        false => Err(reader.unexpected(line, expected)),
    }
}

fn unknown(reader: &Reader<'_, '_>, name: &str) -> Option<u16> {
    let position = reader.ring.variables.iter().take(reader.unknowns).position(|unknown| unknown == name)?;
    u16::try_from(position).ok()
}

#[expect(clippy::type_complexity, reason = "the two lists that the lines make up")]
fn charts(reader: &mut Reader<'_, '_>) -> Result<(Vec<[Odds; 2]>, Vec<Vec<Region>>), CertificateError> {
    let mut samples = Vec::new();
    let mut charts: Vec<Vec<Region>> = Vec::new();
    let (mut open, mut boxes) = (0usize, 0usize);
    loop {
        let expected = match (charts.len(), open) {
            (0, _) => "`sample` or `chart 1`",
            (_, 0) => "the next `chart`, or `end`",
            _ => "`halve` or `exclude …`",
        };
        let line = reader.next(expected)?;
        if let Some(text) = line.strip_prefix("sample ").filter(|_| charts.is_empty()) {
            samples.push(sample(reader, line, text, samples.len().saturating_add(1))?);
        } else if open > 0 {
            let region = match line.strip_prefix("exclude ") {
                Some(text) => {
                    boxes = boxes.saturating_add(1);
                    open = open.saturating_sub(1);
                    Region::Excluded(sum(reader, line, text, samples.len())?)
                }
                None if line == "halve" => {
                    open = open.saturating_add(1);
                    Region::Halved
                }
                None => return Err(reader.unexpected(line, expected)),
            };
            reader.limited(limits::BOXES.check(boxes.saturating_add(open)))?;
            if let Some(chart) = charts.last_mut() {
                chart.push(region);
            }
        } else if charts.len() == Unreachable::chart_count(reader.unknowns) {
            reader.check_seal(line, boxes)?;
            return Ok((samples, charts));
        } else {
            let number = charts.len().saturating_add(1);
            if line != format!("chart {number}") {
                return Err(reader.unexpected(line, expected));
            }
            charts.push(Vec::new());
            open = 1;
        }
    }
}

/// `1 at 1/2 3*h`.
fn sample(
    reader: &mut Reader<'_, '_>,
    line: &str,
    text: &str,
    number: usize,
) -> Result<[Odds; 2], CertificateError> {
    let expected = "`sample`, the next number, ` at ` and two odds";
    let odds = text.split_once(" at ").filter(|(found, _)| *found == number.to_string());
    let pair = odds.and_then(|(_, odds)| odds.split_once(' '));
    let (u, v) = pair.ok_or_else(|| reader.unexpected(line, expected))?;
    reader.limited(limits::SAMPLES.check(number))?;
    let mut read = |odds: &str| {
        let (value, shrinking) = match odds.strip_suffix("*h") {
            Some(value) => (value, true),
            None => (odds, false),
        };
        let value = reader.rational(line, value)?;
        match value.is_negative() {
            true => Err(reader.fail(1, Fault::OutsideSquare)),
            false => Ok(Odds { value, shrinking }),
        }
    };
    Ok([read(u)?, read(v)?])
}

/// `3*upper[1] + 2*lower[2]`: sides in their order, by sample, each once.
fn sum(
    reader: &mut Reader<'_, '_>,
    line: &str,
    text: &str,
    samples: usize,
) -> Result<Vec<(BigInt, Side, usize)>, CertificateError> {
    let expected = "`exclude ` and a sum of terms N*lower[k], N*upper[k], N*weight[k] in order";
    let mut sum: Vec<(BigInt, Side, usize)> = Vec::new();
    for part in text.split(" + ") {
        let (digits, _) = part.split_once('*').unwrap_or_default();
        reader.charge_digits(digits.len().min(limits::DIGITS.length()).saturating_mul(2))?;
        // A term and its number, in a list that may have room for twice as many.
        reader.keep(u64::from(limits::DIGITS.number()).min(count(digits.len())).saturating_add(160))?;
        let term = part.split_once('*').filter(|(factor, _)| limits::DIGITS.allows(factor.len())).and_then(
            |(factor, name)| {
                let (factor, rest) = read_natural(factor).ok()?;
                let (name, index) = name.strip_suffix(']')?.split_once('[')?;
                let side =
                    [Side::Lower, Side::Upper, Side::Weight].into_iter().find(|side| side.name() == name)?;
                let index: usize = index.parse().ok()?;
                (rest.is_empty() && factor.is_positive() && (1..=samples).contains(&index))
                    .then_some((factor, side, index))
            },
        );
        let term = term.ok_or_else(|| reader.unexpected(line, expected))?;
        if sum.last().is_some_and(|(_, side, index)| (*side, *index) >= (term.1, term.2)) {
            return Err(reader.unexpected(line, expected));
        }
        sum.push(term);
    }
    Ok(sum)
}
