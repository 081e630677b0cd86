//! Polynomials in t and s at the ends of the parameters.

use num_bigint::BigInt;

use crate::exact::{Arithmetic, Limit, Monomial, Polynomial};

/// Where a parameter is at its end: the variable, and the exponent of what is left there.
#[derive(Clone, Copy)]
pub(super) struct End {
    pub(super) variable: u16,
    pub(super) exponent: u32,
}

/// What is left of a polynomial of degree D in t (or s) at t = 0, or of t^−D times it at t = ∞.
pub(super) fn at(
    polynomial: &Polynomial,
    end: End,
    arithmetic: &mut Arithmetic<'_>,
) -> Result<Polynomial, Limit> {
    arithmetic.changed(polynomial, |monomial, value, _| {
        let there = monomial.exponent(end.variable) == end.exponent;
        Ok(there.then(|| (monomial.lowered(end.variable, 0), value.clone())))
    })
}

pub(super) fn derivative(
    polynomial: &Polynomial,
    variable: u16,
    arithmetic: &mut Arithmetic<'_>,
) -> Result<Polynomial, Limit> {
    arithmetic.changed(polynomial, |monomial, value, work| {
        let exponent = monomial.exponent(variable);
        let Some(lower) = exponent.checked_sub(1) else { return Ok(None) };
        Ok(Some((monomial.lowered(variable, lower), work.multiple(value, &BigInt::from(exponent))?)))
    })
}

/// A form of this degree in u and 1−u (or v) divided by u, or by 1−u, whichever vanishes at the end; `None` if it is not
/// divisible.
pub(super) fn without_factor(
    polynomial: &Polynomial,
    end: End,
    degree: &mut u32,
    arithmetic: &mut Arithmetic<'_>,
) -> Result<Option<Polynomial>, Limit> {
    let Some(lower) = degree.checked_sub(1) else { return Ok(None) };
    *degree = lower;
    let exponent = |monomial: &Monomial| monomial.exponent(end.variable);
    arithmetic.charge_look(polynomial)?;
    if end.exponent != 0 {
        let divisible = polynomial.terms().all(|(monomial, _)| exponent(monomial) <= lower);
        return if divisible { arithmetic.copied(polynomial).map(Some) } else { Ok(None) };
    }
    if polynomial.terms().any(|(monomial, _)| exponent(monomial) == 0) {
        return Ok(None);
    }
    let divided = arithmetic.changed(polynomial, |monomial, value, _| {
        let lower = exponent(monomial).saturating_sub(1);
        Ok(Some((monomial.lowered(end.variable, lower), value.clone())))
    })?;
    Ok(Some(divided))
}
