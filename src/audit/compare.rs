//! A printed coefficient beside the true one.

use std::collections::BTreeMap;

use super::correction::{Correction, corrections};
use super::targets::{Target, Targets};
use crate::exact::{Limit, Monomial, Polynomial, Radicands, Work};
use crate::formats::listing::{Expression, Scope, Symbol};
use crate::statement::Place;

/// What became of one printed coefficient.
#[derive(Debug, Clone)]
pub struct Finding {
    /// The label as it is compared: `a14`.
    pub label: Symbol,
    /// Where it is printed.
    pub place: Place,
    /// What it names.
    pub target: Target,
    /// As printed.
    pub printed: Polynomial,
    /// As it is.
    pub truth: Polynomial,
    /// Where the two differ, by power product; empty where they agree.
    pub differences: Vec<Difference>,
    /// What the printed one is instead.
    pub relations: Vec<Relation>,
    /// The fewest changes of single signs, numbers, roots, exponents or names that make it right.
    pub corrections: Vec<Correction>,
    /// Whether the search for these came to its end: if not, there may be some, or fewer.
    pub searched: bool,
}

/// One power product with different coefficients, all constants of K.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// The power product.
    pub powers: Polynomial,
    /// Its coefficient as printed.
    pub printed: Polynomial,
    /// Its true coefficient.
    pub truth: Polynomial,
    /// True − printed.
    pub difference: Polynomial,
}

/// What a wrong coefficient is instead.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Relation {
    /// The true one times this constant.
    Factor(Polynomial),
    /// That of the exchanged parameters.
    Exchanged,
    /// That which another label of the listing names.
    Other(Symbol),
}

impl Finding {
    /// Whether printed and true are equal.
    pub fn agrees(&self) -> bool {
        self.differences.is_empty()
    }
}

/// A printed formula with what it is about.
pub(super) struct Printed<'a> {
    pub label: &'a Symbol,
    pub place: Place,
    pub target: Target,
    pub expression: &'a Expression,
    pub value: Polynomial,
    /// The text it was read from.
    pub text: &'a str,
}

/// Compares a printed formula with the true coefficient; nothing is explained yet.
pub(super) fn compare(
    printed: &Printed<'_>,
    targets: &Targets,
    field: &Radicands,
    work: &mut Work,
) -> Result<Finding, Limit> {
    let truth = targets.value(printed.target).cloned().unwrap_or_default();
    let differences = differences(&printed.value, &truth, field, work)?;
    Ok(Finding {
        label: printed.label.clone(),
        place: printed.place.clone(),
        target: printed.target,
        printed: printed.value.clone(),
        truth,
        searched: differences.is_empty(),
        differences,
        relations: Vec::new(),
        corrections: Vec::new(),
    })
}

/// Looks for what explains a difference, as long as the work allowed for it lasts. `others` are the labels of the listing.
pub(super) fn explain(
    finding: &mut Finding,
    printed: &Printed<'_>,
    targets: &Targets,
    others: &[(Symbol, Target)],
    scope: &Scope,
    explaining: &mut Work,
) {
    if finding.agrees() {
        return;
    }
    let Ok(relations) = relations(printed, &finding.truth, targets, others, &scope.field, explaining) else {
        return;
    };
    finding.relations = relations;
    let found = corrections(printed.expression, printed.text, &finding.truth, scope, explaining);
    (finding.corrections, finding.searched) = found;
}

/// The constants in front of each power product.
pub(super) fn by_powers(polynomial: &Polynomial) -> BTreeMap<Monomial, Polynomial> {
    let mut collected: BTreeMap<Monomial, Vec<_>> = BTreeMap::new();
    for (monomial, value) in polynomial.terms() {
        let powers = Monomial::new(0, monomial.powers().to_vec()).and_then(Result::ok);
        let constant = (Monomial::radical(monomial.mask()), value.clone());
        collected.entry(powers.unwrap_or_else(Monomial::one)).or_default().push(constant);
    }
    collected.into_iter().map(|(powers, terms)| (powers, Polynomial::from_terms(terms))).collect()
}

fn differences(
    printed: &Polynomial,
    truth: &Polynomial,
    field: &Radicands,
    work: &mut Work,
) -> Result<Vec<Difference>, Limit> {
    let (of_printed, of_truth) = (by_powers(printed), by_powers(truth));
    let difference = Polynomial::sum(&[truth.clone(), printed.negate()], field, work)?;
    let entry = |(powers, difference): (Monomial, Polynomial)| Difference {
        printed: of_printed.get(&powers).cloned().unwrap_or_default(),
        truth: of_truth.get(&powers).cloned().unwrap_or_default(),
        powers: Polynomial::term(num_traits::One::one(), powers),
        difference,
    };
    Ok(by_powers(&difference).into_iter().map(entry).collect())
}

fn relations(
    printed: &Printed<'_>,
    truth: &Polynomial,
    targets: &Targets,
    others: &[(Symbol, Target)],
    field: &Radicands,
    work: &mut Work,
) -> Result<Vec<Relation>, Limit> {
    let mut relations = Vec::new();
    let exchanged = Targets::transposed(printed.target).and_then(|target| targets.value(target));
    if exchanged == Some(&printed.value) {
        relations.push(Relation::Exchanged);
    }
    let other = others.iter().find(|(_, target)| targets.value(*target) == Some(&printed.value));
    if let Some((label, _)) = other
        && !printed.value.is_zero()
        && relations.is_empty()
    {
        relations.push(Relation::Other(label.clone()));
    }
    if let Some(factor) = factor(&printed.value, truth, field, work)? {
        relations.push(Relation::Factor(factor));
    }
    Ok(relations)
}

/// λ with printed = λ·truth, a non-zero constant.
fn factor(
    printed: &Polynomial,
    truth: &Polynomial,
    field: &Radicands,
    work: &mut Work,
) -> Result<Option<Polynomial>, Limit> {
    let (of_printed, of_truth) = (by_powers(printed), by_powers(truth));
    let (Some((powers, p)), Some((same, t))) = (of_printed.first_key_value(), of_truth.first_key_value())
    else {
        return Ok(None);
    };
    if powers != same {
        return Ok(None);
    }
    let Some(inverse) = t.inverse(field, work)? else { return Ok(None) };
    let factor = p.multiply(&inverse, field, work)?;
    let multiple = truth.multiply(&factor, field, work)?;
    Ok((multiple == *printed).then_some(factor))
}
