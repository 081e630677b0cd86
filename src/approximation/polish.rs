//! Least squares to the last digit: Gauss and Newton's method, with equality constraints.

use itertools::iproduct;

use super::linear::solved;
use super::model::Model;

/// A few steps from near the optimum; the values as they were if these do not settle.
pub(super) fn polish(model: &Model, from: &[f64], intervals: usize, pass: &[(f64, f64)]) -> Vec<f64> {
    let unknowns = from.len();
    let at = |i: usize| i as f64 / intervals as f64;
    let mut values = from.to_vec();
    for _ in 0..20 {
        let fitted = model.at(&values);
        // The matrix of Karush, Kuhn and Tucker: JᵀJ bordered by the constraints' gradients.
        let size = unknowns + pass.len();
        let mut rows = vec![vec![0.0; size + 1]; size];
        for (i, j) in iproduct!(0..=intervals, 0..=intervals) {
            let d = fitted.ratio(at(i), at(j));
            for (k, l) in iproduct!(0..unknowns, 0..unknowns) {
                rows[k][l] += d.gradient[k] * d.gradient[l];
            }
            for (row, slope) in rows.iter_mut().zip(&d.gradient) {
                row[size] -= slope * d.value;
            }
        }
        for (number, &(u, v)) in pass.iter().enumerate() {
            let d = fitted.ratio(u, v);
            for (k, slope) in d.gradient.iter().enumerate() {
                rows[unknowns + number][k] = *slope;
                rows[k][unknowns + number] = *slope;
            }
            rows[unknowns + number][size] = -d.value;
        }
        let Some(step) = solved(rows) else { return from.to_vec() };
        let length = step[..unknowns].iter().fold(0.0f64, |most, dx| most.max(dx.abs()));
        values.iter_mut().zip(&step).for_each(|(x, dx)| *x += dx);
        if length.is_nan() || length > 0.1 {
            return from.to_vec();
        }
        if length < 1e-15 {
            break;
        }
    }
    values
}
