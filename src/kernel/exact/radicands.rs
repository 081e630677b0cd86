//! The radicands d₁ < … < dₖ of the field Q(√d₁, …, √dₖ): distinct primes, at most four.
//!
//! A *mask* names the basis element √(product of a subset): bit b stands for the b-th radicand.

use std::fmt;

use num_bigint::BigInt;

use super::limits;

/// Distinct primes in increasing order; the field they generate has degree 2ᵏ over Q because they are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Radicands {
    values: Vec<u32>,
    /// The product of each subset, by mask.
    products: Vec<BigInt>,
}

/// Why a list of integers is not a list of radicands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RadicandsError {
    /// More than four.
    TooMany(usize),
    /// Not a prime: roots of other numbers lie in the field of the primes they are products of.
    NotPrime(u32),
    /// Larger than [`limits::RADICAND`].
    TooLarge(u32),
    /// Listed twice.
    Repeated(u32),
}

impl fmt::Display for RadicandsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RadicandsError::TooMany(count) => {
                write!(f, "{count} radicands, expected at most {}", limits::RADICANDS.at_most)
            }
            RadicandsError::NotPrime(value) => {
                write!(f, "radicand {value} is not a prime; for √6 list the primes 2 and 3")
            }
            RadicandsError::TooLarge(value) => {
                write!(f, "radicand {value} is larger than {}", limits::RADICAND.at_most)
            }
            RadicandsError::Repeated(value) => write!(f, "radicand {value} is listed twice"),
        }
    }
}

impl std::error::Error for RadicandsError {}

impl Radicands {
    /// Sorts and checks a list of radicands.
    pub fn new(mut values: Vec<u32>) -> Result<Self, RadicandsError> {
        if !limits::RADICANDS.allows(values.len()) {
            return Err(RadicandsError::TooMany(values.len()));
        }
        values.sort_unstable();
        for (position, &value) in values.iter().enumerate() {
            if !limits::RADICAND.allows(value) {
                return Err(RadicandsError::TooLarge(value));
            }
            if !is_prime(value) {
                return Err(RadicandsError::NotPrime(value));
            }
            if values.iter().skip(position.saturating_add(1)).any(|&other| other == value) {
                return Err(RadicandsError::Repeated(value));
            }
        }
        // Each radicand doubles the list: the products with it follow those without. Four radicands make at
        // most 10²⁴.
        let products = values.iter().fold(vec![1u128], |products, &value| {
            let with = products.iter().map(|product| product.saturating_mul(u128::from(value))).collect();
            [products, with].concat()
        });
        Ok(Radicands { values, products: products.into_iter().map(BigInt::from).collect() })
    }

    /// The radicands, increasing.
    pub fn values(&self) -> &[u32] {
        &self.values
    }

    /// The masks 1, 2, 4, … of the single radicands.
    pub fn generators(&self) -> impl Iterator<Item = u8> + '_ {
        (0u32..).zip(&self.values).map(|(bit, _)| 1u8.checked_shl(bit).unwrap_or(0))
    }

    /// All masks of the field: 0 (for 1) up to 2ᵏ − 1.
    pub fn masks(&self) -> impl Iterator<Item = u8> {
        let end = self.generators().fold(0u8, |all, bit| all | bit);
        0..=end
    }

    /// The product of the radicands in `mask`, the number under the root; `None` for a mask of another field.
    pub fn under_root(&self, mask: u8) -> Option<&BigInt> {
        self.products.get(usize::from(mask))
    }

    /// How many masks there are: the degree of the field over Q.
    pub(crate) fn degree(&self) -> usize {
        self.products.len()
    }
}

fn is_prime(value: u32) -> bool {
    let mut divisors = (2u32..).take_while(|&d| d.checked_mul(d).is_some_and(|square| square <= value));
    value >= 2 && divisors.all(|d| !value.is_multiple_of(d))
}

impl fmt::Display for Radicands {
    /// `Q(√2,√3)`, or `Q` for no radicands.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let roots: Vec<String> = self.values.iter().map(|value| format!("√{value}")).collect();
        if roots.is_empty() { write!(f, "Q") } else { write!(f, "Q({})", roots.join(",")) }
    }
}
