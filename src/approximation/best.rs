//! Best values of the unknowns for an objective, enclosed.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;

use super::descent::{GRID, descend};
use super::enclosure::{Enclosure, EnclosureError, enclose};
use super::extremes::{Place, local_extremes};
use super::fixed::to_f64;
use super::model::Model;
use super::objective::Objective;
use super::polish::polish;
use super::recognise::recognise;
use super::start::{least_squares, start};
use super::unreachable::products;
use crate::algebra::{FieldElement, polynomial_from_exact, polynomial_to_exact};
use crate::elimination::{Control, Interrupted};
use crate::exact::Polynomial;
use crate::prove::field_of;
use crate::statement::Statement;

/// Decimals of the values.
const DECIMALS: u32 = 15;

/// What is looked for, and how.
#[derive(Debug, Clone)]
pub struct Search {
    /// What is made small.
    pub objective: Objective,
    /// For least squares: sample points each way.
    pub points: usize,
    /// For least squares: points (u, v) where the patch is to be on the surface.
    pub pass: Vec<(f64, f64)>,
    /// Decimal places of the enclosure.
    pub places: u32,
    /// Where the random starts begin.
    pub seed: u64,
}

/// What was found.
#[derive(Debug, Clone)]
pub struct Approximation {
    /// The values as they were found.
    pub found: Vec<f64>,
    /// Whether these are exact elements of K of small height, not decimals.
    pub recognised: bool,
    /// The values that were taken, and between what they keep the patch.
    pub enclosure: Enclosure,
    /// The local extremes of the deviation.
    pub extremes: Vec<Place>,
}

/// Why nothing was found.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ApproximationError {
    /// A bare system, or a patch without unknowns.
    #[error("there is no patch with unknowns to choose; `bound` encloses one without")]
    NothingToChoose,
    /// No start led to a patch with a positive denominator.
    #[error("no values with a positive denominator were found from {0} random starts; try another --seed")]
    NoStart(usize),
    /// Interrupted.
    #[error("{0}")]
    Interrupted(Interrupted),
    /// No enclosure.
    #[error("{0}")]
    Enclosure(#[from] EnclosureError),
}

impl From<Interrupted> for ApproximationError {
    fn from(why: Interrupted) -> Self {
        ApproximationError::Interrupted(why)
    }
}

/// Finds the best values in floating point, and encloses the patch at decimals near them, or at exact values that they seem to
/// be. That the values are best is not proved by this; `exclude` proves it.
///
/// # Errors
/// [`ApproximationError`]
pub fn approximate(
    statement: &Statement,
    search: &Search,
    control: &Control<'_>,
) -> Result<Approximation, ApproximationError> {
    let model = Model::of(statement).filter(|model| model.unknowns() > 0);
    let model = model.ok_or(ApproximationError::NothingToChoose)?;
    let from = start(&model, search.seed, control)?;
    let from = from.ok_or(ApproximationError::NoStart(super::start::STARTS))?;
    let intervals = search.points.max(2) - 1;
    let squares = least_squares(&model, &from, intervals, &search.pass);
    let squares = polish(&model, &squares, intervals, &search.pass);
    let found = match search.objective {
        Objective::LeastSquares => squares,
        objective => descend(&model, &squares, objective, control)?,
    };
    let extremes = local_extremes(&model.at(&found), GRID);
    let exact = guessed(statement, &found);
    let recognised = exact.is_some();
    let values = exact.unwrap_or_else(|| found.iter().map(|&value| decimal(value)).collect());
    let enclosure = enclose(statement, &values, search.places, control)?;
    Ok(Approximation { found, recognised, enclosure, extremes })
}

/// The number with so many decimals, exactly.
fn decimal(value: f64) -> Polynomial {
    let unit = BigInt::from(10).pow(DECIMALS);
    let exact = BigRational::from_float(value).unwrap_or_default() * BigRational::from_integer(unit.clone());
    Polynomial::rational(BigRational::new(exact.round().to_integer(), unit))
}

/// Elements of K of small height that the values seem to be: all of them, or, for a coordinate of a point with an unknown
/// weight, its product with that.
fn guessed(statement: &Statement, values: &[f64]) -> Option<Vec<Polynomial>> {
    let field = field_of(statement);
    let products = products(statement);
    let mut exact: Vec<Option<FieldElement>> = Vec::new();
    for (k, &value) in values.iter().enumerate() {
        let factor = products.iter().find(|(z, _)| usize::from(*z) == k).map(|(_, w)| usize::from(*w));
        exact.push(Some(recognise(factor.map_or(value, |w| value * values[w]), field)?));
    }
    for &(z, w) in &products {
        let [product, weight] = [z, w].map(|k| exact[usize::from(k)].clone());
        exact[usize::from(z)] = Some(&product? * &weight?.inverse()?);
    }
    let constants = exact.into_iter().flatten().map(crate::algebra::Polynomial::constant);
    constants.map(|value| polynomial_to_exact(&value).ok()).collect()
}

/// The values of an enclosure in floating point.
pub fn approximately(statement: &Statement, values: &[Polynomial]) -> Vec<f64> {
    let field = field_of(statement);
    let constant =
        |value: &Polynomial| polynomial_from_exact(field, value).as_constant().map(|value| to_f64(&value));
    values.iter().map(|value| constant(value).unwrap_or(f64::NAN)).collect()
}

/// The largest distance of the quantity from what it is on the surface, as the bounds have it, in units of the last place.
pub fn error_of(enclosure: &Enclosure) -> BigInt {
    let bounds = &enclosure.bounds;
    let centre = match bounds.quantity {
        crate::certificate::Quantity::Radius => BigInt::from(10).pow(bounds.places),
        crate::certificate::Quantity::Ratio => BigInt::from(0),
    };
    let [below, above] = [&centre - &bounds.lower.bound, &bounds.upper.bound - &centre];
    below.max(above).abs()
}
