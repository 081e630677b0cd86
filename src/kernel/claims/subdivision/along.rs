//! F, W and Wᵉ along a patch.

use num_rational::BigRational;

use super::{Quantity, Rejection};
use crate::equations::{Expanded, expand};
use crate::exact::{Arithmetic, Limit, Polynomial, Stop};
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
pub(in crate::claims) struct Along {
    pub(in crate::claims) expanded: Expanded,
    power: Polynomial,
}

impl Along {
    pub(in crate::claims) fn of(patch: &Patch, arithmetic: &mut Arithmetic<'_>) -> Result<Self, Stop> {
        let expanded = expand(patch, arithmetic)?;
        let power = arithmetic.power(&expanded.weight, patch.surface.degree())?;
        Ok(Along { expanded, power })
    }

    /// F − bound·Wᵉ, bound·Wᵉ − F, or W.
    pub(in crate::claims) fn side(
        &self,
        side: Side,
        bound: BigRational,
        arithmetic: &mut Arithmetic<'_>,
    ) -> Result<Polynomial, Limit> {
        let (surface, power) = (&self.expanded.surface, &self.power);
        let (one, minus_one) = (Polynomial::integer(1), Polynomial::integer(-1));
        let bound = Polynomial::rational(bound);
        match side {
            Side::Lower => {
                let negative = arithmetic.negated(&bound)?;
                arithmetic.dot(&[(&one, surface), (&negative, power)])
            }
            Side::Upper => arithmetic.dot(&[(&bound, power), (&minus_one, surface)]),
            Side::Weight => arithmetic.copied(&self.expanded.weight),
        }
    }
}
