//! The one walk that all targets share: a statement with its argument, flattened to polynomials over Q.
//!
//! Other programs know no multiquadratic fields. To them a polynomial over K = Q(√d₁, …, √dₖ) is one over Q in more
//! *generators*: the roots, then the unknowns, then the Rabinowitsch variables; that √d·√d = d they are told.

use num_rational::BigRational;

use super::text::harmless;
use crate::certificate::{Argument, Certificate, Premise, Step};
use crate::control::{Control, Interrupted};
use crate::exact::{Limit, Polynomial, Radicands, Stop};
use crate::statement::{HomogeneousPoint, Patch, Statement, Subject};

/// What is exported: the equations and why they have no common zero, or the one they have.
#[derive(Debug, Clone)]
pub struct Case {
    /// The statement, for targets that need its equations expanded.
    pub statement: Statement,
    /// The statement's title, fit for a comment in any language.
    pub title: String,
    /// SHA-256 of the canonical statement.
    pub hash: String,
    /// K.
    pub field: Radicands,
    /// The unknowns as the statement calls them. No target may write these names unchanged.
    pub unknowns: Vec<String>,
    /// Polynomials that do not vanish.
    pub assumptions: Vec<Polynomial>,
    /// Where the equations come from; for an exact claim, with the values in place of the unknowns.
    pub subject: Subject,
    /// The argument.
    pub argument: Reasoning,
    /// What may stop the export.
    pub control: Control,
}

/// Why the claim holds.
#[derive(Debug, Clone)]
pub enum Reasoning {
    /// Steps that end in 1.
    Impossible(Vec<Step>),
    /// These values of the unknowns, constants of K, make all equations vanish.
    Exact(Vec<Polynomial>),
}

/// One term of a polynomial: a rational times powers of generators.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Term {
    /// Not zero.
    pub coefficient: BigRational,
    /// (generator from 0, exponent ≥ 1), generators increasing: roots, unknowns, Rabinowitsch variables.
    pub powers: Vec<(usize, u32)>,
}

/// Why something cannot be exported.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// Arguments by subdivision are not exported.
    #[error("only refutations and exact solutions are exported, not `claim {0}`")]
    Claim(&'static str),
    /// The format has no way to say it.
    #[error("the format {format} cannot express {what}")]
    Inexpressible {
        /// The target.
        format: &'static str,
        /// What it lacks.
        what: String,
    },
    /// A step uses an equation that there is not.
    #[error("the certificate uses {0}, which the statement does not have")]
    Premise(Premise),
    /// The values could not be put in.
    #[error(transparent)]
    Limit(#[from] Limit),
    /// Interrupted.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
    /// The equations could not be derived.
    #[error("{0}")]
    Equations(#[from] Stop),
}

impl Case {
    /// Brings a statement and a certificate together. The certificate is *not* checked: that is what the export is for.
    ///
    /// # Errors
    /// [`ExportError::Claim`] for arguments by subdivision, [`ExportError::Limit`] where values cannot be put in.
    pub fn new(statement: &Statement, certificate: &Certificate) -> Result<Case, ExportError> {
        Case::within(statement, certificate, &Control::default())
    }

    /// The same, where the export may be stopped.
    ///
    /// # Errors
    /// As [`Case::new`] has them.
    pub fn within(
        statement: &Statement,
        certificate: &Certificate,
        control: &Control,
    ) -> Result<Case, ExportError> {
        control.check()?;
        let field = statement.field().clone();
        let (argument, subject) = match &certificate.argument {
            Argument::Impossible(steps) => {
                (Reasoning::Impossible(steps.clone()), statement.subject().clone())
            }
            Argument::Exact(values) => {
                (Reasoning::Exact(values.clone()), with_values(statement.subject(), values, &field, control)?)
            }
            Argument::Bounds(_) => return Err(ExportError::Claim("bounds")),
            Argument::Unreachable(_) => return Err(ExportError::Claim("unreachable")),
            Argument::Cover(_) => return Err(ExportError::Claim("cover")),
        };
        let assumptions = match &argument {
            Reasoning::Impossible(_) => statement.nonzero().to_vec(),
            Reasoning::Exact(values) => {
                let at = |assumed: &Polynomial| assumed.substitute(values, &field, &mut control.work());
                statement.nonzero().iter().map(at).collect::<Result<_, _>>()?
            }
        };
        Ok(Case {
            statement: statement.clone(),
            title: harmless(statement.title()),
            hash: statement.hash(),
            field,
            unknowns: statement.unknowns().to_vec(),
            assumptions,
            subject,
            argument,
            control: control.clone(),
        })
    }

    /// The steps of a refutation; none for an exact claim.
    pub fn steps(&self) -> &[Step] {
        match &self.argument {
            Reasoning::Impossible(steps) => steps,
            Reasoning::Exact(_) => &[],
        }
    }

    /// The number of roots: generators 0, 1, … are √d₁, √d₂, …
    pub fn root_count(&self) -> usize {
        self.field.values().len()
    }

    /// The number of unknowns and Rabinowitsch variables.
    pub fn variable_count(&self) -> usize {
        match &self.argument {
            Reasoning::Impossible(_) => self.unknowns.len() + self.assumptions.len(),
            Reasoning::Exact(_) => 0,
        }
    }

    /// A polynomial in the unknowns as terms over Q in the generators, in the order of spelling.
    pub fn terms(&self, polynomial: &Polynomial) -> Vec<Term> {
        let roots = self.root_count();
        let term = |(monomial, coefficient): (&crate::exact::Monomial, &BigRational)| {
            let of_roots = (0..roots).filter(|bit| monomial.mask() >> bit & 1 == 1).map(|bit| (bit, 1));
            let of_variables = monomial.powers().iter().map(|&(k, e)| (roots + usize::from(k), e));
            Term { coefficient: coefficient.clone(), powers: of_roots.chain(of_variables).collect() }
        };
        polynomial.terms().map(term).collect()
    }

    /// The equations that the steps use, each once, in the order of premises.
    pub fn premises(&self) -> Vec<Premise> {
        let used = self.steps().iter().flat_map(|step| &step.combination).map(|(premise, _)| *premise);
        let mut equations: Vec<Premise> = used.filter(|p| !matches!(p, Premise::Step(_))).collect();
        equations.sort_unstable();
        equations.dedup();
        equations
    }
}

fn with_values(
    subject: &Subject,
    values: &[Polynomial],
    field: &Radicands,
    control: &Control,
) -> Result<Subject, Limit> {
    let mut work = control.work();
    let mut at = |polynomial: &Polynomial| polynomial.substitute(values, field, &mut work);
    Ok(match subject {
        Subject::System(polynomials) => {
            Subject::System(polynomials.iter().map(at).collect::<Result<_, _>>()?)
        }
        Subject::Patch(patch) => {
            let mut net = Vec::with_capacity(patch.net.len());
            for row in &patch.net {
                let mut points: Vec<HomogeneousPoint> = Vec::with_capacity(row.len());
                for [x, y, z, w] in row {
                    points.push([at(x)?, at(y)?, at(z)?, at(w)?]);
                }
                net.push(points);
            }
            Subject::Patch(Patch { net, ..patch.clone() })
        }
    })
}
