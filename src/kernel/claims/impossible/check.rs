//! Claim `impossible`: every step is multiplied out, and the last one must conclude 1.

use std::collections::HashMap;

use super::{Refuted, Rejection, Step};
use crate::equations::{Equations, Premise};
use crate::exact::{Arithmetic, Limit, Polynomial, Work};
use crate::failure::{At, Failure, Place};
use crate::statement::Statement;

/// Replays the steps.
pub(in crate::claims) fn verify(
    statement: &Statement,
    steps: &[Step],
    work: &mut Work,
) -> Result<Refuted, Failure<Rejection>> {
    let equations = Equations::of(statement, work).at(Place::Equations)?;
    let arithmetic = &mut Arithmetic::new(statement.field(), work);
    let mut replay =
        Replay { equations: &equations, steps, first: HashMap::new(), used: vec![false; steps.len()] };
    for (name, polynomial) in equations.iter() {
        replay.name(polynomial, name, arithmetic).at(Place::Equations)?;
    }
    let mut multiplier_terms = 0usize;
    let ring = statement.ring();

    for (number, step) in (1usize..).zip(steps) {
        let place = Place::Step(number);
        arithmetic.work.keep_each(step.combination.len(), 16).at(place)?;
        let mut pairs = Vec::with_capacity(step.combination.len());
        for (premise, multiplier) in &step.combination {
            pairs.push((multiplier, replay.find(*premise, number, arithmetic)?));
            multiplier_terms = multiplier_terms.saturating_add(multiplier.term_count());
        }
        let actual = arithmetic.dot(&pairs).at(place)?;
        if actual != step.conclusion {
            let (expected, actual) = (ring.excerpt(&step.conclusion), ring.excerpt(&actual));
            return Err(Rejection::WrongConclusion { step: number, expected, actual }.into());
        }
        if actual.is_zero() {
            return Err(Rejection::ZeroConclusion { step: number }.into());
        }
        // The last conclusion is to be 1, which may well be an equation already.
        let last = number == steps.len();
        let name = Premise::Step(u32::try_from(number).unwrap_or(u32::MAX));
        if let Some(earlier) = replay.name(&step.conclusion, name, arithmetic).at(place)?.filter(|_| !last) {
            return Err(Rejection::RepeatedConclusion { step: number, earlier }.into());
        }
    }

    let Some(last) = steps.last() else {
        return Err(Rejection::NoSteps.into());
    };
    if !last.conclusion.is_one() {
        let actual = ring.excerpt(&last.conclusion);
        return Err(Rejection::LastConclusion { step: steps.len(), actual }.into());
    }
    // The last step needs no user.
    let unused = replay.used.iter().rev().skip(1).rev().position(|used| !used);
    if let Some(position) = unused {
        return Err(Rejection::UnusedStep { step: position.saturating_add(1) }.into());
    }
    Ok(Refuted { steps: steps.len(), multiplier_terms })
}

/// What the steps may use.
struct Replay<'a> {
    equations: &'a Equations,
    steps: &'a [Step],
    /// Where each polynomial first occurs: a premise is used by that name, so that it has only one.
    first: HashMap<&'a Polynomial, Premise>,
    used: Vec<bool>,
}

impl<'a> Replay<'a> {
    /// Names a polynomial, unless it has a name already, which is returned.
    fn name(
        &mut self,
        polynomial: &'a Polynomial,
        name: Premise,
        arithmetic: &mut Arithmetic<'_>,
    ) -> Result<Option<Premise>, Limit> {
        arithmetic.charge_look(polynomial)?;
        arithmetic.work.keep(64)?;
        let known = *self.first.entry(polynomial).or_insert(name);
        Ok(Some(known).filter(|known| *known != name))
    }

    /// The polynomial that a premise of step `number` names.
    fn find(
        &mut self,
        premise: Premise,
        number: usize,
        arithmetic: &mut Arithmetic<'_>,
    ) -> Result<&'a Polynomial, Failure<Rejection>> {
        let missing = || Rejection::NoSuchPremise { step: number, premise };
        let polynomial = match premise {
            Premise::Step(step) => {
                // The reader has refused steps that are not earlier; a certificate built in memory has not
                // been read.
                let index =
                    usize::try_from(step).ok().and_then(|step| step.checked_sub(1)).ok_or_else(missing)?;
                let position = number.checked_sub(1).ok_or_else(missing)?;
                if index >= position {
                    return Err(missing().into());
                }
                *self.used.get_mut(index).ok_or_else(missing)? = true;
                &self.steps.get(index).ok_or_else(missing)?.conclusion
            }
            equation => self.equations.get(equation).ok_or_else(missing)?,
        };
        if polynomial.is_zero() {
            return Err(Rejection::ZeroPremise { step: number, premise }.into());
        }
        arithmetic.charge_look(polynomial).at(Place::Step(number))?;
        match self.first.get(polynomial) {
            Some(&earlier) if earlier != premise => {
                Err(Rejection::SamePremise { step: number, premise, earlier }.into())
            }
            _ => Ok(polynomial),
        }
    }
}
