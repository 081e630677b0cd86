//! Prime fields in which every radicand is a square: images of K to guess with.
//!
//! Nothing that is claimed rests on them: a wrong guess is found out when it is lifted exactly.

use super::field::{FieldElement, MultiquadraticField};
use super::monomial::Monomial;
use super::polynomial::Polynomial;

/// F_p together with one of the 2ᵏ homomorphisms from the p-integral elements of K to it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PrimeField {
    p: u64,
    /// The image of √(ΠS), by subset.
    roots: Vec<u64>,
}

/// The primes below 2³¹, decreasing, that are 3 modulo 4 and modulo which every radicand of K is a square.
pub fn splitting_primes(field: MultiquadraticField) -> impl Iterator<Item = PrimeField> {
    let candidates = (0u64..1 << 29).rev().map(|quarter| 4 * quarter + 3);
    // Looking for the roots is much cheaper than proving a prime, and most candidates fail it.
    candidates.filter_map(move |p| PrimeField::split(field, p)).filter(|image| is_prime(image.p))
}

fn is_prime(odd: u64) -> bool {
    let divisors = (3..).step_by(2).take_while(|divisor| divisor * divisor <= odd);
    odd > 2 && divisors.into_iter().all(|divisor| !odd.is_multiple_of(divisor))
}

impl PrimeField {
    /// F_p for p ≡ 3 (mod 4) if the radicands are non-zero squares in it; meant for primes, and harmless otherwise.
    fn split(field: MultiquadraticField, p: u64) -> Option<Self> {
        let mut image = PrimeField { p, roots: vec![1; field.degree()] };
        for (bit, &radicand) in field.radicands().iter().enumerate() {
            let d = u64::from(radicand) % p;
            // (p+1)/4 is an integer, and a^((p+1)/4) squares to a·a^((p−1)/2) = ±a.
            let root = image.power(d, p.div_ceil(4));
            if d == 0 || image.multiply(root, root) != d {
                return None;
            }
            for subset in (0..field.degree()).filter(|subset| subset >> bit & 1 == 1) {
                image.roots[subset] = image.multiply(image.roots[subset], root);
            }
        }
        Some(image)
    }

    /// p.
    pub fn modulus(&self) -> u64 {
        self.p
    }

    /// a·b.
    pub fn multiply(&self, a: u64, b: u64) -> u64 {
        a * b % self.p
    }

    /// a − b·c.
    pub fn subtract_product(&self, a: u64, b: u64, c: u64) -> u64 {
        (a + (self.p - b) * c) % self.p
    }

    /// 1/a for a ≠ 0.
    pub fn inverse(&self, a: u64) -> u64 {
        self.power(a, self.p - 2)
    }

    fn power(&self, base: u64, mut exponent: u64) -> u64 {
        let (mut square, mut power) = (base, 1);
        while exponent > 0 {
            if exponent & 1 == 1 {
                power = self.multiply(power, square);
            }
            square = self.multiply(square, square);
            exponent >>= 1;
        }
        power
    }

    /// The image of an element of K, `None` where p divides its denominator.
    pub fn reduce(&self, value: &FieldElement) -> Option<u64> {
        let denominator = value.denominator().residue(self.p);
        if denominator == 0 {
            return None;
        }
        let image = value.numerators().iter().zip(&self.roots).filter(|(numerator, _)| !numerator.is_zero());
        let image = image.fold(0, |sum, (numerator, &root)| {
            (sum + self.multiply(numerator.residue(self.p), root)) % self.p
        });
        Some(self.multiply(image, self.inverse(denominator)))
    }

    /// The images of the coefficients, `None` where p divides a denominator.
    pub fn reduce_polynomial(&self, polynomial: &Polynomial) -> Option<Vec<(Monomial, u64)>> {
        let image =
            |(monomial, value): &(Monomial, FieldElement)| Some((monomial.clone(), self.reduce(value)?));
        polynomial.terms().iter().map(image).collect()
    }
}
