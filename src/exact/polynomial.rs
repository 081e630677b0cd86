//! Polynomials over K as maps from basis elements to non-zero rationals.

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::combination::combination;
use super::limits;
use super::monomial::Monomial;
use super::radicands::Radicands;
use super::work::{Limit, Work};

/// A polynomial with coefficients in K; a constant of K is one without variables.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Polynomial {
    /// No coefficient is zero.
    terms: BTreeMap<Monomial, BigRational>,
}

impl Polynomial {
    /// 0.
    pub fn zero() -> Self {
        Polynomial::default()
    }

    /// A rational constant.
    pub fn rational(value: BigRational) -> Self {
        Polynomial::term(value, Monomial::one())
    }

    /// An integer constant.
    pub fn integer(value: impl Into<BigInt>) -> Self {
        Polynomial::rational(BigRational::from_integer(value.into()))
    }

    /// The variable with this index.
    pub fn variable(index: u16) -> Self {
        match Monomial::new(0, vec![(index, 1)]) {
            Some(Ok(monomial)) => Polynomial::term(BigRational::one(), monomial),
            _ => Polynomial::zero(), // not reached: one variable to the first power is well formed
        }
    }

    /// `coefficient · monomial`.
    pub fn term(coefficient: BigRational, monomial: Monomial) -> Self {
        Polynomial::from_terms([(monomial, coefficient)])
    }

    /// A sum of terms, given in any order; the coefficients of equal monomials are *not* added.
    pub fn from_terms(terms: impl IntoIterator<Item = (Monomial, BigRational)>) -> Self {
        Polynomial { terms: terms.into_iter().filter(|(_, coefficient)| !coefficient.is_zero()).collect() }
    }

    /// The terms in the order of spelling.
    pub fn terms(&self) -> impl ExactSizeIterator<Item = (&Monomial, &BigRational)> {
        self.terms.iter()
    }

    /// The number of terms `rational · √n · power product`.
    pub fn term_count(&self) -> usize {
        self.terms.len()
    }

    /// Whether this is 0.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Whether this is 1.
    pub fn is_one(&self) -> bool {
        *self == Polynomial::integer(1)
    }

    /// Whether no variable occurs.
    pub fn is_constant(&self) -> bool {
        self.degree() == 0
    }

    /// The total degree; 0 for the zero polynomial.
    pub fn degree(&self) -> u32 {
        self.terms.keys().map(Monomial::degree).max().unwrap_or(0)
    }

    /// The value, if it is rational.
    pub fn as_rational(&self) -> Option<BigRational> {
        match self.terms.first_key_value() {
            None => Some(BigRational::zero()),
            Some((monomial, value)) if self.term_count() == 1 && *monomial == Monomial::one() => {
                Some(value.clone())
            }
            Some(_) => None,
        }
    }

    /// `self + other`.
    pub fn add(&self, other: &Self, work: &mut Work) -> Result<Self, Limit> {
        work.charge_terms(self.term_count().saturating_add(other.term_count()))?;
        let mut terms = self.terms.clone();
        for (monomial, value) in &other.terms {
            let sum = terms.remove(monomial).unwrap_or_else(BigRational::zero) + value;
            if !sum.is_zero() {
                terms.insert(monomial.clone(), sum);
            }
        }
        if terms.len() > limits::TERMS {
            return Err(Limit::terms());
        }
        Ok(Polynomial { terms })
    }

    /// `−self`.
    pub fn negate(&self) -> Self {
        Polynomial { terms: self.terms.iter().map(|(m, value)| (m.clone(), -value)).collect() }
    }

    /// `self · other`.
    pub fn multiply(&self, other: &Self, field: &Radicands, work: &mut Work) -> Result<Self, Limit> {
        combination(&[(self, other)], field, work)
    }

    /// `self` to a power, by repeated multiplication.
    pub fn power(&self, exponent: u32, field: &Radicands, work: &mut Work) -> Result<Self, Limit> {
        let mut product = Polynomial::integer(1);
        for _ in 0..exponent {
            product = product.multiply(self, field, work)?;
        }
        Ok(product)
    }

    /// 1/self for a non-zero constant of K, `None` otherwise.
    ///
    /// x·σ(x) is fixed by σ: √d ↦ −√d, so after one such step for each radicand a rational is left.
    pub fn inverse(&self, field: &Radicands, work: &mut Work) -> Result<Option<Self>, Limit> {
        if self.is_zero() || !self.is_constant() {
            return Ok(None);
        }
        let (mut norm, mut cofactor) = (self.clone(), Polynomial::integer(1));
        for bit in field.generators() {
            let conjugate = norm.conjugate(bit);
            cofactor = cofactor.multiply(&conjugate, field, work)?;
            norm = norm.multiply(&conjugate, field, work)?;
        }
        match norm.as_rational() {
            Some(value) if !value.is_zero() => {
                let inverse = Polynomial::rational(value.recip());
                Ok(Some(cofactor.multiply(&inverse, field, work)?))
            }
            _ => Ok(None),
        }
    }

    /// The image under √d ↦ −√d for the radicand in `bit`.
    fn conjugate(&self, bit: u8) -> Self {
        let flip = |(m, value): (&Monomial, &BigRational)| {
            (m.clone(), if m.mask() & bit == 0 { value.clone() } else { -value })
        };
        Polynomial { terms: self.terms.iter().map(flip).collect() }
    }

    /// The value at `variable k = values[k]`; variables beyond the list stay.
    pub fn substitute(
        &self,
        values: &[Polynomial],
        field: &Radicands,
        work: &mut Work,
    ) -> Result<Self, Limit> {
        let mut sum = Polynomial::zero();
        for (monomial, coefficient) in &self.terms {
            let mut product = Polynomial::term(coefficient.clone(), Monomial::radical(monomial.mask()));
            for &(variable, exponent) in monomial.powers() {
                let value = values.get(usize::from(variable)).cloned();
                let value = value.unwrap_or_else(|| Polynomial::variable(variable));
                product = product.multiply(&value.power(exponent, field, work)?, field, work)?;
            }
            sum = sum.add(&product, work)?;
        }
        Ok(sum)
    }
}
