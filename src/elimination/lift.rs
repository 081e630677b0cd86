//! From a combination found modulo p to the exact one over K.

use std::collections::BTreeMap;

use super::derivation::{Derivation, Source};
use super::echelon::SparseRow;
use super::linear::normalizing_factor;
use super::macaulay::Unlucky;
use super::solve::solve;
use crate::algebra::{FieldElement, Integer, Monomial, Polynomial, PrimeField};
use crate::control::{Control, Interrupted};

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
    control: &Control,
) -> Result<Result<Source, Unlucky>, Interrupted> {
    let field = derivation.system().field();
    let (last, others) = multiples.split_last().expect("a combination of at least one multiple");
    let rows: Vec<SparseRow> = others.iter().map(|multiple| multiple.row.clone()).collect();
    let coefficient = |multiple: &Multiple, column: u32| {
        let monomial = monomials[column as usize].quotient(&multiple.multiplier)?;
        derivation.polynomial(multiple.source).coefficient(&monomial)
    };
    let entry = |k: usize, column: u32| coefficient(&others[k], column).cloned();
    let right = |column: u32| coefficient(last, column).map(|value| -value);
    let Some((factors, denominator)) = solve(&rows, entry, right, prime, field, control)? else {
        return Ok(Err(Unlucky));
    };

    let of_last = field.rational(denominator, Integer::one());
    let mut terms: BTreeMap<Source, Vec<(Monomial, FieldElement)>> = BTreeMap::new();
    for (multiple, factor) in others.iter().zip(factors).chain([(last, of_last)]) {
        terms.entry(multiple.source).or_default().push((multiple.multiplier.clone(), factor));
    }
    let combination: Vec<(Source, Polynomial)> =
        terms.into_iter().map(|(source, terms)| (source, Polynomial::from_terms(field, terms))).collect();
    let products = combination.iter().map(|(source, by)| (by, derivation.polynomial(*source)));
    let sum = Polynomial::sum_of_products(field, products, control)?;
    if sum.leading_term().is_none_or(|(monomial, _)| monomial != leading) {
        return Ok(Err(Unlucky));
    }
    let factor = normalizing_factor(&sum);
    let scaled = combination.into_iter().map(|(source, by)| (source, by.scaled(&factor))).collect();
    Ok(Ok(derivation.record(scaled, sum.scaled(&factor))))
}
