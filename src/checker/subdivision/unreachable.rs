//! Claim `unreachable`: no values of the unknowns keep the patch strictly between two bounds.
//!
//! Suppose some values did, with W > 0 on the whole square. Then at every point of it F − low·Wᵉ, high·Wᵉ − F and W are
//! positive, and so is every sum of positive multiples of these. The charts cover the space of the unknowns by boxes, and
//! on each box some such sum is nowhere positive.
//!
//! Products of two unknowns, and forms of degree 1, may be put for unknowns first: all values of the old ones are values of the new.
//!
//! In the first chart every unknown is range·ξ with −1 ≤ ξ ≤ 1, and h = 1. In the others the unknown j is ±range/h with
//! 0 < h ≤ 1, and the others are range·ξ/h: together they are all values. A polynomial of degree D in the unknowns is multiplied
//! by h^D, which is positive, and divided by any power of h that all its terms have. Sample points may move with h.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;

use super::bounds::{Powers, subject, threshold};
use super::form::{Form, Interval, Signs};
use crate::certificate::{Odds, Region, Side, Unreachable};
use crate::checker::equations::{S, T, expand};
use crate::checker::error::{CheckError, Rejection};
use crate::checker::theorem::{Claim, Theorem};
use crate::exact::{Limit, Monomial, Polynomial, Radicands, Work};
use crate::statement::Statement;

pub(in crate::checker) fn verify(
    statement: &Statement,
    argument: &Unreachable,
    work: &mut Work,
) -> Result<Theorem, CheckError> {
    let patch = subject(statement, argument.quantity)?;
    let field = statement.field();
    let limited = |limit| CheckError::Replay { step: 0, limit };
    let unknowns = statement.unknowns().len();
    if argument.charts.len() != Unreachable::chart_count(unknowns) || !argument.range.is_positive() {
        return Err(Rejection::Tree { tree: "charts" }.into());
    }
    let expanded = expand(field, patch, work).map_err(limited)?;
    let power = expanded.weight.power(patch.surface.degree(), field, work).map_err(limited)?;
    let powers = Powers { expanded, power, field };
    let low = threshold(argument.quantity, &argument.lower, argument.places)?;
    let high = threshold(argument.quantity, &argument.upper, argument.places)?;
    let mut sides = Vec::with_capacity(3);
    for (side, bound) in [(Side::Lower, low), (Side::Upper, high.clone()), (Side::Weight, high)] {
        let polynomial = powers.side(side, bound, work).map_err(limited)?;
        let mut polynomial = with_products(&polynomial, &argument.products, work)?;
        for (unknown, form) in &argument.forms {
            polynomial = put(&polynomial, *unknown, form, field, work).map_err(limited)?;
        }
        sides.push((side, polynomial));
    }
    let signs = Signs::new(field);
    let mut boxes = 0usize;
    for (number, regions) in (0usize..).zip(&argument.charts) {
        let chart = Chart { far: far(number), unknowns, range: &argument.range };
        let mut known = BTreeMap::new();
        let mut open = vec![(chart.whole(), 0usize)];
        for (position, region) in (1usize..).zip(regions) {
            let at = |limit| CheckError::Subdivision { tree: "charts", node: position, limit };
            let Some((intervals, depth)) = open.pop() else {
                return Err(Rejection::Tree { tree: "charts" }.into());
            };
            match region {
                Region::Halved => {
                    let axis = depth.checked_rem(unknowns.max(1)).unwrap_or(0);
                    let halves = intervals.get(axis).map(Interval::halves);
                    for half in halves.into_iter().flatten().rev() {
                        let mut part = intervals.clone();
                        if let Some(interval) = part.get_mut(axis) {
                            *interval = half;
                        }
                        work.charge(size(&part)).map_err(at)?;
                        open.push((part, depth.saturating_add(1)));
                    }
                }
                Region::Excluded(sum) => {
                    let terms = chart.sum(sum, &sides, &argument.samples, &mut known, work).map_err(at)?;
                    let mut form = Form::new(field, degrees(&terms, unknowns), &terms, work).map_err(at)?;
                    for (axis, interval) in (0usize..).zip(&intervals) {
                        form = form.on(axis, interval, work).map_err(at)?;
                    }
                    if !form.all(&signs, &[Ordering::Less, Ordering::Equal], work).map_err(at)? {
                        let chart = number.saturating_add(1);
                        return Err(Rejection::NotExcluded { chart, node: position }.into());
                    }
                    boxes = boxes.saturating_add(1);
                }
            }
        }
        if !open.is_empty() {
            return Err(Rejection::Tree { tree: "charts" }.into());
        }
    }
    let claim = Claim::Unreachable {
        quantity: argument.quantity,
        places: argument.places,
        between: [argument.lower.clone(), argument.upper.clone()],
        boxes,
    };
    Ok(Theorem::established(statement, claim))
}

