//! What each convention leaves of the surface condition, and to how many decimals rounding may explain it.
//!
//! If the numbers pᵢ are those of a net on the surface, changed by at most δ each, then no coefficient of the condition,
//! a polynomial in them, is larger than M(|p| + δ) − M(|p|), where M has the absolute values of all its coefficients. One
//! expansion with δ as an unknown has these bounds for every δ.

use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::Signed;

use super::NetAudit;
use crate::algebra::{
    FieldElement, Integer, MultiquadraticField, Polynomial as Computed, Sign, polynomial_to_exact,
};
use crate::audit::AuditError;
use crate::bezier::surface_condition_within;
use crate::control::Control;
use crate::exact::Polynomial;
use crate::formats::net::{Convention, PrintedNet, premultiplied};
use crate::problem::field_of;
use crate::statement::{Patch, Statement, Subject};

/// More decimals than these are not counted.
const DECIMALS: u32 = 40;

/// A net read in one convention.
#[derive(Debug, Clone)]
pub struct Reading {
    /// The convention.
    pub convention: Convention,
    /// The coefficient of the largest absolute value, with its index.
    pub largest: (u32, u32, Polynomial),
    /// The most decimals, up to those that are printed, such that all coefficients keep the bound for a net on the surface whose
    /// numbers were all rounded to so many.
    pub decimals: Option<u32>,
    /// How many decimals are printed, 40 at most; none where every number is exact without.
    pub printed: Option<u32>,
}

/// Both readings, that of the file first. One that leaves nothing is left out.
pub(super) fn readings(net: &PrintedNet, audit: &mut NetAudit, control: &Control) -> Result<(), AuditError> {
    for convention in [net.convention, net.convention.other()] {
        control.check()?;
        let net = PrintedNet { convention, ..net.clone() };
        let reading = reading(&net, &audit.statement, control);
        audit.readings.extend(reading.map_err(|error| control.unless_stopped(error))?);
    }
    Ok(())
}

fn reading(
    net: &PrintedNet,
    statement: &Statement,
    control: &Control,
) -> Result<Option<Reading>, AuditError> {
    let Subject::Patch(patch) = statement.subject() else { return Ok(None) };
    let field = field_of(statement);
    let form = surface_condition_within(field, &Patch { net: net.homogeneous()?, ..patch.clone() }, control)?;
    let mut sizes = Vec::new();
    let mut largest: Option<(u32, u32, FieldElement, FieldElement)> = None;
    for (r, s, value) in form.coefficients() {
        let Some((value, size)) = value.as_constant().and_then(|v| Some((v.clone(), absolute(&v)?))) else {
            return Ok(None);
        };
        if largest.as_ref().is_none_or(|(.., most)| exceeds(&size, most)) && !size.is_zero() {
            largest = Some((r, s, value, size.clone()));
        }
        sizes.push(size);
    }
    let Some((r, s, value, _)) = largest else { return Ok(None) };
    let printed = net.points.iter().flatten().flatten().filter_map(decimals_of).max();
    let decimals = match printed {
        Some(printed) if printed > 0 => {
            control.check()?;
            let bounds = bounds(net, patch, field, control)?;
            (1..=printed).rev().find(|&decimals| within(&sizes, &bounds, decimals, field))
        }
        _ => None,
    };
    let value = polynomial_to_exact(&Computed::constant(value))?;
    let printed = printed.filter(|&printed| printed > 0);
    Ok(Some(Reading { convention: net.convention, largest: (r, s, value), decimals, printed }))
}

/// How many decimals spell a number; none where it takes no finite number of them, or more than [`DECIMALS`].
fn decimals_of(number: &Polynomial) -> Option<u32> {
    let rational = number.as_rational()?;
    (0..=DECIMALS).find(|&decimals| BigInt::from(10).pow(decimals).is_multiple_of(rational.denom()))
}

/// The bounds on the coefficients, as polynomials in δ without constant term: the coefficients of δ, δ², ….
fn bounds(
    net: &PrintedNet,
    patch: &Patch,
    field: MultiquadraticField,
    control: &Control,
) -> Result<Vec<Vec<FieldElement>>, AuditError> {
    let mut work = control.work();
    let mut rows = Vec::new();
    for row in &net.points {
        let mut points = Vec::new();
        for point in row {
            let mut enlarged = point.clone();
            for number in &mut enlarged {
                let sum = [of_absolute_terms(number), Polynomial::variable(0)];
                *number = Polynomial::sum(&sum, &net.field, &mut work)?;
            }
            points.push(premultiplied(&enlarged, net.convention, &net.field, &mut work)?);
        }
        rows.push(points);
    }
    let surface = of_absolute_terms(&patch.surface);
    let form = surface_condition_within(field, &Patch { net: rows, surface, ..patch.clone() }, control)?;
    let coefficients = form.coefficients().map(|(_, _, bound)| {
        let mut powers = vec![field.zero(); bound.degree().unwrap_or(0) as usize];
        for (monomial, value) in bound.terms().iter().filter(|(monomial, _)| monomial.degree() > 0) {
            powers[monomial.degree() as usize - 1] = value.clone();
        }
        powers
    });
    Ok(coefficients.collect())
}

/// With the absolute value of each rational in front of a root: at least the absolute value.
fn of_absolute_terms(polynomial: &Polynomial) -> Polynomial {
    Polynomial::from_terms(polynomial.terms().map(|(monomial, value)| (monomial.clone(), value.abs())))
}

/// Whether every size is within its bound for δ = 10⁻ᵈ/2.
fn within(
    sizes: &[FieldElement],
    bounds: &[Vec<FieldElement>],
    decimals: u32,
    field: MultiquadraticField,
) -> bool {
    let delta = field.rational(Integer::one(), Integer::from_bigint(&(BigInt::from(10).pow(decimals) * 2)));
    sizes.iter().zip(bounds).all(|(size, bound)| {
        let bound = bound.iter().rev().fold(field.zero(), |sum, power| &(&sum + power) * &delta);
        !exceeds(size, &bound)
    })
}

/// |x|, if its sign can be found.
pub(super) fn absolute(x: &FieldElement) -> Option<FieldElement> {
    Some(if x.sign() == Sign::Negative { -x } else { x.clone() })
}

/// Whether a > b; where that cannot be found, it is taken to be so.
fn exceeds(a: &FieldElement, b: &FieldElement) -> bool {
    !matches!((a - b).sign(), Sign::Negative | Sign::Zero)
}
