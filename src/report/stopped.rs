//! What a search had when it was stopped.

use num_rational::BigRational;
use serde::Serialize;

use super::bounds::{quantity_name, value_text};
use super::json::{ValueData, values_data};
use super::rounding::{Towards, rounded};
use crate::approximation::{BestSoFar, quantity_of};
use crate::control::{Interrupted, Why};
use crate::document::Document;
use crate::statement::Statement;

/// Digits after the point of what was measured.
const DIGITS: u32 = 4;

/// Which of them it was, as data.
pub fn stopped_by(why: Why) -> &'static str {
    match why {
        Why::Time => "timeout",
        Why::Interrupt => "ctrl-c",
        Why::Memory => "memory",
    }
}

/// That an explanation was not finished; the verdict does not depend on it.
pub fn cut_short(why: &Interrupted) -> String {
    format!("The explanation was cut short: {why}.")
}

/// The best values so far, with what was measured there.
pub(super) fn best_so_far(document: &mut Document, statement: &Statement, best: &BestSoFar) {
    document.heading("Best found so far, by search; nothing is proved of it");
    for (name, value) in statement.unknowns().iter().zip(&best.values.values) {
        document.line(3, format!("{name} = {}", value_text(statement, value)));
    }
    let [low, high] = measured(best);
    let name = quantity_of(statement).map(|quantity| quantity_name(statement, quantity)).unwrap_or_default();
    document.line(3, format!("measured in floating point: {low} ≤ {name} ≤ {high}"));
}

/// The best values so far as data.
#[derive(Debug, Serialize)]
pub(super) struct BestSoFarData {
    values: Vec<ValueData>,
    measured_in_floating_point: MeasuredData,
}

#[derive(Debug, Serialize)]
struct MeasuredData {
    least: f64,
    greatest: f64,
}

impl BestSoFarData {
    pub(super) fn of(statement: &Statement, best: &BestSoFar) -> Self {
        let [least, greatest] = best.measured;
        BestSoFarData {
            values: values_data(statement, &best.values.values),
            measured_in_floating_point: MeasuredData { least, greatest },
        }
    }
}

/// The measured ends, rounded outwards.
fn measured(best: &BestSoFar) -> [String; 2] {
    let ends = [(best.measured[0], Towards::Below), (best.measured[1], Towards::Above)];
    ends.map(|(end, towards)| {
        BigRational::from_float(end).map_or("?".to_owned(), |end| rounded(&end, DIGITS, towards))
    })
}
