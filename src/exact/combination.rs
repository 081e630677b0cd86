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

/// Σ aᵢ·bᵢ over the given pairs.
///
/// All products are brought over one common denominator first, so that the inner loop multiplies and adds
/// integers only; fractions are reduced once, at the end. Costs one unit of [`Work`] for each product of
/// words and 64 for each pair of terms, charged before anything is multiplied.
pub fn combination(
    pairs: &[(&Polynomial, &Polynomial)],
    field: &Radicands,
    work: &mut Work,
) -> Result<Polynomial, Limit> {
    for (a, b) in pairs {
        work.charge_terms(a.term_count().saturating_mul(b.term_count()))?;
        work.charge_terms(a.term_count().saturating_add(b.term_count()))?;
    }
    let mut denominator = BigInt::one();
    let mut denominators = Vec::with_capacity(pairs.len());
    for (a, b) in pairs {
        let (left, right) = (common_denominator(a, work)?, common_denominator(b, work)?);
        work.charge_product(&left, &right)?;
        let product = &left * &right;
        denominator = checked_lcm(&denominator, &product, work)?;
        denominators.push((left, right, product));
    }

    let mut sum: BTreeMap<Monomial, BigInt> = BTreeMap::new();
    let roots: Vec<BigInt> = field.masks().map(|mask| field.under_root(mask)).collect();
    for ((a, b), (left, right, product)) in pairs.iter().zip(&denominators) {
        let factor = left * (&denominator / product);
        let (a, b) = (integral(a, &factor, work)?, integral(b, right, work)?);
        for (m, x) in &a {
            for (n, y) in &b {
                work.charge_product(x, y)?;
                let (monomial, met) = m.product(n)?;
                let mut value = x * y;
                if met != 0 {
                    value *= roots.get(usize::from(met)).unwrap_or(&BigInt::ZERO);
                }
                *sum.entry(monomial).or_insert(BigInt::ZERO) += value;
            }
            if sum.len() > limits::TERMS {
                return Err(Limit::terms());
            }
        }
    }

    let mut terms = Vec::with_capacity(sum.len());
    for (monomial, value) in sum.into_iter().filter(|(_, value)| !value.is_zero()) {
        work.charge_product(&value, &denominator)?;
        terms.push((monomial, BigRational::new(value, denominator.clone())));
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
        work.charge_product(factor, value.numer())?;
        terms.push((monomial.clone(), factor / value.denom() * value.numer()));
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

/// The least common multiple, refused where it would be absurdly long: many large denominators without
/// common factors would otherwise turn a small file into a huge number.
fn checked_lcm(a: &BigInt, b: &BigInt, work: &mut Work) -> Result<BigInt, Limit> {
    /// Bits of a common denominator: a few times the longest denominator allowed.
    const BITS: u64 = 1 << 17;
    if a.bits().saturating_add(b.bits()) > BITS {
        return Err(Limit::new("bits of a common denominator", BITS));
    }
    // A greatest common divisor takes about one subtraction for each bit.
    work.charge_product(a, b)?;
    work.charge(a.bits().saturating_add(b.bits()).saturating_mul(a.bits().max(b.bits()).div_ceil(64)))?;
    Ok(a.lcm(b))
}
