//! Real multiquadratic fields K = Q(√d₁, …, √dₖ) and their elements.

use std::ops::{Add, Mul, Neg, Sub};

use super::integer::Integer;

/// K, given by k ≤ 4 distinct primes in increasing order. Its degree over Q is 2ᵏ.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct MultiquadraticField {
    /// Unused places are 0.
    radicands: [u32; 4],
    rank: usize,
}

impl MultiquadraticField {
    /// The field with these radicands.
    ///
    /// # Panics
    /// On more than four radicands. That they are distinct primes is the statement reader's business.
    pub fn new(values: &[u32]) -> Self {
        let mut radicands = [0; 4];
        radicands[..values.len()].copy_from_slice(values);
        MultiquadraticField { radicands, rank: values.len() }
    }

    /// The field with these radicands, primes, as well; `None` where they would be more than four.
    pub fn with(&self, primes: &[u32]) -> Option<Self> {
        let mut all: Vec<u32> = self.radicands().iter().chain(primes).copied().collect();
        all.sort_unstable();
        all.dedup();
        (all.len() <= self.radicands.len()).then(|| MultiquadraticField::new(&all))
    }

    /// The radicands, increasing.
    pub fn radicands(&self) -> &[u32] {
        &self.radicands[..self.rank]
    }

    /// 2ᵏ: how many coordinates an element has. Coordinate S belongs to √Π{d_b : bit b of S}.
    pub fn degree(&self) -> usize {
        1 << self.rank
    }

    /// Π{d_b : bit b of S}.
    pub fn under_root(&self, subset: usize) -> Integer {
        let chosen = self.radicands().iter().enumerate().filter(|(bit, _)| subset >> bit & 1 == 1);
        chosen.fold(Integer::one(), |product, (_, &d)| &product * &Integer::from(d))
    }

    /// a·√ΠS·√ΠS, `common` being S.
    fn times_squared_root(&self, a: &Integer, common: usize) -> Integer {
        let chosen = self.radicands().iter().enumerate().filter(|(bit, _)| common >> bit & 1 == 1);
        let short = chosen.map(|(_, &d)| u64::from(d)).try_fold(1u64, u64::checked_mul);
        short.map_or_else(|| a * &self.under_root(common), |product| a.times(product))
    }

    /// 0.
    pub fn zero(&self) -> FieldElement {
        self.rational(Integer::zero(), Integer::one())
    }

    /// 1.
    pub fn one(&self) -> FieldElement {
        self.integer(1)
    }

    /// A small integer.
    pub fn integer(&self, value: i64) -> FieldElement {
        self.rational(Integer::from(value), Integer::one())
    }

    /// numerator / denominator, for a denominator that is not 0.
    pub fn rational(&self, numerator: Integer, denominator: Integer) -> FieldElement {
        let mut numerators = vec![Integer::zero(); self.degree()];
        numerators[0] = numerator;
        FieldElement::reduced(*self, numerators, denominator)
    }

    /// The element with these coordinates over one denominator, which is not 0.
    pub fn element(&self, numerators: Vec<Integer>, denominator: Integer) -> FieldElement {
        assert_eq!(numerators.len(), self.degree(), "one numerator for each subset of the radicands");
        FieldElement::reduced(*self, numerators, denominator)
    }
}

/// An element of K: Σ numerator_S √(Π S) / denominator, in lowest terms, the denominator positive.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct FieldElement {
    field: MultiquadraticField,
    numerators: Vec<Integer>,
    denominator: Integer,
}

impl FieldElement {
    fn reduced(field: MultiquadraticField, mut numerators: Vec<Integer>, mut denominator: Integer) -> Self {
        assert!(!denominator.is_zero(), "a denominator must not be zero");
        if !denominator.is_one() {
            let mut divisor = denominator.clone();
            for numerator in numerators.iter().filter(|numerator| !numerator.is_zero()) {
                divisor = divisor.gcd(numerator);
                if divisor.is_one() {
                    break;
                }
            }
            if numerators.iter().all(Integer::is_zero) {
                divisor = denominator.clone();
            }
            divisor = if denominator.is_negative() { -&divisor.abs() } else { divisor.abs() };
            if !divisor.is_one() {
                denominator = denominator.exact_quotient(&divisor);
                numerators = numerators.iter().map(|numerator| numerator.exact_quotient(&divisor)).collect();
            }
        }
        FieldElement { field, numerators, denominator }
    }

    /// K.
    pub fn field(&self) -> MultiquadraticField {
        self.field
    }

    /// The coordinates' numerators, by subset.
    pub fn numerators(&self) -> &[Integer] {
        &self.numerators
    }

    /// The common denominator, positive.
    pub fn denominator(&self) -> &Integer {
        &self.denominator
    }

