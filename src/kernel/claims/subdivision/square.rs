//! Trees of boxes of the unit square, followed from the root.

use std::cmp::Ordering;

use num_rational::BigRational;

use super::form::{Form, Interval, Signs};
use super::{Rejection, Tree};
use crate::equations::{S, T};
use crate::exact::{Polynomial, Radicands, Stop, Work};
use crate::failure::{At, Failure, Place};

/// Signs that may be asked for.
pub(in crate::claims) const POSITIVE: &[Ordering] = &[Ordering::Greater];
pub(in crate::claims) const NOT_NEGATIVE: &[Ordering] = &[Ordering::Greater, Ordering::Equal];

/// What subdivisions of the square have in common.
pub(in crate::claims) struct UnitSquare<'a> {
    field: &'a Radicands,
    signs: Signs,
}

impl<'a> UnitSquare<'a> {
    pub(in crate::claims) fn new(field: &'a Radicands) -> Self {
        UnitSquare { field, signs: Signs::new(field) }
    }

    /// A polynomial in t and s, without unknowns, as a form in u and 1 − u, v and 1 − v: t = u/(1−u), s = v/(1−v).
    pub(in crate::claims) fn form(
        &self,
        polynomial: &Polynomial,
        degrees: [u32; 2],
        work: &mut Work,
    ) -> Result<Form, Stop> {
        let size = |exponent: u32| usize::try_from(exponent).unwrap_or(usize::MAX);
        let mut terms = Vec::with_capacity(polynomial.term_count());
        for (monomial, value) in polynomial.terms() {
            let exponents = [T, S].map(|variable| size(monomial.exponent(variable))).to_vec();
            terms.push((exponents, monomial.mask(), value.clone()));
        }
        Form::new(self.field, degrees.map(size).to_vec(), &terms, work)
    }

    /// The sign at a point (u, v) of the square, of a form in the parameters whose odds are u/(1 − u) and v/(1 − v) over these.
    pub(in crate::claims) fn at(
        &self,
        form: Form,
        point: &[BigRational; 2],
        odds: &[BigRational; 2],
        work: &mut Work,
    ) -> Result<Ordering, Stop> {
        let mut form = form;
        for ((axis, x), odds) in (0usize..).zip(point).zip(odds) {
            let rest = x.denom() - x.numer();
            work.charge_product(x.numer(), odds.denom())?;
            work.charge_product(&rest, odds.numer())?;
            let interval = Interval::point(x.numer() * odds.denom(), rest * odds.numer());
            form = form.on(axis, &interval, work)?;
        }
        form.first(&self.signs, work)
    }

    /// Follows a tree from the whole square: the boxes that are not halved have accepted signs, the others have not.
    /// Returns how many boxes are not halved.
    pub(in crate::claims) fn subdivide(
        &self,
        name: &'static str,
        form: Form,
        tree: &Tree,
        accepted: &[Ordering],
        work: &mut Work,
    ) -> Result<usize, Failure<Rejection>> {
        // u = q/(p+q) and 1 − u = p/(p+q): the lower half has u = q/(2p+2q), the upper one u = (p+2q)/(2p+2q).
        let (low, high) = (Interval::new([0, 1], [2, 1]), Interval::new([1, 2], [1, 0]));
        let mut open = vec![(form, 0usize)];
        let mut boxes = 0usize;
        for (position, halved) in (1usize..).zip(tree) {
            let at = Place::Node(name, position);
            let Some((form, depth)) = open.pop() else {
                return Err(Rejection::Tree { tree: name }.into());
            };
            let holds = form.all(&self.signs, accepted, work).at(at)?;
            match (halved, holds) {
                (false, false) => return Err(Rejection::Sign { tree: name, node: position }.into()),
                (true, true) => return Err(Rejection::NeedlessHalving { tree: name, node: position }.into()),
                (false, true) => boxes = boxes.saturating_add(1),
                (true, false) => {
                    // Across u first, then v, in turn.
                    let axis = depth.checked_rem(2).unwrap_or(0);
                    let next = depth.saturating_add(1);
                    open.push((form.on(axis, &high, work).at(at)?, next));
                    open.push((form.on(axis, &low, work).at(at)?, next));
                }
            }
        }
        match open.is_empty() {
            true => Ok(boxes),
            false => Err(Rejection::Tree { tree: name }.into()),
        }
    }
}
