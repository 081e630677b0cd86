//! Shorter proofs: conclusions are multiplied by elements of K where that makes the text shorter.
//!
//! Associated numbers have very different lengths: 54√2 − 36√3 and 1, say, where only a unit and √6 are between them.

use super::compact::{length_of_polynomial, length_of_term};
use super::derivation::{DerivedStep, Source};
use crate::algebra::{FieldElement, Integer, MultiquadraticField, Polynomial};
use crate::control::{Control, Interrupted};

/// Characters beyond which a step and its users are not looked at.
const LENGTH: usize = 3_000;

/// A factor and its inverse.
type Unit = (FieldElement, FieldElement);

/// Rescales all conclusions but the last, which is 1.
pub(super) fn rescale(steps: &mut [Option<DerivedStep>], control: &Control) -> Result<(), Interrupted> {
    let Some(field) = steps.iter().flatten().map(|step| step.conclusion.field()).next() else {
        return Ok(());
    };
    let factors = small_elements(field);
    for k in (0..steps.len().saturating_sub(1)).rev() {
        while let Some((factor, inverse)) = better(k, steps, &factors, control)? {
            for (_, multiplier) in steps
                .iter_mut()
                .flatten()
                .flat_map(|step| &mut step.combination)
                .filter(|(premise, _)| *premise == Source::Derived(k))
            {
                *multiplier = multiplier.scaled(&inverse);
            }
            if let Some(step) = &mut steps[k] {
                step.conclusion = step.conclusion.scaled(&factor);
                for (_, multiplier) in &mut step.combination {
                    *multiplier = multiplier.scaled(&factor);
                }
            }
        }
    }
    Ok(())
}

/// The factor that shortens step `k` and its users most, if any does.
fn better(
    k: usize,
    steps: &[Option<DerivedStep>],
    factors: &[Unit],
    control: &Control,
) -> Result<Option<Unit>, Interrupted> {
    let Some(step) = &steps[k] else { return Ok(None) };
    let own: Vec<&Polynomial> =
        std::iter::once(&step.conclusion).chain(step.combination.iter().map(|(_, by)| by)).collect();
    let premises = steps.iter().flatten().flat_map(|user| &user.combination);
    let used: Vec<&Polynomial> =
        premises.filter(|(premise, _)| *premise == Source::Derived(k)).map(|(_, by)| by).collect();
    let now: usize = own.iter().chain(&used).map(|by| length_of_polynomial(by)).sum();
    if now > LENGTH {
        return Ok(None);
    }
    let (mut best, mut shortest) = (None, now);
    for unit in factors {
        control.check()?;
        let (factor, inverse) = unit;
        let scaled = own.iter().map(|by| (by, factor)).chain(used.iter().map(|by| (by, inverse)));
        // Most factors are found to be worse after a few terms.
        let terms = scaled.flat_map(|(by, factor)| by.terms().iter().map(move |term| (term, factor)));
        let mut length = 0;
        for ((monomial, value), factor) in terms {
            length += length_of_term(monomial, &(value * factor));
            if length >= shortest {
                break;
            }
        }
        if length < shortest {
            (best, shortest) = (Some(unit), length);
        }
    }
    Ok(best.cloned())
}

/// Small elements of K and their inverses.
fn small_elements(field: MultiquadraticField) -> Vec<Unit> {
    let root = |subset: usize| {
        let mut coordinates = vec![Integer::zero(); field.degree()];
        coordinates[subset] = Integer::one();
        field.element(coordinates, Integer::one())
    };
    let roots: Vec<FieldElement> = (0..field.degree()).map(root).collect();
    let mut found: Vec<FieldElement> = [-1, 2, 3].map(|value| field.integer(value)).to_vec();
    found.extend(roots[1..].iter().cloned());
    for (k, a) in roots.iter().enumerate() {
        for b in &roots[k + 1..] {
            for (m, n) in [(1, 1), (1, -1), (2, 1), (2, -1)] {
                found.push(&(a * &field.integer(m)) + &(b * &field.integer(n)));
            }
        }
    }
    let pairs = found.into_iter().filter_map(|value| Some((value.inverse()?, value)));
    pairs.flat_map(|(inverse, value)| [(value.clone(), inverse.clone()), (inverse, value)]).collect()
}
