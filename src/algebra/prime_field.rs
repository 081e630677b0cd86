//! Prime fields in which every radicand is a square: images of K to guess with.
//!
//! Nothing that is claimed rests on them: a wrong guess is found out when it is lifted exactly.

use super::field::{FieldElement, MultiquadraticField};
use super::integer::Integer;
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

    /// The image of √(ΠS).
    pub(super) fn root(&self, subset: usize) -> u64 {
        self.roots[subset]
    }

    /// a·b.
    pub fn multiply(&self, a: u64, b: u64) -> u64 {
        a * b % self.p
    }

    /// a − b·c.
    pub fn subtract_product(&self, a: u64, b: u64, c: u64) -> u64 {
        (a + (self.p - b) * c) % self.p
    }

    /// a modulo p.
    pub fn remainder(&self, a: u64) -> u64 {
        a % self.p
    }

    /// a − b.
    pub fn subtract(&self, a: u64, b: u64) -> u64 {
        if a >= b { a - b } else { a + self.p - b }
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

    /// All 2ᵏ homomorphisms for this p, this one first: number e changes the signs of the roots in the bits of e.
    pub fn embeddings(&self) -> Vec<PrimeField> {
        let conjugate = |e: usize| {
            let sign = |(subset, &root): (usize, &u64)| {
                if (subset & e).count_ones() % 2 == 1 { self.subtract(0, root) } else { root }
            };
            PrimeField { p: self.p, roots: self.roots.iter().enumerate().map(sign).collect() }
        };
        (0..self.roots.len()).map(conjugate).collect()
    }

    /// The image of Σ coordinate_S·√(ΠS).
    pub fn combine(&self, coordinates: &[Integer]) -> u64 {
        let terms = coordinates.iter().zip(&self.roots).filter(|(coordinate, _)| !coordinate.is_zero());
        terms.fold(0, |sum, (coordinate, &root)| {
            (sum + self.multiply(coordinate.residue(self.p), root)) % self.p
        })
    }

    /// The coordinates, of least absolute value, of the element with these images under [`Self::embeddings`].
    pub fn coordinates(&self, images: &[u64]) -> Vec<i64> {
        let count = self.inverse(images.len() as u64);
        let coordinate = |(subset, &root): (usize, &u64)| {
            let sum = images.iter().enumerate().fold(0, |sum, (e, &image)| {
                if (subset & e).count_ones() % 2 == 1 {
                    self.subtract(sum, image)
                } else {
                    (sum + image) % self.p
                }
            });
            let value = self.multiply(sum, self.multiply(count, self.inverse(root)));
            if value > self.p / 2 { value as i64 - self.p as i64 } else { value as i64 }
        };
        self.roots.iter().enumerate().map(coordinate).collect()
    }

    /// The image of an element of K, `None` where p divides its denominator.
    pub fn reduce(&self, value: &FieldElement) -> Option<u64> {
        let denominator = value.denominator().residue(self.p);
        if denominator == 0 {
            return None;
        }
        Some(self.multiply(self.combine(value.numerators()), self.inverse(denominator)))
    }

    /// The images of the coefficients, `None` where p divides a denominator.
    pub fn reduce_polynomial(&self, polynomial: &Polynomial) -> Option<Vec<(Monomial, u64)>> {
        let image =
            |(monomial, value): &(Monomial, FieldElement)| Some((monomial.clone(), self.reduce(value)?));
        polynomial.terms().iter().map(image).collect()
    }
}
