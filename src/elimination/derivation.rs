//! The record of what was derived from what.

use std::collections::{BTreeMap, HashMap};

use super::compact::{compact, length};
use super::rescale::rescale;
use super::strategy::SHORT;
use super::system::System;
use crate::algebra::{FieldElement, Monomial, Polynomial};
use crate::certificate::Premise;
use crate::control::{Control, Interrupted};

/// A polynomial of the ideal: given, or derived earlier.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Source {
    /// An equation of the system, by its position.
    Generator(usize),
    /// A derived polynomial, by its position.
    Derived(usize),
}

/// Σ multiplier · source = conclusion.
#[derive(Debug, Clone)]
pub(super) struct DerivedStep {
    /// Sources with their multipliers.
    pub(super) combination: Vec<(Source, Polynomial)>,
    /// The sum.
    pub(super) conclusion: Polynomial,
}

/// A step whose premises are named as certificates name them.
#[derive(Debug, Clone)]
pub struct NamedStep {
    /// Premises in order, with their multipliers.
    pub combination: Vec<(Premise, Polynomial)>,
    /// The sum.
    pub conclusion: Polynomial,
}

/// A growing list of exact linear combinations over a system.
#[derive(Debug, Clone)]
pub struct Derivation<'a> {
    system: &'a System,
    steps: Vec<DerivedStep>,
    known: HashMap<Polynomial, Source>,
}

impl<'a> Derivation<'a> {
    /// Nothing derived yet.
    pub fn new(system: &'a System) -> Self {
        let generators = system.generators().iter().enumerate();
        let known =
            generators.map(|(k, (_, polynomial))| (polynomial.clone(), Source::Generator(k))).collect();
        Derivation { system, steps: Vec::new(), known }
    }

    /// The system.
    pub fn system(&self) -> &'a System {
        self.system
    }

    /// All equations of the system.
    pub fn generators(&self) -> Vec<Source> {
        (0..self.system.generators().len()).map(Source::Generator).collect()
    }

    /// The polynomial.
    pub fn polynomial(&self, source: Source) -> &Polynomial {
        match source {
            Source::Generator(k) => &self.system.generators()[k].1,
            Source::Derived(k) => &self.steps[k].conclusion,
        }
    }

    /// Records a combination and returns what it comes to; `None` where that is zero.
    /// A polynomial that is known already is not recorded again.
    ///
    /// # Errors
    /// [`Control::check`]
    pub fn derive(
        &mut self,
        combination: Vec<(Source, Polynomial)>,
        control: &Control,
    ) -> Result<Option<Source>, Interrupted> {
        let mut merged: BTreeMap<Source, Polynomial> = BTreeMap::new();
        for (source, multiplier) in combination {
            let sum = merged.entry(source).or_insert_with(|| Polynomial::zero(self.system.field()));
            *sum = sum.add(&multiplier);
        }
        merged.retain(|_, multiplier| !multiplier.is_zero());
        let products = merged.iter().map(|(&source, multiplier)| (multiplier, self.polynomial(source)));
        let conclusion = Polynomial::sum_of_products(self.system.field(), products, control)?;
        if conclusion.is_zero() {
            return Ok(None);
        }
        Ok(Some(self.record(merged.into_iter().collect(), conclusion)))
    }

    /// Records a combination, without repetitions, that is known to come to `conclusion`, which is not zero.
    pub(super) fn record(
        &mut self,
        combination: Vec<(Source, Polynomial)>,
        conclusion: Polynomial,
    ) -> Source {
        if let Some(&source) = self.known.get(&conclusion) {
            return source;
        }
        let source = Source::Derived(self.steps.len());
        self.known.insert(conclusion.clone(), source);
        self.steps.push(DerivedStep { combination, conclusion });
        source
    }

    /// Records factor · source.
    ///
    /// # Errors
    /// [`Control::check`]
    pub fn derive_scaled(
        &mut self,
        source: Source,
        factor: FieldElement,
        control: &Control,
    ) -> Result<Option<Source>, Interrupted> {
        self.derive(vec![(source, Polynomial::term(factor, Monomial::one()))], control)
    }

    /// About how many characters the steps take that `target` depends on.
    pub(super) fn length_of_proof(&self, target: Source) -> usize {
        let Source::Derived(last) = target else { return 0 };
        needed(self.steps[..=last].iter().cloned().map(Some).collect()).iter().flatten().map(length).sum()
    }

    /// The steps that `target` depends on, in order, each given by named premises, `target`'s own last.
    /// `None` if the target is an equation of the system itself.
    ///
    /// # Errors
    /// [`Control::check`]
    pub fn proof_of(&self, target: Source, control: &Control) -> Result<Option<Vec<NamedStep>>, Interrupted> {
        let Source::Derived(last) = target else {
            return Ok(None);
        };
        let steps: Vec<Option<DerivedStep>> = self.steps[..=last].iter().cloned().map(Some).collect();
        let mut steps = needed(steps);
        // A short proof is left as it was found: it tells how to get there.
        if steps.iter().flatten().map(length).sum::<usize>() > SHORT {
            steps = needed(compact(steps, control)?);
            rescale(&mut steps, control)?;
        }
        let mut numbers = HashMap::new();
        let mut proof = Vec::new();
        for (k, step) in steps.into_iter().enumerate().filter_map(|(k, step)| Some((k, step?))) {
            let named = |(source, multiplier): &(Source, Polynomial)| {
                let premise = match source {
                    Source::Generator(g) => self.system.generators()[*g].0,
                    Source::Derived(d) => Premise::Step(numbers[d]),
                };
                (premise, multiplier.clone())
            };
            let mut combination: Vec<_> = step.combination.iter().map(named).collect();
            combination.sort_by_key(|(premise, _)| *premise);
            proof.push(NamedStep { combination, conclusion: step.conclusion });
            numbers.insert(k, u32::try_from(proof.len()).expect("fewer than 2³² steps"));
        }
        Ok(Some(proof))
    }
}

/// The steps that the last one depends on; `None` in place of the others.
fn needed(mut steps: Vec<Option<DerivedStep>>) -> Vec<Option<DerivedStep>> {
    let mut needed = vec![false; steps.len()];
    if let Some(last) = needed.last_mut() {
        *last = true;
    }
    for k in (0..steps.len()).rev() {
        if !needed[k] {
            steps[k] = None;
        }
        for (source, _) in steps[k].iter().flat_map(|step| &step.combination) {
            if let Source::Derived(earlier) = source {
                needed[*earlier] = true;
            }
        }
    }
    steps
}
