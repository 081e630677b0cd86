//! Polynomials in one variable over K: common divisors, quadratic formula, number of real roots.

use super::field::{FieldElement, MultiquadraticField};
use super::sign::Sign;

/// c₀ + c₁x + … + cₙxⁿ with cₙ ≠ 0, or no coefficient at all for 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Univariate {
    field: MultiquadraticField,
    coefficients: Vec<FieldElement>,
}

impl Univariate {
    /// From c₀, c₁, ….
    pub fn new(field: MultiquadraticField, mut coefficients: Vec<FieldElement>) -> Self {
        while coefficients.last().is_some_and(FieldElement::is_zero) {
            coefficients.pop();
        }
        Univariate { field, coefficients }
    }

    /// c₀, c₁, ….
    pub fn coefficients(&self) -> &[FieldElement] {
        &self.coefficients
    }

    /// n; 0 for constants and for 0.
    pub fn degree(&self) -> usize {
        self.coefficients.len().saturating_sub(1)
    }

    /// The value at a point.
    pub fn evaluate(&self, at: &FieldElement) -> FieldElement {
        self.coefficients.iter().rev().fold(self.field.zero(), |sum, c| &(&sum * at) + c)
    }

    fn derivative(&self) -> Self {
        let terms = (1i64..).zip(self.coefficients.iter().skip(1));
        Univariate::new(self.field, terms.map(|(k, c)| c * &self.field.integer(k)).collect())
    }

    /// (quotient, remainder) of the division by a non-zero polynomial. `check` is asked for each term of the quotient.
    fn divide<E>(
        &self,
        divisor: &Self,
        check: &mut impl FnMut() -> Result<(), E>,
    ) -> Result<(Self, Self), E> {
        let inverse =
            divisor.coefficients.last().and_then(FieldElement::inverse).expect("a non-zero divisor");
        let mut rest = self.coefficients.clone();
        let mut quotient = vec![self.field.zero(); rest.len().saturating_sub(divisor.degree())];
        for shift in (0..quotient.len()).rev() {
            check()?;
            let factor = &rest[shift + divisor.degree()] * &inverse;
            for (k, c) in divisor.coefficients.iter().enumerate() {
                rest[shift + k] = &rest[shift + k] - &(&factor * c);
            }
            quotient[shift] = factor;
        }
        Ok((Univariate::new(self.field, quotient), Univariate::new(self.field, rest)))
    }

    /// The polynomial with the same roots, each once, by Euclid's algorithm. The coefficients on the way have up to
    /// about 2n times as many digits as the first ones.
    ///
    /// # Errors
    /// What `check` says; it is asked in every loop.
    pub fn squarefree<E>(&self, mut check: impl FnMut() -> Result<(), E>) -> Result<Self, E> {
        let (mut a, mut b) = (self.clone(), self.derivative());
        while !b.coefficients.is_empty() {
            let rest = a.divide(&b, &mut check)?.1;
            (a, b) = (b, rest);
        }
        Ok(if a.degree() == 0 { self.clone() } else { self.divide(&a, &mut check)?.0 })
    }

    /// The same polynomial over a field that contains K.
    pub fn over(&self, larger: MultiquadraticField) -> Self {
        Univariate::new(larger, self.coefficients.iter().map(|c| c.over(larger)).collect())
    }

    /// K.
    pub fn field(&self) -> MultiquadraticField {
        self.field
    }

    /// The polynomial divided by x − root.
    pub(super) fn without_root(&self, root: &FieldElement) -> Self {
        // Horner's scheme: its values but the last, which is the remainder.
        let mut value = self.field.zero();
        let mut quotient: Vec<_> = self
            .coefficients
            .iter()
            .rev()
            .map(|c| {
                value = &(&value * root) + c;
                value.clone()
            })
            .collect();
        quotient.pop();
        quotient.reverse();
        Univariate::new(self.field, quotient)
    }

    /// The roots in K of a squarefree polynomial of degree 1 or 2; none of any other.
    pub(super) fn quadratic_roots(&self) -> Vec<FieldElement> {
        let halved = |a: &FieldElement| (&self.field.integer(2) * a).inverse();
        match self.coefficients.as_slice() {
            [b, a] => a.inverse().map(|inverse| -&(b * &inverse)).into_iter().collect(),
            [_, b, a] => {
                let roots = self.discriminant().and_then(|value| value.square_root()).zip(halved(a));
                let roots = roots.map(|(root, inverse)| [&-b + &root, &-b - &root].map(|n| &n * &inverse));
                roots.into_iter().flatten().collect()
            }
            _ => Vec::new(),
        }
    }

    /// b² − 4ac of ax² + bx + c; `None` for other degrees.
    pub fn discriminant(&self) -> Option<FieldElement> {
        let [c, b, a] = self.coefficients.as_slice() else { return None };
        Some(&(b * b) - &(&self.field.integer(4) * &(a * c)))
    }

    /// The number of distinct real roots: Sturm's theorem (Basu, Pollack, Roy, Algorithms in Real Algebraic
    /// Geometry, section 2.2.2), signs decided exactly. It costs about as much as [`squarefree`](Self::squarefree).
    ///
    /// # Errors
    /// What `check` says; it is asked in every loop.
    pub fn count_real_roots<E>(&self, mut check: impl FnMut() -> Result<(), E>) -> Result<usize, E> {
        let mut chain = vec![self.clone(), self.derivative()];
        while let [.., a, b] = chain.as_slice()
            && !b.coefficients.is_empty()
        {
            let negated = a.divide(b, &mut check)?.1.coefficients.iter().map(|c| -c).collect();
            chain.push(Univariate::new(self.field, negated));
        }
        let positive_at = |at_minus_infinity: bool| {
            let leading = chain.iter().filter_map(|p| Some((p.degree(), p.coefficients.last()?)));
            let positive = leading
                .map(|(degree, c)| (c.sign() == Sign::Positive) != (at_minus_infinity && degree % 2 == 1));
            positive.collect::<Vec<bool>>()
        };
        let variations = |signs: Vec<bool>| signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
        Ok(variations(positive_at(true)) - variations(positive_at(false)))
    }
}
