//! Trees of boxes on which Bernstein coefficients show a sign: every sign that decides is exact.

use num_rational::BigRational;

use super::boxes::{Coefficients, Part};
use super::contact::candidates;
use super::exactly::ExactForm;
use crate::algebra::{FieldElement, Integer};
use crate::algebra::{Magnitude, fixed, magnitude};
use crate::certificate::Tree;
use crate::control::{Control, Interrupted};

/// Why there is no tree.
#[derive(Debug, thiserror::Error)]
pub enum NoTree {
    /// At this point (u, v) the form does not have the sign, exactly.
    #[error("the form does not have the sign at a point")]
    Fails {
        /// The point.
        at: Box<[BigRational; 2]>,
        /// Whether it is 0 there.
        zero: bool,
    },
    /// Around this point it comes so near to 0 that no box shows the sign.
    #[error("the form comes too near to 0")]
    Near(Box<[BigRational; 2]>),
    /// The boxes became too many.
    #[error("the boxes became too many")]
    TooMany,
    /// Interrupted.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}

/// The sign that all coefficients are to show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shown {
    Positive,
    NotNegative,
}

/// Bits of the uncertainty of coefficients in fixed point: each halving rounds as often as the form has degrees.
pub(super) const NOISE: u32 = 24;
/// By how many bits the largest coefficient of a box is beyond that where smaller boxes may show what this one does not.
const FEW: u32 = 8;
/// Halvings of a box, so that rounding stays below that: 4096 · 256 < 2²⁴.
const DEPTH: u32 = 4096;
/// How often the precision for a positive form is doubled before it is given up.
const DOUBLINGS: u32 = 3;
/// Bits after the point, beside those that the smallest coefficient needs.
const BITS: u32 = 128;

/// A tree, and a bound on what it shows: no coefficient on its boxes but 0 is smaller than 2^least.
#[derive(Debug, Clone)]
pub(super) struct Grown {
    pub(super) tree: Tree,
    pub(super) least: i64,
}

/// The tree in preorder on whose boxes the coefficients have the sign, each halved only if they have not.
///
/// It is found in fixed point with this many bits; what rounding leaves open is decided exactly. Where all coefficients of a box
/// are that small and do not show the sign, smaller boxes would not show it by more than rounding: the search ends.
pub(super) fn tree(
    form: &ExactForm,
    bits: u32,
    shown: Shown,
    at_most: usize,
    control: &Control,
) -> Result<Grown, NoTree> {
    let values = form.coefficients.iter().map(|value| fixed(value, bits)).collect();
    let mut open = vec![Part::whole([Coefficients { bidegree: form.bidegree, values }])];
    let mut grown = Grown { tree: Tree::new(), least: 0 };
    while let Some(part) = open.pop() {
        control.check()?;
        if shows(form, bits, shown, &part, &mut grown.least, control)? {
            grown.tree.push(false);
            continue;
        }
        grown.tree.push(true);
        if grown.tree.len() + open.len() > at_most || part.depth >= DEPTH {
            return Err(NoTree::TooMany);
        }
        let [first, second] = part.halves();
        open.push(second);
        open.push(first);
    }
    Ok(grown)
}

/// Whether the coefficients on a box show the sign.
fn shows(
    form: &ExactForm,
    bits: u32,
    shown: Shown,
    part: &Part<1>,
    least: &mut i64,
    control: &Control,
) -> Result<bool, NoTree> {
    let [rounded] = &part.forms;
    let certain = |value: &Integer| (value.bits() > u64::from(NOISE) + 1).then(|| of_rounded(value, bits));
    let mut fails = |found: Option<Magnitude>| match found {
        None => shown == Shown::Positive,
        Some(Magnitude { negative, exponent }) => {
            *least = (*least).min(exponent);
            negative
        }
    };
    let corners = rounded.corners();
    let mut holds = true;
    for (corner, &place) in corners.iter().enumerate() {
        let found = certain(&rounded.values[place]).map_or_else(|| form.on_box(part, place), Some);
        if fails(found) {
            return Err(NoTree::Fails { at: Box::new(part.place(corner)), zero: found.is_none() });
        }
    }
    for value in &rounded.values {
        holds &= certain(value).is_none_or(|found| !fails(Some(found)));
    }
    if !holds {
        return Ok(false);
    }
    for (place, _) in rounded.values.iter().enumerate().filter(|(_, value)| certain(value).is_none()) {
        if corners.contains(&place) {
            continue;
        }
        control.check()?;
        if fails(form.on_box(part, place)) {
            // A 0 among larger ones goes away in smaller boxes.
            if rounded.values.iter().any(|value| value.bits() > u64::from(NOISE + FEW)) {
                return Ok(false);
            }
            let [low, high] = [part.place(0), part.place(3)];
            let two = BigRational::from_integer(2.into());
            let middle = std::array::from_fn(|axis| (&low[axis] + &high[axis]) / &two);
            return Err(NoTree::Near(Box::new(middle)));
        }
    }
    Ok(true)
}

/// Of a coefficient in fixed point that rounding does not reach.
fn of_rounded(value: &Integer, bits: u32) -> Magnitude {
    Magnitude { negative: value.is_negative(), exponent: value.bits() as i64 - i64::from(bits) - 2 }
}

/// The tree for a form that is positive on the square, however small it is somewhere.
///
/// Where it seems to vanish, the points that `simple` gives are tried.
pub(super) fn positive(
    form: &ExactForm,
    at_most: usize,
    simple: &dyn Fn(&[BigRational; 2]) -> Vec<[BigRational; 2]>,
    control: &Control,
) -> Result<Grown, NoTree> {
    let sizes = form.coefficients.iter().filter_map(magnitude).map(|size| size.exponent);
    let below = u32::try_from(-sizes.min().unwrap_or(0)).unwrap_or(0);
    let mut nowhere = NoTree::TooMany;
    for doublings in 0..=DOUBLINGS {
        match tree(form, (BITS + below) << doublings, Shown::Positive, at_most, control) {
            Err(NoTree::Near(near)) => {
                for point in simple(&near) {
                    control.check()?;
                    match magnitude(&form.at(&point)) {
                        Some(Magnitude { negative: false, .. }) => {}
                        found => return Err(NoTree::Fails { at: Box::new(point), zero: found.is_none() }),
                    }
                }
                nowhere = NoTree::Near(near);
            }
            other => return other,
        }
    }
    Err(nowhere)
}

/// The tree for a form of this bidegree that is positive on the square, from its Bernstein coefficients, row by row.
///
/// # Errors
/// [`NoTree`]
pub fn positive_tree(
    bidegree: (usize, usize),
    coefficients: Vec<FieldElement>,
    at_most: usize,
    control: &Control,
) -> Result<Tree, NoTree> {
    let field = coefficients[0].field();
    let form = ExactForm::new(field, bidegree, coefficients);
    positive(&form, at_most, &candidates, control).map(|grown| grown.tree)
}
