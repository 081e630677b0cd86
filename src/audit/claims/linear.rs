//! Which coefficients are linear, and what space they span.

use num_traits::Signed;

use super::{Claimed, Judged, Judgement};
use crate::algebra::{FieldElement, Polynomial, polynomial_from_exact, polynomial_to_exact};
use crate::audit::AuditError;
use crate::audit::span::Span;
use crate::document::Phrase;
use crate::exact;
use crate::formats::listing::{Expression, Symbol};
use crate::problem::field_of;

impl Claimed<'_> {
    /// A true coefficient, to compute with.
    pub(super) fn coefficient(&self, label: &Symbol) -> Result<Polynomial, AuditError> {
        Ok(polynomial_from_exact(field_of(self.case.statement), self.truth(label)?))
    }

    /// 1 and the variables that something is linear in.
    pub(super) fn affine(&self, variables: &[Expression]) -> Result<Span, AuditError> {
        let field = field_of(self.case.statement);
        let mut span = Span::new(field);
        span.add(&Polynomial::constant(field.one()));
        for variable in variables {
            let value = self.value(variable, self.case.scope)?;
            if span.add(&polynomial_from_exact(field, &value)).is_some() {
                return Err(self.wrong("the variables of this claim are not independent".to_owned()));
            }
        }
        Ok(span)
    }
}

/// These coefficients, and no others of the listing, are linear in the variables.
pub(super) fn linear(
    at: &Claimed<'_>,
    labels: &[Symbol],
    variables: &[Expression],
) -> Result<Judged, AuditError> {
    let span = at.affine(variables)?;
    let claimed: Vec<_> = labels.iter().map(|label| at.case.targets.resolve(label)).collect();
    let mut evidence = Vec::new();
    let mut holds = true;
    for label in labels {
        if !span.reduce(&at.coefficient(label)?).remainder.is_zero() {
            holds = false;
            evidence.push(Phrase::default().label(label.as_str()).and(" is not linear in them"));
        }
    }
    for finding in at.case.findings {
        let linear = span.reduce(&at.coefficient(&finding.label)?).remainder.is_zero();
        if linear && !claimed.contains(&Some(finding.target)) {
            holds = false;
            evidence.push(Phrase::default().label(finding.label.as_str()).and(" is linear too"));
        }
    }
    if holds {
        let others = at.case.findings.len() - labels.len();
        evidence.push(Phrase::words(format!("these {} are, the other {others} are not", labels.len())));
    }
    Ok((if holds { Judgement::Holds } else { Judgement::Fails }, evidence))
}

/// These coefficients are linearly independent over K.
pub(super) fn independent(at: &Claimed<'_>, labels: &[Symbol]) -> Result<Judged, AuditError> {
    let field = field_of(at.case.statement);
    let mut span = Span::new(field);
    let mut evidence = Vec::new();
    for (position, label) in labels.iter().enumerate() {
        if let Some(scalars) = span.add(&at.coefficient(label)?) {
            evidence.push(combination(label, &labels[..position], &scalars)?);
        }
    }
    let (rank, all) = (span.rank(), labels.len());
    evidence.insert(0, Phrase::words(format!("over {} they have rank {rank}", at.case.statement.field())));
    if rank < all {
        let same = labels.first().and_then(|label| at.case.targets.resolve(label));
        let all = same.map_or(Vec::new(), |target| at.case.targets.like(target));
        let values = all.into_iter().filter_map(|target| at.case.targets.value(target));
        let everything: Vec<Polynomial> = values
            .filter(|value| !value.is_zero())
            .map(|value| polynomial_from_exact(field, value))
            .collect();
        evidence.push(Phrase::words(format!(
            "all {} coefficients that are not zero span a space of dimension {}",
            everything.len(),
            Span::of(field, &everything).rank()
        )));
    }
    Ok((if rank == all { Judgement::Holds } else { Judgement::Fails }, evidence))
}

/// `a3 = 2·a1 − a2`.
fn combination(label: &Symbol, others: &[Symbol], scalars: &[FieldElement]) -> Result<Phrase, AuditError> {
    let mut phrase = Phrase::default().label(label.as_str()).and(" = ");
    let mut first = true;
    for (other, scalar) in others.iter().zip(scalars).filter(|(_, scalar)| !scalar.is_zero()) {
        let scalar: exact::Polynomial = polynomial_to_exact(&Polynomial::constant(scalar.clone()))?;
        let negative = scalar.term_count() == 1 && scalar.terms().all(|(_, value)| value.is_negative());
        let scalar = if negative { scalar.negate() } else { scalar };
        phrase = phrase.and(match (first, negative) {
            (true, false) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (false, true) => " − ",
        });
        if !scalar.is_one() {
            phrase = phrase.factor(&scalar).and("·");
        }
        phrase = phrase.label(other.as_str());
        first = false;
    }
    Ok(if first { phrase.and("0") } else { phrase })
}
