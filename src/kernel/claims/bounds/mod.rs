//! Claim `bounds`: how near a patch is to its surface.

mod check;
mod text;

use std::fmt;

use num_rational::BigRational;

use super::exact::spelled;
use super::subdivision::{self, Quantity, Tree, Units, spell_decimal};
use crate::exact::Polynomial;
use crate::statement::Statement;

pub(super) use check::verify;
pub(super) use text::{read, write};

/// One end of an enclosure.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct End {
    /// The bound.
    pub bound: Units,
    /// A point (u, v) of the square where the quantity is not further from the bound than one unit.
    pub at: [BigRational; 2],
    /// Boxes on each of which the Bernstein coefficients show the bound.
    pub tree: Tree,
}

/// At these values, W > 0 on the whole square and the quantity lies between two decimals, each the best of its length.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Bounds {
    /// A constant of K for each unknown.
    pub values: Vec<Polynomial>,
    /// What is bounded.
    pub quantity: Quantity,
    /// Decimal places of the bounds.
    pub places: u32,
    /// Boxes on each of which the Bernstein coefficients of W are positive.
    pub denominator: Tree,
    /// The lower end.
    pub lower: End,
    /// The upper end.
    pub upper: End,
}

/// At these values W > 0 on the whole square, and the quantity lies between the bounds, each the best decimal of its length.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Bounded {
    /// The value of each unknown, a constant of K.
    pub values: Vec<Polynomial>,
    /// What is bounded.
    pub quantity: Quantity,
    /// Decimal places.
    pub places: u32,
    /// The bounds, in units of the last place.
    pub between: [Units; 2],
    /// Points (u, v) where they are approached to within a unit.
    pub at: [[BigRational; 2]; 2],
    /// Boxes of all subdivisions.
    pub boxes: usize,
}

/// What is wrong with bounds.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(missing_docs, reason = "the fields are what the message prints")]
pub enum Rejection {
    /// The subdivisions.
    Subdivision(subdivision::Rejection),
    /// A bound that is not the best decimal of its length, as far as the stated point shows.
    NotReached { end: &'static str },
}

impl Bounded {
    /// `bounds`.
    pub(super) fn kind(&self) -> &'static str {
        "bounds"
    }

    /// What was proved.
    pub(super) fn sentence(&self, _: &Statement) -> String {
        let Bounded { quantity, places, between, at, .. } = self;
        let [low, high] = between.each_ref().map(|bound| spell_decimal(bound, *places));
        let [at_low, at_high] = at.each_ref().map(|[u, v]| format!("({u}, {v})"));
        format!(
            "At the stated values the denominator W is positive on the whole square, and there \
             {low} ≤ {} ≤ {high}. Both bounds are the best with {places} decimals: the quantity comes within one unit of \
             the last place at (u, v) = {at_low} and {at_high}.",
            quantity.name()
        )
    }

    /// Lines under the sentence.
    pub(super) fn details(&self, statement: &Statement) -> Vec<String> {
        let mut lines = vec![format!("replayed   {} boxes", self.boxes)];
        lines.extend(spelled(statement, &self.values));
        lines
    }
}

impl From<subdivision::Rejection> for Rejection {
    fn from(rejection: subdivision::Rejection) -> Self {
        Rejection::Subdivision(rejection)
    }
}

impl fmt::Display for Rejection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Rejection::Subdivision(rejection) => rejection.fmt(f),
            Rejection::NotReached { end } => {
                write!(
                    f,
                    "{end}: the stated point does not come within one unit of the last place of the bound"
                )
            }
        }
    }
}
