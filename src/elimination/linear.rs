//! Linear equations: solved exactly, substituted everywhere.

use std::collections::BTreeMap;

use super::derivation::{Derivation, Source};
use super::strategy::Strategy;
use crate::algebra::{FieldElement, Monomial, Polynomial};
use crate::control::{Control, Interrupted};

/// The substitutions found so far. No eliminated variable occurs in another substitution.
#[derive(Debug, Clone)]
pub(super) struct Linear {
    substitutions: BTreeMap<u16, Source>,
    strategy: Strategy,
}

/// What absorbing linear equations left.
pub(super) enum Absorbed {
    /// 1.
    Unit(Source),
    /// The non-linear equations, free of eliminated variables.
    Rest(Vec<Source>),
}

/// A linear equation on its way to reduced echelon form, with the scalars that combine it from its sources.
struct Row {
    equation: Polynomial,
    combination: BTreeMap<Source, FieldElement>,
}

impl Linear {
    pub(super) fn new(strategy: Strategy) -> Self {
        Linear { substitutions: BTreeMap::new(), strategy }
    }

    pub(super) fn len(&self) -> usize {
        self.substitutions.len()
    }

    /// Solves the linear ones among the equations, substitutes, and goes on while that makes others linear.
    ///
    /// Each round substitutes into the equations as they were given, so that no step is left in between.
    pub(super) fn absorb(
        &mut self,
        derivation: &mut Derivation<'_>,
        equations: &[Source],
        control: &Control,
    ) -> Result<Absorbed, Interrupted> {
        loop {
            let (mut linear, mut nonlinear) = (Vec::new(), Vec::new());
            for &source in equations {
                control.check()?;
                let Some(reduced) = self.substitute(derivation, source, control)? else {
                    continue;
                };
                match derivation.polynomial(reduced).degree() {
                    Some(0) => {
                        let unit = unit_from(derivation, reduced, control)?;
                        return Ok(unit.map_or(Absorbed::Rest(Vec::new()), Absorbed::Unit));
                    }
                    Some(1) => linear.push(reduced),
                    _ => nonlinear.push(reduced),
                }
            }
            if linear.is_empty() {
                nonlinear.sort_unstable();
                nonlinear.dedup();
                return Ok(Absorbed::Rest(nonlinear));
            }
            if let Some(unit) = self.solve(derivation, &linear, control)? {
                return Ok(Absorbed::Unit(unit));
            }
        }
    }

    /// `source` with the eliminated variables replaced; `None` where that gives zero.
    pub(super) fn substitute(
        &self,
        derivation: &mut Derivation<'_>,
        source: Source,
        control: &Control,
    ) -> Result<Option<Source>, Interrupted> {
        let field = derivation.system().field();
        let mut polynomial = derivation.polynomial(source).clone();
        let mut multipliers: BTreeMap<Source, Polynomial> = BTreeMap::new();
        loop {
            control.check()?;
            let eliminable = |(monomial, value): &(Monomial, FieldElement)| {
                let found =
                    monomial.powers().iter().find_map(|&(v, _)| Some((v, *self.substitutions.get(&v)?)));
                found.map(|(v, equation)| {
                    let quotient = monomial.quotient(&Monomial::variable(v)).expect("the variable occurs");
                    (equation, quotient, -value)
                })
            };
            let Some((equation, quotient, factor)) = polynomial.terms().iter().find_map(eliminable) else {
                break;
            };
            let shifted = derivation.polynomial(equation).shifted(&quotient);
            polynomial = polynomial.add_scaled(&factor, &shifted);
            let multiplier = multipliers.entry(equation).or_insert_with(|| Polynomial::zero(field));
            *multiplier = multiplier.add(&Polynomial::term(factor, quotient));
        }
        if multipliers.is_empty() || polynomial.is_zero() {
            return Ok((!polynomial.is_zero()).then_some(source));
        }
        let factor = normalizing_factor(&polynomial);
        let mut combination = vec![(source, Polynomial::constant(field.one()).scaled(&factor))];
        combination
            .extend(multipliers.into_iter().map(|(source, multiplier)| (source, multiplier.scaled(&factor))));
        derivation.derive(combination, control)
    }

    /// Brings the old and the new linear equations to reduced echelon form.
    fn solve(
        &mut self,
        derivation: &mut Derivation<'_>,
        sources: &[Source],
        control: &Control,
    ) -> Result<Option<Source>, Interrupted> {
        let field = derivation.system().field();
        let mut rows: Vec<Row> = sources
            .iter()
            .map(|&source| Row {
                equation: derivation.polynomial(source).clone(),
                combination: BTreeMap::from([(source, field.one())]),
            })
            .collect();
        let mut solved: Vec<(u16, Row)> = Vec::new();
        while let Some((position, variable)) = pivot(&rows, self.strategy) {
            let mut row = rows.swap_remove(position);
            let leading = row.equation.coefficient(&Monomial::variable(variable)).expect("the pivot");
            row.scale(&leading.inverse().expect("coefficients are not zero"));
            for other in rows.iter_mut().chain(solved.iter_mut().map(|(_, other)| other)) {
                control.check()?;
                other.eliminate(variable, &row);
            }
            solved.push((variable, row));
            rows.retain(|row| !row.equation.is_zero());
        }
        // What is left has no variable.
        if let Some(row) = rows.first() {
            let inverse =
                row.equation.as_constant().and_then(|constant| constant.inverse()).expect("not zero");
            let contradiction = row
                .combination
                .iter()
                .map(|(&source, factor)| (source, Polynomial::constant(factor * &inverse)));
            return derivation.derive(contradiction.collect(), control);
        }
        let mut fresh = BTreeMap::new();
        for (variable, row) in solved {
            let combination =
                row.combination.into_iter().map(|(source, factor)| (source, Polynomial::constant(factor)));
            let row = derivation.derive(combination.collect(), control)?;
            fresh.insert(variable, row.expect("a pivot row is not zero"));
        }
        // The old substitutions must not mention the variables that are eliminated now.
        let newer = Linear { substitutions: fresh, strategy: self.strategy };
        for equation in self.substitutions.values_mut() {
            *equation = newer.substitute_linear(derivation, *equation, control)?;
        }
        self.substitutions.extend(newer.substitutions);
        Ok(None)
    }

