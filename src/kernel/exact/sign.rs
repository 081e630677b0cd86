//! The sign of a constant of K, decided exactly.

use std::cmp::Ordering;

use num_traits::{One, Signed};

use super::arithmetic::Arithmetic;
use super::limits::Limit;
use super::monomial::Monomial;
use super::polynomial::Polynomial;

impl Arithmetic<'_> {
    /// Whether a constant is negative, zero or positive (`None` for a polynomial that is not constant).
    ///
    /// Write x = a + b√d with the last radicand d that occurs. If a and b have the same sign, that is the
    /// sign of x; otherwise the larger of |a| and |b|√d decides, which a² − b²d, an element of a smaller
    /// field, tells.
    ///
    /// # Errors
    /// See [`Arithmetic::dot`].
    pub fn sign(&mut self, value: &Polynomial) -> Result<Option<Ordering>, Limit> {
        let held = self.work.held();
        let sign = self.sign_of(value)?;
        self.work.release_to(held);
        Ok(sign)
    }

    fn sign_of(&mut self, value: &Polynomial) -> Result<Option<Ordering>, Limit> {
        if !value.is_constant() {
            return Ok(None);
        }
        let Some(bit) = self.field.generators().filter(|bit| value.mask() & bit != 0).last() else {
            let rational = value.terms().next().map_or(Ordering::Equal, |(_, q)| match q.is_positive() {
                true => Ordering::Greater,
                false => Ordering::Less,
            });
            return Ok(Some(rational));
        };
        // `root` is b√d itself: the sign of b√d is found from (b√d)·√d, which lies in the smaller field.
        let (plain, root) = self.parts(value, bit)?;
        let sqrt = Polynomial::term(One::one(), Monomial::radical(bit));
        let times_root = self.product(&root, &sqrt)?;
        let (Some(of_plain), Some(of_root)) = (self.sign(&plain)?, self.sign(&times_root)?) else {
            return Ok(None);
        };
        if of_plain == of_root || of_plain == Ordering::Equal {
            return Ok(Some(of_root));
        }
        let negative = self.negated(&root)?;
        let squares = self.dot(&[(&plain, &plain), (&negative, &root)])?;
        Ok(self.sign(&squares)?.map(|larger| match larger {
            Ordering::Greater => of_plain,
            _ => of_root,
        }))
    }
}
