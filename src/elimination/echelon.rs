//! Row echelon form modulo a prime, one row at a time, remembering how each row came about.

use std::collections::BTreeMap;

use crate::algebra::PrimeField;
use crate::control::{Control, Interrupted, Pace};

/// Entries that are added between two questions whether to go on: some milliseconds.
const ENTRIES: usize = 1 << 21;

/// (column, non-zero entry), by decreasing column.
pub type SparseRow = Vec<(u32, u64)>;

/// (inserted row, non-zero factor), by increasing row.
pub type Combination = Vec<(u32, u64)>;

/// Rows with distinct leading columns, each a combination of inserted rows.
pub struct Echelon {
    field: PrimeField,
    /// By leading column, which row of `rows` leads there.
    pivots: BTreeMap<u32, usize>,
    rows: Vec<Row>,
    /// The row being reduced, each entry up to a multiple of p and below p²; all zero between calls.
    dense: Vec<u64>,
}

/// A monic row: scale · (inserted row − Σ factor · earlier row). Half-words: these rows are what fills the memory.
struct Row {
    /// (column, non-zero entry), by decreasing column.
    entries: Vec<(u32, u32)>,
    inserted: u32,
    scale: u64,
    /// (position of the earlier row, factor).
    subtracted: Vec<(u32, u32)>,
}

/// Inserted row = Σ factor · earlier row. What that means for inserted rows is worked out on demand.
pub struct Dependence {
    inserted: u32,
    subtracted: Vec<(u32, u32)>,
}

/// What became of an inserted row.
pub enum Inserted {
    /// It leads in this column, which was free.
    Pivot(u32),
    /// It depends on rows inserted before.
    Dependent(Dependence),
}

impl Echelon {
    /// No rows.
    pub fn new(field: PrimeField) -> Self {
        Echelon { field, pivots: BTreeMap::new(), rows: Vec::new(), dense: Vec::new() }
    }

