//! Whether products that are known, such as w·z = 2, leave one value for each unknown.

use std::convert::Infallible;

use super::{AuditError, Claimed};
use crate::algebra::{
    FieldElement, Polynomial as Computed, Univariate, polynomial_from_exact, polynomial_to_exact,
};
use crate::exact::{Arithmetic, Polynomial};
use crate::problem::field_of;

/// What equations that hold at a point say about other points.
pub(super) enum Others {
    /// There are none, in the unknowns that occur.
    None,
    /// This unknown may have this value too.
    One(usize, Polynomial),
    /// That was not decided.
    Open,
}

/// Whether these equations, which hold at the point, hold elsewhere. An unknown is settled by an equation in which, with
/// what is settled put in, it stands alone and to the first power; a square and the like may have another root.
pub(super) fn others(
    at: &Claimed<'_>,
    equations: &[Polynomial],
    point: &[Polynomial],
) -> Result<Others, AuditError> {
    let statement = at.case.statement;
    let field = statement.field();
    let put = |equation: &Polynomial, settled: &[bool]| {
        let values: Vec<Polynomial> = (0u16..)
            .zip(point)
            .zip(settled)
            .map(|((k, value), settled)| if *settled { value.clone() } else { Polynomial::variable(k) })
            .collect();
        Arithmetic::new(field, &mut at.control.work()).substitute(equation, &values)
    };
    let mut settled = vec![false; point.len()];
    let mut open: Vec<Polynomial> = equations.to_vec();
    loop {
        open = open.iter().map(|equation| put(equation, &settled)).collect::<Result<Vec<_>, _>>()?;
        let next = open.iter().find_map(|equation| alone(equation).filter(|_| equation.degree() == 1));
        match next {
            Some(unknown) => settled[usize::from(unknown)] = true,
            None => break,
        }
    }
    open.retain(|equation| !equation.is_constant());
    if open.is_empty() {
        return Ok(Others::None);
    }
    for equation in &open {
        let Some(unknown) = alone(equation) else { continue };
        let place = usize::from(unknown);
        for root in roots(at, equation, unknown) {
            let root = polynomial_to_exact(&Computed::constant(root))?;
            let mut other = point.to_vec();
            other[place] = root.clone();
            let hold = |equation: &Polynomial| {
                Arithmetic::new(field, &mut at.control.work()).substitute(equation, &other)
            };
            let holds = equations.iter().map(hold).collect::<Result<Vec<_>, _>>()?;
            if root != point[place] && holds.iter().all(Polynomial::is_zero) {
                return Ok(Others::One(place, root));
            }
        }
    }
    Ok(Others::Open)
}

/// The only unknown that occurs; `None` if none does, or several do.
fn alone(equation: &Polynomial) -> Option<u16> {
    let mut unknowns = equation.terms().flat_map(|(monomial, _)| monomial.powers().iter().map(|(k, _)| *k));
    let first = unknowns.next()?;
    unknowns.all(|other| other == first).then_some(first)
}

/// The roots in K of an equation in one unknown, as far as they are looked for.
fn roots(at: &Claimed<'_>, equation: &Polynomial, unknown: u16) -> Vec<FieldElement> {
    let field = field_of(at.case.statement);
    let mut coefficients = vec![field.zero(); equation.degree() as usize + 1];
    for (monomial, value) in polynomial_from_exact(field, equation).terms() {
        debug_assert!(monomial.powers().iter().all(|(k, _)| *k == unknown));
        coefficients[monomial.degree() as usize] = value.clone();
    }
    let Ok(roots) = Univariate::new(field, coefficients).roots_in_field(|| Ok::<(), Infallible>(()));
    roots
}
