//! `approximate`: the best values of the unknowns that are found, enclosed, and if asked for proved best.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::bound::{degree_of, unenclosed};
use super::{Failure, NoAnswer, Source, Undecided, Verdict};
use crate::approximation::{
    self, Approximation, ApproximationError, Barrier, Objective, Search, UnreachableError, error_of, exclude,
};
use crate::certificate::{Quantity, decimal_value};
use crate::control::Control;

/// How near to the best the proof that nothing is better must come.
const WITHIN: f64 = 1e-6;
/// Places of the bounds that no values reach: relative to the error, this many digits.
const DIGITS: u32 = 9;
/// Decimal places of an error, at most.
const PLACES: f64 = 80.0;

/// Values that were found.
#[derive(Debug)]
pub struct Approximated {
    /// The patch.
    pub source: Source,
    /// e, the degree of its surface.
    pub degree: u32,
    /// What was looked for, and how.
    pub search: Search,
    /// The values, enclosed.
    pub found: Approximation,
    /// Whether nothing is better.
    pub best: Best,
}

/// Whether no values do better.
#[derive(Debug)]
pub enum Best {
    /// It was not asked for.
    NotAsked,
    /// The largest deviation is 0, and nothing is less.
    Zero,
    /// It is proved, up to the gap.
    Proved(Box<Barrier>, Gap),
    /// It is not proved, and why.
    Open(UnreachableError),
}

/// Between what values were found to reach and what none reach.
#[derive(Debug, Clone)]
pub struct Gap {
    /// The largest distance of the quantity from what it is on the surface, at most, at the values that were found.
    pub reached: BigRational,
    /// What it is at least, for all values.
    pub unreached: BigRational,
}

impl Gap {
    /// By which part of it the values found may be worse than the best.
    pub fn relative(&self) -> BigRational {
        (&self.reached - &self.unreached) / &self.unreached
    }
}

impl Approximated {
    /// Of the bounds, or that it stays open whether anything is better.
    pub fn verdict(&self) -> Verdict {
        if matches!(self.best, Best::Open(_)) { Verdict::Undecided } else { Verdict::Enclosed }
    }

    /// The largest distance from the surface, as the bounds have it.
    pub fn reached(&self) -> BigRational {
        reached(&self.found)
    }
}

/// Looks for the best values; where asked to, proves that none are better.
///
/// # Errors
/// [`NoAnswer`], with the best values so far where the search was stopped.
pub fn approximate(
    source: Source,
    search: Search,
    prove_best: bool,
    control: &Control,
) -> Result<Approximated, NoAnswer> {
    let degree = degree_of(&source.statement)?;
    let found = match approximation::approximate(&source.statement, &search, control) {
        Ok(found) => found,
        Err(ApproximationError::Enclosure(error)) => return Err(unenclosed(&source, error)),
        Err(ApproximationError::Interrupted(why, best)) => {
            let best = best.map(|best| (source.statement.clone(), best));
            return Err(Undecided { best, ..Undecided::stopped(&source.name, why) }.into());
        }
        Err(error) => return Err(Failure::about(&source.name, error).into()),
    };
    // Nothing is less than 0.
    let zero = search.objective == Objective::Minimax && reached(&found).is_zero();
    let best = match (prove_best && !zero).then(|| barrier(&source, &found, control)) {
        None if zero => Best::Zero,
        None => Best::NotAsked,
        Some(Ok(barrier)) => {
            let gap = Gap { reached: reached(&found), unreached: barrier.half_width.clone() };
            Best::Proved(Box::new(barrier), gap)
        }
        Some(Err(UnreachableError::Refused(error))) => return Err(Failure::of(error).into()),
        Some(Err(error)) => Best::Open(error),
    };
    Ok(Approximated { source, degree, search, found, best })
}

fn reached(found: &Approximation) -> BigRational {
    decimal_value(&error_of(&found.enclosure).abs(), found.enclosure.bounds.places)
}

/// Bounds a millionth tighter than what was found, which no values reach.
fn barrier(source: &Source, found: &Approximation, control: &Control) -> Result<Barrier, UnreachableError> {
    let error = found.extremes.iter().map(|place| place.value.abs()).fold(0.0, f64::max);
    // What is far below the last digit of a double is not told apart from 0 here.
    let places = (-error.max(f64::MIN_POSITIVE).log10()).ceil().clamp(0.0, PLACES) as u32 + DIGITS;
    let unit = BigInt::from(10).pow(places);
    let size = BigRational::from_float(error * (1.0 - WITHIN)).unwrap_or_else(BigRational::zero);
    let size = (size * &unit).to_integer();
    let centre = match found.enclosure.bounds.quantity {
        Quantity::Radius => unit,
        Quantity::Ratio => BigInt::ZERO,
    };
    let worst: Vec<_> =
        found.extremes.iter().filter(|place| place.value.abs() > 0.5 * error).copied().collect();
    exclude(&source.statement, [&centre - &size, &centre + &size], places, &worst, control)
}

/// Whether a search makes sense: what is only for one objective is asked for with it.
///
/// # Errors
/// In the words of the command line.
pub fn sensible(search: &Search, prove_best: bool) -> Result<(), Failure> {
    if prove_best && search.objective != Objective::Minimax {
        return Err(Failure::new("--prove-best is for --objective minimax"));
    }
    if !search.pass.is_empty() && search.objective != Objective::LeastSquares {
        return Err(Failure::new("--pass is for --objective least-squares"));
    }
    Ok(())
}
