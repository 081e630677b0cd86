//! Polynomials in one variable over a prime field, as far as the search for their roots needs them.

use super::prime_field::PrimeField;

/// c₀ + c₁x + … + cₙxⁿ over F_p with cₙ ≠ 0, or no coefficient at all for 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct ResiduePolynomial<'a> {
    field: &'a PrimeField,
    coefficients: Vec<u64>,
}

impl<'a> ResiduePolynomial<'a> {
    /// From c₀, c₁, …, each below p.
    pub(super) fn new(field: &'a PrimeField, mut coefficients: Vec<u64>) -> Self {
        while coefficients.last() == Some(&0) {
            coefficients.pop();
        }
        ResiduePolynomial { field, coefficients }
    }

    /// n; 0 for constants and for 0.
    pub(super) fn degree(&self) -> usize {
        self.coefficients.len().saturating_sub(1)
    }

    /// Whether no root, in any extension, is a multiple one.
    pub(super) fn is_squarefree(&self) -> bool {
        let terms = (1..).zip(self.coefficients.iter().skip(1));
        let derivative = terms.map(|(k, &c)| self.field.multiply(c, k)).collect();
        let divisor = self.gcd(&ResiduePolynomial::new(self.field, derivative));
        divisor.coefficients.len() == 1
    }

    /// The roots in F_p of a squarefree polynomial, increasing.
    pub(super) fn roots(&self) -> Vec<u64> {
        // Fermat: xᵖ − x is the product of all x − a.
        let x = ResiduePolynomial::new(self.field, vec![0, 1]);
        let fermat = x.power(self.field.modulus(), self).minus(&x);
        let mut open = vec![(self.gcd(&fermat), 0)];
        let mut roots = Vec::new();
        while let Some((product, shift)) = open.pop() {
            if product.degree() == 0 {
                continue;
            }
            if let [constant, leading] = product.coefficients[..] {
                let root = self.field.multiply(constant, self.field.inverse(leading));
                roots.push(self.field.subtract(0, root));
                continue;
            }
            // (x + shift)^((p−1)/2) is 1 at about half of the roots (Cantor and Zassenhaus); shifts in turn, so that
            // every run finds the same.
            let shifted = ResiduePolynomial::new(self.field, vec![shift, 1]);
            let one = ResiduePolynomial::new(self.field, vec![1]);
            let half = shifted.power(self.field.modulus() / 2, &product).minus(&one);
            let part = product.gcd(&half);
            let rest = product.divide(&part).0;
            open.push((part, shift + 1));
            open.push((rest, shift + 1));
        }
        roots.sort_unstable();
        roots
    }

    fn minus(&self, other: &Self) -> Self {
        let length = self.coefficients.len().max(other.coefficients.len());
        let at = |of: &Self, k: usize| of.coefficients.get(k).copied().unwrap_or(0);
        let difference = (0..length).map(|k| self.field.subtract(at(self, k), at(other, k))).collect();
        ResiduePolynomial::new(self.field, difference)
    }

    fn times(&self, other: &Self) -> Self {
        let length = (self.coefficients.len() + other.coefficients.len()).saturating_sub(1);
        let mut product = vec![0; length];
        for (i, &a) in self.coefficients.iter().enumerate() {
            for (j, &b) in other.coefficients.iter().enumerate() {
                product[i + j] = self.field.remainder(product[i + j] + self.field.multiply(a, b));
            }
        }
        ResiduePolynomial::new(self.field, product)
    }

    /// selfᵉ modulo a polynomial that is not constant.
    fn power(&self, mut exponent: u64, modulus: &Self) -> Self {
        let mut square = self.divide(modulus).1;
        let mut power = ResiduePolynomial::new(self.field, vec![1]);
        while exponent > 0 {
            if exponent & 1 == 1 {
                power = power.times(&square).divide(modulus).1;
            }
            square = square.times(&square).divide(modulus).1;
            exponent >>= 1;
        }
        power
    }

    /// (quotient, remainder) of the division by a non-zero polynomial.
    fn divide(&self, divisor: &Self) -> (Self, Self) {
        let field = self.field;
        let inverse = divisor.coefficients.last().map_or(0, |&leading| field.inverse(leading));
        let mut rest = self.coefficients.clone();
        let mut quotient = vec![0; rest.len().saturating_sub(divisor.degree())];
        for shift in (0..quotient.len()).rev() {
            let factor = field.multiply(rest[shift + divisor.degree()], inverse);
            for (k, &c) in divisor.coefficients.iter().enumerate() {
                rest[shift + k] = field.subtract_product(rest[shift + k], factor, c);
            }
            quotient[shift] = factor;
        }
        (ResiduePolynomial::new(field, quotient), ResiduePolynomial::new(field, rest))
    }

    fn gcd(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.clone(), other.clone());
        while !b.coefficients.is_empty() {
            let rest = a.divide(&b).1;
            (a, b) = (b, rest);
        }
        a
    }
}
