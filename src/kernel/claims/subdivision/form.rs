//! Homogeneous forms in pairs of variables, and their signs on boxes.
//!
//! A polynomial of degree D in ξ = x/y, on the interval with ends ξ₀ = x₀/y₀ and ξ₁ = x₁/y₁ (y₀, y₁ > 0), is found by putting
//! x = x₀p + x₁q, y = y₀p + y₁q. For p, q ≥ 0 the result, a form in p and q, is a sum of its coefficients with factors
//! that are not negative: if none of them is negative, the polynomial is nowhere negative on the interval. (They are Bernstein
//! coefficients, but for positive factors.) The same holds in several variables, one pair at a time.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::Zero;

use super::signs::Signs;
use super::table::{Interval, Table};
use crate::exact::{Stop, Work, count};

/// Σ c[a] Π xᵢ^aᵢ yᵢ^(Dᵢ−aᵢ), but for a positive factor: each c an element of K by its integral coordinates.
#[derive(Debug)]
pub(in crate::claims) struct Form {
    /// Dᵢ.
    degrees: Vec<usize>,
    /// Coordinates of an element of K.
    masks: usize,
    /// By exponents, the last one fastest, and then by mask.
    coordinates: Vec<BigInt>,
    /// The memory that it holds.
    bytes: u64,
}

impl Form {
    /// The memory of a number where it stands.
    const COORDINATE: u64 = 40;
    /// A look at it.
    const LOOK: u64 = 8;

    /// 0, with these degrees, over a field with so many masks.
    pub(in crate::claims) fn zero(degrees: Vec<usize>, masks: usize, work: &mut Work) -> Result<Self, Stop> {
        let size = degrees.iter().fold(masks, |size, degree| size.saturating_mul(degree.saturating_add(1)));
        work.keep_each(degrees.len(), 16)?;
        work.keep_each(size, Form::COORDINATE)?;
        Ok(Form { coordinates: vec![BigInt::ZERO; size], masks, degrees, bytes: 0 })
    }

    /// The form that `made` makes; all memory that is taken for it is its own.
    pub(in crate::claims) fn counted(
        work: &mut Work,
        made: impl FnOnce(&mut Work) -> Result<Form, Stop>,
    ) -> Result<Self, Stop> {
        let before = work.held();
        let mut form = made(work)?;
        form.bytes = work.held().saturating_sub(before);
        Ok(form)
    }

    /// Gives back its memory.
    pub(in crate::claims) fn let_go(self, work: &mut Work) {
        work.release(self.bytes);
    }

    /// Adds a·b to a coordinate of the coefficient with these exponents.
    pub(in crate::claims) fn add(
        &mut self,
        exponents: &[usize],
        mask: u8,
        [a, b]: [&BigInt; 2],
        work: &mut Work,
    ) -> Result<(), Stop> {
        work.charge_each(exponents.len().saturating_add(1), 16)?;
        const BEYOND: Stop = Stop::Defect("a term beyond the degrees of its form");
        let mut place = 0usize;
        for (exponent, degree) in exponents.iter().zip(&self.degrees) {
            if exponent > degree {
                return Err(BEYOND);
            }
            place = place.saturating_mul(degree.saturating_add(1)).saturating_add(*exponent);
        }
        let place = place.saturating_mul(self.masks).saturating_add(usize::from(mask));
        let coordinate = self.coordinates.get_mut(place);
        let coordinate = coordinate.ok_or(BEYOND)?;
        Ok(work.add_product(coordinate, a, b)?)
    }

    /// The form in p and q of the pair `axis` on an interval.
    pub(in crate::claims) fn on(
        &self,
        axis: usize,
        interval: &Interval,
        work: &mut Work,
    ) -> Result<Self, Stop> {
        let before = work.held();
        let table = Table::new(self.degrees.get(axis).copied().unwrap_or(0), interval, work)?;
        let of_table = work.held().saturating_sub(before);
        let form = Form::counted(work, |work| self.put(axis, table, work))?;
        work.release(of_table);
        Ok(form)
    }

    /// What the rows of a table have is put for the powers of an axis.
    fn put(&self, axis: usize, mut table: Table<'_>, work: &mut Work) -> Result<Self, Stop> {
        let degree = self.degrees.get(axis).copied().unwrap_or(0);
        let stride = self.degrees.iter().skip(axis.saturating_add(1));
        let stride = stride.fold(self.masks, |size, degree| size.saturating_mul(degree.saturating_add(1)));
        let mut result = Form::zero(self.degrees.clone(), self.masks, work)?;
        for exponent in 0..=degree {
            // Where a line along the axis has this exponent: so far from its start.
            let within = exponent.saturating_mul(stride);
            for start in starts(self.coordinates.len(), stride, degree) {
                work.charge(Form::LOOK)?;
                let value = self.coordinates.get(start.saturating_add(within));
                let value = value.ok_or(Stop::Defect("a line that leaves its form"))?;
                if value.is_zero() {
                    continue;
                }
                let targets = result.coordinates.iter_mut().skip(start).step_by(stride.max(1));
                for (target, factor) in targets.zip(table.row()) {
                    work.charge(Form::LOOK)?;
                    if !factor.is_zero() {
                        work.add_product(target, value, factor)?;
                    }
                }
            }
            if exponent < degree {
                table.next(work)?;
            }
        }
        Ok(result)
    }

    /// Whether all coefficients have an accepted sign.
    pub(in crate::claims) fn all(
        &self,
        signs: &Signs,
        accepted: &[Ordering],
        work: &mut Work,
    ) -> Result<bool, Stop> {
        if self.coordinates.len() < self.masks.max(1) {
            return Err(Stop::Defect("a form without coefficients"));
        }
        for coefficient in self.coordinates.chunks(self.masks.max(1)) {
            work.charge(count(self.masks).saturating_mul(Form::LOOK))?;
            if !accepted.contains(&signs.of(coefficient, work)?) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The sign of the first coefficient.
    pub(in crate::claims) fn first(&self, signs: &Signs, work: &mut Work) -> Result<Ordering, Stop> {
        let first = self.coordinates.chunks(self.masks.max(1)).next();
        signs.of(first.ok_or(Stop::Defect("a form without coefficients"))?, work)
    }
}

/// The first places of the lines along an axis with this stride and degree.
fn starts(size: usize, stride: usize, degree: usize) -> impl Iterator<Item = usize> {
    let block = stride.saturating_mul(degree.saturating_add(1)).max(1);
    (0..size).step_by(block).flat_map(move |first| first..first.saturating_add(stride))
}
