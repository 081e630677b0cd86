//! The audit of a control net, for people and as data.

use std::fmt::Write as _;

use num_bigint::BigInt;
use num_rational::BigRational;
use serde::Serialize;

use super::attempt::wrapped_at;
use super::headline::{surface_equation, surface_phrase};
use super::json::{StatementData, statement as statement_data};
use super::mathematics::Notation;
use super::stopped::{cut_short, stopped_by};
use crate::audit::decimal;
use crate::audit::net::{NetAudit, NetChange, NetCorrection, Reading};
use crate::exact::{Limit, Polynomial, Radicands, Ring};
use crate::formats::net::{Convention, PrintedNet};

/// Coefficients and corrections that are printed.
const SHOWN: usize = 12;
/// Digits after the point.
const DIGITS: u32 = 20;

/// `prove-cap audit` of a net, for people.
///
/// # Errors
/// Where a number exceeds what the formats allow.
pub(super) fn describe_net(net: &PrintedNet, audit: &NetAudit) -> Result<String, Limit> {
    let notation = Notation::new(Ring { field: net.field.clone(), variables: Vec::new() });
    let (m, n) = net.bidegree();
    let surface = surface_phrase(&audit.statement);
    let mut text = String::new();
    let _ = match audit.agrees {
        true => writeln!(text, "AGREES  the net lies on {surface}: verified by the independent checker\n"),
        false => writeln!(
            text,
            "DIFFERS  the net does not lie on {surface}: {} of {} coefficients c[r,s] are not zero\n",
            audit.residual.len(),
            audit.coefficients
        ),
    };
    let _ = writeln!(text, "Net      {}", net.title);
    let given = match net.convention {
        Convention::Cartesian => "Cartesian points with weights",
        Convention::Homogeneous => "homogeneous points, premultiplied",
    };
    let _ = writeln!(text, "         bidegree ({m},{n}), {given}, over {}", net.field);
    let _ = writeln!(text, "Surface  {}", surface_equation(&audit.statement));
    if audit.residual.is_empty() {
        return Ok(text);
    }
    text.push('\n');
    for (r, s, value) in audit.residual.iter().take(SHOWN) {
        let _ = writeln!(text, "   c[{r},{s}] = {}", notation.shortened(value, 90));
    }
    if audit.residual.len() > SHOWN {
        let _ = writeln!(text, "   … and {} more", audit.residual.len() - SHOWN);
    }
    if let Some((r, s, value)) = audit.largest() {
        let _ = writeln!(
            text,
            "   None is larger in absolute value than c[{r},{s}] = {}",
            shown_decimal(value, &net.field)?
        );
    }
    text.push('\n');
    let _ = match audit.corrections.len() {
        // Stopped before anything can be said.
        0 if audit.stopped.is_some() && audit.readings.is_empty() => Ok(()),
        0 => {
            let _ = writeln!(
                text,
                "No change of a single number to another of {} was found that puts the net on the surface,\n\
                 and the other convention does not put it there. What each convention leaves:",
                net.field
            );
            for reading in &audit.readings {
                text += &reading_text(net, reading)?;
            }
            Ok(())
        }
        1 => writeln!(text, "One single change puts the net on the surface:"),
        many => writeln!(text, "{many} single changes put the net on the surface, each alone:"),
    };
    for correction in audit.corrections.iter().take(SHOWN) {
        let _ = writeln!(text, "   {}", correction_text(net, &notation, correction));
    }
    if audit.corrections.len() > SHOWN {
        let _ = writeln!(text, "   … and {} more", audit.corrections.len() - SHOWN);
    }
    if let Some(why) = &audit.stopped {
        let _ = writeln!(text, "{}", cut_short(why));
    } else if !audit.searched {
        text += "The search for single changes ended where it had cost as much as it may.\n";
    }
    Ok(text)
}

/// What one convention leaves.
fn reading_text(net: &PrintedNet, reading: &Reading) -> Result<String, Limit> {
    let meant = match reading.convention {
        Convention::Cartesian => "Cartesian points",
        Convention::Homogeneous => "premultiplied",
    };
    let how = if reading.convention == net.convention { "given as" } else { "read as" };
    let (r, s, value) = &reading.largest;
    let mut text =
        format!("   {how} {meant}: the largest is c[{r},{s}] = {}…\n", visible(value, &net.field)?);
    let explained = match (reading.decimals, reading.printed) {
        (_, None) => return Ok(text),
        (Some(decimals), Some(printed)) => format!(
            "no coefficient exceeds the bound for numbers rounded to {decimals} decimals; up to {printed} are printed"
        ),
        (None, Some(_)) => {
            "not all coefficients keep the bound for numbers rounded to one decimal".to_owned()
        }
    };
    text += &wrapped_at(&explained, 6);
    text.push('\n');
    Ok(text)
}

