//! Enclosures, approximations and barriers, for people and as data.

use std::fmt::Write as _;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;
use serde::Serialize;

use super::attempt::{Files, wrapped_at};
use super::json::{CONVENTION, StatementData, ValueData, statement as statement_data, values_data};
use super::mathematics::Notation;
use super::rounding::{Towards, rounded};
use crate::approximation::{Barrier, Enclosure, EndVerdict, Finding};
use crate::certificate::{Bounds, End, Quantity, decimal_value, spell_decimal};
use crate::checker::Theorem;
use crate::commands::Gap;
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

/// Everything below the verdict.
pub fn enclosure_details(statement: &Statement, enclosure: &Enclosure, degree: u32) -> String {
    let bounds = &enclosure.bounds;
    let mut text = String::new();
    for (name, value) in statement.unknowns().iter().zip(&bounds.values) {
        let _ = writeln!(text, "   {name} = {}", value_text(statement, value));
    }
    if !bounds.values.is_empty() {
        text.push('\n');
    }
    let symbol = symbol(bounds.quantity, degree);
    let [low_best, high_best] = enclosure.best;
    let [low_attained, high_attained] = enclosure.attained;
    let ends = [
        ("least", &bounds.lower, 1, low_attained, low_best),
        ("greatest", &bounds.upper, -1, high_attained, high_best),
    ];
    for (name, end, inwards, attained, best) in ends {
        let [outer, inner] =
            [end.bound.clone(), &end.bound + inwards].map(|units| decimal(&units, bounds.places));
        let (low, high) = if inwards > 0 { (&outer, &inner) } else { (&inner, &outer) };
        let name = format!("{name} {symbol}");
        let [exact_u, exact_v] = &end.at;
        let [u, v] = end.at.each_ref().map(parameter);
        let _ = match (attained, best) {
            (true, _) => writeln!(text, "   {name:<14} {outer}, at (u, v) = ({exact_u}, {exact_v})"),
            (false, true) => {
                writeln!(text, "   {name:<14} between {low} and {high}, near (u, v) = ({u}, {v})")
            }
            (false, false) => writeln!(
                text,
                "   {name:<14} between {low} and {high}; it is {inner} at (u, v) = ({exact_u}, {exact_v})"
            ),
        };
    }
    if bounds.quantity == Quantity::Ratio {
        let _ = writeln!(text, "   {}", no_distance(&symbol));
    }
    if bounds.quantity == Quantity::Radius {
        let [low, high] = squares(bounds);
        let _ = writeln!(text, "   {:<14} between {low} and {high}", "r² − 1");
    }
    let count = |tree: &[bool]| tree.iter().filter(|halved| !**halved).count();
    let _ = writeln!(
        text,
        "\nProof\n   Boxes of the unit square on which the Bernstein coefficients have one sign:\n   \
         {} for W > 0, {} for the lower bound, {} for the upper one.",
        count(&bounds.denominator),
        count(&bounds.lower.tree),
        count(&bounds.upper.tree)
    );
    text
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
pub fn verdict_text(verdicts: &[EndVerdict], symbol: &str) -> String {
    let mut text = String::new();
    for EndVerdict { printed, relation, finding } in verdicts {
        let claim = format!("{symbol} {relation} {}", printed.replace('-', "−"));
        let _ = match finding {
            Finding::Bound => writeln!(text, "   {claim}   holds on the whole patch"),
            Finding::Rounded => writeln!(text, "   {claim}   holds on the whole patch to the digits printed"),
            Finding::Fails { at: [u, v], value } => {
                writeln!(
                    text,
                    "   {claim}   FAILS: at (u, v) = ({u}, {v}) {symbol} = {}…",
                    value.replace('-', "−")
                )
            }
            Finding::Open => writeln!(
                text,
                "   {claim}   open: equal to all places computed; a smaller --tolerance may tell"
            ),
        };
    }
    text
}

/// What the checker says of the files.
pub fn checked_text(theorem: &Theorem, files: &Files) -> String {
    format!(
        "\nVerdict of the independent checker, on the files below\n{}\n\nStatement    {}\nCertificate  {}\n",
        wrapped_at(&format!("VERIFIED. {}", with_true_minus(&theorem.sentence())), 3),
        files.statement.display(),
        files.certificate.display()
    )
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
pub fn barrier_text(barrier: &Barrier, gap: &Gap) -> String {
    format!(
        "\nNo values do better than {}: proved on {} boxes of all values of the unknowns with W > 0.\n\
         Those above reach {}, which is at most {} of it more.\n",
        rounded(&gap.unreached, 7, Towards::Below),
        barrier.boxes,
        rounded(&gap.reached, 7, Towards::Above),
        rounded(&gap.relative(), 1, Towards::Above)
    )
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
