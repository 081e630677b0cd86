//! What a source claims, judged.

mod linear;
mod proved;
mod quantity;
mod radius;
mod relation;
mod solution;
mod unique;

use super::AuditError;
use super::compare::Finding;
use super::targets::Targets;
use crate::control::Control;
use crate::document::Phrase;
use crate::exact::{Limit, Polynomial};
use crate::formats::listing::{
    Claim, ClaimKind, Expression, Listing, ListingError, ListingFault, Scope, Symbol,
};
use crate::statement::{Place, Statement};

/// What became of a claim.
#[derive(Debug, Clone)]
pub struct ClaimVerdict {
    /// The claim.
    pub claim: Claim,
    /// The judgement.
    pub judgement: Judgement,
    /// What it rests on.
    pub evidence: Vec<Phrase>,
}

/// The three ways a claim can come out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Judgement {
    /// Computed, and right.
    Holds,
    /// Computed, and wrong.
    Fails,
    /// Not computed.
    NotChecked,
}

/// A judgement with its evidence.
type Judged = (Judgement, Vec<Phrase>);

/// What claims are about.
pub(super) struct Case<'a> {
    pub(super) statement: &'a Statement,
    pub(super) targets: &'a Targets,
    pub(super) findings: &'a [Finding],
    pub(super) scope: &'a Scope,
    pub(super) listing: &'a Listing,
}

/// Judges one claim.
pub(super) fn judge(claim: &Claim, case: &Case<'_>, control: &Control) -> Result<ClaimVerdict, AuditError> {
    let at = Claimed { claim, case, control };
    let (judgement, evidence) = match &claim.kind {
        ClaimKind::Relation(formula) => relation::relation(&at, formula)?,
        ClaimKind::Symmetric => relation::symmetric(&at)?,
        ClaimKind::Linear { labels, variables } => linear::linear(&at, labels, variables)?,
        ClaimKind::Independent(labels) => linear::independent(&at, labels)?,
        ClaimKind::Solution { labels, variables, values, least_squares } => {
            solution::solution(&at, labels, variables, values, *least_squares)?
        }
        ClaimKind::Values { at: point, printed } => solution::values(&at, point, printed)?,
        ClaimKind::Decimal { of, printed } => solution::decimal_of(&at, of, printed)?,
        ClaimKind::Radius { at: point, interval } => radius::radius(&at, point, interval, control)?,
        ClaimKind::Unrivalled { at: point, rival } => radius::unrivalled(&at, point, rival, control)?,
        ClaimKind::Proved { statement, expected } => proved::proved(&at, statement, *expected, control)?,
        ClaimKind::Quantity { name, printed } => quantity::quantity(&at, name, printed)?,
        ClaimKind::Unchecked => (Judgement::NotChecked, Vec::new()),
    };
    Ok(ClaimVerdict { claim: claim.clone(), judgement, evidence })
}

/// A claim with what it is about.
struct Claimed<'a> {
    claim: &'a Claim,
    case: &'a Case<'a>,
    control: &'a Control,
}

impl<'a> Claimed<'a> {
    /// An error about the claim itself.
    fn wrong(&self, message: String) -> AuditError {
        let place = Place::of(&self.case.listing.text, self.claim.span.clone());
        ListingError { place, fault: ListingFault::File { message } }.into()
    }

    /// The true coefficient a label names.
    fn truth(&self, label: &Symbol) -> Result<&'a Polynomial, AuditError> {
        let target = self.case.targets.resolve(label);
        target.and_then(|target| self.case.targets.value(target)).ok_or_else(|| {
            self.wrong(format!("`{label}` names no coefficient, expected {}", self.case.targets.expected()))
        })
    }

    /// The printed coefficient, if it is listed.
    fn printed(&self, label: &Symbol) -> Option<&'a Polynomial> {
        let target = self.case.targets.resolve(label)?;
        self.case.findings.iter().find(|finding| finding.target == target).map(|finding| &finding.printed)
    }

    /// The value of an expression of the claim in this scope.
    fn value(&self, expression: &Expression, scope: &Scope) -> Result<Polynomial, AuditError> {
        expression.value_within(scope, &mut self.control.work()).map_err(|limit| match limit {
            Some(limit) => limit.into(),
            None => self.wrong("an expression of this claim has no value here".to_owned()),
        })
    }

    /// The values of all unknowns of the statement at a point that is given in the listing's names.
    fn point(&self, values: &[(Symbol, Expression)]) -> Result<Vec<Polynomial>, AuditError> {
        let unknowns = self.case.statement.unknowns();
        let constants = Scope::of(self.case.statement.field(), &[]);
        let mut point = vec![None; unknowns.len()];
        for (name, expression) in values {
            let value = self.value(expression, &constants)?;
            let place = self.case.scope.names.get(name).and_then(Option::as_ref).and_then(|meaning| {
                (0..unknowns.len()).find(|&k| *meaning == Polynomial::variable(k as u16))
            });
            match place {
                Some(place) => point[place] = Some(value),
                None => return Err(self.wrong(format!("`{name}` is not one of the unknowns"))),
            }
        }
        let missing = |(place, value): (usize, Option<Polynomial>)| {
            value.ok_or_else(|| self.wrong(format!("the value of `{}` is missing", unknowns[place])))
        };
        point.into_iter().enumerate().map(missing).collect()
    }

    /// a − b.
    fn difference(&self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Limit> {
        Polynomial::sum(&[a.clone(), b.negate()], self.case.statement.field(), &mut self.control.work())
    }
}
