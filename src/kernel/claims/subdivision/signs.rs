//! Signs of elements of K by their integral coordinates.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;

use crate::exact::{Arithmetic, Limit, Monomial, Radicands, Stop, Work};

/// How signs of elements of K with integral coordinates are decided.
pub(in crate::claims) struct Signs<'a> {
    field: &'a Radicands,
    /// ⌊√n·2ᵇ⌋ for each mask, for some b.
    roots: Vec<Vec<BigInt>>,
}

impl<'a> Signs<'a> {
    /// The bits b: nearly always the first suffice.
    const PRECISIONS: [u32; 3] = [128, 512, 2048];

    pub(in crate::claims) fn new(field: &'a Radicands, work: &mut Work) -> Result<Self, Limit> {
        let mut roots = Vec::with_capacity(Signs::PRECISIONS.len());
        for bits in Signs::PRECISIONS {
            let scale = work.power(&BigInt::from(4), bits)?;
            let mut of_masks = Vec::with_capacity(field.degree());
            for under_root in field.masks().filter_map(|mask| field.under_root(mask)) {
                work.keep(1024)?;
                let square = work.product(under_root, &scale)?;
                of_masks.push(work.root(&square)?);
            }
            roots.push(of_masks);
        }
        Ok(Signs { field, roots })
    }

    /// How many coordinates there are.
    pub(in crate::claims) fn masks(&self) -> usize {
        self.field.degree()
    }

    /// Σ c·√n·2ᵇ differs from Σ c·⌊√n·2ᵇ⌋ by less than Σ|c| over the irrational √n. Where that leaves the
    /// sign open, it is found exactly.
    pub(super) fn of(&self, coordinates: &[BigInt], work: &mut Work) -> Result<Ordering, Stop> {
        let held = work.held();
        let sign = self.found(coordinates, work)?;
        work.release_to(held);
        Ok(sign)
    }

    fn found(&self, coordinates: &[BigInt], work: &mut Work) -> Result<Ordering, Stop> {
        let mut error = BigInt::ZERO;
        for value in coordinates.iter().skip(1) {
            let size = work.size(value)?;
            work.add(&mut error, &size)?;
        }
        if error.is_zero() {
            let rational = coordinates.first().ok_or(Stop::Defect("a number without coordinates"))?;
            return Ok(rational.cmp(&BigInt::ZERO));
        }
        for roots in &self.roots {
            let mut sum = BigInt::ZERO;
            for (value, root) in coordinates.iter().zip(roots) {
                work.add_product(&mut sum, value, root)?;
            }
            if sum.magnitude() > error.magnitude() {
                return Ok(sum.cmp(&BigInt::ZERO));
            }
        }
        let mut terms = Vec::with_capacity(coordinates.len());
        for (mask, value) in (0u8..).zip(coordinates) {
            terms.push((Monomial::radical(mask), BigRational::from_integer(work.copied(value)?)));
        }
        let mut arithmetic = Arithmetic::new(self.field, work);
        let exact = arithmetic.gathered(terms)?;
        arithmetic.sign(&exact)?.ok_or(Stop::Defect("a coefficient of a form that is not constant"))
    }
}
