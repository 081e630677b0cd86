//! Proved enclosures: between which decimals the radius of a patch lies, with a certificate.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::end::{BOXES, Search, small};
use super::scene::Scene;
use super::tree::{NoTree, positive};
use crate::certificate::{Argument, Bounds, End, Quantity, Side};
use crate::checker::CheckError;
use crate::control::{Control, Interrupted};
use crate::exact::{Arithmetic, Limit, Polynomial, Work};
use crate::proof::{NoProof, Proof};
use crate::statement::{Patch, Statement, Subject};

/// Bounds with their certificate, accepted by the checker.
#[derive(Debug, Clone)]
pub struct Enclosure {
    /// The bounds.
    pub bounds: Bounds,
    /// Whether the quantity is the lower, and the upper, bound at the stated points, exactly.
    pub attained: [bool; 2],
    /// Whether they are the best with their places; if not, the quantity at its point is the next decimal, exactly.
    pub best: [bool; 2],
    /// What the checker has accepted.
    pub proof: Proof,
}

/// Why there is no enclosure.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum EnclosureError {
    /// A bare system.
    #[error("a system of equations has no patch to bound")]
    NotAPatch,
    /// The denominator is not positive.
    #[error("the denominator W of the patch is {} at u = {}, v = {}, expected positive on the whole square{}",
        if *zero { "0" } else { "negative" },
        at[0],
        at[1],
        if *vanishes { "; it is positive at u = v = 0, so that it vanishes in between" } else { "" })]
    Denominator {
        /// The place (u, v).
        at: Box<[BigRational; 2]>,
        /// Whether it is 0 there.
        zero: bool,
        /// Whether it is positive at u = v = 0, and so vanishes in between.
        vanishes: bool,
    },
    /// The denominator comes too near to 0.
    #[error("whether the denominator W of the patch is positive was not decided: it comes too near to 0, around {}", around(.0))]
    NearZero(Box<[BigRational; 2]>),
    /// An extreme that is next to a decimal, or it.
    #[error(
        "whether the {end} value lies beyond {bound} was not decided: it comes too near to it, around {}",
        around(near)
    )]
    Unsettled {
        /// `least` or `greatest`.
        end: &'static str,
        /// The decimal.
        bound: String,
        /// A place near that of the extreme.
        near: Box<[BigRational; 2]>,
    },
    /// The subdivision became too fine.
    #[error("the subdivision became too fine: more than {0} boxes")]
    TooFine(usize),
    /// Interrupted.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
    /// A limit of the checker, whatever the certificate.
    #[error("the checker, which judges every certificate, has limits: {0}")]
    Limit(#[from] Limit),
    /// The checker refused.
    #[error("the independent checker refused the bounds: {0}")]
    Refused(CheckError),
}

/// Encloses the quantity between two decimals with this many places, each the best.
///
/// The values are constants of K, one for each unknown. For the unit sphere the radius is enclosed, else F/Wᵉ.
///
/// # Errors
/// [`EnclosureError`]
pub fn enclose(
    statement: &Statement,
    values: &[Polynomial],
    places: u32,
    control: &Control,
) -> Result<Enclosure, EnclosureError> {
    let quantity = quantity_of(statement).ok_or(EnclosureError::NotAPatch)?;
    within_limits(statement, values, quantity, places, control)?;
    let scene = Scene::of(statement, values, control)?;
    let denominator = positive(&scene.weight, BOXES, &|near| scene.simple(near), control);
    let denominator = denominator.map_err(|why| match why {
        NoTree::Fails { at, zero } => {
            EnclosureError::Denominator { at: Box::new(scene.outer(&at)), zero, vanishes: !zero }
        }
        NoTree::Near(near) => EnclosureError::NearZero(Box::new(scene.outer(&near))),
        NoTree::TooMany => EnclosureError::TooFine(BOXES),
        NoTree::Interrupted(why) => EnclosureError::Interrupted(why),
    })?;
    let small = small(denominator.least);
    let end = |side| Search { scene: &scene, side, places, small, control }.end();
    let (lower, upper) = (end(Side::Lower)?, end(Side::Upper)?);
    let attains = |end: &End| scene.compare_decimal(&end.at, &end.bound, places) == Ordering::Equal;
    let attained = [attains(&lower), attains(&upper)];
    let next = |end: &End, inwards: i64| {
        scene.compare_decimal(&end.at, &(&end.bound + inwards), places) == Ordering::Equal
    };
    let best = [!next(&lower, 1), !next(&upper, -1)];
    let denominator = denominator.tree;
    let (values, odds) = (values.to_vec(), scene.odds.clone());
    let bounds = Bounds { values, quantity, places, odds, denominator, lower, upper };
    let argument = Argument::Bounds(bounds.clone());
    Ok(Enclosure { bounds, attained, best, proof: Proof::of(statement, argument, control)? })
}

/// Whether the checker can derive F, W and Wᵉ at all: what it says of a certificate without boxes.
fn within_limits(
    statement: &Statement,
    values: &[Polynomial],
    quantity: Quantity,
    places: u32,
    control: &Control,
) -> Result<(), EnclosureError> {
    let origin = || [BigRational::zero(), BigRational::zero()];
    let end = || End { bound: BigInt::ZERO, at: origin(), tree: vec![false] };
    let values = values.to_vec();
    let (odds, denominator) = ([BigRational::one(), BigRational::one()], vec![false]);
    let bounds = Bounds { values, quantity, places, odds, denominator, lower: end(), upper: end() };
    match Proof::of(statement, Argument::Bounds(bounds), control) {
        // That one box is not enough is no news.
        Ok(_) | Err(NoProof::Refused(_)) => Ok(()),
        Err(why) => Err(why.into()),
    }
}

impl From<NoProof> for EnclosureError {
    fn from(why: NoProof) -> Self {
        match why {
            NoProof::Interrupted(why) => EnclosureError::Interrupted(why),
            NoProof::Limit(limit) => EnclosureError::Limit(limit),
            NoProof::Refused(error) => EnclosureError::Refused(error),
        }
    }
}

/// `(u, v) = (0.333333, 0.5)`, rounded.
pub(crate) fn around(point: &[BigRational; 2]) -> String {
    let [u, v] = point.each_ref().map(|x| num_traits::ToPrimitive::to_f64(x).unwrap_or(f64::NAN));
    format!("(u, v) = ({u:.6}, {v:.6})")
}

/// What is bounded along the patch of a statement; nothing for a system.
pub fn quantity_of(statement: &Statement) -> Option<Quantity> {
    let Subject::Patch(patch) = statement.subject() else { return None };
    Some(if patch.is_on_unit_sphere() { Quantity::Radius } else { Quantity::Ratio })
}

/// The patch of a statement with values for its unknowns.
pub fn patch_at(statement: &Statement, values: &[Polynomial]) -> Result<Patch, EnclosureError> {
    let Subject::Patch(patch) = statement.subject() else { return Err(EnclosureError::NotAPatch) };
    let (mut patch, mut work) = (patch.clone(), Work::full());
    for coordinate in patch.net.iter_mut().flatten().flatten() {
        *coordinate = Arithmetic::new(statement.field(), &mut work).substitute(coordinate, values)?;
    }
    Ok(patch)
}
