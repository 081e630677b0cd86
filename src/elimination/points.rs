//! Isolated zeros with coordinates in K: the roots of one eliminant after another, the rest solved anew.

use super::closure::{Closure, Eliminant};
use super::derivation::Derivation;
use super::eliminant::eliminant;
use super::strategy::Strategy;
use super::system::System;
use super::{Outcome, Undecided, run};
use crate::algebra::{FieldElement, Monomial, Polynomial};
use crate::control::{Control, Interrupted};

/// Zeros that are collected at most.
const POINTS: usize = 64;

/// Zeros over the algebraic closure up to which those in K are looked for.
const ZEROS: usize = 100;

/// Where there are too many zeros for all eliminants, that of one variable.
fn only_eliminant(
    system: &System,
    closure: &Closure,
    control: &Control,
) -> Result<Option<Eliminant>, Interrupted> {
    let few = closure.verified && closure.zeros.is_some_and(|count| count <= ZEROS);
    let variable = closure.basis.iter().flat_map(Polynomial::variables).min();
    let Some(variable) = variable.filter(|_| few && closure.eliminants.is_empty()) else { return Ok(None) };
    let polynomial = eliminant(variable, None, &closure.basis, system.field(), control)?;
    let roots = polynomial.roots_in_field(|| control.check())?;
    Ok(Some(Eliminant { variable, polynomial, roots, real_roots: None }))
}

/// The zeros in K of a system as far as [`points_in_field`] finds them, and its closure where it has finitely many and
/// is not solved by linear equations alone.
pub fn zeros_in_field(
    system: &System,
    control: &Control,
) -> Result<(Vec<Vec<FieldElement>>, Option<Closure>), Interrupted> {
    Ok(match run(&mut Derivation::new(system), Strategy::Thorough, control)? {
        Outcome::Point(point) => (vec![point], None),
        Outcome::Open(Undecided::Consistent(closure)) => {
            (points_in_field(system, &closure, control)?, Some(closure))
        }
        Outcome::Unit(_) | Outcome::Open(_) => (Vec::new(), None),
    })
}

/// Common zeros of a system in K, by variable: of up to `ZEROS` zeros all those in K, but no more than `POINTS`.
/// Nothing is claimed of them (the checker has the last word).
pub fn points_in_field(
    system: &System,
    closure: &Closure,
    control: &Control,
) -> Result<Vec<Vec<FieldElement>>, Interrupted> {
    // The variable with the fewest possible values: each is tried in turn.
    let only = only_eliminant(system, closure, control)?;
    let mut fewest: Option<(u16, &Vec<FieldElement>)> = None;
    for Eliminant { variable, polynomial, roots, .. } in closure.eliminants.iter().chain(&only) {
        if polynomial.degree() > 1 && fewest.is_none_or(|(_, others)| roots.len() < others.len()) {
            fewest = Some((*variable, roots));
        }
    }
    let Some((variable, roots)) = fewest else { return Ok(Vec::new()) };
    let mut points = Vec::new();
    for root in roots {
        let fixed =
            Polynomial::variable(system.field(), variable).add(&Polynomial::term(-root, Monomial::one()));
        let smaller = system.with_equation(fixed);
        match run(&mut Derivation::new(&smaller), Strategy::Thorough, control)? {
            Outcome::Point(point) => points.push(point),
            Outcome::Open(Undecided::Consistent(closure)) => {
                points.extend(points_in_field(&smaller, &closure, control)?);
            }
            Outcome::Unit(_) | Outcome::Open(_) => {}
        }
        if points.len() >= POINTS {
            break;
        }
    }
    Ok(points)
}
