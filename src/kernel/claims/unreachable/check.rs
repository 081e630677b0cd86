//! Claim `unreachable`: no values of the unknowns keep the patch strictly between two bounds.
//!
//! Suppose some values did, with W > 0 on the whole square. Then at every point of it F − low·Wᵉ, high·Wᵉ − F and W are
//! positive, and so is every sum of positive multiples of these. The charts cover the space of the unknowns by boxes, and
//! on each box some such sum is nowhere positive.
//!
//! Products of two unknowns, and forms of degree 1, may be put for unknowns first: all values of the old ones are
//! values of the new.
//!
//! In the first chart every unknown is range·ξ with −1 ≤ ξ ≤ 1, and h = 1. In the others the unknown j is ±range/h with
//! 0 < h ≤ 1, and the others are range·ξ/h: together they are all values. A polynomial of degree D in the unknowns is multiplied
//! by h^D, which is positive, and divided by any power of h that all its terms have. Sample points may move with h.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::Signed;

use super::chart::{Chart, degrees, far};
use super::{Excluded, Region, Rejection, Unreachable};
use crate::claims::subdivision::{self, Along, Form, Interval, Side, Signs, subject, threshold};
use crate::equations::expand;
use crate::exact::{Limit, Monomial, Polynomial, Radicands, Work};
use crate::failure::{At, Failure, Place};
use crate::statement::Statement;

/// Follows the charts.
pub(in crate::claims) fn verify(
    statement: &Statement,
    argument: &Unreachable,
    work: &mut Work,
) -> Result<Excluded, Failure<Rejection>> {
    let not_a_tree = || Rejection::from(subdivision::Rejection::Tree { tree: "charts" });
    let patch = subject(statement, argument.quantity).map_err(Rejection::from)?;
    let field = statement.field();
    let values = Place::Values;
    let unknowns = statement.unknowns().len();
    if argument.charts.len() != Unreachable::chart_count(unknowns) || !argument.range.is_positive() {
        return Err(not_a_tree().into());
    }
    let expanded = expand(field, patch, work).at(values)?;
    let power = expanded.weight.power(patch.surface.degree(), field, work).at(values)?;
    let along = Along { expanded, power, field };
    let low = threshold(argument.quantity, &argument.lower, argument.places).map_err(Rejection::from)?;
    let high = threshold(argument.quantity, &argument.upper, argument.places).map_err(Rejection::from)?;
    let mut sides = Vec::with_capacity(3);
    for (side, bound) in [(Side::Lower, low), (Side::Upper, high.clone()), (Side::Weight, high)] {
        let polynomial = along.side(side, bound, work).at(values)?;
        let mut polynomial = with_products(&polynomial, &argument.products, work)?;
        for (unknown, form) in &argument.forms {
            polynomial = put(&polynomial, *unknown, form, field, work).at(values)?;
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
            let node = Place::Node("charts", position);
            let Some((intervals, depth)) = open.pop() else {
                return Err(not_a_tree().into());
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
                        work.charge(size(&part)).at(node)?;
                        open.push((part, depth.saturating_add(1)));
                    }
                }
                Region::Excluded(sum) => {
                    let terms = chart.sum(sum, &sides, &argument.samples, &mut known, work).at(node)?;
                    let mut form = Form::new(field, degrees(&terms, unknowns), &terms, work).at(node)?;
                    for (axis, interval) in (0usize..).zip(&intervals) {
                        form = form.on(axis, interval, work).at(node)?;
                    }
                    if !form.all(&signs, &[Ordering::Less, Ordering::Equal], work).at(node)? {
                        let chart = number.saturating_add(1);
                        return Err(Rejection::NotExcluded { chart, node: position }.into());
                    }
                    boxes = boxes.saturating_add(1);
                }
            }
        }
        if !open.is_empty() {
            return Err(not_a_tree().into());
        }
    }
    Ok(Excluded {
        quantity: argument.quantity,
        places: argument.places,
        between: [argument.lower.clone(), argument.upper.clone()],
        boxes,
    })
}

/// The price of keeping a box: its numbers grow with its depth.
fn size(intervals: &[Interval]) -> u64 {
    let numbers = intervals.iter().flat_map(|interval| interval.x.iter().chain(&interval.y));
    let bits = numbers.fold(0u64, |bits, number| bits.saturating_add(number.bits()));
    bits.saturating_mul(2).saturating_add(1000)
}

/// A form is put for an unknown. It contains the unknown and has degree 1, so that every value of the unknown is a value
/// of the form, whatever the others are.
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

/// z is put for z·w: z^b w^a becomes z^b w^(a−b), which must not have a negative exponent.
fn with_products(
    polynomial: &Polynomial,
    products: &[(u16, u16)],
    work: &mut Work,
) -> Result<Polynomial, Failure<Rejection>> {
    let mut terms: Vec<(Monomial, BigRational)> =
        polynomial.terms().map(|(monomial, value)| (monomial.clone(), value.clone())).collect();
    for &(z, w) in products {
        for (monomial, _) in &mut terms {
            work.charge_term(monomial).at(Place::Values)?;
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
