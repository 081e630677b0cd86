//! How far the points of a patch are from the origin.

use std::cmp::Ordering;

use num_rational::BigRational;
use num_traits::Zero;

use super::{Claimed, Judged, Judgement};
use crate::algebra::{FieldElement, Integer, Polynomial, polynomial_from_exact, polynomial_to_exact};
use crate::audit::AuditError;
use crate::audit::decimal::{Decimal, decimal_of_root};
use crate::audit::phrase::Phrase;
use crate::bezier::{BernsteinForm, SignOnSquare, sign_on_square, surface_condition, value_at};
use crate::exact::{self, Work};
use crate::listing::{Expression, Symbol};
use crate::prove::field_of;
use crate::statement::{Patch, Subject};

/// Boxes of a subdivision before it is given up.
const BOXES: usize = 20_000;
/// Decimals that are shown of a radius.
const PLACES: u32 = 12;

/// Σ coefficients of X², Y², Z², W².
type Quadric = [BigRational; 4];

/// At the given values the radius √(x² + y² + z²) stays in the printed interval, to the digits printed.
pub(super) fn radius(
    at: &Claimed<'_>,
    values: &[(Symbol, Expression)],
    interval: &(String, String),
) -> Result<Judged, AuditError> {
    let Subject::Patch(patch) = at.case.statement.subject() else {
        return Err(at.wrong("a system of equations has no radius".to_owned()));
    };
    let patch = at.patch_at(patch, values)?;
    let not_decided =
        |what: &str| Ok((Judgement::NotChecked, vec![Phrase::words(format!("not yet bounded: {what}"))]));
    // The denominator must keep its sign, or else the radius is not bounded at all.
    let weights = patch.net.iter().flatten().map(|point| &point[3]);
    for weight in weights {
        if exact::sign(weight, at.case.statement.field(), &mut Work::full())? != Some(Ordering::Greater) {
            return not_decided("not all weights are positive");
        }
    }
    let (low, high) = (Decimal::read(&interval.0), Decimal::read(&interval.1));
    let one = || BigRational::from_integer(1.into());
    let mut evidence = Vec::new();
    let mut judgement = Judgement::Holds;
    // r ≤ h iff x² + y² + z² − h²w² ≤ 0, and r ≥ l iff its opposite with l.
    let above = &high.value + &high.tolerance;
    let below = &low.value - &low.tolerance;
    let sides: [(&str, &str, Quadric); 2] = [
        ("≤", &interval.1, [one(), one(), one(), -(&above * &above)]),
        ("≥", &interval.0, [-one(), -one(), -one(), &below * &below]),
    ];
    for (relation, printed, quadric) in sides {
        let form = at.condition(&patch, &quadric);
        match sign_on_square(&form, BOXES) {
            Some(SignOnSquare::NowherePositive { boxes }) => {
                let counted = if boxes == 1 { "one box".to_owned() } else { format!("{boxes} boxes") };
                evidence.push(Phrase::words(format!(
                    "r {relation} {printed}, to the digits printed, on the whole patch: proved on {counted}"
                )));
            }
            Some(SignOnSquare::PositiveAt(u, v)) => {
                judgement = Judgement::Fails;
                let radius = at.radius_at(&patch, &u, &v)?;
                let constant = |value| polynomial_to_exact(&Polynomial::constant(value));
                evidence.push(
                    Phrase::words("at u = ")
                        .formula(&constant(u)?)
                        .and(", v = ")
                        .formula(&constant(v)?)
                        .and(format!(" the radius is {radius}…, not {relation} {printed}")),
                );
            }
            Some(SignOnSquare::Undecided) | None => return not_decided("the subdivision became too fine"),
        }
    }
    let half = field_of(at.case.statement).rational(Integer::one(), Integer::from(2i64));
    evidence.push(Phrase::words(format!("in the middle r = {}…", at.radius_at(&patch, &half, &half)?)));
    Ok((judgement, evidence))
}

impl Claimed<'_> {
    /// The patch with values for its unknowns.
    fn patch_at(&self, patch: &Patch, values: &[(Symbol, Expression)]) -> Result<Patch, AuditError> {
        let point = self.point(values)?;
        let mut work = Work::full();
        let mut patch = patch.clone();
        for coordinate in patch.net.iter_mut().flatten().flatten() {
            *coordinate = coordinate.substitute(&point, self.case.statement.field(), &mut work)?;
        }
        Ok(patch)
    }

    /// The quadric along the patch.
    fn condition(&self, patch: &Patch, quadric: &Quadric) -> BernsteinForm {
        let square = |(k, value): (u16, &BigRational)| {
            let monomial = exact::Monomial::new(0, vec![(k, 2)]).and_then(Result::ok);
            (monomial.unwrap_or_else(exact::Monomial::one), value.clone())
        };
        let terms = (0u16..).zip(quadric).filter(|(_, value)| !value.is_zero()).map(square);
        let surface = exact::Polynomial::from_terms(terms);
        surface_condition(field_of(self.case.statement), &Patch { surface, ..patch.clone() })
    }

    /// The radius at a point, in decimals.
    fn radius_at(&self, patch: &Patch, u: &FieldElement, v: &FieldElement) -> Result<String, AuditError> {
        let one = || BigRational::from_integer(1.into());
        let zero = BigRational::zero;
        let at = |quadric: Quadric| value_at(&self.condition(patch, &quadric), u, v);
        let squares = at([one(), one(), one(), zero()]);
        let denominator = at([zero(), zero(), zero(), one()]).and_then(|value| value.inverse());
        let (Some(squares), Some(inverse)) = (squares, denominator) else {
            return Err(self.wrong("the patch has no point there".to_owned()));
        };
        let square = polynomial_to_exact(&Polynomial::constant(&squares * &inverse))?;
        debug_assert!(polynomial_from_exact(squares.field(), &square).as_constant().is_some());
        Ok(decimal_of_root(&square, PLACES, self.case.statement.field())?)
    }
}
