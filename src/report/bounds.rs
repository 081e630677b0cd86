//! Enclosures, approximations and barriers, for people and as data.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;
use serde::Serialize;

use super::attempt::{Files, verdict_of_checker};
use super::json::{CONVENTION, StatementData, ValueData, statement as statement_data, values_data};
use super::mathematics::Notation;
use super::rounding::{Towards, rounded};
use crate::approximation::{Barrier, Enclosure, EndVerdict, Finding};
use crate::certificate::{Bounds, End, Quantity, decimal_value, spell_decimal};
use crate::checker::Theorem;
use crate::commands::Gap;
use crate::document::{Block, Column, Document, Table};
use crate::exact::{Arithmetic, Limit, Polynomial, Work};
use crate::statement::{HomogeneousPoint, Statement, Subject};

/// `r` or `F/W²`.
pub fn symbol(quantity: Quantity, degree: u32) -> String {
    match quantity {
        Quantity::Radius => "r".to_owned(),
        Quantity::Ratio => format!("F/W{}", super::mathematics::superscript(degree)),
    }
}

/// A decimal with a true minus sign.
pub fn decimal(units: &BigInt, places: u32) -> String {
    spell_decimal(units, places).replace('-', "−")
}

/// A value as people write it: an element of K, or a decimal where the denominator is a power of ten.
pub fn value_text(statement: &Statement, value: &Polynomial) -> String {
    let exact = value.as_rational().and_then(|rational| {
        let places =
            (1..=400u32).find(|&places| (BigInt::from(10).pow(places) % rational.denom()) == BigInt::ZERO)?;
        let units = &rational * BigRational::from_integer(BigInt::from(10).pow(places));
        (rational.denom() > &BigInt::from(1000)).then_some((units, places))
    });
    match exact {
        Some((units, places)) => decimal(&units.to_integer(), places),
        None => Notation::new(statement.ring()).polynomial(value),
    }
}

/// `LOW ≤ r ≤ HIGH`.
pub fn enclosure_text(bounds: &Bounds, degree: u32) -> String {
    let [low, high] = [&bounds.lower, &bounds.upper].map(|end| decimal(&end.bound, bounds.places));
    format!("{low} ≤ {} ≤ {high}", symbol(bounds.quantity, degree))
}

/// Characters of the name of what is bounded, at least.
const NAMED: usize = 14;

/// Everything below the verdict.
pub(super) fn enclosure_details(
    document: &mut Document,
    statement: &Statement,
    enclosure: &Enclosure,
    degree: u32,
) {
    let bounds = &enclosure.bounds;
    for (name, value) in statement.unknowns().iter().zip(&bounds.values) {
        document.line(3, format!("{name} = {}", value_text(statement, value)));
    }
    if !bounds.values.is_empty() {
        document.gap();
    }
    let symbol = symbol(bounds.quantity, degree);
    let [low_best, high_best] = enclosure.best;
    let [low_attained, high_attained] = enclosure.attained;
    let ends = [
        ("least", &bounds.lower, 1, low_attained, low_best),
        ("greatest", &bounds.upper, -1, high_attained, high_best),
    ];
    let mut table = Table::new(3, [Column::left(0).at_least(NAMED), Column::left(1)]);
    for (name, end, inwards, attained, best) in ends {
        let [outer, inner] =
            [end.bound.clone(), &end.bound + inwards].map(|units| decimal(&units, bounds.places));
        let (low, high) = if inwards > 0 { (&outer, &inner) } else { (&inner, &outer) };
        let [exact_u, exact_v] = &end.at;
        let [u, v] = end.at.each_ref().map(parameter);
        let bounded = match (attained, best) {
            (true, _) => format!("{outer}, at (u, v) = ({exact_u}, {exact_v})"),
            (false, true) => format!("between {low} and {high}, near (u, v) = ({u}, {v})"),
            (false, false) => {
                format!("between {low} and {high}; it is {inner} at (u, v) = ({exact_u}, {exact_v})")
            }
        };
        table.row([format!("{name} {symbol}"), bounded]);
    }
    if bounds.quantity == Quantity::Radius {
        let [low, high] = squares(bounds);
        table.row(["r² − 1".to_owned(), format!("between {low} and {high}")]);
    }
    document.push(Block::Table(table));
    if bounds.quantity == Quantity::Ratio {
        document.line(3, no_distance(&symbol));
    }
    let count = |tree: &[bool]| tree.iter().filter(|halved| !**halved).count();
    document.gap();
    document.heading("Proof");
    document.line(
        3,
        format!(
            "Boxes of the unit square on which the Bernstein coefficients have one sign:\n\
             {} for W > 0, {} for the lower bound, {} for the upper one.",
            count(&bounds.denominator),
            count(&bounds.lower.tree),
            count(&bounds.upper.tree)
        ),
    );
}

