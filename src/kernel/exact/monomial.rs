//! `√n · power product`: what a rational coefficient stands in front of.

use std::cmp::Ordering;

use super::limits::{self, Limit};
use super::work::count;

/// A basis element of K[x₀, x₁, …] over Q: the root named by a mask of radicands, times a power product.
///
/// Its `Ord` is the order of spelling: higher degree first, then the power product that is larger in the
/// first variable where they differ first, then the smaller mask first.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Monomial {
    degree: u32,
    /// (variable, exponent ≥ 1), variables increasing.
    powers: Vec<(u16, u32)>,
    radical: u8,
}

impl Monomial {
    /// 1.
    pub fn one() -> Self {
        Monomial::radical(0)
    }

    /// The root of the radicands in `mask`.
    pub fn radical(mask: u8) -> Self {
        Monomial { degree: 0, powers: Vec::new(), radical: mask }
    }

    /// `√(mask) · Π variable^exponent`; the variables must be given in increasing order, each once.
    /// `None` if they are not or if an exponent is 0.
    pub fn new(mask: u8, powers: Vec<(u16, u32)>) -> Option<Result<Self, Limit>> {
        let increasing = powers.iter().zip(powers.iter().skip(1)).all(|((a, _), (b, _))| a < b);
        if !increasing || powers.iter().any(|&(_, exponent)| exponent == 0) {
            return None;
        }
        let degree = powers.iter().try_fold(0u32, |sum, &(_, exponent)| sum.checked_add(exponent));
        Some(match degree {
            Some(degree) if limits::DEGREE.allows(degree) => Ok(Monomial { degree, powers, radical: mask }),
            _ => Err(limits::DEGREE),
        })
    }

    /// A variable.
    pub fn variable(variable: u16) -> Self {
        Monomial { degree: 1, powers: vec![(variable, 1)], radical: 0 }
    }

    /// The square of a variable.
    pub fn square(variable: u16) -> Self {
        Monomial { degree: 2, powers: vec![(variable, 2)], radical: 0 }
    }

    /// The same with a lower exponent of one variable (the same, where it is lower already).
    pub fn lowered(&self, variable: u16, exponent: u32) -> Self {
        let lower =
            |&(other, old): &(u16, u32)| (other, if other == variable { old.min(exponent) } else { old });
        let powers: Vec<(u16, u32)> =
            self.powers.iter().map(lower).filter(|&(_, exponent)| exponent > 0).collect();
        let degree = powers.iter().fold(0u32, |sum, &(_, exponent)| sum.saturating_add(exponent));
        Monomial { degree, powers, radical: self.radical }
    }

    /// The memory of the powers.
    pub(crate) fn bytes(&self) -> u64 {
        // The allocator's own part, and eight bytes for each power.
        count(self.powers.len()).saturating_mul(8).saturating_add(24)
    }

    /// The root, and the powers of some of the variables.
    pub(crate) fn kept(&self, stays: impl Fn(u16) -> bool) -> Self {
        let powers: Vec<(u16, u32)> =
            self.powers.iter().filter(|(variable, _)| stays(*variable)).copied().collect();
        let degree = powers.iter().fold(0u32, |sum, &(_, exponent)| sum.saturating_add(exponent));
        Monomial { degree, powers, radical: self.radical }
    }

    /// The total degree in the variables.
    pub fn degree(&self) -> u32 {
        self.degree
    }

    /// The mask of the root.
    pub fn mask(&self) -> u8 {
        self.radical
    }

    /// (variable, exponent ≥ 1), variables increasing.
    pub fn powers(&self) -> &[(u16, u32)] {
        &self.powers
    }

    /// The exponent of one variable.
    pub fn exponent(&self, variable: u16) -> u32 {
        self.powers.iter().find(|&&(v, _)| v == variable).map_or(0, |&(_, exponent)| exponent)
    }

    /// Separates the powers of the variables below `bound` from the others.
    pub fn split(&self, bound: u16) -> (Monomial, Monomial) {
        let (low, high): (Vec<_>, Vec<_>) = self.powers.iter().partition(|&&(v, _)| v < bound);
        let with_degree = |powers: Vec<(u16, u32)>, radical| Monomial {
            degree: powers.iter().fold(0, |sum, &(_, exponent)| exponent.saturating_add(sum)),
            powers,
            radical,
        };
        (with_degree(low, self.radical), with_degree(high, 0))
    }

    /// The product, and the mask of the radicands whose roots met: √a·√b = (Π a∩b)·√(a△b).
    pub fn product(&self, other: &Self) -> Result<(Self, u8), Limit> {
        let degree = self.degree.checked_add(other.degree).filter(|&sum| limits::DEGREE.allows(sum));
        let degree = degree.ok_or(limits::DEGREE)?;
        let mut powers = Vec::with_capacity(self.powers.len().saturating_add(other.powers.len()));
        let (mut left, mut right) = (self.powers.iter().peekable(), other.powers.iter().peekable());
        loop {
            let next = match (left.peek(), right.peek()) {
                (None, None) => break,
                (Some(&&power), None) => (left.next(), power).1,
                (None, Some(&&power)) => (right.next(), power).1,
                (Some(&&(a, e)), Some(&&(b, f))) => match a.cmp(&b) {
                    Ordering::Less => (left.next(), (a, e)).1,
                    Ordering::Greater => (right.next(), (b, f)).1,
                    // Cannot saturate: the sum is at most the degree.
                    Ordering::Equal => ((left.next(), right.next()), (a, e.saturating_add(f))).1,
                },
            };
            powers.push(next);
        }
        let product = Monomial { degree, powers, radical: self.radical ^ other.radical };
        Ok((product, self.radical & other.radical))
    }
}

impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        other
            .degree
            .cmp(&self.degree)
            .then_with(|| {
                let differing = self.powers.iter().zip(&other.powers).find(|(a, b)| a != b);
                match differing {
                    // The smaller variable, or the larger exponent of the same one, is spelled first.
                    Some((&(a, e), &(b, f))) => a.cmp(&b).then(f.cmp(&e)),
                    None => other.powers.len().cmp(&self.powers.len()),
                }
            })
            .then(self.radical.cmp(&other.radical))
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
