//! Row echelon form modulo a prime, one row at a time, remembering how each row came about.

use std::collections::BTreeMap;

use crate::algebra::PrimeField;

/// (column, non-zero entry), by decreasing column.
pub(super) type SparseRow = Vec<(u32, u64)>;

/// Rows with distinct leading columns, each a combination of inserted rows.
pub(super) struct Echelon {
    field: PrimeField,
    /// By leading column: the row, monic, and its combination.
    pivots: BTreeMap<u32, (SparseRow, Combination)>,
    /// The row being reduced; all zero between calls.
    dense: Vec<u64>,
}

/// (inserted row, non-zero factor), by increasing row.
pub(super) type Combination = Vec<(u32, u64)>;

/// What became of an inserted row.
pub(super) enum Inserted {
    /// It leads in this column, which was free.
    Pivot(u32),
    /// It depends on rows inserted before: this combination, the row itself included, is zero.
    Dependent(Combination),
}

impl Echelon {
    pub(super) fn new(field: PrimeField) -> Self {
        Echelon { field, pivots: BTreeMap::new(), dense: Vec::new() }
    }

    /// The leading columns, increasing.
    pub(super) fn pivots(&self) -> impl Iterator<Item = u32> + '_ {
        self.pivots.keys().copied()
    }

    /// The inserted rows that the row leading in `column` is made of.
    pub(super) fn combination(&self, column: u32) -> &[(u32, u64)] {
        &self.pivots[&column].1
    }

    /// Reduces a row by those inserted before, from the left, until it leads in a free column.
    pub(super) fn insert(&mut self, id: u32, row: &[(u32, u64)]) -> Inserted {
        let width = row.first().map_or(0, |&(column, _)| column as usize + 1);
        if self.dense.len() < width {
            self.dense.resize(width, 0);
        }
        for &(column, value) in row {
            self.dense[column as usize] = value;
        }
        let mut combination = BTreeMap::from([(id, 1)]);
        // Invariant: dense = Σ combination · inserted rows, and it is zero beyond `column`.
        for column in (0..width).rev() {
            let value = self.dense[column];
            if value == 0 {
                continue;
            }
            let Some((pivot, made_of)) = self.pivots.get(&(column as u32)) else {
                return self.store(column as u32, combination);
            };
            for &(at, entry) in pivot {
                let cell = &mut self.dense[at as usize];
                *cell = self.field.subtract_product(*cell, value, entry);
            }
            for &(other, factor) in made_of {
                let cell = combination.entry(other).or_insert(0);
                *cell = self.field.subtract_product(*cell, value, factor);
            }
        }
        Inserted::Dependent(combination.into_iter().filter(|&(_, factor)| factor != 0).collect())
    }

    fn store(&mut self, column: u32, combination: BTreeMap<u32, u64>) -> Inserted {
        let inverse = self.field.inverse(self.dense[column as usize]);
        let mut row = SparseRow::new();
        for at in (0..=column).rev() {
            let value = std::mem::take(&mut self.dense[at as usize]);
            if value != 0 {
                row.push((at, self.field.multiply(value, inverse)));
            }
        }
        let factors = combination.into_iter().filter(|&(_, factor)| factor != 0);
        let combination = factors.map(|(id, factor)| (id, self.field.multiply(factor, inverse))).collect();
        self.pivots.insert(column, (row, combination));
        Inserted::Pivot(column)
    }
}
