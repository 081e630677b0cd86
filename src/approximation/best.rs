//! Best values of the unknowns for an objective, enclosed.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;

use super::descent::{GRID, descend};
use super::enclosure::{Enclosure, EnclosureError, enclose, quantity_of};
use super::extremes::{Place, local_extremes};
use super::model::Model;
use super::normal::{Normal, decimal_exponent};
use super::objective::Objective;
use super::polish::polish;
use super::recognise::recognised;
use super::start::{Stopped, least_squares, start};
use crate::certificate::Quantity;
use crate::control::{Control, Interrupted};
use crate::exact::Polynomial;
use crate::statement::Statement;

/// Decimals of values near 1.
const DECIMALS: i64 = 15;

/// What is looked for, and how.
#[derive(Debug, Clone)]
pub struct Search {
    /// What is made small.
    pub objective: Objective,
    /// For least squares: sample points each way.
    pub points: usize,
    /// For least squares: points (u, v) where the patch is to be on the surface.
    pub pass: Vec<(f64, f64)>,
    /// Decimal places of the enclosure; without a wish 12 for the radius, and for F/Wᵉ as many digits.
    pub places: Option<u32>,
    /// Where the random starts begin.
    pub seed: u64,
}

/// What was found.
#[derive(Debug, Clone)]
pub struct Approximation {
    /// The values as they were found, in decimals.
    pub found: Decimals,
    /// Whether the values that were taken are not these, but elements of K of small height near them. That these are the best values is
    /// a guess; what is proved is the enclosure at them.
    pub recognised: bool,
    /// The values that were taken, and between what they keep the patch.
    pub enclosure: Enclosure,
    /// The local extremes of the deviation.
    pub extremes: Vec<Place>,
}

/// Values in decimals.
#[derive(Debug, Clone)]
pub struct Decimals {
    /// One constant for each unknown.
    pub values: Vec<Polynomial>,
    /// How many decimals each has; fewer than none means zeros before the point.
    pub places: Vec<i64>,
}

/// What a search had when it was stopped; nothing of it is proved.
#[derive(Debug, Clone)]
pub struct BestSoFar {
    /// The best values so far.
    pub values: Decimals,
    /// The least and the greatest deviation there (r − 1, or F/Wᵉ), measured in floating point.
    pub measured: [f64; 2],
}

/// Why nothing was found.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ApproximationError {
    /// A bare system, or a patch without unknowns.
    #[error("there is no patch with unknowns to choose; `bound` encloses one without")]
    NothingToChoose,
    /// No start led to a patch with a positive denominator.
    #[error("no values with a positive denominator were found from {0} starts; try another --seed")]
    NoStart(usize),
    /// A control point at infinity, written in Cartesian coordinates.
    #[error(
        "at the best values found a control point has weight 0, so that its Cartesian coordinates are infinite; \
         write the net with convention = \"homogeneous\""
    )]
    AtInfinity,
    /// Interrupted.
    #[error("{0}")]
    Interrupted(Interrupted, Option<Box<BestSoFar>>),
    /// No enclosure.
    #[error("{0}")]
    Enclosure(#[from] EnclosureError),
}

