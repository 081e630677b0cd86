//! Arithmetic of polynomials over K, on account: the one thing of the kernel that calculates with them.
//!
//! Everything is a sum of products, [`Arithmetic::dot`]. All products are brought over one common denominator
//! first, so that the inner loop multiplies and adds integers only; fractions are reduced once, at the end.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::limits::{self, Limit};
use super::monomial::Monomial;
use super::numbers::{self, words};
use super::polynomial::Polynomial;
use super::radicands::Radicands;
use super::work::{Work, count};

/// A field, and the work that may still be done in it.
pub struct Arithmetic<'a> {
    pub(crate) field: &'a Radicands,
    pub(crate) work: &'a mut Work,
}

impl<'a> Arithmetic<'a> {
    /// Arithmetic in polynomials over `field`, for which `work` pays.
    pub fn new(field: &'a Radicands, work: &'a mut Work) -> Self {
        Arithmetic { field, work }
    }

    /// Σ aᵢ·bᵢ over the given pairs.
    ///
    /// # Errors
    /// Where a limit is reached, as everywhere here.
    pub fn dot(&mut self, pairs: &[(&Polynomial, &Polynomial)]) -> Result<Polynomial, Limit> {
        self.alone(|this| this.sum_of_products(pairs))
    }

    /// What `polynomial` comes to, all else that it takes memory for being given back.
    pub(crate) fn alone(
        &mut self,
        polynomial: impl FnOnce(&mut Self) -> Result<Polynomial, Limit>,
    ) -> Result<Polynomial, Limit> {
        let held = self.work.held();
        let result = polynomial(self)?;
        self.work.release_to(held);
        self.work.hold(Arithmetic::memory(&result))?;
        Ok(result)
    }

    fn sum_of_products(&mut self, pairs: &[(&Polynomial, &Polynomial)]) -> Result<Polynomial, Limit> {
        self.work.charge(Work::CALL)?;
        self.work.keep_each(pairs.len(), 128)?;
        for (a, b) in pairs {
            self.charge_pairs(a, b)?;
        }
        let mut denominator = BigInt::one();
        let mut denominators = Vec::with_capacity(pairs.len());
        for (a, b) in pairs {
            let (left, right) = (self.common_denominator(a)?, self.common_denominator(b)?);
            let product = self.work.product(&left, &right)?;
            denominator = self.work.common_multiple(&denominator, &product)?;
            let bytes = [&left, &right, &product].into_iter().map(numbers::bytes);
            self.work.keep(bytes.fold(0, u64::saturating_add))?;
            denominators.push((left, right, product));
        }
        let mut sum = Sum::default();
        for ((a, b), (left, right, product)) in pairs.iter().zip(&denominators) {
            let cofactor = self.work.quotient(&denominator, product)?;
            let factor = self.work.product(left, &cofactor)?;
            let (a, b) = (self.integral(a, &factor)?, self.integral(b, right)?);
            for (m, x) in &a {
                for (n, y) in &b {
                    let (monomial, met) = m.product(n)?;
                    let mut value = self.work.product(x, y)?;
                    if met != 0 {
                        let root = self.field.under_root(met).ok_or(limits::FOREIGN_ROOTS)?;
                        value = self.work.product(&value, root)?;
                    }
                    sum.add(monomial, value, self.work)?;
                }
            }
        }
        sum.over(&denominator, self.work)
    }

    /// All pairs of terms of two polynomials.
    fn charge_pairs(&mut self, a: &Polynomial, b: &Polynomial) -> Result<(), Limit> {
        let counts = (count(a.term_count()), count(b.term_count()));
        // Counting the powers is work too.
        self.work.charge(counts.0.saturating_add(counts.1).saturating_mul(4))?;
        let powers = (count(a.power_count()), count(b.power_count()));
        let powers = powers.0.saturating_mul(counts.1).saturating_add(powers.1.saturating_mul(counts.0));
        let pairs = counts.0.saturating_mul(counts.1).saturating_mul(Work::TERM);
        self.work.charge(pairs.saturating_add(powers.saturating_mul(Work::POWER)))
    }

    fn common_denominator(&mut self, polynomial: &Polynomial) -> Result<BigInt, Limit> {
        let mut denominator = BigInt::one();
        for (_, value) in polynomial.terms() {
            if !value.denom().is_one() && *value.denom() != denominator {
                denominator = self.work.common_multiple(&denominator, value.denom())?;
            }
        }
        Ok(denominator)
    }

