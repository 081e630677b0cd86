//! Trees of boxes of the unit square, followed from the root.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use super::form::Form;
use super::signs::Signs;
use super::table::Interval;
use super::{Rejection, Tree};
use crate::equations::{S, T};
use crate::exact::{Limit, Polynomial, Radicands, Stop, Work};
use crate::failure::{At, Failure, Place};

/// Signs that may be asked for.
pub(in crate::claims) const POSITIVE: &[Ordering] = &[Ordering::Greater];
pub(in crate::claims) const NOT_NEGATIVE: &[Ordering] = &[Ordering::Greater, Ordering::Equal];

/// What subdivisions of the square have in common.
pub(in crate::claims) struct UnitSquare<'a> {
    signs: Signs<'a>,
}

impl<'a> UnitSquare<'a> {
    pub(in crate::claims) fn new(field: &'a Radicands, work: &mut Work) -> Result<Self, Limit> {
        Ok(UnitSquare { signs: Signs::new(field, work)? })
    }

    /// A polynomial in t and s, without unknowns, as a form in u and 1 − u, v and 1 − v: t = u/(1−u), s = v/(1−v).
    pub(in crate::claims) fn form(
        &self,
        polynomial: &Polynomial,
        degrees: [u32; 2],
        work: &mut Work,
    ) -> Result<Form, Stop> {
        Form::counted(work, |work| self.dense(polynomial, degrees, work))
    }

    fn dense(&self, polynomial: &Polynomial, degrees: [u32; 2], work: &mut Work) -> Result<Form, Stop> {
        let size = |exponent: u32| usize::try_from(exponent).unwrap_or(usize::MAX);
        let mut form = Form::zero(degrees.map(size).to_vec(), self.signs.masks(), work)?;
        let mut denominator = BigInt::one();
        for (_, value) in polynomial.terms() {
            denominator = work.common_multiple(&denominator, value.denom())?;
        }
        for (monomial, value) in polynomial.terms() {
            let exponents = [T, S].map(|variable| size(monomial.exponent(variable)));
            let factor = work.quotient(&denominator, value.denom())?;
            form.add(&exponents, monomial.mask(), [value.numer(), &factor], work)?;
        }
        Ok(form)
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
            let rest = work.difference(x.denom(), x.numer())?;
            let (there, rest) = (work.product(x.numer(), odds.denom())?, work.product(&rest, odds.numer())?);
            let next = form.on(axis, &Interval::point(there, rest), work)?;
            form.let_go(work);
            form = next;
        }
        let sign = form.first(&self.signs, work)?;
        form.let_go(work);
        Ok(sign)
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
            form.let_go(work);
        }
        match open.is_empty() {
            true => Ok(boxes),
            false => Err(Rejection::Tree { tree: name }.into()),
        }
    }
}