/// A decimal with at least three digits that are not leading zeros, within reason.
fn visible(value: &Polynomial, field: &Radicands) -> Result<String, Limit> {
    for places in [6, 12, 20, 40, 100] {
        let text = decimal(value, places, field)?;
        let digits: String = text.chars().filter(char::is_ascii_digit).collect();
        if digits.trim_start_matches('0').len() >= 3 {
            return Ok(text);
        }
    }
    decimal(value, 300, field)
}

/// The decimal, if it ends within some digits; otherwise those digits and `…`.
fn shown_decimal(value: &Polynomial, field: &Radicands) -> Result<String, Limit> {
    let digits = decimal(value, DIGITS, field)?;
    let unit = BigRational::from_integer(BigInt::from(10).pow(DIGITS));
    Ok(match value.as_rational().is_some_and(|value| (value * unit).is_integer()) {
        true => digits.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => format!("{digits}…"),
    })
}

fn convention_text(convention: Convention) -> &'static str {
    match convention {
        Convention::Cartesian => "Cartesian, not premultiplied by the weight",
        Convention::Homogeneous => "premultiplied by the weight",
    }
}

fn correction_text(net: &PrintedNet, notation: &Notation, correction: &NetCorrection) -> String {
    let place = match correction.point {
        Some((i, j)) => format!("point (i,j) = ({i},{j})"),
        None => "the whole net".to_owned(),
    };
    match &correction.change {
        NetChange::Entry { coordinate, printed, right } => {
            let name = net.convention.names()[*coordinate];
            let what = if printed.negate() == *right { "the sign of " } else { "" };
            format!(
                "{place}: {what}{name}: {} is printed where {} would be right",
                notation.polynomial(printed),
                notation.polynomial(right)
            )
        }
        NetChange::Scale(factor) => {
            let names = net.convention.names();
            format!(
                "{place}: {}, {}, {} are to be multiplied by {}",
                names[0],
                names[1],
                names[2],
                notation.polynomial(factor)
            )
        }
        NetChange::Convention { meant } => format!("{place} is {}", convention_text(*meant)),
    }
}

/// The audit of a net as data.
#[derive(Debug, Serialize)]
pub struct NetData {
    title: String,
    convention: &'static str,
    statement: StatementData,
    residual: Vec<ResidualData>,
    corrections: Vec<CorrectionData>,
    readings: Vec<ReadingData>,
    searched: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    stopped: Option<&'static str>,
}

/// What one convention leaves.
#[derive(Debug, Serialize)]
struct ReadingData {
    convention: &'static str,
    largest: ResidualData,
    decimals: Option<u32>,
    printed: Option<u32>,
}

#[derive(Debug, Serialize)]
struct ResidualData {
    index: (u32, u32),
    value: String,
}

#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
enum CorrectionData {
    Entry { point: Option<(usize, usize)>, coordinate: &'static str, printed: String, right: String },
    Scale { point: Option<(usize, usize)>, factor: String },
    Convention { point: Option<(usize, usize)>, meant: &'static str },
}

/// The audit of a net as data.
pub(super) fn net_data(net: &PrintedNet, audit: &NetAudit) -> NetData {
    let ring = Ring { field: net.field.clone(), variables: Vec::new() };
    let spell = |value: &Polynomial| ring.spell(value);
    let corrections = audit.corrections.iter().map(|correction| {
        let point = correction.point;
        match &correction.change {
            NetChange::Entry { coordinate, printed, right } => CorrectionData::Entry {
                point,
                coordinate: net.convention.names()[*coordinate],
                printed: spell(printed),
                right: spell(right),
            },
            NetChange::Scale(factor) => CorrectionData::Scale { point, factor: spell(factor) },
            NetChange::Convention { meant } => CorrectionData::Convention { point, meant: meant.word() },
        }
    });
    let residual =
        audit.residual.iter().map(|(r, s, value)| ResidualData { index: (*r, *s), value: spell(value) });
    NetData {
        title: net.title.clone(),
        convention: net.convention.word(),
        statement: statement_data(&audit.statement),
        residual: residual.collect(),
        corrections: corrections.collect(),
        readings: audit.readings.iter().map(|reading| reading_data(reading, &ring)).collect(),
        searched: audit.searched,
        stopped: audit.stopped.as_ref().map(|stopped| stopped_by(stopped.why)),
    }
}

fn reading_data(reading: &Reading, ring: &Ring) -> ReadingData {
    let (r, s, value) = &reading.largest;
    ReadingData {
        convention: reading.convention.word(),
        largest: ResidualData { index: (*r, *s), value: ring.spell(value) },
        decimals: reading.decimals,
        printed: reading.printed,
    }
}
