//! Claim `unreachable`: how near no patch comes to its surface.

mod boxes;
mod chart;
mod check;
mod text;

use std::fmt;

use num_bigint::BigInt;
use num_rational::BigRational;

use super::subdivision::{self, Quantity, Side, Units, spell_decimal};
use super::wording;
use crate::exact::Polynomial;
use crate::statement::Statement;

pub(super) use check::verify;
pub(super) use text::{read, write};

/// Where a sample point lies, by its odds t = u/(1−u) (or v/(1−v)): a rational κ ≥ 0, or κ·h, where h is
/// 1 for bounded unknowns and tends to 0 as they grow.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Odds {
    /// κ.
    pub value: BigRational,
    /// Whether h is a factor.
    pub shrinking: bool,
}

/// A box of the unknowns' space.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Region {
    /// Halved; its two halves follow.
    Halved,
    /// Excluded: this sum of positive multiples of sides at samples (from 1) is nowhere positive on the box.
    Excluded(Vec<(BigInt, Side, usize)>),
}

/// For no real values of the unknowns has the patch W > 0 on the whole square and the quantity strictly between two decimals.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unreachable {
    /// What is bounded.
    pub quantity: Quantity,
    /// Decimal places of the bounds.
    pub places: u32,
    /// The lower bound.
    pub lower: Units,
    /// The upper bound.
    pub upper: Units,
    /// Pairs (z, w) of unknowns: from here on z stands for the product z·w.
    pub products: Vec<(u16, u16)>,
    /// Unknowns and what is put for them, one after another: forms of degree 1 with rational coefficients that contain
    /// the unknown itself. They choose units, and where zero is, so that boxes of one shape suit all unknowns.
    pub forms: Vec<(u16, Polynomial)>,
    /// What the first chart reaches: all unknowns from −range to range.
    pub range: BigInt,
    /// Sample points (u, v) of the square.
    pub samples: Vec<[Odds; 2]>,
    /// For each chart a tree in preorder: the box of bounded unknowns, then for each unknown in turn those values where it is
    /// positive and largest of all in size, and those where it is negative and largest.
    pub charts: Vec<Vec<Region>>,
}

impl Unreachable {
    /// The version of the format that has everything that is used.
    pub(super) fn version(&self) -> u32 {
        if self.forms.is_empty() { 1 } else { 2 }
    }

    /// How many charts cover the space of so many unknowns.
    pub fn chart_count(unknowns: usize) -> usize {
        unknowns.saturating_mul(2).saturating_add(1)
    }
}

/// At no real values is W > 0 on the whole square and the quantity strictly between the bounds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Excluded {
    /// What is bounded.
    pub quantity: Quantity,
    /// Decimal places.
    pub places: u32,
    /// The bounds, in units of the last place.
    pub between: [Units; 2],
    /// Boxes that were excluded.
    pub boxes: usize,
}

/// What is wrong with an argument over all values.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(missing_docs, reason = "the fields are what the message prints")]
pub enum Rejection {
    /// The subdivisions.
    Subdivision(subdivision::Rejection),
    /// Bounds between which there is no number.
    Empty,
    /// Unknowns that do not occur as a product.
    NotAProduct,
    /// A sum that is not shown to be nowhere positive on its box.
    NotExcluded { chart: usize, node: usize },
}

impl Excluded {
    /// `unreachable`.
    pub(super) fn kind(&self) -> &'static str {
        "unreachable"
    }

    /// What was proved.
    pub(super) fn sentence(&self, statement: &Statement) -> String {
        let decimal = |units| wording::mathematics(&spell_decimal(units, self.places));
        let [low, high] = self.between.each_ref().map(decimal);
        // No assumption is made use of.
        let whether = wording::assumptions(statement)
            .map_or_else(String::new, |assumed| format!(", whether {assumed} or not,"));
        let (values, is) = match statement.unknowns() {
            [] => ("It is not so that".to_owned(), " is"),
            [one] => (format!("For no real value of {one}{whether} is"), ""),
            many => (format!("For no real values of {}{whether} is", many.join(", ")), ""),
        };
        format!(
            "{values} the denominator W{is} positive on the whole square and {low} < {} < {high} everywhere on it{}.",
            self.quantity.name(statement),
            self.quantity.meaning(statement)
        )
    }

    /// Lines under the sentence.
    pub(super) fn details(&self, _: &Statement) -> Vec<String> {
        vec![format!("replayed   {} boxes", self.boxes)]
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
            Rejection::Empty => write!(f, "no number is strictly between the two bounds"),
            Rejection::NotAProduct => {
                write!(f, "the equations are not polynomials in the stated products")
            }
            Rejection::NotExcluded { chart, node } => {
                write!(
                    f,
                    "chart {chart}: on box {node} of the tree, the sum is not shown to be nowhere positive"
                )
            }
        }
    }
}
