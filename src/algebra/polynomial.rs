//! Polynomials over K, sorted by decreasing monomials.

use std::collections::BTreeMap;

use super::field::{FieldElement, MultiquadraticField};
use super::integer::Integer;
use super::monomial::Monomial;
use crate::control::{Control, Interrupted};

/// Products of two terms between two questions whether to go on.
const PRODUCTS: usize = 64;

/// A polynomial in x₀, x₁, … with coefficients in K.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Polynomial {
    field: MultiquadraticField,
    /// Strictly decreasing monomials, no zero coefficients.
    terms: Vec<(Monomial, FieldElement)>,
}

impl Polynomial {
    /// 0.
    pub fn zero(field: MultiquadraticField) -> Self {
        Polynomial { field, terms: Vec::new() }
    }

    /// A constant.
    pub fn constant(value: FieldElement) -> Self {
        Polynomial::term(value, Monomial::one())
    }

    /// One variable.
    pub fn variable(field: MultiquadraticField, index: u16) -> Self {
        Polynomial::term(field.one(), Monomial::variable(index))
    }

    /// coefficient · monomial.
    pub fn term(coefficient: FieldElement, monomial: Monomial) -> Self {
        Polynomial::from_terms(coefficient.field(), [(monomial, coefficient)])
    }

    /// The sum of terms in any order; equal monomials are added.
    pub fn from_terms(
        field: MultiquadraticField,
        terms: impl IntoIterator<Item = (Monomial, FieldElement)>,
    ) -> Self {
        let mut sum = BTreeMap::new();
        for (monomial, coefficient) in terms {
            add_to(&mut sum, monomial, coefficient);
        }
        Polynomial { field, terms: sum.into_iter().rev().collect() }
    }

    /// K.
    pub fn field(&self) -> MultiquadraticField {
        self.field
    }

    /// The terms, by decreasing monomial.
    pub fn terms(&self) -> &[(Monomial, FieldElement)] {
        &self.terms
    }

    /// The terms themselves.
    pub fn into_terms(self) -> Vec<(Monomial, FieldElement)> {
        self.terms
    }

    /// The largest monomial with its coefficient, `None` for 0.
    pub fn leading_term(&self) -> Option<&(Monomial, FieldElement)> {
        self.terms.first()
    }

    /// Whether this is 0.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The value, if no variable occurs.
    pub fn as_constant(&self) -> Option<FieldElement> {
        match self.terms.as_slice() {
            [] => Some(self.field.zero()),
            [(monomial, value)] if monomial.degree() == 0 => Some(value.clone()),
            _ => None,
        }
    }

    /// The total degree, `None` for 0.
    pub fn degree(&self) -> Option<u32> {
        self.leading_term().map(|(monomial, _)| monomial.degree())
    }

    /// The coefficient of a monomial, `None` where it is 0.
    pub fn coefficient(&self, monomial: &Monomial) -> Option<&FieldElement> {
        let found = self.terms.binary_search_by(|(other, _)| monomial.cmp(other));
        found.ok().map(|index| &self.terms[index].1)
    }

    /// self + factor · other.
    pub fn add_scaled(&self, factor: &FieldElement, other: &Self) -> Self {
        let scaled = other.terms.iter().map(|(monomial, value)| (monomial.clone(), value * factor));
        Polynomial::from_terms(self.field, self.terms.iter().cloned().chain(scaled))
    }

    /// self + other.
    pub fn add(&self, other: &Self) -> Self {
        Polynomial::from_terms(self.field, self.terms.iter().chain(&other.terms).cloned())
    }

    /// factor · self.
    pub fn scaled(&self, factor: &FieldElement) -> Self {
        if factor.is_zero() {
            return Polynomial::zero(self.field);
        }
        let terms = self.terms.iter().map(|(monomial, value)| (monomial.clone(), value * factor)).collect();
        Polynomial { field: self.field, terms }
    }

    /// monomial · self.
    pub fn shifted(&self, monomial: &Monomial) -> Self {
        // An admissible order: multiplying by a monomial keeps the terms sorted.
        let terms = self.terms.iter().map(|(m, value)| (m.product(monomial), value.clone())).collect();
        Polynomial { field: self.field, terms }
    }

    /// self · other.
    pub fn multiply(&self, other: &Self) -> Self {
        let product = Polynomial::sum_of_products(self.field, [(self, other)], &Control::default());
        product.expect("nobody stops it")
    }

    /// Σ a·b over the given pairs.
    ///
    /// # Errors
    /// [`Control::check`]
    pub fn sum_of_products<'a>(
        field: MultiquadraticField,
        pairs: impl IntoIterator<Item = (&'a Polynomial, &'a Polynomial)>,
        control: &Control,
    ) -> Result<Self, Interrupted> {
        let mut sum = BTreeMap::new();
        let mut pace = control.every(PRODUCTS);
        for (x, y) in pairs {
            for (m, a) in &x.terms {
                for (n, b) in &y.terms {
                    pace.count(1)?;
                    add_to(&mut sum, m.product(n), a * b);
                }
            }
        }
        Ok(Polynomial { field, terms: sum.into_iter().rev().collect() })
    }

    /// The value at a point, given by variable.
    pub fn evaluate(&self, at: &[FieldElement]) -> FieldElement {
        let value = |(monomial, coefficient): &(Monomial, FieldElement)| {
            let powers = monomial.powers().iter();
            let factors =
                powers.flat_map(|&(v, exponent)| std::iter::repeat_n(&at[usize::from(v)], exponent as usize));
            factors.fold(coefficient.clone(), |product, factor| &product * factor)
        };
        self.terms.iter().fold(self.field.zero(), |sum, term| &sum + &value(term))
    }

    /// The same polynomial over a field that contains K.
    pub fn over(&self, larger: MultiquadraticField) -> Self {
        let terms = self.terms.iter().map(|(monomial, value)| (monomial.clone(), value.over(larger)));
        Polynomial { field: larger, terms: terms.collect() }
    }

    /// The variables that occur, increasing.
    pub fn variables(&self) -> Vec<u16> {
        let powers = self.terms.iter().flat_map(|(monomial, _)| monomial.powers());
        let mut variables: Vec<u16> = powers.map(|&(variable, _)| variable).collect();
        variables.sort_unstable();
        variables.dedup();
        variables
    }

    /// The positive rational that makes all coordinates of all coefficients integers without a common factor.
    pub fn primitive_factor(&self) -> FieldElement {
        let (mut divisor, mut multiple) = (Integer::zero(), Integer::one());
        for (_, value) in &self.terms {
            multiple = multiple.lcm(value.denominator());
        }
        for (_, value) in &self.terms {
            let scale = multiple.exact_quotient(value.denominator());
            for numerator in value.numerators().iter().filter(|numerator| !numerator.is_zero()) {
                divisor = divisor.gcd(&(numerator * &scale));
            }
        }
        if divisor.is_zero() { self.field.one() } else { self.field.rational(multiple, divisor) }
    }
}

fn add_to(sum: &mut BTreeMap<Monomial, FieldElement>, monomial: Monomial, value: FieldElement) {
    use std::collections::btree_map::Entry;
    match sum.entry(monomial) {
        Entry::Vacant(entry) if !value.is_zero() => {
            entry.insert(value);
        }
        Entry::Vacant(_) => {}
        Entry::Occupied(mut entry) => {
            let total = entry.get() + &value;
            if total.is_zero() {
                entry.remove();
            } else {
                entry.insert(total);
            }
        }
    }
}
