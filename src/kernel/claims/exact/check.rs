//! Claim `exact`: the stated values make every equation vanish.

use std::cmp::Ordering;

use super::{ExactNet, Rejection, Solution};
use crate::equations::{Equations, Premise};
use crate::exact::{Arithmetic, Limit, Polynomial, Work};
use crate::failure::{At, Failure, Place};
use crate::statement::{HomogeneousPoint, Patch, Statement, Subject};

/// What values establish.
pub(in crate::claims) enum Zero {
    OfPatch(ExactNet),
    OfSystem(Solution),
}

/// Tries the values.
pub(in crate::claims) fn verify(
    statement: &Statement,
    values: &[Polynomial],
    work: &mut Work,
) -> Result<Zero, Failure<Rejection>> {
    let equations = Equations::of(statement, work).at(Place::Equations)?;
    let at = Place::Values;
    let arithmetic = &mut Arithmetic::new(statement.field(), work);
    for (number, assumed) in (1u32..).zip(statement.nonzero()) {
        if arithmetic.substitute(assumed, values).at(at)?.is_zero() {
            return Err(Rejection::AssumptionVanishes { assumption: Premise::Nonzero(number) }.into());
        }
    }
    let equalities = equations.iter().filter(|(name, _)| !matches!(name, Premise::Nonzero(_)));
    for (name, equation) in equalities {
        let value = arithmetic.substitute(equation, values).at(at)?;
        if !value.is_zero() {
            let actual = statement.ring().excerpt(&value);
            return Err(Rejection::NotAZero { equation: name, actual }.into());
        }
    }
    let values = copies(values, arithmetic).at(at)?;
    match statement.subject() {
        Subject::System(_) => Ok(Zero::OfSystem(Solution { values })),
        Subject::Patch(patch) => {
            let net = evaluated(patch, &values, arithmetic).at(at)?;
            let weights: Vec<&Polynomial> = net.iter().flatten().map(|[.., weight]| weight).collect();
            if weights.iter().all(|weight| weight.is_zero()) {
                return Err(Rejection::NoDenominator.into());
            }
            let mut weights_positive = true;
            for weight in weights {
                weights_positive &= arithmetic.sign(weight).at(at)? == Some(Ordering::Greater);
            }
            Ok(Zero::OfPatch(ExactNet { values, net, weights_positive }))
        }
    }
}

/// The net at the values of the unknowns.
pub(in crate::claims) fn evaluated(
    patch: &Patch,
    values: &[Polynomial],
    arithmetic: &mut Arithmetic<'_>,
) -> Result<Vec<Vec<HomogeneousPoint>>, Limit> {
    let mut net = Vec::with_capacity(patch.net.len());
    for row in &patch.net {
        let mut points = Vec::with_capacity(row.len());
        for [x, y, z, w] in row {
            arithmetic.work.keep(256)?;
            let mut at = |entry: &Polynomial| arithmetic.substitute(entry, values);
            points.push([at(x)?, at(y)?, at(z)?, at(w)?]);
        }
        net.push(points);
    }
    Ok(net)
}

/// The values once more.
pub(in crate::claims) fn copies(
    values: &[Polynomial],
    arithmetic: &mut Arithmetic<'_>,
) -> Result<Vec<Polynomial>, Limit> {
    values.iter().map(|value| arithmetic.copied(value)).collect()
}