    /// The leading columns, increasing.
    pub fn pivots(&self) -> impl Iterator<Item = u32> + '_ {
        self.pivots.keys().copied()
    }

    /// The rows of the reduced echelon form: in no other row is there an entry where one leads.
    ///
    /// # Errors
    /// [`Control::check`]; nothing more can be inserted then.
    pub fn reduced_rows(&mut self, control: &Control) -> Result<Vec<SparseRow>, Interrupted> {
        let mut pace = control.every(ENTRIES);
        let positions: Vec<usize> = self.pivots.values().copied().collect();
        let reduce = |position: usize| {
            let Some(&(leading, _)) = self.rows[position].entries.first() else {
                return Ok(SparseRow::new());
            };
            let width = leading as usize + 1;
            if self.dense.len() < width {
                self.dense.resize(width, 0);
            }
            for &(column, value) in &self.rows[position].entries {
                self.dense[column as usize] = u64::from(value);
            }
            for column in (0..leading).rev() {
                let value = self.field.remainder(self.dense[column as usize]);
                self.dense[column as usize] = value;
                let Some(&other) = self.pivots.get(&column).filter(|_| value != 0) else { continue };
                subtract_multiple(&mut self.dense, value, &self.rows[other].entries, &self.field, &mut pace)?;
                self.dense[column as usize] = 0;
            }
            let cells = self.dense[..width].iter_mut().zip(0..width as u32).rev();
            Ok(cells.map(|(cell, at)| (at, std::mem::take(cell))).filter(|&(_, value)| value != 0).collect())
        };
        positions.into_iter().map(reduce).collect()
    }

    /// The inserted rows that the row leading in `column` is made of.
    ///
    /// # Errors
    /// [`Control::check`]
    pub fn combination(&self, column: u32, control: &Control) -> Result<Combination, Interrupted> {
        let row = &self.rows[self.pivots[&column]];
        self.unfold(row.inserted, row.scale, &row.subtracted, control)
    }

    /// Reduces a row by those inserted before, from the left, until it leads in a free column.
    ///
    /// # Errors
    /// [`Control::check`]; nothing more can be inserted then.
    pub fn insert(
        &mut self,
        id: u32,
        row: &[(u32, u64)],
        control: &Control,
    ) -> Result<Inserted, Interrupted> {
        let mut pace = control.every(ENTRIES);
        let width = row.first().map_or(0, |&(column, _)| column as usize + 1);
        if self.dense.len() < width {
            self.dense.resize(width, 0);
        }
        for &(column, value) in row {
            self.dense[column as usize] = value;
        }
        let mut subtracted = Vec::new();
        // Invariant: dense ≡ row − Σ factor · earlier row, and it is zero beyond `column`.
        for column in (0..width).rev() {
            let value = self.field.remainder(std::mem::take(&mut self.dense[column]));
            if value == 0 {
                continue;
            }
            let Some(&position) = self.pivots.get(&(column as u32)) else {
                return Ok(self.store(column as u32, value, id, subtracted));
            };
            let entries = &self.rows[position].entries[1..];
            subtract_multiple(&mut self.dense, value, entries, &self.field, &mut pace)?;
            subtracted.push((position as u32, value as u32));
        }
        Ok(Inserted::Dependent(Dependence { inserted: id, subtracted }))
    }

    /// The combination of inserted rows, the dependent one with factor 1, that is zero.
    ///
    /// # Errors
    /// [`Control::check`]
    pub fn relation(&self, dependence: &Dependence, control: &Control) -> Result<Combination, Interrupted> {
        self.unfold(dependence.inserted, 1, &dependence.subtracted, control)
    }

    fn store(
        &mut self,
        column: u32,
        leading: u64,
        inserted: u32,
        mut subtracted: Vec<(u32, u32)>,
    ) -> Inserted {
        let scale = self.field.inverse(leading);
        let mut entries = vec![(column, 1)];
        for at in (0..column).rev() {
            let value = self.field.remainder(std::mem::take(&mut self.dense[at as usize]));
            if value != 0 {
                entries.push((at, self.field.multiply(value, scale) as u32));
            }
        }
        entries.shrink_to_fit();
        subtracted.shrink_to_fit();
        self.pivots.insert(column, self.rows.len());
        self.rows.push(Row { entries, inserted, scale, subtracted });
        Inserted::Pivot(column)
    }

    /// scale · (inserted row − Σ factor · earlier row), all the way back to inserted rows.
    fn unfold(
        &self,
        inserted: u32,
        scale: u64,
        subtracted: &[(u32, u32)],
        control: &Control,
    ) -> Result<Combination, Interrupted> {
        let mut pace = control.every(ENTRIES);
        let mut combination = BTreeMap::from([(inserted, scale)]);
        let mut pending = vec![0u64; self.rows.len()];
        for &(position, factor) in subtracted {
            let cell = &mut pending[position as usize];
            *cell = self.field.subtract_product(*cell, scale, u64::from(factor));
        }
        // A row is made of earlier ones only.
        for position in (0..self.rows.len()).rev() {
            let outer = pending[position];
            if outer == 0 {
                continue;
            }
            let row = &self.rows[position];
            let factor = self.field.multiply(outer, row.scale);
            combination.insert(row.inserted, factor);
            pace.count(row.subtracted.len())?;
            for &(earlier, inner) in &row.subtracted {
                let cell = &mut pending[earlier as usize];
                *cell = self.field.subtract_product(*cell, factor, u64::from(inner));
            }
        }
        Ok(combination.into_iter().filter(|&(_, factor)| factor != 0).collect())
    }
}

/// dense − factor · row. There is no division: a sum that reaches p² loses p², and stays in a word.
fn subtract_multiple(
    dense: &mut [u64],
    factor: u64,
    row: &[(u32, u32)],
    field: &PrimeField,
    pace: &mut Pace<'_>,
) -> Result<(), Interrupted> {
    pace.count(row.len())?;
    let p = field.modulus();
    let (negative, square) = (p - factor, p * p);
    for &(at, entry) in row {
        let cell = &mut dense[at as usize];
        let sum = *cell + negative * u64::from(entry);
        *cell = if sum >= square { sum - square } else { sum };
    }
    Ok(())
}
