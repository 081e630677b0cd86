//! Elements of K of small height near a number in floating point.

use crate::algebra::{FieldElement, Integer, MultiquadraticField};

/// How near the number must be.
const TOLERANCE: f64 = 1e-12;
/// The largest common denominator that is tried.
const DENOMINATOR: i64 = 12;
/// The largest numerator.
const NUMERATOR: i64 = 24;

/// An element (Σ n_S √ΠS)/d with |n_S| ≤ 24 and the smallest d ≤ 12, for fields of degree 4 at most. It is a guess: so many
/// candidates there are that of a million random numbers one or so has such an element near it.
pub(super) fn recognise(value: f64, field: MultiquadraticField) -> Option<FieldElement> {
    let degree = field.degree();
    if degree > 4 || !value.is_finite() {
        return None;
    }
    let root = |subset: usize| {
        let radicand = field.under_root(subset).to_i64().unwrap_or(0);
        (radicand as f64).sqrt()
    };
    let roots: Vec<f64> = (1..degree).map(root).collect();
    for denominator in 1..=DENOMINATOR {
        let scaled = value * denominator as f64;
        let mut best: Option<(i64, Vec<i64>)> = None;
        let combinations = roots.iter().fold(vec![(0.0, vec![])], |sums: Vec<(f64, Vec<i64>)>, root| {
            let more = |(sum, numerators): &(f64, Vec<i64>)| {
                let (sum, numerators) = (*sum, numerators.clone());
                (-NUMERATOR..=NUMERATOR)
                    .map(move |n| (sum + n as f64 * root, [&numerators[..], &[n]].concat()))
            };
            sums.iter().flat_map(more).collect()
        });
        for (sum, numerators) in combinations {
            let rational = (scaled - sum).round();
            let near = (scaled - sum - rational).abs() < TOLERANCE * denominator as f64;
            if !near || rational.abs() > NUMERATOR as f64 {
                continue;
            }
            let height = rational.abs() as i64 + numerators.iter().map(|n| n.abs()).sum::<i64>();
            if best.as_ref().is_none_or(|(least, _)| height < *least) {
                best = Some((height, [&[rational as i64], &numerators[..]].concat()));
            }
        }
        if let Some((_, numerators)) = best {
            let numerators = numerators.into_iter().map(Integer::from).collect();
            return Some(field.element(numerators, Integer::from(denominator)));
        }
    }
    None
}
