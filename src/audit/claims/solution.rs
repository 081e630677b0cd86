//! Solutions of linear equations, and values at a point.

use super::unique::{Others, others};
use super::{Claimed, Judged, Judgement};
use crate::algebra::{FieldElement, MultiquadraticField, Polynomial, polynomial_to_exact};
use crate::audit::AuditError;
use crate::audit::decimal::{Decimal, decimal};
use crate::audit::span::{Solutions, solve};
use crate::document::Phrase;
use crate::exact;
use crate::formats::listing::{Expression, Scope, Symbol};
use crate::problem::field_of;

/// Decimals that are shown of a value at least.
const PLACES: u32 = 8;

/// Two decimals more than are printed, but so many at least.
fn shown(printed: &str, least: u32) -> u32 {
    let decimals = printed.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    u32::try_from(decimals).unwrap_or(u32::MAX).saturating_add(2).max(least)
}

/// The equations have the printed solution and no other.
pub(super) fn solution(
    at: &Claimed<'_>,
    labels: &[Symbol],
    variables: &[Expression],
    values: &[(Symbol, Expression)],
    least_squares: bool,
) -> Result<Judged, AuditError> {
    let field = field_of(at.case.statement);
    let span = at.affine(variables)?;
    let (mut matrix, mut right) = (Vec::new(), Vec::new());
    for label in labels {
        let reduced = span.reduce(&at.coefficient(label)?);
        if !reduced.remainder.is_zero() {
            let phrase = Phrase::default().label(label.as_str()).and(" is not linear in them");
            return Ok((Judgement::Fails, vec![phrase]));
        }
        right.push(-&reduced.scalars[0]);
        matrix.push(reduced.scalars[1..].to_vec());
    }
    let (equation_rank, _) = solve(&matrix, &right, variables.len());
    if least_squares {
        (matrix, right) = normal_equations(field, &matrix, &right, variables.len());
    }
    let (_, solutions) = solve(&matrix, &right, variables.len());
    let mut evidence = vec![Phrase::words(format!("the equations have rank {equation_rank}"))];
    let found = match solutions {
        Solutions::Unique(found) => found,
        Solutions::Inconsistent => {
            evidence.push(Phrase::words("and no solution"));
            return Ok((Judgement::Fails, evidence));
        }
        Solutions::Family(dimension) => {
            evidence.push(Phrase::words(format!("and a family of solutions of dimension {dimension}")));
            return Ok((Judgement::Fails, evidence));
        }
    };
    let point = at.point(values)?;
    let mut holds = true;
    let mut equations = Vec::with_capacity(variables.len());
    let mut phrase = Phrase::default();
    for (position, (variable, found)) in variables.iter().zip(&found).enumerate() {
        let symbolic = at.value(variable, at.case.scope)?;
        let claimed = symbolic.substitute(&point, at.case.statement.field(), &mut at.control.work())?;
        let found = polynomial_to_exact(&Polynomial::constant(found.clone()))?;
        holds &= claimed == found;
        equations.push(at.difference(&symbolic, &found)?);
        phrase =
            phrase.and(if position > 0 { ", " } else { "" }).formula(&symbolic).and(" = ").formula(&found);
    }
    // One value for each variable is not yet one value for each unknown: w² = 4.
    let others = if holds { others(at, &equations, &point)? } else { Others::None };
    let what = match others {
        Others::None if holds => "the only solution has ",
        _ if least_squares => "least squares gives ",
        _ => "they hold if and only if ",
    };
    evidence.push(Phrase::words(what).followed_by(phrase));
    match others {
        Others::None => {}
        Others::One(unknown, value) => {
            let name = &at.case.statement.unknowns()[unknown];
            evidence.push(Phrase::words(format!("which is also so with {name} = ")).formula(&value));
            return Ok((Judgement::Fails, evidence));
        }
        Others::Open => {
            evidence.push(Phrase::words("whether other values of the unknowns satisfy that was not decided"));
            return Ok((Judgement::NotChecked, evidence));
        }
    }
    Ok((if holds { Judgement::Holds } else { Judgement::Fails }, evidence))
}

/// AᵀA x = Aᵀb.
fn normal_equations(
    field: MultiquadraticField,
    matrix: &[Vec<FieldElement>],
    right: &[FieldElement],
    columns: usize,
) -> (Vec<Vec<FieldElement>>, Vec<FieldElement>) {
    let dot = |a: &dyn Fn(usize) -> FieldElement, b: &dyn Fn(usize) -> FieldElement| {
        (0..matrix.len()).fold(field.zero(), |sum, k| &sum + &(&a(k) * &b(k)))
    };
    let column = |i: usize| move |k: usize| matrix[k][i].clone();
    let square = (0..columns).map(|i| (0..columns).map(|j| dot(&column(i), &column(j))).collect()).collect();
    let values = (0..columns).map(|i| dot(&column(i), &|k| right[k].clone())).collect();
    (square, values)
}

/// At a point the coefficients have the printed values, to the digits printed.
pub(super) fn values(
    at: &Claimed<'_>,
    values: &[(Symbol, Expression)],
    printed: &[(Symbol, String)],
) -> Result<Judged, AuditError> {
    let field = at.case.statement.field();
    let point = at.point(values)?;
    let mut groups: Vec<(exact::Polynomial, Vec<&Symbol>)> = Vec::new();
    let mut evidence = Vec::new();
    for (label, text) in printed {
        let exact = at.truth(label)?.substitute(&point, field, &mut at.control.work())?;
        if !Decimal::read(text).is_close_to(&exact, field)? {
            evidence.push(
                Phrase::default()
                    .label(label.as_str())
                    .and(format!(" is printed as {text}, but is "))
                    .formula(&exact)
                    .and(format!(" = {}…", decimal(&exact, shown(text, PLACES), field)?)),
            );
        }
        match groups.iter_mut().find(|(value, _)| *value == exact) {
            Some((_, labels)) => labels.push(label),
            None => groups.push((exact, vec![label])),
        }
    }
    let judgement = if evidence.is_empty() { Judgement::Holds } else { Judgement::Fails };
    for (value, labels) in groups {
        let mut phrase = Phrase::default();
        for (position, label) in labels.iter().enumerate() {
            phrase = phrase.and(if position > 0 { " = " } else { "" }).label(label.as_str());
        }
        evidence.push(phrase.and(" = ").formula(&value));
    }
    Ok((judgement, evidence))
}

/// A constant is the printed decimal, to the digits printed.
pub(super) fn decimal_of(at: &Claimed<'_>, of: &Expression, printed: &str) -> Result<Judged, AuditError> {
    let field = at.case.statement.field();
    let exact = at.value(of, &Scope::of(field, &[]))?;
    let holds = Decimal::read(printed).is_close_to(&exact, field)?;
    let evidence = Phrase::default()
        .formula(&exact)
        .and(format!(" = {}…", decimal(&exact, shown(printed, PLACES + 2), field)?));
    Ok((if holds { Judgement::Holds } else { Judgement::Fails }, vec![evidence]))
}
