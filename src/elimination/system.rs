//! The equations to be refuted or solved, with the names a certificate knows them by.

use crate::algebra::{MultiquadraticField, Polynomial};
use crate::certificate::Premise;

/// Polynomials in x₀, x₁, …, each with its name.
#[derive(Debug, Clone)]
pub struct System {
    field: MultiquadraticField,
    variables: usize,
    generators: Vec<(Premise, Polynomial)>,
}

impl System {
    /// The system of these equations in `variables` variables. Zero polynomials and repetitions are dropped:
    /// a certificate uses each polynomial by its first name.
    pub fn new(
        field: MultiquadraticField,
        variables: usize,
        equations: impl IntoIterator<Item = (Premise, Polynomial)>,
    ) -> Self {
        let mut seen = std::collections::HashSet::new();
        let mut generators: Vec<(Premise, Polynomial)> = equations.into_iter().collect();
        generators.sort_by_key(|(name, _)| *name);
        generators.retain(|(_, polynomial)| !polynomial.is_zero() && seen.insert(polynomial.clone()));
        System { field, variables, generators }
    }

    /// The system with one more equation, which has no name that a certificate could use.
    pub(super) fn with_equation(&self, equation: Polynomial) -> Self {
        let generators = self.generators.iter().cloned().chain([(Premise::Equation(0), equation)]);
        System::new(self.field, self.variables, generators)
    }

    /// The system of other equations in the same variables, which have no names that a certificate could use.
    pub(super) fn with_equations(&self, equations: impl IntoIterator<Item = Polynomial>) -> Self {
        let generators = equations.into_iter().map(|equation| (Premise::Equation(0), equation));
        System::new(self.field, self.variables, generators)
    }

    /// The same system over a field that contains K.
    pub fn over(&self, larger: MultiquadraticField) -> Self {
        let generators = self.generators.iter().map(|(name, equation)| (*name, equation.over(larger)));
        System { field: larger, variables: self.variables, generators: generators.collect() }
    }

    /// K.
    pub fn field(&self) -> MultiquadraticField {
        self.field
    }

    /// How many variables there are, used or not.
    pub fn variables(&self) -> usize {
        self.variables
    }

    /// The equations that are left, by name.
    pub fn generators(&self) -> &[(Premise, Polynomial)] {
        &self.generators
    }
}
