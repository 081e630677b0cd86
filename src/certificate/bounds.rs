//! Arguments by subdivision: how near a patch is to its surface, and how near no patch comes.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::exact::Polynomial;

/// What is bounded, along a patch with denominator W > 0 on a surface F = 0 of degree e.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// r = √(x² + y² + z²), for the unit sphere only, where F/W² = r² − 1.
    Radius,
    /// F/Wᵉ.
    Ratio,
}

/// A decimal with a fixed number of places, as an integer of units of the last one.
pub type Units = BigInt;

/// What a sum in an argument may contain, at one point of the square; all are positive for a patch with W > 0
/// whose quantity lies strictly between the bounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Side {
    /// F − low·Wᵉ.
    Lower,
    /// high·Wᵉ − F.
    Upper,
    /// W.
    Weight,
}

impl Side {
    /// The name in a certificate.
    pub fn name(self) -> &'static str {
        match self {
            Side::Lower => "lower",
            Side::Upper => "upper",
            Side::Weight => "weight",
        }
    }
}

/// A binary tree in preorder: `true` for a box that is halved, `false` for one that is not.
pub type Tree = Vec<bool>;

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
    /// Unknowns and what is put for them, one after another: forms of degree 1 with rational coefficients that contain the unknown
    /// itself. They choose units, and where zero is, so that boxes of one shape suit all unknowns.
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
    /// How many charts cover the space of so many unknowns.
    pub fn chart_count(unknowns: usize) -> usize {
        unknowns.saturating_mul(2).saturating_add(1)
    }
}

/// A bound as a rational number.
pub fn decimal_value(units: &Units, places: u32) -> BigRational {
    BigRational::new(units.clone(), power_of_ten(places))
}

/// A decimal as it is spelled: a sign, digits, and a point with all places after it (none for no places).
pub fn spell_decimal(units: &Units, places: u32) -> String {
    let width = usize::try_from(places).unwrap_or(usize::MAX);
    let digits = units.magnitude().to_string();
    let sign = if *units < BigInt::zero() { "-" } else { "" };
    let missing = width.saturating_add(1).saturating_sub(digits.len());
    let padded: String = std::iter::repeat_n('0', missing).chain(digits.chars()).collect();
    match padded.split_at_checked(padded.len().saturating_sub(width)) {
        Some((whole, decimals)) if width > 0 => format!("{sign}{whole}.{decimals}"),
        _ => format!("{sign}{padded}"),
    }
}

/// 10ⁿ.
fn power_of_ten(places: u32) -> BigInt {
    (0..places).fold(BigInt::one(), |power, _| power * BigInt::from(10))
}