    /// Like `substitute`, for an equation that stays monic.
    fn substitute_linear(
        &self,
        derivation: &mut Derivation<'_>,
        source: Source,
        control: &Control,
    ) -> Result<Source, Interrupted> {
        let field = derivation.system().field();
        let equation = derivation.polynomial(source);
        let used = self.substitutions.iter().filter_map(|(&variable, &other)| {
            let coefficient = equation.coefficient(&Monomial::variable(variable))?;
            Some((other, Polynomial::constant(-coefficient)))
        });
        let mut combination: Vec<_> = used.collect();
        if combination.is_empty() {
            return Ok(source);
        }
        combination.push((source, Polynomial::constant(field.one())));
        Ok(derivation.derive(combination, control)?.expect("its own variable is left"))
    }

    /// The eliminated variables.
    pub(super) fn variables(&self) -> impl Iterator<Item = u16> + '_ {
        self.substitutions.keys().copied()
    }

    /// The equations variable + … = 0.
    pub(super) fn equations(&self, derivation: &Derivation<'_>) -> Vec<Polynomial> {
        self.substitutions.values().map(|&equation| derivation.polynomial(equation).clone()).collect()
    }

    /// The equation that is solved for a variable.
    pub(super) fn equation<'a>(
        &self,
        derivation: &'a Derivation<'_>,
        variable: u16,
    ) -> Option<&'a Polynomial> {
        self.substitutions.get(&variable).map(|&equation| derivation.polynomial(equation))
    }

    /// The value of every variable, if all are determined.
    pub(super) fn point(&self, derivation: &Derivation<'_>) -> Option<Vec<FieldElement>> {
        let value = |index: usize| {
            let equation = derivation.polynomial(*self.substitutions.get(&u16::try_from(index).ok()?)?);
            let constant = equation.coefficient(&Monomial::one());
            match equation.terms().len() {
                1 => Some(derivation.system().field().zero()),
                2 => constant.map(|constant| -constant),
                _ => None,
            }
        };
        (0..derivation.system().variables()).map(value).collect()
    }
}

impl Row {
    fn scale(&mut self, factor: &FieldElement) {
        self.equation = self.equation.scaled(factor);
        self.combination.values_mut().for_each(|value| *value = &*value * factor);
    }

    /// Subtracts the multiple of `pivot`, monic in `variable`, that removes the variable.
    fn eliminate(&mut self, variable: u16, pivot: &Row) {
        let Some(coefficient) = self.equation.coefficient(&Monomial::variable(variable)) else {
            return;
        };
        let factor = -coefficient;
        self.equation = self.equation.add_scaled(&factor, &pivot.equation);
        for (&source, value) in &pivot.combination {
            let zero = || factor.field().zero();
            let sum = self.combination.entry(source).or_insert_with(zero);
            *sum = &*sum + &(value * &factor);
        }
        self.combination.retain(|_, value| !value.is_zero());
    }
}

/// The shortest row, and in it the variable that occurs in the fewest rows (then the first one; the last one where
/// that has proved to keep proofs shorter).
fn pivot(rows: &[Row], strategy: Strategy) -> Option<(usize, u16)> {
    let candidates = rows.iter().enumerate().filter(|(_, row)| row.equation.degree() == Some(1));
    let (position, row) = candidates.min_by_key(|(_, row)| row.equation.terms().len())?;
    let occurrences = |variable: u16| {
        let monomial = Monomial::variable(variable);
        rows.iter().filter(|row| row.equation.coefficient(&monomial).is_some()).count()
    };
    let turn = |variable: u16| if strategy == Strategy::Plain { variable } else { !variable };
    let variable = row
        .equation
        .variables()
        .into_iter()
        .min_by_key(|&variable| (occurrences(variable), turn(variable)))?;
    Some((position, variable))
}

/// Bits of a leading coefficient that a linear polynomial is still divided by.
const MONIC: u64 = 64;

/// What brings a polynomial into its usual form: monic if it is linear, since that reads as a solution; without
/// fractions otherwise, or where division would make long numbers longer.
pub(super) fn normalizing_factor(polynomial: &Polynomial) -> FieldElement {
    let (monomial, coefficient) = polynomial.leading_term().expect("not zero");
    let short = coefficient.numerators().iter().all(|numerator| numerator.bits() <= MONIC);
    if monomial.degree() <= 1 && short {
        coefficient.inverse().expect("coefficients are not zero")
    } else {
        polynomial.primitive_factor()
    }
}

/// 1 from a non-zero constant.
pub(super) fn unit_from(
    derivation: &mut Derivation<'_>,
    constant: Source,
    control: &Control,
) -> Result<Option<Source>, Interrupted> {
    let inverse = derivation.polynomial(constant).as_constant().and_then(|constant| constant.inverse());
    inverse.map_or(Ok(None), |inverse| derivation.derive_scaled(constant, inverse, control))
}