    /// Whether this is 0.
    pub fn is_zero(&self) -> bool {
        self.numerators.iter().all(Integer::is_zero)
    }

    /// Whether this is 1.
    pub fn is_one(&self) -> bool {
        self.denominator.is_one() && self.numerators[0].is_one() && self.is_rational()
    }

    /// Whether this lies in Q.
    pub fn is_rational(&self) -> bool {
        self.numerators[1..].iter().all(Integer::is_zero)
    }

    /// The same number in a field that contains K.
    ///
    /// # Panics
    /// If a radicand of K is not one of the larger field.
    pub fn over(&self, larger: MultiquadraticField) -> Self {
        let place = |d: &u32| larger.radicands().iter().position(|other| other == d).expect("a larger field");
        let places: Vec<usize> = self.field.radicands().iter().map(place).collect();
        let mut numerators = vec![Integer::zero(); larger.degree()];
        for (subset, numerator) in self.numerators.iter().enumerate() {
            let bits = places.iter().enumerate().filter(|(bit, _)| subset >> bit & 1 == 1);
            numerators[bits.map(|(_, place)| 1 << place).sum::<usize>()] = numerator.clone();
        }
        FieldElement { field: larger, numerators, denominator: self.denominator.clone() }
    }

    /// Whether only roots of radicands of the other field occur.
    pub fn lies_in(&self, smaller: MultiquadraticField) -> bool {
        let foreign = |bit: usize| !smaller.radicands().contains(&self.field.radicands()[bit]);
        let occurs = |bit: usize| {
            self.numerators.iter().enumerate().any(|(subset, n)| subset >> bit & 1 == 1 && !n.is_zero())
        };
        (0..self.field.rank).all(|bit| !foreign(bit) || !occurs(bit))
    }

    /// The image under √d ↦ −√d for the radicand of one bit.
    fn conjugate(&self, bit: usize) -> Self {
        let flip = |(subset, value): (usize, &Integer)| {
            if subset >> bit & 1 == 1 { -value } else { value.clone() }
        };
        let numerators = self.numerators.iter().enumerate().map(flip).collect();
        FieldElement { field: self.field, numerators, denominator: self.denominator.clone() }
    }

    /// 1/self, or `None` for 0.
    ///
    /// Each factor x ↦ x·σ(x) removes one radicand; after k of them the norm, a rational, is left.
    pub fn inverse(&self) -> Option<Self> {
        if self.is_zero() {
            return None;
        }
        let (mut norm, mut cofactor) = (self.clone(), self.field.one());
        for bit in 0..self.field.rank {
            if norm.is_rational() {
                break;
            }
            let conjugate = norm.conjugate(bit);
            cofactor = &cofactor * &conjugate;
            norm = &norm * &conjugate;
        }
        let inverse = self.field.rational(norm.denominator, norm.numerators[0].clone());
        Some(&cofactor * &inverse)
    }
}

impl Add for &FieldElement {
    type Output = FieldElement;
    fn add(self, other: &FieldElement) -> FieldElement {
        if self.denominator == other.denominator {
            let numerators = self.numerators.iter().zip(&other.numerators).map(|(a, b)| a + b).collect();
            return FieldElement::reduced(self.field, numerators, self.denominator.clone());
        }
        let pairs = self.numerators.iter().zip(&other.numerators);
        let numerators = pairs.map(|(a, b)| &(a * &other.denominator) + &(b * &self.denominator)).collect();
        FieldElement::reduced(self.field, numerators, &self.denominator * &other.denominator)
    }
}

impl Sub for &FieldElement {
    type Output = FieldElement;
    fn sub(self, other: &FieldElement) -> FieldElement {
        self + &-other
    }
}

impl Neg for &FieldElement {
    type Output = FieldElement;
    fn neg(self) -> FieldElement {
        let numerators = self.numerators.iter().map(|numerator| -numerator).collect();
        FieldElement { field: self.field, numerators, denominator: self.denominator.clone() }
    }
}

impl Mul for &FieldElement {
    type Output = FieldElement;
    /// √ΠS · √ΠT = Π(S∩T) · √Π(S△T).
    fn mul(self, other: &FieldElement) -> FieldElement {
        let mut numerators = vec![Integer::zero(); self.field.degree()];
        for (s, a) in self.numerators.iter().enumerate().filter(|(_, a)| !a.is_zero()) {
            for (t, b) in other.numerators.iter().enumerate().filter(|(_, b)| !b.is_zero()) {
                let product = a * b;
                let product =
                    if s & t == 0 { product } else { self.field.times_squared_root(&product, s & t) };
                numerators[s ^ t] += &product;
            }
        }
        FieldElement::reduced(self.field, numerators, &self.denominator * &other.denominator)
    }
}
