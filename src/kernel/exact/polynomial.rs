//! Polynomials over K as sums of basis elements with non-zero rational coefficients.

use std::hash::{Hash, Hasher};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::combination::combination;
use super::monomial::Monomial;
use super::radicands::Radicands;
use super::work::{Limit, Work};

/// A polynomial with coefficients in K; a constant of K is one without variables.
#[derive(Debug, Clone, Default)]
pub struct Polynomial {
    /// In the order of spelling, each monomial once, no coefficient zero, all in lowest terms.
    terms: Vec<(Monomial, BigRational)>,
}

/// Equality by numerators and denominators. (`Ratio` compares and hashes by continued fractions, recursively:
/// two long numbers would exhaust the stack.)
impl PartialEq for Polynomial {
    fn eq(&self, other: &Self) -> bool {
        let same = |((m, a), (n, b)): (&(Monomial, BigRational), &(Monomial, BigRational))| {
            m == n && a.numer() == b.numer() && a.denom() == b.denom()
        };
        self.terms.len() == other.terms.len() && self.terms.iter().zip(&other.terms).all(same)
    }
}

impl Eq for Polynomial {}

impl Hash for Polynomial {
    fn hash<H: Hasher>(&self, state: &mut H) {
        for (monomial, value) in &self.terms {
            monomial.hash(state);
            value.numer().hash(state);
            value.denom().hash(state);
        }
    }
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

    /// A sum of terms, in any order, each monomial once.
    pub fn from_terms(terms: impl IntoIterator<Item = (Monomial, BigRational)>) -> Self {
        let mut terms: Vec<_> = terms.into_iter().filter(|(_, value)| !value.is_zero()).collect();
        if !terms.is_sorted_by(|(a, _), (b, _)| a < b) {
            terms.sort_by(|(a, _), (b, _)| a.cmp(b));
        }
        terms.shrink_to_fit();
        Polynomial { terms }
    }

    /// The terms in the order of spelling.
    pub fn terms(&self) -> impl ExactSizeIterator<Item = (&Monomial, &BigRational)> {
        self.terms.iter().map(|(monomial, value)| (monomial, value))
    }

    /// The number of terms `rational · √n · power product`.
    pub fn term_count(&self) -> usize {
        self.terms.len()
    }

    /// The number of powers of variables in all terms.
    pub fn power_count(&self) -> usize {
        self.terms.iter().fold(0, |sum, (monomial, _)| monomial.powers().len().saturating_add(sum))
    }

    /// The bits of all numerators and denominators.
    pub fn bit_count(&self) -> u64 {
        let bits = |value: &BigRational| value.numer().bits().saturating_add(value.denom().bits());
        self.terms.iter().fold(0, |sum, (_, value)| bits(value).saturating_add(sum))
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
        self.terms.iter().map(|(monomial, _)| monomial.degree()).max().unwrap_or(0)
    }

    /// The radicands that occur, as one mask.
    pub fn mask(&self) -> u8 {
        self.terms.iter().fold(0, |all, (monomial, _)| all | monomial.mask())
    }

    /// The value, if it is rational.
    pub fn as_rational(&self) -> Option<BigRational> {
        match self.terms.as_slice() {
            [] => Some(BigRational::zero()),
            [(monomial, value)] if *monomial == Monomial::one() => Some(value.clone()),
            _ => None,
        }
    }

    /// The sum of polynomials.
    pub fn sum(of: &[Polynomial], field: &Radicands, work: &mut Work) -> Result<Self, Limit> {
        let one = Polynomial::integer(1);
        let pairs: Vec<(&Polynomial, &Polynomial)> = of.iter().map(|summand| (&one, summand)).collect();
        combination(&pairs, field, work)
    }

    /// `−self`.
    pub fn negate(&self) -> Self {
        Polynomial { terms: self.terms.iter().map(|(monomial, value)| (monomial.clone(), -value)).collect() }
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
            if norm.mask() & bit != 0 {
                let conjugate = norm.conjugate(bit);
                cofactor = cofactor.multiply(&conjugate, field, work)?;
                norm = norm.multiply(&conjugate, field, work)?;
            }
        }
        match norm.as_rational() {
            Some(value) if !value.is_zero() => {
                let inverse = Polynomial::rational(value.recip());
                Ok(Some(cofactor.multiply(&inverse, field, work)?))
            }
            _ => Ok(None),
        }
    }

    /// The sum of the terms without and of those with √d, for the radicand d in `bit`.
    pub(super) fn parts(&self, bit: u8) -> (Self, Self) {
        let part = |with_root: bool| {
            let terms = self.terms().filter(|(monomial, _)| (monomial.mask() & bit != 0) == with_root);
            Polynomial::from_terms(terms.map(|(monomial, value)| (monomial.clone(), value.clone())))
        };
        (part(false), part(true))
    }

    /// The image under √d ↦ −√d for the radicand in `bit`.
    fn conjugate(&self, bit: u8) -> Self {
        let flip = |(monomial, value): &(Monomial, BigRational)| {
            (monomial.clone(), if monomial.mask() & bit == 0 { value.clone() } else { -value })
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
        let mut products = Vec::with_capacity(self.terms.len());
        for (monomial, coefficient) in &self.terms {
            let mut product = Polynomial::term(coefficient.clone(), Monomial::radical(monomial.mask()));
            for &(variable, exponent) in monomial.powers() {
                let value = values.get(usize::from(variable)).cloned();
                let value = value.unwrap_or_else(|| Polynomial::variable(variable));
                product = product.multiply(&value.power(exponent, field, work)?, field, work)?;
            }
            products.push(product);
        }
        Polynomial::sum(&products, field, work)
    }
}
