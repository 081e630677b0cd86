//! Σ multiplier · premise: the one sum of products that all trusted arithmetic goes through.

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::limits;
use super::monomial::Monomial;
use super::polynomial::Polynomial;
use super::radicands::Radicands;
use super::work::{Limit, Work};

/// What a call costs at least.
const CALL: u64 = 1000;

/// Σ aᵢ·bᵢ over the given pairs.
///
/// All products are brought over one common denominator first, so that the inner loop multiplies and adds
/// integers only; fractions are reduced once, at the end. Everything is charged before it is done.
pub fn combination(
    pairs: &[(&Polynomial, &Polynomial)],
    field: &Radicands,
    work: &mut Work,
) -> Result<Polynomial, Limit> {
    work.charge(CALL)?;
    for (a, b) in pairs {
        work.charge_pairs((a.term_count(), b.term_count()), (a.power_count(), b.power_count()))?;
    }
    let mut denominator = BigInt::one();
    let mut denominators = Vec::with_capacity(pairs.len());
    for (a, b) in pairs {
        let (left, right) = (common_denominator(a, work)?, common_denominator(b, work)?);
        let product = checked_product(&left, &right, work)?;
        denominator = checked_lcm(&denominator, &product, work)?;
        denominators.push((left, right, product));
    }

    let mut sum: BTreeMap<Monomial, BigInt> = BTreeMap::new();
    let (mut powers, mut bits) = (0usize, 0u64);
    for ((a, b), (left, right, product)) in pairs.iter().zip(&denominators) {
        work.charge_product(left, &denominator)?;
        let factor = left * (&denominator / product);
        let (a, b) = (integral(a, &factor, work)?, integral(b, right, work)?);
        for (m, x) in &a {
            for (n, y) in &b {
                let (monomial, met) = m.product(n)?;
                let mut value = checked_product(x, y, work)?;
                if met != 0 {
                    value *= field.under_root(met);
                }
                let length = monomial.powers().len();
                let size = value.bits();
                let cell = sum.entry(monomial).or_insert_with(|| {
                    powers = powers.saturating_add(length);
                    bits = bits.saturating_add(size);
                    BigInt::ZERO
                });
                *cell += value;
                if bits > limits::SUM_BITS {
                    return Err(Limit::new("bits in the numbers of a sum", limits::SUM_BITS));
                }
                if powers > limits::POWERS {
                    return Err(Limit::new("powers of variables in a polynomial", 10_000_000));
                }
            }
            if sum.len() > limits::TERMS {
                return Err(Limit::terms());
            }
        }
    }

    let mut terms = Vec::with_capacity(sum.len());
    for (monomial, value) in sum.into_iter().filter(|(_, value)| !value.is_zero()) {
        if denominator.is_one() {
            terms.push((monomial, BigRational::from_integer(value)));
        } else {
            work.charge_gcd(&value, &denominator)?;
            terms.push((monomial, BigRational::new(value, denominator.clone())));
        }
    }
    Ok(Polynomial::from_terms(terms))
}

/// The terms multiplied by `factor`, a multiple of every denominator.
fn integral(
    polynomial: &Polynomial,
    factor: &BigInt,
    work: &mut Work,
) -> Result<Vec<(Monomial, BigInt)>, Limit> {
    let mut terms = Vec::with_capacity(polynomial.term_count());
    for (monomial, value) in polynomial.terms() {
        work.charge_term(monomial)?;
        work.charge_product(factor, factor)?;
        terms.push((monomial.clone(), checked_product(&(factor / value.denom()), value.numer(), work)?));
    }
    Ok(terms)
}

fn common_denominator(polynomial: &Polynomial, work: &mut Work) -> Result<BigInt, Limit> {
    let mut denominator = BigInt::one();
    for (_, value) in polynomial.terms() {
        if !value.denom().is_one() && *value.denom() != denominator {
            denominator = checked_lcm(&denominator, value.denom(), work)?;
        }
    }
    Ok(denominator)
}

fn checked_lcm(a: &BigInt, b: &BigInt, work: &mut Work) -> Result<BigInt, Limit> {
    if b.is_one() || a == b {
        return Ok(a.clone());
    }
    work.charge_gcd(a, b)?;
    // a and gcd(a, b) divide without remainder: the product is no longer than both factors together.
    checked_product(&(a / a.gcd(b)), b, work)
}

/// The product, refused where it would be absurdly long: many large denominators without common factors would
/// otherwise turn a small file into a huge number.
fn checked_product(a: &BigInt, b: &BigInt, work: &mut Work) -> Result<BigInt, Limit> {
    if a.bits().saturating_add(b.bits()) > limits::BITS {
        return Err(Limit::new("bits of an intermediate number", limits::BITS));
    }
    work.charge_product(a, b)?;
    Ok(a * b)
}
