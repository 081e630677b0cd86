//! From a combination found modulo p to the exact one over K.

use std::collections::BTreeMap;

use super::control::{Control, Interrupted};
use super::derivation::{Derivation, Source};
use super::echelon::{Echelon, Inserted, SparseRow};
use super::linear::normalizing_factor;
use super::macaulay::Unlucky;
use crate::algebra::{FieldElement, Monomial, Polynomial, PrimeField};

/// multiplier · source, with the part modulo p that is to cancel.
pub(super) struct Multiple {
    pub source: Source,
    pub multiplier: Monomial,
    pub row: SparseRow,
}

/// The combination of `multiples`, the last with factor 1, that has no monomial above `leading`.
///
/// Modulo p the multiples but the last are independent above `leading`; their leading columns there give a
/// square system, regular over K because it is regular modulo p. Its solution is exact, and that *all*
/// monomials above `leading` cancel is verified; if they do not, p was unlucky.
pub(super) fn lift(
    derivation: &mut Derivation<'_>,
    multiples: &[Multiple],
    leading: &Monomial,
    monomials: &[Monomial],
    prime: &PrimeField,
    control: &Control<'_>,
) -> Result<Result<Source, Unlucky>, Interrupted> {
    let field = derivation.system().field();
    let (last, others) = multiples.split_last().expect("a combination of at least one multiple");
    let mut echelon = Echelon::new(prime.clone());
    let mut columns = Vec::new();
    for (id, multiple) in others.iter().enumerate() {
        match echelon.insert(id as u32, &multiple.row) {
            Inserted::Pivot(column) => columns.push(column),
            Inserted::Dependent(_) => return Ok(Err(Unlucky)),
        }
    }
    let entry = |multiple: &Multiple, column: u32| {
        let monomial = monomials[column as usize].quotient(&multiple.multiplier)?;
        derivation.polynomial(multiple.source).coefficient(&monomial).cloned()
    };
    // One equation for each column: Σ factor · entry = −entry of the last.
    let zero = field.zero();
    let equations: Vec<Vec<FieldElement>> = columns
        .iter()
        .map(|&column| {
            let left = others.iter().map(|multiple| entry(multiple, column).unwrap_or_else(|| zero.clone()));
            let right = entry(last, column).map_or_else(|| zero.clone(), |value| -&value);
            left.chain([right]).collect()
        })
        .collect();
    let Some(factors) = solve(equations, control)? else {
        return Ok(Err(Unlucky));
    };

    let mut combination: BTreeMap<Source, Polynomial> = BTreeMap::new();
    for (multiple, factor) in others.iter().zip(&factors).chain([(last, &field.one())]) {
        let term = Polynomial::term(factor.clone(), multiple.multiplier.clone());
        let sum = combination.entry(multiple.source).or_insert_with(|| Polynomial::zero(field));
        *sum = sum.add(&term);
    }
    let products = combination.iter().map(|(&source, by)| by.multiply(derivation.polynomial(source)));
    let sum = Polynomial::from_terms(field, products.flat_map(|product| product.terms().to_vec()));
    if sum.leading_term().is_none_or(|(monomial, _)| monomial != leading) {
        return Ok(Err(Unlucky));
    }
    let factor = normalizing_factor(&sum);
    let scaled = combination.into_iter().map(|(source, by)| (source, by.scaled(&factor))).collect();
    Ok(derivation.derive(scaled).ok_or(Unlucky))
}

/// Solves a regular square system, given as rows with the right side last. `None` if it is singular.
fn solve(
    mut rows: Vec<Vec<FieldElement>>,
    control: &Control<'_>,
) -> Result<Option<Vec<FieldElement>>, Interrupted> {
    let size = rows.len();
    for column in 0..size {
        control.check()?;
        // The sparsest row with an entry here: fewer products, and smaller numbers.
        let candidates = (column..size).filter(|&row| !rows[row][column].is_zero());
        let filled = |row: usize| rows[row][column..].iter().filter(|value| !value.is_zero()).count();
        let Some(pivot) = candidates.min_by_key(|&row| filled(row)) else {
            return Ok(None);
        };
        rows.swap(column, pivot);
        let inverse = rows[column][column].inverse().expect("the pivot is not zero");
        for value in &mut rows[column][column..] {
            if !value.is_zero() {
                *value = &*value * &inverse;
            }
        }
        let pivot_row = rows[column].clone();
        for (row, values) in rows.iter_mut().enumerate() {
            if row == column || values[column].is_zero() {
                continue;
            }
            let factor = -&values[column];
            for (value, of_pivot) in values[column..].iter_mut().zip(&pivot_row[column..]) {
                if !of_pivot.is_zero() {
                    *value = &*value + &(&factor * of_pivot);
                }
            }
        }
    }
    Ok(Some(rows.into_iter().map(|mut row| row.pop().expect("a right side")).collect()))
}
