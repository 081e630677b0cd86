//! Steps over the integers: for programs that have no fractions.
//!
//! A step Σ aₖ·pₖ = c over K becomes Σ âₖ·p̂ₖ = μ·ĉ with integral âₖ, p̂ₖ, ĉ and an integer μ ≠ 0, where each p̂ is an integral
//! multiple of p: conclusions by their own common denominator, equations by whatever the target multiplies them with.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::certificate::{Premise, Step};
use crate::exact::Polynomial;

/// A step whose numbers are integers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct IntegralStep {
    /// Premises, as multiplied by the target, with integral multipliers.
    pub summands: Vec<(Premise, Polynomial)>,
    /// The integer μ > 0 in front of the conclusion.
    pub multiple: BigInt,
    /// The conclusion with integral coefficients.
    pub conclusion: Polynomial,
}

/// The steps over the integers, where the target has multiplied each equation by `scale`.
pub(super) fn integral_steps(steps: &[Step], scale: impl Fn(Premise) -> BigInt) -> Vec<IntegralStep> {
    let scales: Vec<BigInt> = steps.iter().map(|step| common_denominator([&step.conclusion])).collect();
    let of_premise = |premise: Premise| match premise {
        // A certificate that has not been checked may name what is not there; the target will refuse it.
        Premise::Step(k) => {
            (k as usize).checked_sub(1).and_then(|k| scales.get(k)).cloned().unwrap_or_else(BigInt::one)
        }
        equation => scale(equation),
    };
    let integral = |(step, own): (&Step, &BigInt)| {
        let divided: Vec<(Premise, Polynomial)> = step
            .combination
            .iter()
            .map(|(premise, multiplier)| {
                (*premise, scaled(multiplier, &BigRational::new(BigInt::one(), of_premise(*premise))))
            })
            .collect();
        let factor = common_denominator(divided.iter().map(|(_, multiplier)| multiplier)).lcm(own);
        let by = BigRational::from_integer(factor.clone());
        IntegralStep {
            summands: divided.iter().map(|(premise, m)| (*premise, scaled(m, &by))).collect(),
            multiple: &factor / own,
            conclusion: scaled(&step.conclusion, &BigRational::from_integer(own.clone())),
        }
    };
    steps.iter().zip(&scales).map(integral).collect()
}

/// The least common denominator of all coefficients.
pub(super) fn common_denominator<'a>(polynomials: impl IntoIterator<Item = &'a Polynomial>) -> BigInt {
    let denominators = polynomials.into_iter().flat_map(Polynomial::terms).map(|(_, value)| value.denom());
    denominators.fold(BigInt::one(), |common, denominator| common.lcm(denominator))
}

/// The polynomial multiplied by a rational.
pub(super) fn scaled(polynomial: &Polynomial, by: &BigRational) -> Polynomial {
    if by.is_zero() {
        return Polynomial::zero();
    }
    Polynomial::from_terms(
        polynomial.terms().map(|(monomial, value)| (monomial.clone(), value * by)).collect::<Vec<_>>(),
    )
}
