//! How far the points of a patch are from the origin.

use num_bigint::BigInt;

use super::{Claimed, Judged, Judgement};
use crate::approximation::{Enclosure, EnclosureError, Finding, enclose, judge};
use crate::audit::AuditError;
use crate::certificate::{Quantity, spell_decimal};
use crate::control::Control;
use crate::document::Phrase;
use crate::exact::Polynomial;
use crate::formats::listing::{Expression, Symbol};

/// Decimals of the bounds.
const PLACES: u32 = 12;

/// Values of the unknowns in the listing's names.
type Values = [(Symbol, Expression)];

/// At the given values the radius √(x² + y² + z²) stays in the printed interval, to the digits printed.
pub(super) fn radius(
    at: &Claimed<'_>,
    values: &Values,
    interval: &(String, String),
    control: &Control,
) -> Result<Judged, AuditError> {
    let enclosure = match enclosed(at, values, control)? {
        Ok(enclosure) => enclosure,
        Err(why) => return Ok((Judgement::NotChecked, vec![Phrase::words(format!("not bounded: {why}"))])),
    };
    let claim = [interval.0.clone(), interval.1.clone()];
    let verdicts =
        judge(at.case.statement, &enclosure, &claim).map_err(|error| at.wrong(error.to_string()))?;
    let (mut judgement, mut evidence) = (Judgement::Holds, vec![proved(&enclosure)]);
    for verdict in verdicts {
        match verdict.finding {
            Finding::Bound | Finding::Rounded => {}
            Finding::Fails { at: [u, v], value } => {
                judgement = Judgement::Fails;
                let [u, v] = [u, v].map(Polynomial::rational);
                evidence.push(
                    Phrase::words("at u = ").formula(&u).and(", v = ").formula(&v).and(format!(
                        " the radius is {value}…, not {} {}",
                        verdict.relation, verdict.printed
                    )),
                );
            }
            Finding::Open if judgement == Judgement::Holds => {
                judgement = Judgement::NotChecked;
                evidence.push(Phrase::words(format!("not told apart from {}", verdict.printed)));
            }
            Finding::Open => {}
        }
    }
    Ok((judgement, evidence))
}

/// The rival does not keep the radius in a smaller interval than the given values do.
pub(super) fn unrivalled(
    at: &Claimed<'_>,
    values: &Values,
    rival: &Values,
    control: &Control,
) -> Result<Judged, AuditError> {
    let (Ok(own), Ok(other)) = (enclosed(at, values, control)?, enclosed(at, rival, control)?) else {
        return Ok((Judgement::NotChecked, vec![Phrase::words("not bounded".to_owned())]));
    };
    // All bounds are within a unit of what they bound, or at it.
    let no_farther = |own: &BigInt, other: &BigInt, attained: bool| other < own || other == own && attained;
    let [own_ends, other_ends] =
        [&own, &other].map(|one| [-&one.bounds.lower.bound, one.bounds.upper.bound.clone()]);
    let ends = own_ends.iter().zip(&other_ends);
    let inside = ends.clone().zip(own.attained).all(|((own, other), at)| no_farther(own, other, at))
        && ends.clone().any(|(own, other)| other + 1 < *own);
    let mut at_rival = Phrase::words("the radius stays in a smaller interval at ");
    let unknowns = at.case.statement.unknowns();
    for (position, (name, value)) in unknowns.iter().zip(&other.bounds.values).enumerate() {
        let comma = if position > 0 { ", " } else { "" };
        at_rival = at_rival.and(format!("{comma}{name} = ")).formula(value);
    }
    Ok(match inside {
        true => (Judgement::Fails, vec![proved(&own), at_rival, proved(&other)]),
        false => (Judgement::NotChecked, vec![proved(&own), proved(&other)]),
    })
}

/// The bounds, as they are proved.
fn proved(enclosure: &Enclosure) -> Phrase {
    let bounds = &enclosure.bounds;
    let decimal = |units| spell_decimal(units, bounds.places);
    let trees = [&bounds.denominator, &bounds.lower.tree, &bounds.upper.tree];
    let boxes = trees.into_iter().flatten().filter(|halved| !**halved).count();
    Phrase::words(format!(
        "proved on {boxes} boxes, checked: {} ≤ r ≤ {}",
        decimal(&bounds.lower.bound),
        decimal(&bounds.upper.bound)
    ))
}

/// The enclosure at these values, or why there is none.
fn enclosed(
    at: &Claimed<'_>,
    values: &Values,
    control: &Control,
) -> Result<Result<Enclosure, String>, AuditError> {
    let point = at.point(values)?;
    match enclose(at.case.statement, &point, PLACES, control) {
        Ok(enclosure) if enclosure.bounds.quantity == Quantity::Radius => Ok(Ok(enclosure)),
        Ok(_) => Err(at.wrong("the surface is not the unit sphere X² + Y² + Z² = W²".to_owned())),
        Err(EnclosureError::Interrupted(why)) => Err(why.into()),
        Err(error @ EnclosureError::NotAPatch) => Err(at.wrong(error.to_string())),
        Err(error) => Ok(Err(error.to_string())),
    }
}
