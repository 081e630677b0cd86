//! Intervals, and what is put for a pair of variables on them.

use num_bigint::BigInt;
use num_traits::{One, Zero};

use crate::exact::{Limit, Work, bytes, count, limits};

/// The ends of an interval in one variable, as coefficients of p and q: x = x\[0\]·p + x\[1\]·q, y likewise.
#[derive(Debug)]
pub(in crate::claims) struct Interval {
    pub(in crate::claims) x: [BigInt; 2],
    pub(in crate::claims) y: [BigInt; 2],
}

impl Interval {
    pub(in crate::claims) fn new(x: [i32; 2], y: [i32; 2]) -> Self {
        Interval { x: x.map(BigInt::from), y: y.map(BigInt::from) }
    }

    /// One point x/y as an interval: the form's first coefficient becomes its value there.
    pub(in crate::claims) fn point(x: BigInt, y: BigInt) -> Self {
        Interval { x: [x, BigInt::ZERO], y: [y, BigInt::ZERO] }
    }

    /// Both halves of an interval whose y has equal coefficients.
    pub(in crate::claims) fn halves(&self, work: &mut Work) -> Result<[Interval; 2], Limit> {
        let (Interval { x: [a, b], y: [c, d] }, two) = (self, BigInt::from(2));
        // Two times four numbers, each one bit longer at most.
        let kept = [a, b, c, d].into_iter().fold(512u64, |kept, number| kept.saturating_add(bytes(number)));
        work.keep(kept.saturating_mul(2))?;
        let of_x = work.sum(a, b)?;
        let of_y = work.sum(c, d)?;
        let low = [work.product(a, &two)?, work.copied(&of_x)?, work.product(c, &two)?, work.copied(&of_y)?];
        let high = [of_x, work.product(b, &two)?, of_y, work.product(d, &two)?];
        let mut interval = |numbers| {
            let [a, b, c, d] = work.halved(numbers)?;
            Ok(Interval { x: [a, b], y: [c, d] })
        };
        Ok([interval(low)?, interval(high)?])
    }
}

/// For each exponent a from 0 up the coefficients, from q⁰ up, of (x₀p + x₁q)^a (y₀p + y₁q)^(D−a): a row at a
/// time.
pub(super) struct Table<'a> {
    interval: &'a Interval,
    row: Vec<BigInt>,
    /// D − a.
    left: usize,
}

impl<'a> Table<'a> {
    pub(super) fn new(degree: usize, interval: &'a Interval, work: &mut Work) -> Result<Self, Limit> {
        let Interval { x, y } = interval;
        // Two rows at a time, no number longer than a power of the largest.
        let longest = x.iter().chain(y).map(BigInt::bits).max().unwrap_or(0).saturating_add(1);
        let bits = longest.saturating_mul(count(degree)).min(limits::BITS.at_most);
        let number = bits.div_ceil(8).saturating_add(96);
        work.keep(count(degree).saturating_add(1).saturating_mul(3).saturating_mul(number))?;
        Ok(Table { interval, row: power(degree, y, work)?, left: degree })
    }

    pub(super) fn row(&self) -> &[BigInt] {
        &self.row
    }

    /// Goes on to the next row, which is this one times x/y: with n = row·x, row′·y = n gives y₀·row′ₖ = nₖ −
    /// y₁·row′ₖ₋₁ from below or, where y₀ is 0, y₁·row′ₖ = nₖ₊₁. Where both are 0, no row but the last has
    /// anything.
    pub(super) fn next(&mut self, work: &mut Work) -> Result<(), Limit> {
        let Interval { x, y: [y0, y1] } = self.interval;
        self.left = self.left.saturating_sub(1);
        if y0.is_zero() && y1.is_zero() {
            if self.left == 0 {
                self.row = power(self.row.len().saturating_sub(1), x, work)?;
            }
            return Ok(());
        }
        let from_below = !y0.is_zero();
        let (divisor, first) = if from_below { (y0, 0usize) } else { (y1, 1) };
        let mut next: Vec<BigInt> = Vec::with_capacity(self.row.len());
        for k in 0..self.row.len() {
            let mut value = product_at(&self.row, x, k.saturating_add(first), work)?;
            if let Some(last) = next.last().filter(|last| from_below && !y1.is_zero() && !last.is_zero()) {
                let product = work.product(last, y1)?;
                value = work.difference(&value, &product)?;
            }
            work.charge(16)?;
            next.push(if value.is_zero() || divisor.is_one() {
                value
            } else {
                work.quotient(&value, divisor)?
            });
        }
        self.row = next;
        Ok(())
    }
}

/// The k-th coefficient of a form times ap + bq.
fn product_at(row: &[BigInt], [a, b]: &[BigInt; 2], k: usize, work: &mut Work) -> Result<BigInt, Limit> {
    let mut value = match row.get(k).filter(|here| !here.is_zero() && !a.is_zero()) {
        Some(here) => work.product(here, a)?,
        None => BigInt::ZERO,
    };
    let before = k.checked_sub(1).and_then(|before| row.get(before));
    if let Some(before) = before.filter(|before| !before.is_zero() && !b.is_zero()) {
        let product = work.product(before, b)?;
        value = work.sum(&value, &product)?;
    }
    Ok(value)
}

/// (ap + bq)^D.
fn power(degree: usize, form: &[BigInt; 2], work: &mut Work) -> Result<Vec<BigInt>, Limit> {
    let mut row = vec![BigInt::one()];
    for _ in 0..degree {
        let mut next = Vec::with_capacity(row.len().saturating_add(1));
        for k in 0..=row.len() {
            work.charge(16)?;
            next.push(product_at(&row, form, k, work)?);
        }
        row = next;
    }
    Ok(row)
}
