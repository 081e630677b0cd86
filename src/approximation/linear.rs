//! Small systems of linear equations in floating point.

/// The solution of a square system whose rows end with the right side, by elimination with pivots.
pub(super) fn solved(mut rows: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let size = rows.len();
    for column in 0..size {
        let pivot =
            (column..size).max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()))?;
        rows.swap(column, pivot);
        let leading = rows[column].clone();
        if leading[column].abs() < 1e-300 {
            return None;
        }
        for (_, row) in rows.iter_mut().enumerate().filter(|(number, _)| *number != column) {
            let factor = row[column] / leading[column];
            row.iter_mut().zip(&leading).for_each(|(entry, lead)| *entry -= factor * lead);
        }
    }
    Some((0..size).map(|k| rows[k][size] / rows[k][k]).collect())
}

/// The x with the smallest |Ax − b|² + ridge·|x|², from the rows of A and b.
pub(super) fn least_squares(rows: &[(Vec<f64>, f64)], unknowns: usize, ridge: f64) -> Option<Vec<f64>> {
    let mut normal = vec![vec![0.0; unknowns + 1]; unknowns];
    for (row, right) in rows {
        for (k, to) in normal.iter_mut().enumerate() {
            to.iter_mut().zip(row).for_each(|(entry, x)| *entry += row[k] * x);
            to[unknowns] += row[k] * right;
        }
    }
    normal.iter_mut().enumerate().for_each(|(k, row)| row[k] += ridge);
    solved(normal).filter(|values| values.iter().all(|value| value.is_finite()))
}

/// A = QR with orthonormal columns of Q, by Gram and Schmidt, each column cleared twice. The condition of A is not squared, as it is
/// in AᵀA.
pub(super) struct Orthogonal {
    /// Columns.
    q: Vec<Vec<f64>>,
    /// Column k has the entries 0 to k.
    r: Vec<Vec<f64>>,
}

/// A column that is, in proportion, no longer than this beside the others says nothing.
const NOTHING: f64 = 1e-14;

impl Orthogonal {
    /// Of a matrix by its columns.
    pub(super) fn of(columns: Vec<Vec<f64>>) -> Self {
        let (mut q, mut r): (Vec<Vec<f64>>, Vec<Vec<f64>>) = (Vec::new(), Vec::new());
        for mut column in columns {
            let length = norm(&column);
            let mut entries = vec![0.0; q.len()];
            for _ in 0..2 {
                for (entry, before) in entries.iter_mut().zip(&q) {
                    let part = dot(before, &column);
                    *entry += part;
                    column.iter_mut().zip(before).for_each(|(x, y)| *x -= part * y);
                }
            }
            let rest = norm(&column);
            // Kept away from zero: a direction in which nothing changes is a very long one.
            let least = (NOTHING * length).max(f64::MIN_POSITIVE.sqrt());
            entries.push(rest.max(least));
            let scale = if rest > least { 1.0 / rest } else { 0.0 };
            column.iter_mut().for_each(|x| *x *= scale);
            q.push(column);
            r.push(entries);
        }
        Orthogonal { q, r }
    }

    /// The x with the smallest |Ax − b|².
    pub(super) fn solved(&self, right: &[f64]) -> Vec<f64> {
        self.step(&self.q.iter().map(|column| dot(column, right)).collect::<Vec<_>>())
    }

    /// x from s = Rx.
    pub(super) fn step(&self, white: &[f64]) -> Vec<f64> {
        let mut result = white.to_vec();
        for k in (0..white.len()).rev() {
            result[k] /= self.r[k][k];
            let value = result[k];
            for (to, factor) in result[..k].iter_mut().zip(&self.r[k]) {
                *to -= factor * value;
            }
        }
        result
    }

    /// The coefficients of a form in x, as those of a form in s = Rx.
    pub(super) fn slopes(&self, form: &[f64]) -> Vec<f64> {
        let mut result: Vec<f64> = Vec::with_capacity(form.len());
        for (entries, value) in self.r.iter().zip(form) {
            let done = dot(entries, &result);
            result.push((value - done) / entries[result.len()]);
        }
        result
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}
