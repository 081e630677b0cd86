//! Polynomials in t and s at the ends of the parameters.

use crate::exact::Polynomial;

/// Where a parameter is at its end: the variable, and the exponent of what is left there.
#[derive(Clone, Copy)]
pub(super) struct End {
    pub(super) variable: u16,
    pub(super) exponent: u32,
}

/// What is left of a polynomial of degree D in t (or s) at t = 0, or of t^−D times it at t = ∞.
pub(super) fn at(polynomial: &Polynomial, end: End) -> Polynomial {
    let there = polynomial.terms().filter(|(monomial, _)| monomial.exponent(end.variable) == end.exponent);
    Polynomial::from_terms(there.map(|(monomial, value)| (monomial.lowered(end.variable, 0), value.clone())))
}

pub(super) fn derivative(polynomial: &Polynomial, variable: u16) -> Polynomial {
    let terms = polynomial.terms().filter_map(|(monomial, value)| {
        let exponent = monomial.exponent(variable);
        let lower = exponent.checked_sub(1)?;
        Some((monomial.lowered(variable, lower), value * num_bigint::BigInt::from(exponent)))
    });
    Polynomial::from_terms(terms)
}

/// A form of this degree in u and 1−u (or v) divided by u, or by 1−u, whichever vanishes at the end; `None` if it is not
/// divisible.
pub(super) fn without_factor(polynomial: &Polynomial, end: End, degree: &mut u32) -> Option<Polynomial> {
    *degree = degree.checked_sub(1)?;
    if end.exponent != 0 {
        let divisible = polynomial.terms().all(|(monomial, _)| monomial.exponent(end.variable) <= *degree);
        return divisible.then(|| polynomial.clone());
    }
    let mut terms = Vec::with_capacity(polynomial.term_count());
    for (monomial, value) in polynomial.terms() {
        let lower = monomial.exponent(end.variable).checked_sub(1)?;
        terms.push((monomial.lowered(end.variable, lower), value.clone()));
    }
    Some(Polynomial::from_terms(terms))
}