/// Looks for the best values in floating point, and encloses the patch at decimals near them, or at exact values that they seem to
/// be. That the values are best is not proved by this; `exclude` proves it.
///
/// The search works with unknowns in their own units, so that it does not depend on what the patch is measured in.
///
/// # Errors
/// [`ApproximationError`]
pub fn approximate(
    statement: &Statement,
    search: &Search,
    control: &Control,
) -> Result<Approximation, ApproximationError> {
    let normal = Normal::of(statement).map_err(EnclosureError::Limit)?;
    let normal = normal.filter(|normal| !normal.unknowns.is_empty());
    let normal = normal.ok_or(ApproximationError::NothingToChoose)?;
    let model = Model::normal(statement, &normal).ok_or(ApproximationError::NothingToChoose)?;
    let found = searched(&model, &normal, search, control).map_err(|Stopped { why, best }| {
        let best = best.and_then(|y| BestSoFar::at(&model, &normal, &y));
        ApproximationError::Interrupted(why, best.map(Box::new))
    })?;
    let y = found.ok_or(ApproximationError::NoStart(super::start::STARTS))?;
    let decimals = Decimals::of(&normal, &y).ok_or(ApproximationError::AtInfinity)?;
    let exact = recognised(statement, &normal, &y);
    let recognised = exact.is_some();
    let values = exact.unwrap_or_else(|| decimals.values.clone());
    let places = search.places.unwrap_or_else(|| natural_places(statement, &normal));
    let enclosure = enclose(statement, &values, places, control).map_err(|error| match error {
        EnclosureError::Interrupted(why) => {
            ApproximationError::Interrupted(why, BestSoFar::at(&model, &normal, &y).map(Box::new))
        }
        error => ApproximationError::Enclosure(error),
    })?;
    let extremes = extremes(&model, &y);
    Ok(Approximation { found: decimals, recognised, enclosure, extremes })
}

/// The best values by their own units; nothing if no start led to a positive denominator.
fn searched(
    model: &Model,
    normal: &Normal,
    search: &Search,
    control: &Control,
) -> Result<Option<Vec<f64>>, Stopped> {
    let Some(from) = start(model, normal.fairest.as_deref(), search.seed, control)? else { return Ok(None) };
    let intervals = search.points.max(2) - 1;
    let squares = least_squares(model, &from, intervals, &search.pass, control)?;
    let squares = polish(model, &squares, intervals, &search.pass);
    Ok(Some(match search.objective {
        Objective::LeastSquares => squares,
        objective => descend(model, &squares, objective, control)?,
    }))
}

/// The local extremes of the deviation, in its own unit.
fn extremes(model: &Model, y: &[f64]) -> Vec<Place> {
    let places = local_extremes(&model.at(y), GRID);
    places.into_iter().map(|place| Place { value: place.value * model.unit(), ..place }).collect()
}

/// As many decimals of F/Wᵉ as twelve are of the radius of a unit sphere.
fn natural_places(statement: &Statement, normal: &Normal) -> u32 {
    let exponent = match quantity_of(statement) {
        Some(Quantity::Ratio) => decimal_exponent(normal.ratio),
        _ => 0,
    };
    u32::try_from((12 - exponent).clamp(1, 100)).unwrap_or(12)
}

impl Decimals {
    /// Of values in their own units: as many digits as a double has.
    fn of(normal: &Normal, y: &[f64]) -> Option<Self> {
        let exact = normal.undone(&normal.exactly(y))?;
        let places = normal.decimals(DECIMALS);
        let rounded = |(value, &places): (&BigRational, &i64)| {
            let unit = ten(places);
            Polynomial::rational(BigRational::from_integer((value * &unit).round().to_integer()) / unit)
        };
        Some(Decimals { values: exact.iter().zip(&places).map(rounded).collect(), places })
    }
}

impl BestSoFar {
    fn at(model: &Model, normal: &Normal, y: &[f64]) -> Option<Self> {
        let values = Decimals::of(normal, y)?;
        let extremes = extremes(model, y);
        let of = |sign: f64| extremes.iter().map(|place| sign * place.value).reduce(f64::max);
        Some(BestSoFar { values, measured: [-of(-1.0)?, of(1.0)?] })
    }
}

/// 10ⁿ.
fn ten(exponent: i64) -> BigRational {
    let size = BigRational::from_integer(BigInt::from(10).pow(exponent.unsigned_abs() as u32));
    if exponent < 0 { size.recip() } else { size }
}

/// The largest distance of the quantity from what it is on the surface, as the bounds have it, in units of the last place.
pub fn error_of(enclosure: &Enclosure) -> BigInt {
    let bounds = &enclosure.bounds;
    let centre = match bounds.quantity {
        Quantity::Radius => BigInt::from(10).pow(bounds.places),
        Quantity::Ratio => BigInt::from(0),
    };
    let [below, above] = [&centre - &bounds.lower.bound, &bounds.upper.bound - &centre];
    below.max(above).abs()
}
