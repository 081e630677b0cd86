//! Isolated zeros with coordinates in K, where they are found by linear and quadratic eliminants.

use super::closure::Closure;
use super::derivation::Derivation;
use super::strategy::Strategy;
use super::system::System;
use super::{Outcome, Undecided, run};
use crate::algebra::{FieldElement, Monomial, Polynomial};
use crate::control::{Control, Interrupted};

/// Zeros that are collected at most.
const POINTS: usize = 64;

/// Common zeros of a system in K, by variable. Nothing is claimed of them (the checker has the last word), nor that
/// there are no others.
pub fn points_in_field(
    system: &System,
    closure: &Closure,
    control: &Control,
) -> Result<Vec<Vec<FieldElement>>, Interrupted> {
    // The variable with the fewest possible values: each is tried in turn.
    let candidates = closure.eliminants.iter().filter(|(_, eliminant)| eliminant.degree() > 1);
    let candidates =
        candidates.filter_map(|(variable, eliminant)| Some((*variable, eliminant.roots_in_field()?)));
    let Some((variable, roots)) = candidates.min_by_key(|(_, roots)| roots.len()) else {
        return Ok(Vec::new());
    };
    let mut points = Vec::new();
    for root in roots {
        let fixed =
            Polynomial::variable(system.field(), variable).add(&Polynomial::term(-&root, Monomial::one()));
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
