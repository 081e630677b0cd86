//! The charts that cover the space of the unknowns, and sums of sides in them.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use num_bigint::BigInt;
use num_rational::BigRational;

use super::Odds;
use crate::claims::subdivision::{Interval, Side};
use crate::equations::{S, T};
use crate::exact::{Monomial, Polynomial, Stop, Work};

/// Terms in h and the ξ, one variable for each unknown.
pub(super) type Terms = Vec<(Vec<usize>, u8, BigRational)>;

/// Which unknown is the largest in a chart, and its sign; none in the first.
pub(super) fn far(number: usize) -> Option<(usize, bool)> {
    let index = number.checked_sub(1)?;
    Some((index.checked_div(2)?, index.checked_rem(2)? == 1))
}

/// One chart.
pub(super) struct Chart<'a> {
    /// The unknown that is ±range/h, and whether it is negative.
    pub(super) far: Option<(usize, bool)>,
    pub(super) unknowns: usize,
    pub(super) range: &'a BigInt,
}

impl Chart<'_> {
    /// ξ from −1 to 1, and h from 0 to 1 in the place of the unknown that is far.
    pub(super) fn whole(&self) -> Vec<Interval> {
        let is_far = |axis: usize| self.far.is_some_and(|(far, _)| far == axis);
        let range = |axis| if is_far(axis) { [0, 1] } else { [-1, 1] };
        (0..self.unknowns).map(|axis| Interval::new(range(axis), [1, 1])).collect()
    }

    /// Σ factor·side at its sample, times a power of h. What sides at samples are is computed once for a chart.
    pub(super) fn sum(
        &self,
        sum: &[(BigInt, Side, usize)],
        sides: &[(Side, Polynomial)],
        samples: &[[Odds; 2]],
        known: &mut BTreeMap<(Side, usize, u32), Terms>,
        work: &mut Work,
    ) -> Result<Terms, Stop> {
        let of =
            |wanted: Side| sides.iter().find(|(side, _)| *side == wanted).map(|(_, polynomial)| polynomial);
        let degree = |polynomial: &Polynomial| {
            let of_unknowns = polynomial.terms().map(|(monomial, _)| monomial.split(T).0.degree());
            of_unknowns.max().unwrap_or(0)
        };
        // All of them are brought to the largest degree.
        let degree = sum.iter().filter_map(|(_, side, _)| of(*side).map(degree)).max().unwrap_or(0);
        let mut terms: Terms = Vec::new();
        for (factor, side, sample) in sum {
            let (Some(polynomial), Some(odds)) =
                (of(*side), sample.checked_sub(1).and_then(|index| samples.get(index)))
            else {
                // The reader has refused samples that do not exist.
                continue;
            };
            let at_sample = match known.entry((*side, *sample, degree)) {
                Entry::Occupied(entry) => entry.into_mut(),
                Entry::Vacant(entry) => entry.insert(self.at_sample(polynomial, odds, degree, work)?),
            };
            let factor = BigRational::from_integer(factor.clone());
            for (exponents, mask, value) in at_sample.iter() {
                work.charge(300)?;
                work.charge_gcd(factor.numer(), value.denom())?;
                work.charge_product(factor.numer(), value.numer())?;
                terms.push((exponents.clone(), *mask, value * &factor));
            }
        }
        // A power of h that is in all terms is divided out: h > 0 for all values that the chart is about.
        if let Some((far, _)) = self.far {
            let common = terms.iter().filter_map(|(exponents, ..)| exponents.get(far)).min().copied();
            for (exponents, ..) in &mut terms {
                if let Some(exponent) = exponents.get_mut(far) {
                    *exponent = exponent.saturating_sub(common.unwrap_or(0));
                }
            }
        }
        Ok(terms)
    }

    /// A side at a sample, like terms collected.
    fn at_sample(
        &self,
        polynomial: &Polynomial,
        odds: &[Odds; 2],
        degree: u32,
        work: &mut Work,
    ) -> Result<Terms, Stop> {
        let mut collected: BTreeMap<(Vec<usize>, u8), BigRational> = BTreeMap::new();
        for (monomial, value) in polynomial.terms() {
            work.charge_term(monomial)?;
            let (exponents, mask, value) = self.term(monomial, value.clone(), odds, degree, work)?;
            let sum = collected.entry((exponents, mask)).or_default();
            work.charge_gcd(sum.denom(), value.denom())?;
            *sum += value;
        }
        Ok(collected.into_iter().map(|((exponents, mask), value)| (exponents, mask, value)).collect())
    }

    /// One term, with t, s and the unknowns replaced.
    fn term(
        &self,
        monomial: &Monomial,
        value: BigRational,
        odds: &[Odds; 2],
        degree: u32,
        work: &mut Work,
    ) -> Result<(Vec<usize>, u8, BigRational), Stop> {
        let (unknowns, _) = monomial.split(T);
        let mut value = value;
        let mut of_h = degree.saturating_sub(unknowns.degree());
        for (Odds { value: odds, shrinking }, variable) in odds.iter().zip([T, S]) {
            let exponent = monomial.exponent(variable);
            for _ in 0..exponent {
                work.charge_gcd(value.numer(), odds.denom())?;
                value *= odds;
            }
            if *shrinking {
                of_h = of_h.saturating_add(exponent);
            }
        }
        let mut exponents = vec![0usize; self.unknowns];
        for &(variable, exponent) in unknowns.powers() {
            for _ in 0..exponent {
                work.charge_gcd(value.numer(), self.range)?;
                value *= BigRational::from_integer(self.range.clone());
            }
            let negative = self.far == Some((usize::from(variable), true));
            if negative && exponent.checked_rem(2) == Some(1) {
                value = -value;
            }
            if let Some(place) = exponents.get_mut(usize::from(variable)) {
                *place = usize::try_from(exponent).unwrap_or(usize::MAX);
            }
        }
        if let Some(place) = self.far.and_then(|(far, _)| exponents.get_mut(far)) {
            *place = usize::try_from(of_h).unwrap_or(usize::MAX);
        }
        Ok((exponents, monomial.mask(), value))
    }
}

/// The largest exponent of each variable.
pub(super) fn degrees(terms: &Terms, unknowns: usize) -> Vec<usize> {
    let largest = |axis: usize| terms.iter().filter_map(|(exponents, ..)| exponents.get(axis)).max().copied();
    (0..unknowns).map(|axis| largest(axis).unwrap_or(0)).collect()
}
