//! Claim `exact`: the stated values make every equation vanish.

use std::cmp::Ordering;

use super::equations::Equations;
use super::error::Rejection;
use super::replay::shown;
use super::theorem::{Claim, Theorem};
use crate::certificate::Premise;
use crate::exact::{Limit, Polynomial, Work, sign};
use crate::statement::{HomogeneousPoint, Patch, Statement, Subject};

/// Why the values were not accepted.
pub(super) enum Failure {
    Rejected(Rejection),
    Limit(Limit),
}

impl From<Limit> for Failure {
    fn from(limit: Limit) -> Self {
        Failure::Limit(limit)
    }
}

impl From<Rejection> for Failure {
    fn from(rejection: Rejection) -> Self {
        Failure::Rejected(rejection)
    }
}

pub(super) fn verify(
    statement: &Statement,
    equations: &Equations,
    values: &[Polynomial],
    work: &mut Work,
) -> Result<Theorem, Failure> {
    for (number, assumed) in (1u32..).zip(statement.nonzero()) {
        if assumed.substitute(values, statement.field(), work)?.is_zero() {
            return Err(Rejection::AssumptionVanishes { assumption: Premise::Nonzero(number) }.into());
        }
    }
    let equalities = equations.iter().filter(|(name, _)| !matches!(name, Premise::Nonzero(_)));
    for (name, equation) in equalities {
        let value = equation.substitute(values, statement.field(), work)?;
        if !value.is_zero() {
            let actual = shown(&statement.ring(), &value);
            return Err(Rejection::NotAZero { equation: name, actual }.into());
        }
    }
    let values = values.to_vec();
    let claim = match statement.subject() {
        Subject::System(_) => Claim::Solution { values },
        Subject::Patch(patch) => {
            let net = evaluated(patch, &values, statement, work)?;
            let weights: Vec<&Polynomial> = net.iter().flatten().map(|[.., weight]| weight).collect();
            if weights.iter().all(|weight| weight.is_zero()) {
                return Err(Rejection::NoDenominator.into());
            }
            let mut weights_positive = true;
            for weight in weights {
                weights_positive &= sign(weight, statement.field(), work)? == Some(Ordering::Greater);
            }
            Claim::Exact { values, net, weights_positive }
        }
    };
    Ok(Theorem::established(statement, claim))
}

/// The net at the values of the unknowns.
pub(super) fn evaluated(
    patch: &Patch,
    values: &[Polynomial],
    statement: &Statement,
    work: &mut Work,
) -> Result<Vec<Vec<HomogeneousPoint>>, Limit> {
    let mut net = Vec::with_capacity(patch.net.len());
    for row in &patch.net {
        let mut points = Vec::with_capacity(row.len());
        for [x, y, z, w] in row {
            let mut at = |entry: &Polynomial| entry.substitute(values, statement.field(), work);
            points.push([at(x)?, at(y)?, at(z)?, at(w)?]);
        }
        net.push(points);
    }
    Ok(net)
}
