//! Dense LU decomposition modulo a prime: factor once, solve for many right sides.

use crate::algebra::PrimeField;
use crate::control::{Control, Interrupted};

/// A·Q = L·U for a regular square matrix A.
pub(super) struct Decomposition {
    field: PrimeField,
    size: usize,
    /// Row by row: U on and above the diagonal, L·(diagonal of U) below.
    entries: Vec<u32>,
    /// Column `k` of A·Q is column `order[k]` of A.
    order: Vec<usize>,
    /// The inverses of U's diagonal.
    inverses: Vec<u64>,
}

impl Decomposition {
    /// Decomposes the matrix with these rows; `None` if it is singular.
    ///
    /// Row by row, so that each row is summed up in words and reduced once.
    pub(super) fn new(
        field: PrimeField,
        size: usize,
        mut entries: Vec<u32>,
        control: &Control,
    ) -> Result<Option<Self>, Interrupted> {
        let p = field.modulus();
        let square = p * p;
        let mut order: Vec<usize> = (0..size).collect();
        let mut inverses: Vec<u64> = Vec::with_capacity(size);
        let mut sums = vec![0u64; size];
        for row in 0..size {
            control.check()?;
            let (above, below) = entries.split_at_mut(row * size);
            for (sum, &column) in sums.iter_mut().zip(&order) {
                *sum = u64::from(below[column]);
            }
            for (k, &inverse) in inverses.iter().enumerate() {
                let value = field.remainder(sums[k]);
                sums[k] = value;
                if value == 0 {
                    continue;
                }
                let negative = p - field.multiply(value, inverse);
                for (sum, &entry) in sums[k + 1..].iter_mut().zip(&above[k * size + k + 1..(k + 1) * size]) {
                    let more = *sum + negative * u64::from(entry);
                    *sum = if more >= square { more - square } else { more };
                }
            }
            for sum in &mut sums[row..] {
                *sum = field.remainder(*sum);
            }
            let Some(pivot) = (row..size).find(|&column| sums[column] != 0) else { return Ok(None) };
            sums.swap(row, pivot);
            order.swap(row, pivot);
            for earlier in above.chunks_exact_mut(size) {
                earlier.swap(row, pivot);
            }
            inverses.push(field.inverse(sums[row]));
            for (entry, &sum) in below.iter_mut().zip(&sums) {
                *entry = sum as u32;
            }
        }
        Ok(Some(Decomposition { field, size, entries, order, inverses }))
    }

    /// x with A·x = right.
    pub(super) fn solve(&self, right: &[u64]) -> Vec<u64> {
        // Below the diagonal each column still has the factor of its pivot; dividing y by it makes up for that.
        let mut scaled = vec![0u64; self.size];
        let mut y = vec![0u64; self.size];
        for row in 0..self.size {
            let known = self.dot(&self.entries[row * self.size..][..row], &scaled[..row]);
            y[row] = self.field.subtract(right[row], known);
            scaled[row] = self.field.multiply(y[row], self.inverses[row]);
        }
        let mut x = vec![0u64; self.size];
        for row in (0..self.size).rev() {
            let known = self.dot(&self.entries[row * self.size..][row + 1..self.size], &y[row + 1..]);
            // From here on y holds the solution in the order of the columns of A·Q.
            y[row] = self.field.multiply(self.field.subtract(y[row], known), self.inverses[row]);
            x[self.order[row]] = y[row];
        }
        x
    }

    fn dot(&self, entries: &[u32], x: &[u64]) -> u64 {
        let p = self.field.modulus();
        // Products are below p² < 2⁶², so that a sum kept below p² leaves room for one more.
        let square = p * p;
        let sum = entries.iter().zip(x).fold(0u64, |sum, (&a, &b)| {
            let sum = sum + u64::from(a) * b;
            if sum >= square { sum - square } else { sum }
        });
        sum % p
    }
}
