//! Polynomials in one variable over K: common divisors, roots in K, number of real roots.

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

    /// (quotient, remainder) of the division by a non-zero polynomial.
    fn divide(&self, divisor: &Self) -> (Self, Self) {
        let inverse =
            divisor.coefficients.last().and_then(FieldElement::inverse).expect("a non-zero divisor");
        let mut rest = self.coefficients.clone();
        let mut quotient = vec![self.field.zero(); rest.len().saturating_sub(divisor.degree())];
        for shift in (0..quotient.len()).rev() {
            let factor = &rest[shift + divisor.degree()] * &inverse;
            for (k, c) in divisor.coefficients.iter().enumerate() {
                rest[shift + k] = &rest[shift + k] - &(&factor * c);
            }
            quotient[shift] = factor;
        }
        (Univariate::new(self.field, quotient), Univariate::new(self.field, rest))
    }

    /// The polynomial with the same roots, each once.
    pub fn squarefree(&self) -> Self {
        let (mut a, mut b) = (self.clone(), self.derivative());
        while !b.coefficients.is_empty() {
            let rest = a.divide(&b).1;
            (a, b) = (b, rest);
        }
        if a.degree() == 0 { self.clone() } else { self.divide(&a).0 }
    }

    /// The roots in K of the linear and quadratic squarefree polynomials; `None` for higher degrees, where they
    /// are not looked for.
    pub fn roots_in_field(&self) -> Option<Vec<FieldElement>> {
        match self.squarefree().coefficients.as_slice() {
            [b, a] => Some(vec![-&(b * &a.inverse()?)]),
            [c, b, a] => {
                let four = self.field.integer(4);
                let discriminant = &(b * b) - &(&four * &(a * c));
                let denominator = (&self.field.integer(2) * a).inverse()?;
                let Some(root) = discriminant.square_root() else { return Some(Vec::new()) };
                Some([&-b + &root, &-b - &root].iter().map(|numerator| numerator * &denominator).collect())
            }
            _ => None,
        }
    }

    /// The number of distinct real roots: Sturm's theorem (Basu, Pollack, Roy, Algorithms in Real Algebraic
    /// Geometry, section 2.2.2), signs decided exactly. `None` where numbers grow beyond the limits of `exact`.
    pub fn count_real_roots(&self) -> Option<usize> {
        let mut chain = vec![self.clone(), self.derivative()];
        while let [.., a, b] = chain.as_slice()
            && !b.coefficients.is_empty()
        {
            let negated = a.divide(b).1.coefficients.iter().map(|c| -c).collect();
            chain.push(Univariate::new(self.field, negated));
        }
        let leading = |at_minus_infinity: bool| {
            let signs = chain.iter().filter_map(|p| Some((p.degree(), p.coefficients.last()?)));
            signs
                .map(|(degree, c)| {
                    let positive = c.sign() == Sign::Positive;
                    Some(positive != (at_minus_infinity && degree % 2 == 1))
                })
                .collect::<Option<Vec<bool>>>()
        };
        let variations = |signs: Vec<bool>| signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
        Some(variations(leading(true)?) - variations(leading(false)?))
    }
}