    /// The terms multiplied by `factor`, a multiple of every denominator.
    fn integral<'p>(
        &mut self,
        polynomial: &'p Polynomial,
        factor: &BigInt,
    ) -> Result<Vec<(&'p Monomial, Cow<'p, BigInt>)>, Limit> {
        self.work.keep_each(polynomial.term_count(), 64)?;
        let mut terms = Vec::with_capacity(polynomial.term_count());
        for (monomial, value) in polynomial.terms() {
            let scaled = if factor == value.denom() {
                Cow::Borrowed(value.numer())
            } else {
                let factor = self.work.quotient(factor, value.denom())?;
                let product = self.work.product(&factor, value.numer())?;
                self.work.keep(numbers::bytes(&product))?;
                Cow::Owned(product)
            };
            terms.push((monomial, scaled));
        }
        Ok(terms)
    }

    /// a·b.
    ///
    /// # Errors
    /// See [`Arithmetic::dot`].
    pub fn product(&mut self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Limit> {
        self.dot(&[(a, b)])
    }

    /// The sum of polynomials.
    ///
    /// # Errors
    /// See [`Arithmetic::dot`].
    pub fn sum(&mut self, of: &[Polynomial]) -> Result<Polynomial, Limit> {
        let one = Polynomial::integer(1);
        self.work.keep_each(of.len(), 16)?;
        let pairs: Vec<(&Polynomial, &Polynomial)> = of.iter().map(|summand| (&one, summand)).collect();
        self.dot(&pairs)
    }

    /// a − b.
    ///
    /// # Errors
    /// See [`Arithmetic::dot`].
    pub fn difference(&mut self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Limit> {
        self.dot(&[(&Polynomial::integer(1), a), (&Polynomial::integer(-1), b)])
    }

    /// aⁿ, by repeated multiplication.
    ///
    /// # Errors
    /// See [`Arithmetic::dot`].
    pub fn power(&mut self, a: &Polynomial, exponent: u32) -> Result<Polynomial, Limit> {
        self.alone(|this| {
            let mut product = this.copied(&Polynomial::integer(1))?;
            for _ in 0..exponent {
                let next = this.product(&product, a)?;
                this.let_go(product);
                product = next;
            }
            Ok(product)
        })
    }

    /// −a.
    ///
    /// # Errors
    /// See [`Arithmetic::dot`].
    pub fn negated(&mut self, a: &Polynomial) -> Result<Polynomial, Limit> {
        self.charge_copy(a)?;
        Ok(a.negate())
    }

    /// Keeping, or copying, a polynomial.
    ///
    /// # Errors
    /// See [`Arithmetic::dot`].
    pub fn charge_copy(&mut self, a: &Polynomial) -> Result<(), Limit> {
        self.work.keep(Arithmetic::memory(a))
    }

    /// The memory of a polynomial, where it stands and beyond.
    fn memory(a: &Polynomial) -> u64 {
        a.bytes().saturating_add(64)
    }

    /// Gives back the memory of a polynomial that was held.
    pub(crate) fn let_go(&mut self, a: Polynomial) {
        self.work.release(Arithmetic::memory(&a));
    }

    /// Looking a polynomial up among others, or comparing it.
    pub(crate) fn charge_look(&mut self, a: &Polynomial) -> Result<(), Limit> {
        self.work.charge(a.bytes().saturating_add(Work::TERM))
    }

    /// A copy.
    pub(crate) fn copied(&mut self, a: &Polynomial) -> Result<Polynomial, Limit> {
        self.charge_copy(a)?;
        Ok(a.clone())
    }

    /// A polynomial from terms in any order, each monomial once.
    pub(crate) fn gathered(&mut self, terms: Vec<(Monomial, BigRational)>) -> Result<Polynomial, Limit> {
        // Sorting takes some twenty comparisons of each.
        let powers =
            terms.iter().fold(0usize, |sum, (monomial, _)| sum.saturating_add(monomial.powers().len()));
        self.work.charge_each(terms.len(), Work::TERM)?;
        self.work.charge_each(powers, Work::POWER)?;
        Ok(Polynomial::from_terms(terms))
    }

    /// The terms for which `change` has something, changed; a copy is paid for.
    pub(crate) fn changed(
        &mut self,
        a: &Polynomial,
        mut change: impl FnMut(
            &Monomial,
            &BigRational,
            &mut Work,
        ) -> Result<Option<(Monomial, BigRational)>, Limit>,
    ) -> Result<Polynomial, Limit> {
        self.charge_copy(a)?;
        let mut terms = Vec::with_capacity(a.term_count());
        for (monomial, value) in a.terms() {
            terms.extend(change(monomial, value, self.work)?);
        }
        self.gathered(terms)
    }

    /// 1/a for a non-zero constant of K, `None` otherwise.
    ///
    /// x·σ(x) is fixed by σ: √d ↦ −√d, so after one such step for each radicand a rational is left.
    ///
    /// # Errors
    /// See [`Arithmetic::dot`].
    pub fn inverse(&mut self, a: &Polynomial) -> Result<Option<Polynomial>, Limit> {
        if a.is_zero() || !a.is_constant() {
            return Ok(None);
        }
        let (mut norm, mut cofactor) = (self.copied(a)?, Polynomial::integer(1));
        for bit in self.field.generators() {
            if norm.mask() & bit != 0 {
                let conjugate = self.conjugate(&norm, bit)?;
                cofactor = self.product(&cofactor, &conjugate)?;
                norm = self.product(&norm, &conjugate)?;
            }
        }
        match norm.as_rational() {
            Some(value) if !value.is_zero() => {
                let inverse = Polynomial::rational(self.work.reciprocal(&value)?);
                Ok(Some(self.product(&cofactor, &inverse)?))
            }
            _ => Ok(None),
        }
    }

    /// The image under √d ↦ −√d for the radicand in `bit`.
    fn conjugate(&mut self, a: &Polynomial, bit: u8) -> Result<Polynomial, Limit> {
        self.changed(a, |monomial, value, _| {
            let value = value.clone();
            Ok(Some((
                monomial.clone(),
                if monomial.mask() & bit == 0 { value } else { numbers::negated(value) },
            )))
        })
    }

    /// The sum of the terms without and of those with √d, for the radicand d in `bit`.
    pub(super) fn parts(&mut self, a: &Polynomial, bit: u8) -> Result<(Polynomial, Polynomial), Limit> {
        let mut part = |with_root: bool| {
            self.changed(a, |monomial, value, _| {
                let belongs = (monomial.mask() & bit != 0) == with_root;
                Ok(belongs.then(|| (monomial.clone(), value.clone())))
            })
        };
        Ok((part(false)?, part(true)?))
    }
}

/// A sum of integral terms, like ones collected.
#[derive(Default)]
struct Sum {
    cells: BTreeMap<Monomial, BigInt>,
    powers: u64,
    bits: u64,
}

impl Sum {
    /// The memory of a cell, beside that of its monomial and its number: a node of the tree has room for 11
    /// and is filled with
    /// 5 at least.
    const CELL: u64 = 192;

    fn add(&mut self, monomial: Monomial, value: BigInt, work: &mut Work) -> Result<(), Limit> {
        let cells = self.cells.len();
        match self.cells.entry(monomial) {
            Entry::Occupied(mut cell) => work.add(cell.get_mut(), &value),
            Entry::Vacant(cell) => {
                limits::TERMS.check(count(cells).saturating_add(1))?;
                self.powers = self.powers.saturating_add(count(cell.key().powers().len()));
                limits::POWERS.check(self.powers)?;
                self.bits = self.bits.saturating_add(value.bits());
                limits::SUM_BITS.check(self.bits)?;
                let words = words(&value).saturating_add(1).saturating_mul(8);
                work.keep(cell.key().bytes().saturating_add(words).saturating_add(Sum::CELL))?;
                cell.insert(value);
                Ok(())
            }
        }
    }

    /// The sum over a denominator, in lowest terms.
    fn over(self, denominator: &BigInt, work: &mut Work) -> Result<Polynomial, Limit> {
        work.keep_each(self.cells.len(), 192)?;
        let mut terms = Vec::with_capacity(self.cells.len());
        for (monomial, value) in self.cells {
            if !value.is_zero() {
                terms.push((monomial, work.ratio(value, denominator)?));
            }
        }
        work.charge_each(terms.len(), Work::POWER)?;
        Ok(Polynomial::from_terms(terms))
    }
}
