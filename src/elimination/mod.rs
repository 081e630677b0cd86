//! Elimination: from equations to 1, with every step accounted for.
//!
//! 1. Linear equations are solved exactly and substituted into the others (`linear`).
//! 2. What is left is treated degree by degree: multiples of the equations are reduced modulo a prime, which
//!    is fast and shows *which* multiples matter (`macaulay`, `echelon`).
//! 3. Only those are combined exactly over K (`lift`). A polynomial whose degree fell is kept and multiplied
//!    again; a linear one sends us back to 1.
//!
//! Everything derived is recorded as a linear combination of what it came from (`derivation`), so that the
//! certificate is the part of that record the 1 depends on. Primes may mislead the search, never the proof.

mod choice;
mod closure;
mod compact;
mod derivation;
mod echelon;
mod eliminant;
mod grading;
mod lift;
mod linear;
mod lu;
mod macaulay;
mod points;
mod progress;
mod reconstruct;
mod rescale;
mod solve;
mod sparsify;
mod strategy;
mod system;

pub use choice::{ChosenZero, Isolated, Tried, VALUES, choose};
pub use closure::{Closure, Eliminant};
pub use derivation::{Derivation, NamedStep, Source};
pub use echelon::{Combination, Dependence, Echelon, Inserted, SparseRow};
pub use points::{points_in_field, zeros_in_field};
pub use progress::Progress;
pub use solve::solve;
pub use system::System;

use crate::algebra::FieldElement;
use crate::control::{Control, Interrupted};
use linear::{Absorbed, Linear};
use macaulay::{Macaulay, Search};
use strategy::{SHORT, Strategy};

/// How elimination ended.
#[derive(Debug, Clone)]
pub enum Outcome {
    /// 1 is a combination of the equations: they have no common zero.
    Unit(Source),
    /// Every variable is determined; the equations hold at these values. By variable.
    Point(Vec<FieldElement>),
    /// 1 was not found.
    Open(Undecided),
}

/// Why there is neither a certificate nor a solution.
#[derive(Debug, Clone)]
pub enum Undecided {
    /// The equations have common zeros over the algebraic closure, so that no certificate exists.
    Consistent(Closure),
    /// The search became too large at this degree.
    TooLarge {
        /// The last degree that was completed.
        degree: u32,
        /// Rows and columns the next matrix would have.
        matrix: (usize, usize),
    },
    /// Stopped by the user, by the clock or for want of memory.
    Interrupted(Interrupted),
}

/// Eliminates until 1, a point, or neither is found; with what was derived on the way.
pub fn eliminate<'a>(system: &'a System, control: &Control) -> (Derivation<'a>, Outcome) {
    for strategy in [Strategy::Plain, Strategy::Thorough] {
        let mut derivation = Derivation::new(system);
        let outcome = match run(&mut derivation, strategy, control) {
            Ok(outcome) => outcome,
            Err(why) => {
                return (derivation, Outcome::Open(Undecided::Interrupted(why)));
            }
        };
        let again = match &outcome {
            Outcome::Unit(unit) => derivation.length_of_proof(*unit) > SHORT,
            Outcome::Open(Undecided::TooLarge { .. }) => true,
            _ => false,
        };
        if strategy == Strategy::Thorough || !again {
            return (derivation, outcome);
        }
    }
    unreachable!("the thorough strategy is the last one")
}

fn run(
    derivation: &mut Derivation<'_>,
    strategy: Strategy,
    control: &Control,
) -> Result<Outcome, Interrupted> {
    let mut linear = Linear::new(strategy);
    let mut equations = derivation.generators();
    if strategy == Strategy::Thorough {
        let given = equations.len();
        let (symmetries, parts) = grading::homogeneous_parts(derivation, &equations, control)?;
        equations = sparsify::sparsify(derivation, parts, control)?;
        control.observe(&Progress::Parts { symmetries, equations: given, parts: equations.len() });
    }
    loop {
        let rest = match linear.absorb(derivation, &equations, control)? {
            Absorbed::Unit(unit) => return Ok(Outcome::Unit(unit)),
            Absorbed::Rest(rest) => rest,
        };
        control.observe(&Progress::Linear { solved: linear.len(), left: rest.len() });
        if rest.is_empty()
            && let Some(point) = linear.point(derivation)
        {
            return Ok(Outcome::Point(point));
        }
        match Macaulay::new(derivation, &rest, strategy).search(derivation, control)? {
            Search::Unit(unit) => return Ok(Outcome::Unit(unit)),
            Search::Linear(found) => equations.extend(found),
            // Linear polynomials are not always substituted when they turn up: they would all have to be lifted, of which 1 may
            // not need a single one.
            Search::Closed(basis) if basis.iter().any(|&f| derivation.polynomial(f).degree() == Some(1)) => {
                equations.extend(basis);
            }
            Search::Closed(basis) => {
                let closure = Closure::of(derivation, &linear, &basis, control)?;
                return Ok(Outcome::Open(Undecided::Consistent(closure)));
            }
            Search::TooLarge { degree, matrix } => {
                return Ok(Outcome::Open(Undecided::TooLarge { degree, matrix }));
            }
        }
    }
}
