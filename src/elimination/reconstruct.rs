//! Rational numbers from their residues (Wang 1981, doi:10.1145/800206.806398; von zur Gathen and Gerhard, section 5.10).

use crate::algebra::Integer;
use crate::control::{Control, Interrupted, Pace};

/// Binary digits by which numerator · denominator must be shorter than the modulus, so that a wrong guess is unlikely.
const MARGIN: u64 = 40;

/// Bits that go through divisions between two questions whether to go on.
const DIVIDED: usize = 1 << 24;

/// Numerators over one common denominator that are congruent to `residues` modulo `modulus` and clearly smaller;
/// `None` if the modulus is too small for that.
pub(super) fn reconstruct(
    residues: &[Integer],
    modulus: &Integer,
    control: &Control,
) -> Result<Option<(Vec<Integer>, Integer)>, Interrupted> {
    let mut pace = control.every(DIVIDED);
    let mut denominator = Integer::one();
    // (numerator, the denominator it was found with).
    let mut found: Vec<(Integer, Integer)> = Vec::with_capacity(residues.len());
    for residue in residues {
        let fraction = fraction(&(residue * &denominator), modulus, denominator.bits(), &mut pace)?;
        let Some((numerator, more)) = fraction else { return Ok(None) };
        denominator = &denominator * &more;
        found.push((numerator, denominator.clone()));
    }
    let lifted = found.into_iter().map(|(numerator, of)| &numerator * &denominator.exact_quotient(&of));
    Ok(Some((lifted.collect(), denominator)))
}

/// The fraction congruent to `residue` that the Euclidean algorithm shows first: |numerator| below √modulus.
fn fraction(
    residue: &Integer,
    modulus: &Integer,
    taken: u64,
    pace: &mut Pace<'_>,
) -> Result<Option<(Integer, Integer)>, Interrupted> {
    let total = modulus.bits();
    let half = total / 2;
    let (mut larger, mut smaller) = (modulus.clone(), residue.modulo(modulus));
    // The negative remainder of least absolute value saves the whole algorithm for negative integers.
    let complement = &larger - &smaller;
    if complement.bits() <= half.saturating_sub(taken) {
        return Ok(Some((-&complement, Integer::one())));
    }
    let (mut before, mut cofactor) = (Integer::zero(), Integer::one());
    while smaller.bits() > half {
        pace.count(total as usize)?;
        let (quotient, remainder) = larger.quotient_and_remainder(&smaller);
        larger = std::mem::replace(&mut smaller, remainder);
        let next = &before - &(&quotient * &cofactor);
        before = std::mem::replace(&mut cofactor, next);
    }
    if smaller.bits() + cofactor.bits() + taken + MARGIN > total {
        return Ok(None);
    }
    Ok(Some(if cofactor.is_negative() { (-&smaller, -&cofactor) } else { (smaller, cofactor) }))
}