/// What the size of F/Wᵉ does not tell.
fn no_distance(symbol: &str) -> String {
    format!("{symbol} is no distance: its size depends on how F is scaled.")
}

/// A simple fraction as it is, another in six decimals (the certificate has it exactly).
fn parameter(x: &BigRational) -> String {
    match *x.denom() < BigInt::from(1000) {
        true => x.to_string(),
        false => format!("{:.6}", num_traits::ToPrimitive::to_f64(x).unwrap_or(f64::NAN)),
    }
}

/// r² − 1 to the places of r, rounded outwards.
fn squares(bounds: &Bounds) -> [String; 2] {
    let unit = BigRational::from_integer(BigInt::from(10).pow(bounds.places));
    let square = |units: &BigInt| {
        let value = decimal_value(units, bounds.places);
        (&value * &value - BigRational::one()) * &unit
    };
    let low = square(&bounds.lower.bound).floor().to_integer();
    let high = square(&bounds.upper.bound).ceil().to_integer();
    [low, high].map(|units| decimal(&units, bounds.places))
}

/// The judgement of a printed interval.
pub(super) fn judged(document: &mut Document, verdicts: &[EndVerdict], symbol: &str) {
    for EndVerdict { printed, relation, finding } in verdicts {
        let claim = format!("{symbol} {relation} {}", printed.replace('-', "−"));
        let found = match finding {
            Finding::Bound => "holds on the whole patch".to_owned(),
            Finding::Rounded => "holds on the whole patch to the digits printed".to_owned(),
            Finding::Fails { at: [u, v], value } => {
                format!("FAILS: at (u, v) = ({u}, {v}) {symbol} = {}…", value.replace('-', "−"))
            }
            Finding::Open => "open: equal to all places computed; a smaller --tolerance may tell".to_owned(),
        };
        document.line(3, format!("{claim}   {found}"));
    }
}

/// What the checker says of the files.
pub(super) fn checked(document: &mut Document, theorem: &Theorem, files: &Files) {
    document.gap();
    verdict_of_checker(document, &with_true_minus(&theorem.sentence()));
    document.push(files.block());
}

/// A minus sign before a digit is a true one, a hyphen stays what it is.
fn with_true_minus(text: &str) -> String {
    let mut result = String::with_capacity(text.len());
    let mut rest = text.chars().peekable();
    let mut before = ' ';
    while let Some(c) = rest.next() {
        let negative = c == '-' && !before.is_alphanumeric() && rest.peek().is_some_and(char::is_ascii_digit);
        result.push(if negative { '−' } else { c });
        before = c;
    }
    result
}

/// An enclosure as data.
#[derive(Debug, Serialize)]
pub struct EnclosureData {
    name: String,
    statement: StatementData,
    values: Vec<ValueData>,
    convention: &'static str,
    net: Option<Vec<Vec<[String; 4]>>>,
    decimals: Option<DecimalNetData>,
    quantity: &'static str,
    places: u32,
    lower: EndData,
    upper: EndData,
    boxes: BoxesData,
    theorem: String,
    certificate: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<String>,
}

/// A bound.
#[derive(Debug, Serialize)]
struct EndData {
    bound: String,
    near: [String; 2],
    best: bool,
}

/// How many boxes each sign took.
#[derive(Debug, Serialize)]
struct BoxesData {
    denominator: usize,
    lower: usize,
    upper: usize,
}

/// A net in decimals.
#[derive(Debug, Serialize)]
struct DecimalNetData {
    places: u32,
    convention: &'static str,
    net: Vec<Vec<Vec<String>>>,
}

