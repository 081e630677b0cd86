//! A statement as the prover has it: its field, the condition expanded, the equations.

use crate::algebra::{MultiquadraticField, Polynomial, polynomial_from_exact};
use crate::bezier::{BernsteinForm, surface_condition_within};
use crate::certificate::Premise;
use crate::control::{Control, Interrupted};
use crate::elimination::System;
use crate::statement::{Statement, Subject};

/// A statement, with what the prover computes from it once and everything else uses.
#[derive(Debug, Clone)]
pub struct Problem {
    statement: Statement,
    condition: Result<Option<BernsteinForm>, Interrupted>,
}

/// The field a statement is made over, for computing.
pub fn field_of(statement: &Statement) -> MultiquadraticField {
    MultiquadraticField::new(statement.field().values())
}

impl Problem {
    /// Expands the condition. Costs as many products of polynomials as the surface has factors, times (emn)².
    ///
    /// Where that is stopped, all that needs the condition says so.
    pub fn of(statement: &Statement, control: &Control) -> Self {
        let condition = match statement.subject() {
            Subject::Patch(patch) => surface_condition_within(field_of(statement), patch, control).map(Some),
            Subject::System(_) => Ok(None),
        };
        Problem { statement: statement.clone(), condition }
    }

    /// The statement.
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    /// The field it is made over.
    pub fn field(&self) -> MultiquadraticField {
        field_of(&self.statement)
    }

    /// The form whose coefficients must vanish for the patch to lie on the surface; `None` for a bare system.
    ///
    /// # Errors
    /// If its expansion was stopped.
    pub fn condition(&self) -> Result<Option<&BernsteinForm>, Interrupted> {
        self.condition.as_ref().map(Option::as_ref).map_err(Clone::clone)
    }

    /// An equation of the statement by its name; `None` for a name it does not have, for steps, and where the expansion
    /// was stopped.
    pub fn equation(&self, name: Premise) -> Option<Polynomial> {
        let index = |number: u32| usize::try_from(number).ok()?.checked_sub(1);
        match name {
            Premise::Coefficient(r, s) => {
                let form = self.condition.as_ref().ok()?.as_ref()?;
                let (m, n) = form.bidegree();
                (r <= m && s <= n).then(|| form.coefficient(r, s).clone())
            }
            Premise::Equation(number) => match self.statement.subject() {
                Subject::System(all) => {
                    all.get(index(number)?).map(|equation| polynomial_from_exact(self.field(), equation))
                }
                Subject::Patch(_) => None,
            },
            // Rabinowitsch: d ≠ 0 means that d·t = 1 for some t.
            Premise::Nonzero(number) => {
                let k = index(number)?;
                let assumed = polynomial_from_exact(self.field(), self.statement.nonzero().get(k)?);
                let t = Polynomial::variable(self.field(), (self.statement.unknowns().len() + k) as u16);
                let minus_one = Polynomial::constant(self.field().integer(-1));
                Some(assumed.multiply(&t).add(&minus_one))
            }
            Premise::Step(_) => None,
        }
    }

    /// The equations: the coefficients row by row, or those of the system, and the assumptions after them.
    ///
    /// # Errors
    /// If the expansion of the condition was stopped.
    pub fn system(&self) -> Result<System, Interrupted> {
        let equations: Vec<Premise> = match self.statement.subject() {
            Subject::Patch(_) => {
                let all = self.condition()?.into_iter().flat_map(BernsteinForm::coefficients);
                all.map(|(r, s, _)| Premise::Coefficient(r, s)).collect()
            }
            Subject::System(all) => (1..).zip(all).map(|(number, _)| Premise::Equation(number)).collect(),
        };
        let assumptions = (1..).zip(self.statement.nonzero()).map(|(number, _)| Premise::Nonzero(number));
        let named = equations.into_iter().chain(assumptions);
        let system: Vec<_> = named.filter_map(|name| Some((name, self.equation(name)?))).collect();
        let variables = self.statement.unknowns().len() + self.statement.nonzero().len();
        Ok(System::new(self.field(), variables, system))
    }
}
