//! A statement as the prover has it: its field, the condition expanded, the equations.

use std::sync::OnceLock;

use crate::algebra::{MultiquadraticField, Polynomial, polynomial_from_exact};
use crate::bezier::{BernsteinForm, surface_condition_within};
use crate::certificate::Premise;
use crate::control::{Control, Interrupted};
use crate::elimination::System;
use crate::statement::{Statement, Subject};

/// A statement, with what the prover computes from it once, when it is first asked for, and everything else uses.
#[derive(Debug, Clone)]
pub struct Problem {
    statement: Statement,
    condition: OnceLock<Option<BernsteinForm>>,
}

/// The field a statement is made over, for computing.
pub fn field_of(statement: &Statement) -> MultiquadraticField {
    MultiquadraticField::new(statement.field().values())
}

impl Problem {
    /// A problem of which nothing is computed yet.
    pub fn of(statement: &Statement) -> Self {
        Problem { statement: statement.clone(), condition: OnceLock::new() }
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
    /// The first time it costs as many products of polynomials as the surface has factors, times (emn)².
    ///
    /// # Errors
    /// [`Control::check`]; then nothing is kept.
    pub fn condition(&self, control: &Control) -> Result<Option<&BernsteinForm>, Interrupted> {
        if let Some(known) = self.condition.get() {
            return Ok(known.as_ref());
        }
        let expanded = match self.statement.subject() {
            Subject::Patch(patch) => Some(surface_condition_within(self.field(), patch, control)?),
            Subject::System(_) => None,
        };
        Ok(self.condition.get_or_init(|| expanded).as_ref())
    }

    /// An equation of the statement by its name; `None` for a name it does not have, and for steps.
    ///
    /// # Errors
    /// [`Problem::condition`]
    pub fn equation(&self, name: Premise, control: &Control) -> Result<Option<Polynomial>, Interrupted> {
        let index = |number: u32| usize::try_from(number).ok()?.checked_sub(1);
        Ok(match name {
            Premise::Coefficient(r, s) => self.condition(control)?.and_then(|form| {
                let (m, n) = form.bidegree();
                (r <= m && s <= n).then(|| form.coefficient(r, s).clone())
            }),
            Premise::Equation(number) => match self.statement.subject() {
                Subject::System(all) => {
                    index(number).and_then(|k| all.get(k)).map(|equation| self.read(equation))
                }
                Subject::Patch(_) => None,
            },
            Premise::Nonzero(number) => {
                index(number).and_then(|k| Some(self.inverted(k, self.statement.nonzero().get(k)?)))
            }
            Premise::Step(_) => None,
        })
    }

    /// The equations: the coefficients row by row, or those of the system, and the assumptions after them.
    ///
    /// # Errors
    /// [`Problem::condition`]
    pub fn system(&self, control: &Control) -> Result<System, Interrupted> {
        let mut equations: Vec<(Premise, Polynomial)> = match self.statement.subject() {
            Subject::Patch(_) => {
                let all = self.condition(control)?.into_iter().flat_map(BernsteinForm::coefficients);
                all.map(|(r, s, coefficient)| (Premise::Coefficient(r, s), coefficient.clone())).collect()
            }
            Subject::System(all) => {
                (1..).map(Premise::Equation).zip(all.iter().map(|equation| self.read(equation))).collect()
            }
        };
        for (k, assumed) in self.statement.nonzero().iter().enumerate() {
            equations.push((Premise::Nonzero(k as u32 + 1), self.inverted(k, assumed)));
        }
        let variables = self.statement.unknowns().len() + self.statement.nonzero().len();
        Ok(System::new(self.field(), variables, equations))
    }

    fn read(&self, polynomial: &crate::exact::Polynomial) -> Polynomial {
        polynomial_from_exact(self.field(), polynomial)
    }

    /// Rabinowitsch: d ≠ 0, the assumption k, means that d·t = 1 for some t.
    fn inverted(&self, k: usize, assumed: &crate::exact::Polynomial) -> Polynomial {
        let t = Polynomial::variable(self.field(), (self.statement.unknowns().len() + k) as u16);
        let minus_one = Polynomial::constant(self.field().integer(-1));
        self.read(assumed).multiply(&t).add(&minus_one)
    }
}
