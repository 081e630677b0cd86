//! F, W and Wᵉ along a patch.

use num_rational::BigRational;

use super::{Quantity, Rejection};
use crate::equations::Expanded;
use crate::exact::{Limit, Polynomial, Radicands, Work, combination};
use crate::statement::{Patch, Statement, Subject};

/// What a sum in an argument may contain, at one point of the square; all are positive for a patch with W > 0
/// whose quantity lies strictly between the bounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Side {
    /// F − low·Wᵉ.
    Lower,
    /// high·Wᵉ − F.
    Upper,
    /// W.
    Weight,
}

impl Side {
    /// The name in a certificate.
    pub fn name(self) -> &'static str {
        match self {
            Side::Lower => "lower",
            Side::Upper => "upper",
            Side::Weight => "weight",
        }
    }
}

/// The patch of a statement that this quantity belongs to.
pub(in crate::claims) fn subject(statement: &Statement, quantity: Quantity) -> Result<&Patch, Rejection> {
    let Subject::Patch(patch) = statement.subject() else {
        return Err(Rejection::NotAPatch);
    };
    match quantity == Quantity::Radius && !patch.is_on_unit_sphere() {
        true => Err(Rejection::NotTheUnitSphere),
        false => Ok(patch),
    }
}

/// F, W and Wᵉ along the patch, in t and s.
pub(in crate::claims) struct Along<'a> {
    pub(in crate::claims) expanded: Expanded,
    pub(in crate::claims) power: Polynomial,
    pub(in crate::claims) field: &'a Radicands,
}

impl Along<'_> {
    /// F − bound·Wᵉ, bound·Wᵉ − F, or W.
    pub(in crate::claims) fn side(
        &self,
        side: Side,
        bound: BigRational,
        work: &mut Work,
    ) -> Result<Polynomial, Limit> {
        let (one, bound) = (Polynomial::integer(1), Polynomial::rational(bound));
        let (surface, power) = (&self.expanded.surface, &self.power);
        match side {
            Side::Lower => combination(&[(&one, surface), (&bound.negate(), power)], self.field, work),
            Side::Upper => combination(&[(&bound, power), (&one.negate(), surface)], self.field, work),
            Side::Weight => Ok(self.expanded.weight.clone()),
        }
    }
}
