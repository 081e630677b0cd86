//! Polynomials over K as polynomials over Q in generators, with the division by root² − radicand made explicit.
//!
//! Where √d is only a variable s with s² = d, a true equation over K is no identity: both sides differ by multiples of
//! s² − d. The languages that multiply out want to be told which.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::Zero;

use super::case::{Case, ExportError};
use crate::certificate::Premise;
use crate::checker::Equations;
use crate::control::Control;
use crate::exact::{Limit, Monomial, Polynomial, Radicands, combination};

/// Σ aᵢ·bᵢ over Q in the generators, nothing reduced.
pub(super) fn sum_of_products(
    pairs: &[(&Polynomial, &Polynomial)],
    control: &Control,
) -> Result<Polynomial, Limit> {
    combination(pairs, &rationals(), &mut control.work())
}

/// Q: the generators that were roots are variables like others.
pub(super) fn rationals() -> Radicands {
    Radicands::new(Vec::new()).expect("no radicands are neither too many nor wrong")
}

/// A polynomial in the unknowns over K as one over Q in the generators.
pub(super) fn lift(case: &Case, polynomial: &Polynomial) -> Result<Polynomial, Limit> {
    let terms = case.terms(polynomial).into_iter().map(|term| {
        let powers = term.powers.into_iter().map(|(generator, e)| Ok((variable(generator)?, e)));
        Ok((power_product(powers.collect::<Result<_, _>>()?)?, term.coefficient))
    });
    Ok(Polynomial::from_terms(terms.collect::<Result<Vec<_>, Limit>>()?))
}

/// The number of a generator as that of a variable.
fn variable(generator: usize) -> Result<u16, Limit> {
    u16::try_from(generator).map_err(|_| Limit::new("generators", u16::MAX.into()))
}

/// The monomial with these powers, variables increasing.
fn power_product(powers: Vec<(u16, u32)>) -> Result<Monomial, Limit> {
    Monomial::new(0, powers).unwrap_or_else(|| Ok(Monomial::one()))
}

/// Divides a polynomial in the generators, of which the first are roots of these numbers: the quotient q of each root in
/// polynomial = rest + Σ q·(root² − radicand), where no root occurs in the rest to a power above 1.
pub(super) fn quotients(polynomial: &Polynomial, radicands: &[u32]) -> Result<Vec<Polynomial>, Limit> {
    let mut rest = polynomial.clone();
    let mut quotients = Vec::with_capacity(radicands.len());
    for (root, &radicand) in (0u16..).zip(radicands) {
        let square = BigRational::from_integer(radicand.into());
        let (mut quotient, mut left) = (BTreeMap::new(), BTreeMap::new());
        for (monomial, coefficient) in rest.terms() {
            let mut coefficient = coefficient.clone();
            let mut exponent = monomial.exponent(root);
            // c·sᵉ = c·sᵉ⁻²·(s² − d) + d·c·sᵉ⁻², as long as it goes.
            while exponent >= 2 {
                exponent -= 2;
                add(&mut quotient, with_exponent(monomial, root, exponent)?, coefficient.clone());
                coefficient *= &square;
            }
            add(&mut left, with_exponent(monomial, root, exponent)?, coefficient);
        }
        quotients.push(Polynomial::from_terms(quotient));
        rest = Polynomial::from_terms(left);
    }
    Ok(quotients)
}

fn add(sum: &mut BTreeMap<Monomial, BigRational>, monomial: Monomial, coefficient: BigRational) {
    *sum.entry(monomial).or_insert_with(BigRational::zero) += coefficient;
}

/// The monomial with another exponent at one variable that stands before all others or occurs already.
fn with_exponent(monomial: &Monomial, variable: u16, exponent: u32) -> Result<Monomial, Limit> {
    if monomial.exponent(variable) == exponent {
        return Ok(monomial.clone());
    }
    let changed = |&(v, e): &(u16, u32)| (v, if v == variable { exponent } else { e });
    power_product(monomial.powers().iter().map(changed).filter(|&(_, e)| e > 0).collect())
}

/// root² − radicand for every root, in the generators.
pub(super) fn root_equations(radicands: &[u32]) -> Result<Vec<Polynomial>, Limit> {
    let equation = |(root, &radicand): (u16, &u32)| {
        let square = (power_product(vec![(root, 2)])?, BigRational::from_integer(1.into()));
        let constant = (Monomial::one(), -BigRational::from_integer(radicand.into()));
        Ok(Polynomial::from_terms([square, constant]))
    };
    (0u16..).zip(radicands).map(equation).collect()
}

/// The equations that the steps use, by name, in the generators: from the checker, which derives them from the statement.
///
/// # Errors
/// [`ExportError::Premise`] for a name that means nothing: the certificate need not be right.
pub(super) fn used_equations(case: &Case) -> Result<Vec<(Premise, Polynomial)>, ExportError> {
    let equations = Equations::of(&case.statement, &mut case.control.work())?;
    let named = case.premises().into_iter().map(|premise| {
        let equation = equations.get(premise).ok_or(ExportError::Premise(premise))?;
        Ok((premise, lift(case, equation)?))
    });
    named.collect()
}

#[cfg(test)]
mod tests {
    use super::{quotients, root_equations, sum_of_products};
    use crate::control::Control;
    use crate::exact::{Polynomial, Ring, Work};

    fn ring() -> Ring {
        Ring { field: super::rationals(), variables: ["s", "t", "x"].map(String::from).to_vec() }
    }

    fn read(text: &str) -> Polynomial {
        ring().read(text, &mut Work::full()).unwrap()
    }

    #[test]
    fn the_division_leaves_no_square() {
        let radicands = [2, 3];
        for (text, rest) in [
            ("s^5*t^4*x^3 - 1/2*s^2*x + t^3 - 7", "36*s*x^3 + 3*t - x - 7"),
            ("s*t*x + 1", "s*t*x + 1"),
            ("s^2 - 2", "0"),
            ("s^2 - 3", "-1"),
            ("s^4 - 4/3*t^2", "0"),
            ("0", "0"),
        ] {
            let negated: Vec<_> =
                quotients(&read(text), &radicands).unwrap().iter().map(Polynomial::negate).collect();
            let (one, polynomial, equations) =
                (Polynomial::integer(1), read(text), root_equations(&radicands).unwrap());
            let mut pairs: Vec<_> = negated.iter().zip(&equations).collect();
            pairs.push((&one, &polynomial));
            assert_eq!(
                ring().spell(&sum_of_products(&pairs, &Control::default()).unwrap()),
                ring().spell(&read(rest)),
                "{text}"
            );
        }
    }
}
