//! Polynomials over K as sums of basis elements with non-zero rational coefficients. What is calculated with
//! them is in [`super::Arithmetic`].

use std::hash::{Hash, Hasher};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::monomial::Monomial;
use super::numbers;

/// A basis element of K[x₀, x₁, …] over Q and what stands in front of it.
type Term = (Monomial, BigRational);

/// A polynomial with coefficients in K; a constant of K is one without variables.
#[derive(Debug, Clone, Default)]
pub struct Polynomial {
    /// In the order of spelling, each monomial once, no coefficient zero, all in lowest terms.
    terms: Vec<Term>,
    /// The memory of the terms.
    bytes: u64,
}

/// Equality by numerators and denominators. (`Ratio` compares and hashes by continued fractions, recursively:
/// two long numbers would exhaust the stack.)
impl PartialEq for Polynomial {
    fn eq(&self, other: &Self) -> bool {
        let same =
            |((m, a), (n, b)): (&Term, &Term)| m == n && a.numer() == b.numer() && a.denom() == b.denom();
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
        Polynomial::term(BigRational::one(), Monomial::variable(index))
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
        let bytes = terms.iter().fold(0u64, |sum, (monomial, value)| {
            sum.saturating_add(Polynomial::bytes_of(monomial, value.numer(), value.denom()))
        });
        Polynomial { terms, bytes }
    }

    /// The memory of one term.
    pub(crate) fn bytes_of(monomial: &Monomial, numerator: &BigInt, denominator: &BigInt) -> u64 {
        const TERM: u64 = 96;
        let numbers = numbers::bytes(numerator).saturating_add(numbers::bytes(denominator));
        monomial.bytes().saturating_add(numbers).saturating_add(TERM)
    }

    /// The memory of all terms.
    pub(crate) fn bytes(&self) -> u64 {
        self.bytes
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
        // The order of spelling has the largest degree first.
        self.terms.first().map_or(0, |(monomial, _)| monomial.degree())
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

    /// −self, a sign at each term; for those who need not account for the copy.
    pub fn negate(&self) -> Self {
        let negated = |(monomial, value): &Term| (monomial.clone(), numbers::negated(value.clone()));
        Polynomial { terms: self.terms.iter().map(negated).collect(), bytes: self.bytes }
    }
}
