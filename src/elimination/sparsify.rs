//! Equations with few terms: combinations of two equations that are shorter than one of them.
//!
//! Mirror images of a coefficient of the surface condition often differ in the signs of some squares only; sums and
//! differences of such equations have half the terms, and everything that is done with them later is shorter by half.

use super::derivation::{Derivation, Source};
use crate::algebra::{FieldElement, Polynomial};
use crate::control::{Control, Interrupted};

/// Equations beyond which all pairs are too many to look at.
const EQUATIONS: usize = 100;

/// Equations with the same span, none of which gets shorter by a multiple of another. Linear ones are left alone: they
/// are solved in any case.
pub(super) fn sparsify(
    derivation: &mut Derivation<'_>,
    equations: Vec<Source>,
    control: &Control,
) -> Result<Vec<Source>, Interrupted> {
    let (mut short, linear): (Vec<Source>, Vec<Source>) = equations
        .into_iter()
        .partition(|&f| derivation.polynomial(f).degree().is_some_and(|degree| degree > 1));
    if short.len() <= EQUATIONS {
        let mut k = 0;
        let mut unchanged = 0;
        while unchanged < short.len() {
            let f = derivation.polynomial(short[k]);
            let mut shorter = Vec::new();
            for &other in short.iter().filter(|&&other| other != short[k]) {
                control.check()?;
                shorter.extend(shortening(f, derivation.polynomial(other)).map(|shorter| (other, shorter)));
            }
            match shorter.into_iter().min_by_key(|&(other, (terms, _))| (terms, other)) {
                Some((other, (_, factor))) => {
                    let one = derivation.system().field().one();
                    let combination =
                        vec![(short[k], Polynomial::constant(one)), (other, Polynomial::constant(factor))];
                    match derivation.derive(combination, control)? {
                        Some(sum) => short[k] = sum,
                        None => {
                            short.remove(k);
                        }
                    }
                    unchanged = 0;
                }
                None => unchanged += 1,
            }
            k = if k + 1 < short.len() { k + 1 } else { 0 };
        }
    }
    Ok(linear.into_iter().chain(short).collect())
}

/// The factor for which f + factor·g has fewest terms, with their number, if that is fewer than f has.
fn shortening(f: &Polynomial, g: &Polynomial) -> Option<(usize, FieldElement)> {
    // Only monomials of g are removed, and those of g that f lacks are added.
    let shared: Vec<FieldElement> = f
        .terms()
        .iter()
        .filter_map(|(monomial, a)| Some(&-a * &g.coefficient(monomial)?.inverse()?))
        .collect();
    let added = g.terms().len() - shared.len();
    let best = shared.iter().map(|factor| (shared.iter().filter(|other| *other == factor).count(), factor));
    let (removed, factor) = best.max_by_key(|&(removed, _)| removed)?;
    (removed > added).then(|| (f.terms().len() + added - removed, factor.clone()))
}