/// The price of keeping a box: its numbers grow with its depth.
fn size(intervals: &[Interval]) -> u64 {
    let numbers = intervals.iter().flat_map(|interval| interval.x.iter().chain(&interval.y));
    let bits = numbers.fold(0u64, |bits, number| bits.saturating_add(number.bits()));
    bits.saturating_mul(2).saturating_add(1000)
}

/// Terms in h and the ξ, one variable for each unknown.
type Terms = Vec<(Vec<usize>, u8, BigRational)>;

/// z is put for z·w: z^b w^a becomes z^b w^(a−b), which must not have a negative exponent.
fn with_products(
    polynomial: &Polynomial,
    products: &[(u16, u16)],
    work: &mut Work,
) -> Result<Polynomial, CheckError> {
    let mut terms: Vec<(Monomial, BigRational)> =
        polynomial.terms().map(|(monomial, value)| (monomial.clone(), value.clone())).collect();
    for &(z, w) in products {
        for (monomial, _) in &mut terms {
            work.charge_term(monomial).map_err(|limit| CheckError::Replay { step: 0, limit })?;
            let spent = monomial.exponent(z);
            let mut powers = monomial.powers().to_vec();
            for (variable, exponent) in &mut powers {
                if *variable == w {
                    *exponent = exponent.checked_sub(spent).ok_or(Rejection::NotAProduct)?;
                }
            }
            if spent > 0 && monomial.exponent(w) == 0 {
                return Err(Rejection::NotAProduct.into());
            }
            powers.retain(|&(_, exponent)| exponent > 0);
            let replaced = Monomial::new(monomial.mask(), powers).and_then(Result::ok);
            *monomial = replaced.ok_or(Rejection::NotAProduct)?;
        }
    }
    // z·w ↦ z is one to one on the monomials it applies to, so that no two of them have become equal.
    Ok(Polynomial::from_terms(terms))
}

/// A form is put for an unknown. It contains the unknown and has degree 1, so that every value of the unknown is a value of the form,
/// whatever the others are.
fn put(
    polynomial: &Polynomial,
    unknown: u16,
    form: &Polynomial,
    field: &Radicands,
    work: &mut Work,
) -> Result<Polynomial, Limit> {
    let of = |k: u16| if k == unknown { form.clone() } else { Polynomial::variable(k) };
    let values: Vec<Polynomial> = (0..=unknown).map(of).collect();
    polynomial.substitute(&values, field, work)
}

/// Which unknown is the largest in a chart, and its sign; none in the first.
fn far(number: usize) -> Option<(usize, bool)> {
    let index = number.checked_sub(1)?;
    Some((index.checked_div(2)?, index.checked_rem(2)? == 1))
}

struct Chart<'a> {
    /// The unknown that is ±range/h, and whether it is negative.
    far: Option<(usize, bool)>,
    unknowns: usize,
    range: &'a BigInt,
}

impl Chart<'_> {
    /// ξ from −1 to 1, and h from 0 to 1 in the place of the unknown that is far.
    fn whole(&self) -> Vec<Interval> {
        let is_far = |axis: usize| self.far.is_some_and(|(far, _)| far == axis);
        let range = |axis| if is_far(axis) { [0, 1] } else { [-1, 1] };
        (0..self.unknowns).map(|axis| Interval::new(range(axis), [1, 1])).collect()
    }

    /// Σ factor·side at its sample, times a power of h. What sides at samples are is computed once for a chart.
    fn sum(
        &self,
        sum: &[(BigInt, Side, usize)],
        sides: &[(Side, Polynomial)],
        samples: &[[Odds; 2]],
        known: &mut BTreeMap<(Side, usize, u32), Terms>,
        work: &mut Work,
    ) -> Result<Terms, Limit> {
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
    ) -> Result<Terms, Limit> {
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
    ) -> Result<(Vec<usize>, u8, BigRational), Limit> {
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
fn degrees(terms: &Terms, unknowns: usize) -> Vec<usize> {
    let largest = |axis: usize| terms.iter().filter_map(|(exponents, ..)| exponents.get(axis)).max().copied();
    (0..unknowns).map(|axis| largest(axis).unwrap_or(0)).collect()
}
