//! Shorter proofs: a step is multiplied into those that use it where that makes the text shorter.

use std::collections::BTreeMap;

use super::derivation::{DerivedStep, Source};
use crate::algebra::{FieldElement, Monomial, Polynomial};
use crate::control::{Control, Interrupted};

/// Products of terms beyond which multiplying a step into its users is not even tried.
const PRODUCTS: usize = 2_000;
/// Characters of a user beyond which little would be gained.
const LENGTH: usize = 10_000;
/// Characters of a step and of a premise besides their polynomials: `step 12`, `conclude`, `add c[1,1] times`.
const STEP: usize = 18;
const PREMISE: usize = 16;

/// Removes steps that are cheaper to multiply out; `None` stands where one was. The last step stays.
pub(super) fn compact(
    mut steps: Vec<Option<DerivedStep>>,
    control: &Control,
) -> Result<Vec<Option<DerivedStep>>, Interrupted> {
    let mut changed = true;
    while changed {
        changed = false;
        for k in 0..steps.len().saturating_sub(1) {
            let Some(step) = &steps[k] else { continue };
            let Some(replaced) = multiplied_out(step, Source::Derived(k), &steps, control)? else { continue };
            for (user, shorter) in replaced {
                steps[user] = Some(shorter);
            }
            steps[k] = None;
            changed = true;
        }
    }
    Ok(steps)
}

/// The users of a step with the step multiplied out, if they are shorter than they are together with it.
fn multiplied_out(
    step: &DerivedStep,
    source: Source,
    steps: &[Option<DerivedStep>],
    control: &Control,
) -> Result<Option<Vec<(usize, DerivedStep)>>, Interrupted> {
    let own: usize = step.combination.iter().map(|(_, by)| by.terms().len()).sum();
    let mut gain = length(step);
    let mut replaced = Vec::new();
    for (k, user) in steps.iter().enumerate() {
        let Some(user) = user else { continue };
        let Some((_, factor)) = user.combination.iter().find(|(premise, _)| *premise == source) else {
            continue;
        };
        let before = length_of_premises(user);
        if own * factor.terms().len() > PRODUCTS || before > LENGTH {
            return Ok(None);
        }
        let mut merged: BTreeMap<Source, Polynomial> =
            user.combination.iter().filter(|(premise, _)| *premise != source).cloned().collect();
        for (premise, by) in &step.combination {
            control.check()?;
            let product = by.multiply(factor);
            let sum = match merged.remove(premise) {
                Some(before) => before.add(&product),
                None => product,
            };
            if !sum.is_zero() {
                merged.insert(*premise, sum);
            }
        }
        let shorter =
            DerivedStep { combination: merged.into_iter().collect(), conclusion: user.conclusion.clone() };
        let Some(left) = (gain + before).checked_sub(length_of_premises(&shorter)) else { return Ok(None) };
        gain = left;
        replaced.push((k, shorter));
    }
    Ok((gain > 0).then_some(replaced))
}

pub(super) fn length(step: &DerivedStep) -> usize {
    STEP + length_of_polynomial(&step.conclusion) + length_of_premises(step)
}

fn length_of_premises(step: &DerivedStep) -> usize {
    step.combination.iter().map(|(_, by)| PREMISE + length_of_polynomial(by)).sum()
}

/// About as many characters as the certificate needs.
pub(super) fn length_of_polynomial(polynomial: &Polynomial) -> usize {
    polynomial.terms().iter().map(|(monomial, value)| length_of_term(monomial, value)).sum()
}

pub(super) fn length_of_term(monomial: &Monomial, value: &FieldElement) -> usize {
    let powers: usize = monomial.powers().iter().map(|&(_, e)| if e > 1 { 6 } else { 4 }).sum();
    length_of_element(value, powers)
}

fn length_of_element(value: &FieldElement, powers: usize) -> usize {
    let digits = |bits: u64| bits as usize * 3 / 10 + 1;
    let below = if value.denominator().is_one() { 0 } else { 1 + digits(value.denominator().bits()) };
    let coordinates = value.numerators().iter().enumerate().filter(|(_, numerator)| !numerator.is_zero());
    let root = |subset: usize| if subset == 0 { 0 } else { 8 };
    coordinates.map(|(subset, numerator)| digits(numerator.bits()) + below + root(subset) + powers + 3).sum()
}
