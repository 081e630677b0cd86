//! Dense LU decomposition modulo a prime: factor once, solve for many right sides.

use crate::algebra::PrimeField;

/// P·A = L·U for a regular square matrix A.
pub(super) struct Decomposition {
    field: PrimeField,
    size: usize,
    /// Row by row: U on and above the diagonal, L without its unit diagonal below.
    entries: Vec<u32>,
    /// Row `k` of P·A is row `order[k]` of A.
    order: Vec<usize>,
    /// The inverses of U's diagonal.
    inverses: Vec<u64>,
}

impl Decomposition {
    /// Decomposes the matrix with these rows; `None` if it is singular.
    pub(super) fn new(field: PrimeField, size: usize, mut entries: Vec<u32>) -> Option<Self> {
        let mut order: Vec<usize> = (0..size).collect();
        let mut inverses = Vec::with_capacity(size);
        for column in 0..size {
            let pivot = (column..size).find(|row| entries[row * size + column] != 0)?;
            order.swap(column, pivot);
            for k in 0..size {
                entries.swap(column * size + k, pivot * size + k);
            }
            let inverse = field.inverse(u64::from(entries[column * size + column]));
            inverses.push(inverse);
            let (above, below) = entries.split_at_mut((column + 1) * size);
            let pivot_row = &above[column * size + column + 1..];
            for row in below.chunks_exact_mut(size).filter(|row| row[column] != 0) {
                let factor = field.multiply(u64::from(row[column]), inverse);
                row[column] = factor as u32;
                for (entry, &of_pivot) in row[column + 1..].iter_mut().zip(pivot_row) {
                    *entry = field.subtract_product(u64::from(*entry), factor, u64::from(of_pivot)) as u32;
                }
            }
        }
        Some(Decomposition { field, size, entries, order, inverses })
    }

    /// x with A·x = right.
    pub(super) fn solve(&self, right: &[u64]) -> Vec<u64> {
        let mut x: Vec<u64> = self.order.iter().map(|&row| right[row]).collect();
        for row in 0..self.size {
            let known = self.dot(&self.entries[row * self.size..][..row], &x[..row]);
            x[row] = self.field.subtract(x[row], known);
        }
        for row in (0..self.size).rev() {
            let known = self.dot(&self.entries[row * self.size..][row + 1..self.size], &x[row + 1..]);
            x[row] = self.field.multiply(self.field.subtract(x[row], known), self.inverses[row]);
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
