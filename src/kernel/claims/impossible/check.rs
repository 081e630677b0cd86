//! Claim `impossible`: every step is multiplied out, and the last one must conclude 1.

use std::collections::HashMap;

use super::{Refuted, Rejection, Step};
use crate::equations::{Equations, Premise};
use crate::exact::{Polynomial, Work, combination};
use crate::failure::{At, Failure, Place};
use crate::statement::Statement;

/// Replays the steps.
pub(in crate::claims) fn verify(
    statement: &Statement,
    steps: &[Step],
    work: &mut Work,
) -> Result<Refuted, Failure<Rejection>> {
    let equations = Equations::of(statement, work).at(Place::Equations)?;
    // Where each polynomial first occurs: a premise is used by that name, so that it has only one.
    let mut first: HashMap<&Polynomial, Premise> = HashMap::new();
    for (name, polynomial) in equations.iter() {
        first.entry(polynomial).or_insert(name);
    }
    let mut used = vec![false; steps.len()];
    let mut multiplier_terms = 0usize;
    let ring = statement.ring();

    for (number, step) in (1usize..).zip(steps) {
        let mut pairs = Vec::with_capacity(step.combination.len());
        for (premise, multiplier) in &step.combination {
            pairs.push((multiplier, find(*premise, number, &equations, steps, &first, &mut used)?));
            multiplier_terms = multiplier_terms.saturating_add(multiplier.term_count());
        }
        let actual = combination(&pairs, statement.field(), work).at(Place::Step(number))?;
        if actual != step.conclusion {
            let (expected, actual) = (ring.excerpt(&step.conclusion), ring.excerpt(&actual));
            return Err(Rejection::WrongConclusion { step: number, expected, actual }.into());
        }
        if actual.is_zero() {
            return Err(Rejection::ZeroConclusion { step: number }.into());
        }
        // The last conclusion is to be 1, which may well be an equation already.
        let last = number == steps.len();
        if let Some(&earlier) = first.get(&step.conclusion).filter(|_| !last) {
            return Err(Rejection::RepeatedConclusion { step: number, earlier }.into());
        }
        first.insert(&step.conclusion, Premise::Step(u32::try_from(number).unwrap_or(u32::MAX)));
    }

    let Some(last) = steps.last() else {
        return Err(Rejection::NoSteps.into());
    };
    if !last.conclusion.is_one() {
        let actual = ring.excerpt(&last.conclusion);
        return Err(Rejection::LastConclusion { step: steps.len(), actual }.into());
    }
    // The last step needs no user.
    let unused = used.iter().rev().skip(1).rev().position(|used| !used);
    if let Some(position) = unused {
        return Err(Rejection::UnusedStep { step: position.saturating_add(1) }.into());
    }
    Ok(Refuted { steps: steps.len(), multiplier_terms })
}

/// The polynomial that a premise of step `number` names.
fn find<'a>(
    premise: Premise,
    number: usize,
    equations: &'a Equations,
    steps: &'a [Step],
    first: &HashMap<&Polynomial, Premise>,
    used: &mut [bool],
) -> Result<&'a Polynomial, Rejection> {
    let missing = || Rejection::NoSuchPremise { step: number, premise };
    let polynomial = match premise {
        Premise::Step(step) => {
            // The reader has refused steps that are not earlier; a certificate built in memory has not been read.
            let index =
                usize::try_from(step).ok().and_then(|step| step.checked_sub(1)).ok_or_else(missing)?;
            let position = number.checked_sub(1).ok_or_else(missing)?;
            if index >= position {
                return Err(missing());
            }
            *used.get_mut(index).ok_or_else(missing)? = true;
            &steps.get(index).ok_or_else(missing)?.conclusion
        }
        equation => equations.get(equation).ok_or_else(missing)?,
    };
    if polynomial.is_zero() {
        return Err(Rejection::ZeroPremise { step: number, premise });
    }
    match first.get(polynomial) {
        Some(&earlier) if earlier != premise => {
            Err(Rejection::SamePremise { step: number, premise, earlier })
        }
        _ => Ok(polynomial),
    }
}
