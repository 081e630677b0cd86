//! From zeros of the equations to the one that is certified: the best patch among them.

use std::ops::ControlFlow;

use super::{Attempt, Consistent, NoAnswer, Reason, checked, interrupted};
use crate::algebra::{FieldElement, Polynomial, polynomial_from_exact, polynomial_to_exact};
use crate::bezier::{Image, image};
use crate::certificate::Argument;
use crate::checker::{CheckError, Claim, ExactNet, ExactRejection, Rejection};
use crate::control::Control;
use crate::elimination::{ChosenZero, Closure, System, Tried, choose};
use crate::problem::field_of;
use crate::proof::NoProof;
use crate::statement::{HomogeneousPoint, Statement, Subject};

/// What was free where there are infinitely many zeros.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Freedom {
    /// Unknowns that occur in no equation: whatever their values, the equations hold.
    pub indifferent: Vec<usize>,
    /// The values that were chosen for unknowns.
    pub chosen: Vec<(usize, FieldElement)>,
    /// Whether it was verified that there are infinitely many zeros over the complex numbers.
    pub infinite: bool,
}

/// The image of an exact net: a surface, or a curve or a point.
pub fn image_of(statement: &Statement, net: &[Vec<HomogeneousPoint>]) -> Image {
    let field = field_of(statement);
    let constant = |entry| polynomial_from_exact(field, entry).as_constant().unwrap_or_else(|| field.zero());
    let points: Vec<[FieldElement; 4]> =
        net.iter().flatten().map(|point| point.each_ref().map(constant)).collect();
    let columns = net.first().map_or(0, Vec::len);
    image(field, (net.len().saturating_sub(1) as u32, columns.saturating_sub(1) as u32), &points)
}

/// How good a certified zero is: a surface before a curve, a curve before a point, and all weights positive.
fn rank(attempt: &Attempt) -> (Image, bool) {
    match attempt {
        Attempt::Proved { proof, .. } => match proof.theorem().claim() {
            Claim::Exact(ExactNet { net, weights_positive, .. }) => {
                (image_of(proof.theorem().statement(), net), *weights_positive)
            }
            _ => BEST,
        },
        Attempt::Undecided(_) => (Image::Point, false),
    }
}

const BEST: (Image, bool) = (Image::Surface, true);

/// The best of the zeros shown to it.
#[derive(Default)]
pub(super) struct Best {
    found: Option<((Image, bool), Attempt)>,
    failure: Option<NoAnswer>,
    /// How many zeros make the denominator vanish identically.
    pub(super) without_patch: usize,
}

impl Best {
    /// Looks at a zero; `Break` when none can be better.
    pub(super) fn consider(
        &mut self,
        statement: &Statement,
        zero: Vec<FieldElement>,
        freedom: &Freedom,
        control: &Control,
    ) -> ControlFlow<()> {
        match certified(statement, zero, control) {
            Ok(Some(mut attempt)) => {
                let rank = rank(&attempt);
                if let Attempt::Proved { freedom: of_attempt, .. } = &mut attempt {
                    *of_attempt = freedom.clone();
                }
                if self.found.as_ref().is_none_or(|(best, _)| rank > *best) {
                    self.found = Some((rank, attempt));
                }
                if rank == BEST { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            }
            Ok(None) => {
                self.without_patch += 1;
                ControlFlow::Continue(())
            }
            // Another zero may be shorter.
            Err(limit @ NoAnswer::Limit(_)) => {
                self.failure = self.failure.take().or(Some(limit));
                ControlFlow::Continue(())
            }
            Err(error) => {
                self.failure = Some(error);
                ControlFlow::Break(())
            }
        }
    }

    /// The best, or what went wrong.
    pub(super) fn take(self) -> Result<Option<Attempt>, NoAnswer> {
        match (self.failure, self.found) {
            (Some(NoAnswer::Limit(_)), Some((_, found))) => Ok(Some(found)),
            (Some(error), _) => Err(error),
            (_, found) => Ok(found.map(|(_, attempt)| attempt)),
        }
    }
}

/// A zero as the checker accepts it; `None` where it makes no patch.
fn certified(
    statement: &Statement,
    zero: Vec<FieldElement>,
    control: &Control,
) -> Result<Option<Attempt>, NoAnswer> {
    let constants = zero.into_iter().take(statement.unknowns().len()).map(Polynomial::constant);
    let values = constants.map(|value| polynomial_to_exact(&value)).collect::<Result<_, _>>()?;
    match checked(statement, Argument::Exact(values), control) {
        Ok(attempt) => Ok(Some(attempt)),
        Err(NoProof::Refused(CheckError::Rejected(Rejection::Exact(ExactRejection::NoDenominator)))) => {
            Ok(None)
        }
        Err(refused) => Err(refused.into()),
    }
}

/// Infinitely many zeros: one of them, or what was tried.
pub(super) fn one_of_many(
    statement: &Statement,
    system: &System,
    closure: Closure,
    control: &Control,
) -> Result<Attempt, NoAnswer> {
    let unknowns = statement.unknowns().len();
    let occurs = |k: usize| {
        let occurs_in = |equation: &Polynomial| equation.variables().contains(&(k as u16));
        system.generators().iter().any(|(_, equation)| occurs_in(equation))
    };
    let indifferent: Vec<usize> = (0..unknowns).filter(|&k| !occurs(k)).collect();
    let freedom = |zero: &ChosenZero| Freedom {
        indifferent: indifferent.clone(),
        chosen: zero.chosen.iter().map(|(k, value)| (usize::from(*k), value.clone())).collect(),
        infinite: closure.verified,
    };
    let mut best = Best::default();
    let tried = choose(system, &closure, &weights_first(statement), control, &mut |zero| {
        let freedom = freedom(&zero);
        best.consider(statement, zero.zero, &freedom, control)
    });
    let without_patch = best.without_patch;
    // What was certified before an interruption stays certified.
    match (best.take()?, tried) {
        (Some(attempt), _) => Ok(attempt),
        (None, Err(why)) => Ok(interrupted(why)),
        (None, Ok(tried)) => Ok(undecided(statement, system, (closure, without_patch), Some(tried), control)),
    }
}

/// The unknowns, those that occur in a weight first.
fn weights_first(statement: &Statement) -> Vec<u16> {
    let field = field_of(statement);
    let mut weights = Vec::new();
    if let Subject::Patch(patch) = statement.subject() {
        for point in patch.net.iter().flatten() {
            weights.extend(polynomial_from_exact(field, &point[3]).variables());
        }
    }
    let all = 0..statement.unknowns().len() as u16;
    let (first, others): (Vec<u16>, Vec<u16>) = all.partition(|k| weights.contains(k));
    first.into_iter().chain(others).collect()
}

/// No zero was certified: the closure, with all that helps to go on.
pub(super) fn undecided(
    statement: &Statement,
    system: &System,
    (mut closure, without_patch): (Closure, usize),
    tried: Option<Tried>,
    control: &Control,
) -> Attempt {
    let isolated = tried.as_ref().and_then(|tried| tried.isolated.as_ref());
    let (of, its_closure) = isolated.map_or((system, &closure), |found| (&found.system, &found.closure));
    // Optional: that it was interrupted takes nothing from what is known.
    let extension = super::extension::find(statement, of, its_closure, control).ok().flatten();
    closure.count_real_roots(control);
    Attempt::Undecided(Reason::Consistent(Box::new(Consistent { closure, without_patch, tried, extension })))
}
