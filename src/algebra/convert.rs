//! Between the trusted polynomials of statements and certificates and the prover's own.

use num_rational::BigRational;

use super::field::MultiquadraticField;
use super::integer::Integer;
use super::monomial::Monomial;
use super::polynomial::Polynomial;
use crate::exact;

/// A polynomial of a statement as one to compute with.
pub fn polynomial_from_exact(field: MultiquadraticField, polynomial: &exact::Polynomial) -> Polynomial {
    let term = |(monomial, value): (&exact::Monomial, &BigRational)| {
        let mut numerators = vec![Integer::zero(); field.degree()];
        numerators[usize::from(monomial.mask())] = Integer::from_bigint(value.numer());
        let coefficient = field.element(numerators, Integer::from_bigint(value.denom()));
        (Monomial::from_powers(monomial.powers().to_vec()), coefficient)
    };
    Polynomial::from_terms(field, polynomial.terms().map(term))
}

/// A polynomial to be written into a certificate.
///
/// # Errors
/// Where a degree exceeds what the format allows.
pub fn polynomial_to_exact(polynomial: &Polynomial) -> Result<exact::Polynomial, exact::Limit> {
    let mut terms = Vec::new();
    for (monomial, value) in polynomial.terms() {
        for (mask, numerator) in (0u8..).zip(value.numerators()).filter(|(_, numerator)| !numerator.is_zero())
        {
            let powers = monomial.powers().to_vec();
            let monomial = exact::Monomial::new(mask, powers).expect("powers are sorted and positive")?;
            terms.push((monomial, BigRational::new(numerator.to_bigint(), value.denominator().to_bigint())));
        }
    }
    Ok(exact::Polynomial::from_terms(terms))
}
