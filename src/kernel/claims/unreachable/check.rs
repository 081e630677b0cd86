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

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;

use super::boxes::Walk;
use super::chart::{Along, Chart, Powers, far};
use super::{Excluded, Region, Rejection, Unreachable};
use crate::claims::subdivision::{self, Side, Signs, subject, threshold};
use crate::exact::{Arithmetic, Monomial, Polynomial, Stop, Work};
use crate::failure::{At, Failure, Place};
use crate::statement::{Patch, Statement};

/// Follows the charts.
pub(in crate::claims) fn verify(
    statement: &Statement,
    argument: &Unreachable,
    work: &mut Work,
) -> Result<Excluded, Failure<Rejection>> {
    let patch = subject(statement, argument.quantity).map_err(Rejection::from)?;
    let values = Place::Values;
    let unknowns = statement.unknowns().len();
    if argument.charts.len() != Unreachable::chart_count(unknowns) || !argument.range.is_positive() {
        return Err(not_a_tree());
    }
    if argument.lower >= argument.upper {
        return Err(Rejection::Empty.into());
    }
    let sides = sides(patch, argument, &mut Arithmetic::new(statement.field(), work))?;
    let signs = Signs::new(statement.field(), work).at(values)?;
    let mut boxes = 0usize;
    for (number, regions) in (0usize..).zip(&argument.charts) {
        let (held, far) = (work.held(), far(number));
        work.charge(Work::TERM).at(values)?;
        let mut range = Powers::new(&argument.range, work).at(values)?;
        let mut chart = Chart::new(far, &mut range, &argument.samples, &sides);
        let mut walk = Walk::new(far.map(|(far, _)| far), unknowns);
        for (position, region) in (1usize..).zip(regions) {
            let node = Place::Node("charts", position);
            if !walk.open {
                return Err(not_a_tree());
            }
            match region {
                // Without unknowns there is nothing to halve across.
                Region::Halved if unknowns == 0 => return Err(not_a_tree()),
                Region::Halved => walk.halve(work).at(node)?,
                Region::Excluded(sum) => {
                    if !excluded(&mut chart, sum, &walk, &signs, work).at(node)? {
                        let chart = number.saturating_add(1);
                        return Err(Rejection::NotExcluded { chart, node: position }.into());
                    }
                    boxes = boxes.saturating_add(1);
                    walk.leave(work);
                }
            }
        }
        if walk.open {
            return Err(not_a_tree());
        }
        work.release_to(held);
    }
    Ok(Excluded {
        quantity: argument.quantity,
        places: argument.places,
        between: [argument.lower.clone(), argument.upper.clone()],
        boxes,
    })
}

fn not_a_tree() -> Failure<Rejection> {
    Rejection::from(subdivision::Rejection::Tree { tree: "charts" }).into()
}

/// Whether a sum is nowhere positive on the box that a walk has come to.
fn excluded(
    chart: &mut Chart<'_>,
    sum: &[(BigInt, Side, usize)],
    walk: &Walk,
    signs: &Signs<'_>,
    work: &mut Work,
) -> Result<bool, Stop> {
    let (mut form, axes) = chart.sum(sum, signs.masks(), work)?;
    for (place, axis) in (0usize..).zip(axes) {
        let next = form.on(place, walk.interval(axis, &mut None), work)?;
        form.let_go(work);
        form = next;
    }
    let nowhere_positive = form.all(signs, &[Ordering::Less, Ordering::Equal], work)?;
    form.let_go(work);
    Ok(nowhere_positive)
}

/// The three sides along the patch, in the unknowns that the argument is about.
fn sides(
    patch: &Patch,
    argument: &Unreachable,
    arithmetic: &mut Arithmetic<'_>,
) -> Result<BTreeMap<Side, Along>, Failure<Rejection>> {
    let values = Place::Values;
    let along = subdivision::Along::of(patch, arithmetic).at(values)?;
    let mut bound = |units| {
        let bound = threshold(argument.quantity, units, argument.places, arithmetic.work);
        bound.map_err(|error| error.map(Rejection::from))
    };
    let (low, high) = (bound(&argument.lower)?, bound(&argument.upper)?);
    let mut sides = BTreeMap::new();
    for (side, bound) in [(Side::Lower, low), (Side::Upper, high.clone()), (Side::Weight, high)] {
        let polynomial = along.side(side, bound, arithmetic).at(values)?;
        let mut polynomial = with_products(&polynomial, &argument.products, arithmetic)?;
        for (unknown, form) in &argument.forms {
            // It contains the unknown and has degree 1, so that every value of the unknown is a value of the
            // form, whatever the others are.
            let put = arithmetic.put(&polynomial, |variable| (variable == *unknown).then_some(form));
            polynomial = put.at(values)?;
        }
        sides.insert(side, Along::new(polynomial, arithmetic.work).at(values)?);
    }
    Ok(sides)
}

/// z is put for z·w: z^b w^a becomes z^b w^(a−b), which must not have a negative exponent.
fn with_products(
    polynomial: &Polynomial,
    products: &[(u16, u16)],
    arithmetic: &mut Arithmetic<'_>,
) -> Result<Polynomial, Failure<Rejection>> {
    let values = Place::Values;
    arithmetic.charge_copy(polynomial).at(values)?;
    let mut terms: Vec<(Monomial, BigRational)> =
        polynomial.terms().map(|(monomial, value)| (monomial.clone(), value.clone())).collect();
    for &(z, w) in products {
        for (monomial, _) in &mut terms {
            let powers = arithmetic.work.charge_each(monomial.powers().len(), Work::POWER);
            powers.and_then(|()| arithmetic.work.charge(Work::TERM)).at(values)?;
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
    arithmetic.gathered(terms).at(values)
}
