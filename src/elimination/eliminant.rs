//! Eliminants: for finitely many zeros, the polynomial in one variable that vanishes at their coordinates.

use super::closure::normal_form;
use crate::algebra::{FieldElement, MultiquadraticField, Polynomial, Univariate};
use crate::control::{Control, Interrupted};

/// The polynomial of least degree in `variable` that lies in the ideal of a Gröbner basis, which must have finitely
/// many zeros. A variable that was eliminated comes with the linear equation that is `solved` for it.
///
/// The powers of the variable, reduced, lie in a space of finite dimension: the first that depends on those before
/// it gives the eliminant (Cox, Little, O'Shea, Using Algebraic Geometry, section 2.2).
pub(super) fn eliminant(
    variable: u16,
    solved: Option<&Polynomial>,
    basis: &[Polynomial],
    field: MultiquadraticField,
    control: &Control,
) -> Result<Univariate, Interrupted> {
    let plain = Polynomial::variable(field, variable);
    // variable = −(the other terms of its equation).
    let image = solved.map_or(plain.clone(), |equation| plain.add_scaled(&field.integer(-1), equation));
    let image = normal_form(&image, basis, control)?;

    let mut power = Polynomial::constant(field.one());
    // Reduced powers in echelon form, each with the combination of powers that it is.
    let mut rows: Vec<(Polynomial, Vec<FieldElement>)> = Vec::new();
    loop {
        let degree = rows.len();
        control.check()?;
        let mut rest = power.clone();
        let mut combination = vec![field.zero(); degree + 1];
        combination[degree] = field.one();
        for (row, of_row) in &rows {
            let (leading, _) = row.leading_term().expect("rows are not zero");
            control.check()?;
            let Some(factor) = rest.coefficient(leading).map(|value| -value) else { continue };
            rest = rest.add_scaled(&factor, row);
            for (cell, value) in combination.iter_mut().zip(of_row) {
                *cell = &*cell + &(value * &factor);
            }
        }
        let Some((_, coefficient)) = rest.leading_term() else {
            return Ok(Univariate::new(field, combination));
        };
        let inverse = coefficient.inverse().expect("coefficients are not zero");
        rows.push((rest.scaled(&inverse), combination.iter().map(|value| value * &inverse).collect()));
        // Rows that lead higher first, so that one pass reduces.
        rows.sort_by(|(a, _), (b, _)| b.leading_term().map(|t| &t.0).cmp(&a.leading_term().map(|t| &t.0)));
        power = normal_form(&power.multiply(&image), basis, control)?;
    }
}
