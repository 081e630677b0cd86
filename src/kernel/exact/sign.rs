//! The sign of a constant of K, decided exactly.

use std::cmp::Ordering;

use num_traits::{One, Signed};

use super::combination::combination;
use super::monomial::Monomial;
use super::polynomial::Polynomial;
use super::radicands::Radicands;
use super::work::{Limit, Work};

/// Whether a constant is negative, zero or positive (`None` for a polynomial that is not constant).
///
/// Write x = a + b√d with the last radicand d that occurs. If a and b have the same sign, that is the sign
/// of x; otherwise the larger of |a| and |b|√d decides, which a² − b²d, an element of a smaller field, tells.
pub fn sign(value: &Polynomial, field: &Radicands, work: &mut Work) -> Result<Option<Ordering>, Limit> {
    if !value.is_constant() {
        return Ok(None);
    }
    let Some(bit) = field.generators().filter(|bit| value.mask() & bit != 0).last() else {
        let rational = value.terms().next().map_or(Ordering::Equal, |(_, q)| match q.is_positive() {
            true => Ordering::Greater,
            false => Ordering::Less,
        });
        return Ok(Some(rational));
    };
    // `root` is b√d itself: the sign of b√d is found from (b√d)·√d, which lies in the smaller field.
    let (plain, root) = value.parts(bit);
    let sqrt = Polynomial::term(One::one(), Monomial::radical(bit));
    let (Some(of_plain), Some(of_root)) =
        (sign(&plain, field, work)?, sign(&root.multiply(&sqrt, field, work)?, field, work)?)
    else {
        return Ok(None);
    };
    if of_plain == of_root || of_plain == Ordering::Equal {
        return Ok(Some(of_root));
    }
    let squares = combination(&[(&plain, &plain), (&root.negate(), &root)], field, work)?;
    Ok(sign(&squares, field, work)?.map(|larger| match larger {
        Ordering::Greater => of_plain,
        _ => of_root,
    }))
}
