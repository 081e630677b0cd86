//! Claim `bounds`: how near a patch is to its surface.

mod check;
mod text;

use std::fmt;

use num_rational::BigRational;
use num_traits::One;

use super::exact::spelled;
use super::subdivision::{self, Quantity, Tree, Units, spell_decimal};
use super::wording;
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

/// At these values, W > 0 on the whole square and the quantity lies between two decimals, each the best of its length or
/// next to it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Bounds {
    /// A constant of K for each unknown.
    pub values: Vec<Polynomial>,
    /// What is bounded.
    pub quantity: Quantity,
    /// Decimal places of the bounds.
    pub places: u32,
    /// Boxes are those of the square of u′ and v′, where the odds u/(1 − u) are this multiple of u′/(1 − u′), those of v likewise;
    /// positive.
    pub odds: [BigRational; 2],
    /// Boxes on each of which the Bernstein coefficients of W are positive.
    pub denominator: Tree,
    /// The lower end.
    pub lower: End,
    /// The upper end.
    pub upper: End,
}

/// At these values W > 0 on the whole square, and the quantity lies between the bounds, each the best decimal of its length
/// or next to it.
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
    /// Whether each bound is the best with its places; if not, the quantity at its point is the next decimal exactly.
    pub best: [bool; 2],
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

impl Bounds {
    /// Whether the boxes are those of u and v themselves.
    pub(super) fn plain(&self) -> bool {
        self.odds.iter().all(BigRational::is_one)
    }

    /// The version of the format that has everything that is used.
    pub(super) fn version(&self) -> u32 {
        if self.plain() { 1 } else { 2 }
    }
}

impl Bounded {
    /// `bounds`.
    pub(super) fn kind(&self) -> &'static str {
        "bounds"
    }

    /// What was proved.
    pub(super) fn sentence(&self, statement: &Statement) -> String {
        let Bounded { quantity, places, between, .. } = self;
        let decimal = |bound| wording::mathematics(&spell_decimal(bound, *places));
        let [low, high] = between.each_ref().map(decimal);
        let unchecked = wording::assumptions(statement)
            .map_or_else(String::new, |assumed| format!(" That {assumed} at these values is not checked."));
        format!(
            "{} the denominator W is positive on the whole square, and there {low} ≤ {} ≤ {high}{}. {}{unchecked}",
            wording::at_values(statement),
            quantity.name(statement),
            quantity.meaning(statement),
            self.how_good()
        )
    }

    /// How near the bounds are to the extremes.
    fn how_good(&self) -> String {
        let Bounded { places, at, best, .. } = self;
        let [low, high] = at.each_ref().map(|[u, v]| format!("({u}, {v})"));
        let within = "the quantity comes within one unit of the last place";
        let apart = "the quantity is one unit of the last place";
        match best {
            [true, true] => format!(
                "Both bounds are the best with {places} decimals: {within} at (u, v) = {low} and {high}."
            ),
            [false, false] => format!(
                "Both bounds are the best with {places} decimals, or next to it: {apart} from them at (u, v) = {low} and \
                 {high}."
            ),
            _ => {
                let one = |end: &str, best: bool, point: &str| match best {
                    true => format!(
                        "The {end} bound is the best with {places} decimals: {within} of it at (u, v) = {point}."
                    ),
                    false => format!(
                        "The {end} bound is the best with {places} decimals, or next to it: {apart} from it at (u, v) = \
                         {point}."
                    ),
                };
                let [of_low, of_high] = *best;
                format!("{} {}", one("lower", of_low, &low), one("upper", of_high, &high))
            }
        }
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
