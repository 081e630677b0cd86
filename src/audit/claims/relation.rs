//! Relations between coefficients.

use std::collections::BTreeMap;

use super::{Claimed, Judged, Judgement};
use crate::audit::AuditError;
use crate::audit::targets::Targets;
use crate::document::Phrase;
use crate::exact::Polynomial;
use crate::formats::listing::{Expression, Formula, Kind, Scope, Symbol};

/// `a12 = a15 = -2*a16`.
pub(super) fn relation(at: &Claimed<'_>, formula: &Formula) -> Result<Judged, AuditError> {
    let mut used = Vec::new();
    labels_in(&formula.expression, &mut used);
    let scope = |value: &dyn Fn(&Symbol) -> Option<Polynomial>| {
        let names: BTreeMap<Symbol, Option<Polynomial>> =
            used.iter().filter_map(|label| Some((label.clone(), Some(value(label)?)))).collect();
        Scope { field: at.case.statement.field().clone(), names }
    };
    for label in &used {
        at.truth(label)?;
    }
    let right = at.value(&formula.expression, &scope(&|label| at.truth(label).ok().cloned()))?;
    let mut evidence = Vec::new();
    let mut holds = true;
    for (label, _) in &formula.labels {
        let rest = at.difference(at.truth(label)?, &right)?;
        if !rest.is_zero() {
            holds = false;
            evidence.push(
                Phrase::words("the true ")
                    .label(label.as_str())
                    .and(" exceeds what is claimed by ")
                    .formula(&rest),
            );
        }
    }
    // The printed formulas may contradict what is said of them.
    let printed = scope(&|label| at.printed(label).cloned());
    if printed.names.len() == used.len() {
        let right = at.value(&formula.expression, &printed)?;
        for (label, _) in &formula.labels {
            let Some(left) = at.printed(label) else { continue };
            let rest = at.difference(left, &right)?;
            if !rest.is_zero() {
                evidence.push(
                    Phrase::words("but not as printed: there ")
                        .label(label.as_str())
                        .and(" exceeds it by ")
                        .formula(&rest),
                );
            }
        }
    }
    Ok((if holds { Judgement::Holds } else { Judgement::Fails }, evidence))
}

fn labels_in(expression: &Expression, found: &mut Vec<Symbol>) {
    match &expression.kind {
        Kind::Number(_) => {}
        Kind::Name(symbol) => {
            if !found.contains(symbol) {
                found.push(symbol.clone());
            }
        }
        Kind::Sum(terms) => terms.iter().for_each(|term| labels_in(&term.term, found)),
        Kind::Product(first, factors) => {
            labels_in(first, found);
            factors.iter().for_each(|(_, factor)| labels_in(factor, found));
        }
        Kind::Power(base, ..) | Kind::Root(base) => labels_in(base, found),
    }
}

/// The coefficients of uⁱvʲ and uʲvⁱ are equal.
pub(super) fn symmetric(at: &Claimed<'_>) -> Result<Judged, AuditError> {
    let mut evidence = Vec::new();
    let (mut pairs, mut equal) = (0, 0);
    for finding in at.case.findings {
        let Some(target) = Targets::transposed(finding.target).filter(|target| finding.target < *target)
        else {
            continue;
        };
        let Some(other) = at.case.findings.iter().find(|other| other.target == target) else { continue };
        pairs += 1;
        if finding.truth == other.truth {
            equal += 1;
        } else {
            evidence.push(
                Phrase::default()
                    .label(finding.label.as_str())
                    .and(" and ")
                    .label(other.label.as_str())
                    .and(" differ by ")
                    .formula(&at.difference(&finding.truth, &other.truth)?),
            );
        }
    }
    let judgement = if equal == pairs { Judgement::Holds } else { Judgement::Fails };
    if pairs == 0 {
        return Ok((Judgement::NotChecked, vec![Phrase::words("no such pair is listed")]));
    }
    evidence.insert(0, Phrase::words(format!("{equal} of {pairs} pairs of true coefficients are equal")));
    Ok((judgement, evidence))
}
