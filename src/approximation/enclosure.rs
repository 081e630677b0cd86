//! Proved enclosures: between which decimals the radius of a patch lies, with a certificate.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::boxes::Coefficients;
use super::extreme::{Extreme, largest};
use super::fixed::fixed;
use super::point::compare_at;
use super::tree::{NoTree, tree};
use crate::algebra::{FieldElement, Integer, MultiquadraticField};
use crate::bezier::{binomial, surface_condition};
use crate::certificate::{Argument, Bounds, Certificate, End, Quantity, Side, Units, decimal_value};
use crate::checker::{BoundsRejection, CheckError, Rejection, Theorem, check_read};
use crate::elimination::{Control, Interrupted};
use crate::exact::{self, Limit, Polynomial, Work};
use crate::prove::field_of;
use crate::statement::{Patch, Statement, Subject};

/// Boxes before an enclosure is given up.
const BOXES: usize = 200_000;
/// Bits beyond those that the decimals need: for the rounding of the subdivision, and for the places of the extremes.
const SPARE: u32 = 96;
/// By how many bits the extremes are known better than one unit of the last decimal.
const FINER: u32 = 2;

/// Bounds with their certificate, accepted by the checker.
#[derive(Debug, Clone)]
pub struct Enclosure {
    /// The bounds.
    pub bounds: Bounds,
    /// Whether the quantity is the lower, and the upper, bound at the stated points.
    pub attained: [bool; 2],
    /// The certificate.
    pub certificate: Certificate,
    /// What the checker made of it.
    pub theorem: Theorem,
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
        /// Whether it is positive elsewhere.
        vanishes: bool,
    },
    /// The subdivision became too fine.
    #[error("the subdivision became too fine: more than {0} boxes")]
    TooFine(usize),
    /// Interrupted.
    #[error("{0}")]
    Interrupted(Interrupted),
    /// A limit of the format.
    #[error("{0}")]
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
    control: &Control<'_>,
) -> Result<Enclosure, EnclosureError> {
    let quantity = quantity_of(statement).ok_or(EnclosureError::NotAPatch)?;
    let scene = Scene::at(statement, values, quantity)?;
    // 10 < 2^(10/3).
    let bits = places * 10 / 3 + SPARE;
    let denominator = scene.positive_denominator(bits, control)?;
    let mut finer = FINER;
    loop {
        let lower = scene.end(Side::Lower, places, bits, finer, control)?;
        let upper = scene.end(Side::Upper, places, bits, finer, control)?;
        let bounds = Bounds {
            values: values.to_vec(),
            quantity,
            places,
            denominator: denominator.clone(),
            lower,
            upper,
        };
        let argument = Argument::Bounds(bounds.clone());
        let certificate = Certificate { statement: statement.hash(), argument };
        match check_read(statement, &certificate) {
            Ok(theorem) => {
                let attains = |end: &End| {
                    let bound = decimal_value(&end.bound, places);
                    compare_at(statement, values, &end.at, &bound).map(Ordering::is_eq)
                };
                let attained = [attains(&bounds.lower)?, attains(&bounds.upper)?];
                return Ok(Enclosure { bounds, attained, certificate, theorem });
            }
            // The extreme lies next to a decimal: its place must be known better.
            Err(CheckError::Rejected(Rejection::Bounds(BoundsRejection::NotReached { .. })))
                if finer + 16 < SPARE / 2 =>
            {
                finer += 16;
            }
            Err(error) => return Err(EnclosureError::Refused(error)),
        }
    }
}

/// What is bounded along the patch of a statement; nothing for a system.
pub fn quantity_of(statement: &Statement) -> Option<Quantity> {
    let Subject::Patch(patch) = statement.subject() else { return None };
    let sphere = statement.coordinate_ring().read("X^2 + Y^2 + Z^2 - W^2", &mut Work::full()).ok();
    Some(if sphere.as_ref() == Some(&patch.surface) { Quantity::Radius } else { Quantity::Ratio })
}