/// An enclosure as data.
pub(super) fn enclosure_data(
    name: &str,
    statement: &Statement,
    enclosure: &Enclosure,
    files: &Files,
) -> EnclosureData {
    let bounds = &enclosure.bounds;
    let count = |tree: &[bool]| tree.iter().filter(|halved| !**halved).count();
    let net = evaluated(statement, &bounds.values).ok();
    let end = |end: &End, best: bool| EndData {
        bound: spell_decimal(&end.bound, bounds.places),
        near: end.at.each_ref().map(ToString::to_string),
        best,
    };
    let note = match (bounds.quantity, statement.subject()) {
        (Quantity::Ratio, Subject::Patch(patch)) => {
            Some(no_distance(&symbol(bounds.quantity, patch.surface.degree())))
        }
        _ => None,
    };
    EnclosureData {
        name: name.to_owned(),
        statement: statement_data(statement),
        values: values_data(statement, &bounds.values),
        convention: CONVENTION,
        net: net.as_ref().map(|net| super::json::net(statement, net)),
        decimals: net.and_then(|net| decimals(statement, &net).ok()),
        quantity: match bounds.quantity {
            Quantity::Radius => "radius",
            Quantity::Ratio => "ratio",
        },
        places: bounds.places,
        lower: end(&bounds.lower, enclosure.best[0]),
        upper: end(&bounds.upper, enclosure.best[1]),
        boxes: BoxesData {
            denominator: count(&bounds.denominator),
            lower: count(&bounds.lower.tree),
            upper: count(&bounds.upper.tree),
        },
        theorem: enclosure.proof.theorem().sentence(),
        certificate: files.certificate.display().to_string(),
        note,
    }
}

/// The net at these values of the unknowns.
fn evaluated(statement: &Statement, values: &[Polynomial]) -> Result<Vec<Vec<HomogeneousPoint>>, Limit> {
    let Subject::Patch(patch) = statement.subject() else { return Ok(Vec::new()) };
    let mut work = Work::full();
    let mut net = patch.net.clone();
    for entry in net.iter_mut().flatten().flatten() {
        *entry = Arithmetic::new(statement.field(), &mut work).substitute(entry, values)?;
    }
    Ok(net)
}

/// The same in decimals that are cut off after 17 places.
fn decimals(statement: &Statement, net: &[Vec<HomogeneousPoint>]) -> Result<DecimalNetData, Limit> {
    const PLACES: u32 = 17;
    let number = |entry: &Polynomial| {
        crate::audit::decimal(entry, PLACES, statement.field()).map(|text| text.replace('−', "-"))
    };
    let mut rows = Vec::new();
    for row in net {
        let points = row.iter().map(|point| point.iter().map(number).collect::<Result<Vec<_>, _>>());
        rows.push(points.collect::<Result<Vec<_>, _>>()?);
    }
    Ok(DecimalNetData { places: PLACES, convention: CONVENTION, net: rows })
}

/// The verdict on an end of a printed interval as data.
#[derive(Debug, Serialize)]
pub(super) struct EndVerdictData {
    printed: String,
    relation: &'static str,
    finding: &'static str,
    at: Option<[String; 2]>,
    value: Option<String>,
}

impl EndVerdictData {
    pub(super) fn of(verdict: &EndVerdict) -> Self {
        let (finding, at, value) = match &verdict.finding {
            Finding::Bound => ("holds", None, None),
            Finding::Rounded => ("holds to the digits printed", None, None),
            Finding::Fails { at, value } => {
                ("fails", Some(at.each_ref().map(ToString::to_string)), Some(value.clone()))
            }
            Finding::Open => ("open", None, None),
        };
        let (printed, relation) = (verdict.printed.clone(), verdict.relation);
        EndVerdictData { printed, relation, finding, at, value }
    }
}

/// That no values do better, and how much those that were found may be worse than the best: both rounded so that it stays true.
pub(super) fn none_better(document: &mut Document, barrier: &Barrier, gap: &Gap) {
    document.gap();
    document.line(
        0,
        format!(
            "No values do better than {}: proved on {} boxes of all values of the unknowns with W > 0.\n\
             Those above reach {}, which is at most {} of it more.",
            rounded(&gap.unreached, 7, Towards::Below),
            barrier.boxes,
            rounded(&gap.reached, 7, Towards::Above),
            rounded(&gap.relative(), 1, Towards::Above)
        ),
    );
}

/// What is measured: `r − 1`, or `F/W²`.
pub fn quantity_name(statement: &Statement, quantity: Quantity) -> String {
    let degree = match statement.subject() {
        Subject::Patch(patch) => patch.surface.degree(),
        Subject::System(_) => 0,
    };
    match quantity {
        Quantity::Radius => "r − 1".to_owned(),
        Quantity::Ratio => symbol(quantity, degree),
    }
}
