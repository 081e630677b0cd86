//! The audit of a control net, for people and as data.

use num_bigint::BigInt;
use num_rational::BigRational;
use serde::Serialize;

use super::headline::{surface_equation, surface_phrase};
use super::json::{StatementData, statement as statement_data};
use super::mathematics::Notation;
use super::stopped::{cut_short, stopped_by};
use crate::audit::decimal;
use crate::audit::net::{NetAudit, NetChange, NetCorrection, Reading};
use crate::commands::AuditedNet;
use crate::document::{Block, Document, Equations, Phrase};
use crate::exact::{Limit, Polynomial, Radicands, Ring};
use crate::formats::net::{Convention, PrintedNet};

/// Coefficients and corrections that are printed.
const SHOWN: usize = 12;
/// Digits after the point.
const DIGITS: u32 = 20;

/// Where what stands behind a name begins.
const NAMED: usize = 9;
/// Characters of a coefficient that is printed.
const COEFFICIENT: usize = 90;

/// `prove-cap audit` of a net, for people.
///
/// # Errors
/// Where a number exceeds what the formats allow.
pub(super) fn describe_net(audited: &AuditedNet) -> Result<Document, Limit> {
    let AuditedNet { net, audit } = audited;
    let ring = Ring { field: net.field.clone(), variables: Vec::new() };
    let notation = Notation::new(ring.clone());
    let mut document = Document::new(ring);
    let (m, n) = net.bidegree();
    let surface = surface_phrase(&audit.statement);
    let sentence = match audit.agrees {
        true => format!("the net lies on {surface}: verified by the independent checker"),
        false => format!(
            "the net does not lie on {surface}: {} of {} coefficients c[r,s] are not zero",
            audit.residual.len(),
            audit.coefficients
        ),
    };
    document.headline(audited.verdict().word(), sentence);
    document.gap();
    document.field("Net", NAMED, net.title.as_str());
    let given = match net.convention {
        Convention::Cartesian => "Cartesian points with weights",
        Convention::Homogeneous => "homogeneous points, premultiplied",
    };
    document.field("", NAMED, format!("bidegree ({m},{n}), {given}, over {}", net.field));
    document.field("Surface", NAMED, surface_equation(&audit.statement));
    if audit.residual.is_empty() {
        return Ok(document);
    }
    document.gap();
    let rows = audit.residual.iter().take(SHOWN).map(|(r, s, value)| {
        let value = Phrase::default().shortened(value, COEFFICIENT);
        (Phrase::default().label(format!("c[{r},{s}]")), value, String::new())
    });
    document.push(Block::Equations(Equations { indent: 3, width: 0, rows: rows.collect() }));
    if audit.residual.len() > SHOWN {
        document.line(3, format!("… and {} more", audit.residual.len() - SHOWN));
    }
    if let Some((r, s, value)) = audit.largest() {
        let decimal = shown_decimal(value, &net.field)?;
        document.line(3, format!("None is larger in absolute value than c[{r},{s}] = {decimal}"));
    }
    document.gap();
    match audit.corrections.len() {
        // Stopped before anything can be said.
        0 if audit.stopped.is_some() && audit.readings.is_empty() => {}
        0 => {
            document.line(
                0,
                format!(
                    "No change of a single number to another of {} was found that puts the net on the surface,\n\
                     and the other convention does not put it there. What each convention leaves:",
                    net.field
                ),
            );
            for reading in &audit.readings {
                read_as(&mut document, net, reading)?;
            }
        }
        1 => document.line(0, "One single change puts the net on the surface:"),
        many => document.line(0, format!("{many} single changes put the net on the surface, each alone:")),
    }
    for correction in audit.corrections.iter().take(SHOWN) {
        document.line(3, correction_text(net, &notation, correction));
    }
    if audit.corrections.len() > SHOWN {
        document.line(3, format!("… and {} more", audit.corrections.len() - SHOWN));
    }
    if let Some(why) = &audit.stopped {
        document.line(0, cut_short(why));
    } else if !audit.searched {
        document.line(0, "The search for single changes ended where it had cost as much as it may.");
    }
    Ok(document)
}

/// What one convention leaves.
fn read_as(document: &mut Document, net: &PrintedNet, reading: &Reading) -> Result<(), Limit> {
    let meant = match reading.convention {
        Convention::Cartesian => "Cartesian points",
        Convention::Homogeneous => "premultiplied",
    };
    let how = if reading.convention == net.convention { "given as" } else { "read as" };
    let (r, s, value) = &reading.largest;
    let value = visible(value, &net.field)?;
    document.line(3, format!("{how} {meant}: the largest is c[{r},{s}] = {value}…"));
    let explained = match (reading.decimals, reading.printed) {
        (_, None) => return Ok(()),
        (Some(decimals), Some(printed)) => format!(
            "no coefficient exceeds the bound for numbers rounded to {decimals} decimals; up to {printed} are printed"
        ),
        (None, Some(_)) => {
            "not all coefficients keep the bound for numbers rounded to one decimal".to_owned()
        }
    };
    document.paragraph(6, explained);
    Ok(())
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