/// The patch of a statement with values for its unknowns.
pub fn patch_at(statement: &Statement, values: &[Polynomial]) -> Result<Patch, EnclosureError> {
    let Subject::Patch(patch) = statement.subject() else { return Err(EnclosureError::NotAPatch) };
    let (mut patch, mut work) = (patch.clone(), Work::full());
    for coordinate in patch.net.iter_mut().flatten().flatten() {
        *coordinate = coordinate.substitute(values, statement.field(), &mut work)?;
    }
    Ok(patch)
}

/// F, W and Wᵉ along a patch.
struct Scene {
    field: MultiquadraticField,
    quantity: Quantity,
    surface: Vec<FieldElement>,
    power: Vec<FieldElement>,
    weight: Vec<FieldElement>,
    bidegree: (usize, usize),
    patch_bidegree: (usize, usize),
}

impl Scene {
    fn at(statement: &Statement, values: &[Polynomial], quantity: Quantity) -> Result<Self, EnclosureError> {
        let patch = patch_at(statement, values)?;
        let field = field_of(statement);
        let along = |surface: exact::Polynomial| {
            surface_condition(field, &Patch { surface, ..patch.clone() }).constants()
        };
        let degree = patch.surface.degree();
        let weight = exact::Polynomial::variable(3);
        let power = weight.power(degree, statement.field(), &mut Work::full())?;
        let size = |(m, n): (u32, u32)| (m as usize, n as usize);
        Ok(Scene {
            field,
            quantity,
            surface: along(patch.surface.clone()),
            power: along(power),
            weight: along(weight),
            bidegree: size((patch.bidegree.0 * degree, patch.bidegree.1 * degree)),
            patch_bidegree: size(patch.bidegree),
        })
    }

    fn positive_denominator(&self, bits: u32, control: &Control<'_>) -> Result<Vec<bool>, EnclosureError> {
        let values: Vec<Integer> = self.weight.iter().map(|value| fixed(value, bits)).collect();
        let positive = values[0] > Integer::zero();
        let form = Coefficients { bidegree: self.patch_bidegree, values };
        // What is nearer to zero than the rounding of the subdivision counts as zero.
        let least = Integer::one().shifted_left(SPARE / 4);
        tree(form, &least, BOXES, control).map_err(|why| match why {
            NoTree::Negative { corner, depths } => {
                let [u, v] = [(corner.0, depths.0), (corner.1, depths.1)].map(rational);
                let value = self.weight_at(&u, &v);
                EnclosureError::Denominator {
                    at: Box::new([u, v]),
                    zero: value.is_zero(),
                    vanishes: positive,
                }
            }
            other => failed(other),
        })
    }

    fn weight_at(&self, u: &BigRational, v: &BigRational) -> FieldElement {
        let (m, n) = self.patch_bidegree;
        let basis = |degree: usize, i: usize, x: &BigRational| -> FieldElement {
            let rest = BigRational::one() - x;
            let power = |base: &BigRational, e: usize| (0..e).fold(BigRational::one(), |p, _| p * base);
            let value = power(x, i) * power(&rest, degree - i);
            let [numerator, denominator] = [value.numer(), value.denom()].map(Integer::from_bigint);
            self.field.rational(&numerator * &binomial(degree as u32, i as u32), denominator)
        };
        let mut sum = self.field.zero();
        for i in 0..=m {
            for j in 0..=n {
                let weight = &self.weight[i * (n + 1) + j];
                sum = &sum + &(&(&basis(m, i, u) * &basis(n, j, v)) * weight);
            }
        }
        sum
    }

