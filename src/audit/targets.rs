//! Which coefficient a label names.

use crate::control::Control;
use crate::exact::Polynomial;
use crate::expand::{Basis, Coefficient, ExpansionError, coefficients_of};
use crate::formats::listing::Symbol;
use crate::problem::Problem;
use crate::statement::{Statement, Subject};

/// A coefficient of the surface condition, or an equation of a system.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Target {
    /// The coefficient of uⁱvʲ.
    Monomial(u32, u32),
    /// The coefficient of uʳ(1−u)^(M−r)·vˢ(1−v)^(N−s).
    Bernstein(u32, u32),
    /// The k-th polynomial of a system, from 1.
    Equation(u32),
}

/// All that labels can name, with the true values.
#[derive(Debug, Clone)]
pub struct Targets {
    monomial: Vec<Coefficient>,
    bernstein: Vec<Coefficient>,
    equations: Vec<Polynomial>,
    /// (M, N), the bidegree of the condition.
    bidegree: (u32, u32),
    /// The listing's own labels.
    labels: Vec<(Symbol, Vec<u32>)>,
    basis: Basis,
}

impl Targets {
    /// The targets of a statement, for labels that are mapped like this or speak for themselves.
    ///
    /// # Errors
    /// [`ExpansionError`]
    pub fn of(
        statement: &Statement,
        labels: &[(Symbol, Vec<u32>)],
        basis: Basis,
        control: &Control,
    ) -> Result<Self, ExpansionError> {
        let problem = Problem::of(statement);
        let of = |basis| coefficients_of(&problem, basis, control).map(Option::unwrap_or_default);
        let (monomial, bernstein) = (of(Basis::Monomial)?, of(Basis::Bernstein)?);
        let equations = match statement.subject() {
            Subject::System(polynomials) => polynomials.clone(),
            Subject::Patch(_) => Vec::new(),
        };
        let bidegree = monomial.last().map_or((0, 0), |last| last.index);
        Ok(Targets { monomial, bernstein, equations, bidegree, labels: labels.to_vec(), basis })
    }

    /// Whether F vanishes on the edges u = 0 and v = 0, so that coefficients can be numbered row by row from u¹v¹.
    fn is_numbered(&self) -> bool {
        let on_edge = |c: &&Coefficient| c.index.0 == 0 || c.index.1 == 0;
        self.monomial.iter().filter(on_edge).all(|c| c.value.is_zero())
    }

    /// What a label names.
    pub fn resolve(&self, label: &Symbol) -> Option<Target> {
        let target = match self.labels.iter().find(|(other, _)| other == label) {
            Some((_, indices)) => self.indexed(self.basis, indices)?,
            None => {
                let (letters, indices) = label.indices()?;
                let basis = match letters {
                    "c" => Basis::Bernstein,
                    "a" => Basis::Monomial,
                    _ => self.basis,
                };
                match indices.as_slice() {
                    // a_k, row by row: the paper's Eq. 10.
                    [k] if self.equations.is_empty() && basis == Basis::Monomial && self.is_numbered() => {
                        let columns = self.bidegree.1;
                        let (row, column) = (k.checked_sub(1)? / columns, (k - 1) % columns);
                        Target::Monomial(row + 1, column + 1)
                    }
                    indices => self.indexed(basis, indices)?,
                }
            }
        };
        self.value(target).map(|_| target)
    }

    fn indexed(&self, basis: Basis, indices: &[u32]) -> Option<Target> {
        match (indices, basis) {
            ([k], _) if !self.equations.is_empty() => Some(Target::Equation(*k)),
            ([i, j], Basis::Monomial) => Some(Target::Monomial(*i, *j)),
            ([r, s], Basis::Bernstein) => Some(Target::Bernstein(*r, *s)),
            _ => None,
        }
    }

    /// The true value.
    pub fn value(&self, target: Target) -> Option<&Polynomial> {
        let find = |list: &'_ [Coefficient], index: (u32, u32)| -> Option<usize> {
            list.iter().position(|coefficient| coefficient.index == index)
        };
        match target {
            Target::Monomial(i, j) => find(&self.monomial, (i, j)).map(|at| &self.monomial[at].value),
            Target::Bernstein(r, s) => find(&self.bernstein, (r, s)).map(|at| &self.bernstein[at].value),
            Target::Equation(k) => self.equations.get((k as usize).checked_sub(1)?),
        }
    }

    /// The target with the parameters u and v exchanged.
    pub fn transposed(target: Target) -> Option<Target> {
        match target {
            Target::Monomial(i, j) if i != j => Some(Target::Monomial(j, i)),
            Target::Bernstein(r, s) if r != s => Some(Target::Bernstein(s, r)),
            _ => None,
        }
    }

    /// All targets of the same kind as this one.
    pub fn like(&self, target: Target) -> Vec<Target> {
        match target {
            Target::Monomial(..) => {
                self.monomial.iter().map(|c| Target::Monomial(c.index.0, c.index.1)).collect()
            }
            Target::Bernstein(..) => {
                self.bernstein.iter().map(|c| Target::Bernstein(c.index.0, c.index.1)).collect()
            }
            Target::Equation(_) => (1..=self.equations.len() as u32).map(Target::Equation).collect(),
        }
    }

    /// How many equations there are: coefficients of the condition, or polynomials of a system.
    pub fn count(&self) -> usize {
        self.bernstein.len() + self.equations.len()
    }

    /// Whether all of them are zero.
    pub fn vanish(&self) -> bool {
        self.bernstein.iter().all(|c| c.value.is_zero()) && self.equations.iter().all(Polynomial::is_zero)
    }

    /// What labels may be, for a message.
    pub fn expected(&self) -> String {
        if !self.equations.is_empty() {
            return format!("f1, …, f{}", self.equations.len());
        }
        let (m, n) = self.bidegree;
        let numbered = if self.is_numbered() { format!("a1, …, a{} or ", m * n) } else { String::new() };
        format!(
            "{numbered}a_{{i,j}} (of u^i v^j) or c_{{r,s}} with indices up to ({m},{n}), or an explicit mapping"
        )
    }
}