    /// One end: the extreme, the decimal beyond it, and the tree that shows it.
    fn end(
        &self,
        side: Side,
        places: u32,
        bits: u32,
        finer: u32,
        control: &Control<'_>,
    ) -> Result<End, EnclosureError> {
        let signed = |value: &FieldElement| if side == Side::Lower { -value } else { value.clone() };
        let numerator = self.surface.iter().map(|value| fixed(&signed(value), bits)).collect();
        let denominator = self.power.iter().map(|value| fixed(value, bits)).collect();
        let [numerator, denominator] =
            [numerator, denominator].map(|values| Coefficients { bidegree: self.bidegree, values });
        let slack = Integer::one().shifted_left(SPARE - finer);
        let extreme = largest(numerator, denominator, bits, &slack, BOXES, control).map_err(failed)?;
        let Extreme { corner, depths, value } = extreme;
        let at = [(corner.0, depths.0), (corner.1, depths.1)].map(rational);
        let value = if side == Side::Lower { -&value } else { value };
        // First the decimal next to the extreme as far as it is known; then the one after it.
        let nearest = self.decimal(side, &value, places, bits);
        let outwards = if side == Side::Lower { -1 } else { 1 };
        for (bound, at_most) in [(nearest.clone(), BOXES / 10), (nearest + outwards, BOXES)] {
            if self.quantity == Quantity::Radius && bound.is_negative() {
                continue;
            }
            match tree(self.beyond(side, &bound, places, bits), &rounding(), at_most, control) {
                Ok(tree) => return Ok(End { bound, at, tree }),
                Err(NoTree::Interrupted(why)) => return Err(EnclosureError::Interrupted(why)),
                Err(_) => {}
            }
        }
        Err(EnclosureError::TooFine(BOXES))
    }

    /// The decimal beyond a value of F/Wᵉ in fixed point, or at it, taken with some tolerance for its rounding.
    fn decimal(&self, side: Side, value: &Integer, places: u32, bits: u32) -> Units {
        let unit = Integer::from(10i64).power(places);
        // In units 2^−bits; for the radius √(1 + value).
        let size = match self.quantity {
            Quantity::Ratio => value.clone(),
            Quantity::Radius => {
                let square = &Integer::one().shifted_left(bits) + value;
                if square.is_negative() { Integer::zero() } else { square.shifted_left(bits).floor_sqrt() }
            }
        };
        let tolerance = Integer::one().shifted_left(SPARE / 2);
        let bound = match side {
            // The ceiling of −x is −⌊x⌋.
            Side::Lower => (&(&size + &tolerance) * &unit).shifted_right(bits),
            _ => -&(&(&tolerance - &size) * &unit).shifted_right(bits),
        };
        bound.to_bigint()
    }

    /// F − low·Wᵉ or high·Wᵉ − F.
    fn beyond(&self, side: Side, bound: &Units, places: u32, bits: u32) -> Coefficients {
        let unit = BigInt::from(10).pow(places);
        let value = BigRational::new(bound.clone(), unit);
        let value = match self.quantity {
            Quantity::Radius => &value * &value - BigRational::one(),
            Quantity::Ratio => value,
        };
        let [numerator, denominator] = [value.numer(), value.denom()].map(Integer::from_bigint);
        let threshold = self.field.rational(numerator, denominator);
        let difference = |(surface, power): (&FieldElement, &FieldElement)| {
            let beyond = surface - &(&threshold * power);
            fixed(&if side == Side::Lower { beyond } else { -&beyond }, bits)
        };
        let values = self.surface.iter().zip(&self.power).map(difference).collect();
        Coefficients { bidegree: self.bidegree, values }
    }
}

/// What is above this, in fixed point, may be zero exactly: the checker will tell.
fn rounding() -> Integer {
    -&Integer::one().shifted_left(SPARE / 4)
}

fn rational((numerator, depth): (Integer, u32)) -> BigRational {
    BigRational::new(numerator.to_bigint(), BigInt::one() << depth)
}

fn failed(why: NoTree) -> EnclosureError {
    match why {
        NoTree::Interrupted(why) => EnclosureError::Interrupted(why),
        NoTree::TooMany | NoTree::Negative { .. } => EnclosureError::TooFine(BOXES),
    }
}
