//! From a statement to a certificate that the independent checker has accepted.

mod extension;
mod zero;

use crate::algebra::{Polynomial, polynomial_to_exact};
use crate::certificate::{Argument, Premise, Step};
use crate::checker::{CheckError, Equations};
use crate::control::{Control, Interrupted};
use crate::elimination::{
    Closure, Derivation, NamedStep, Outcome, Progress, Source, Tried, Undecided, eliminate, points_in_field,
};
use crate::exact::{self, Arithmetic, Limit, Stop};
use crate::problem::Problem;
use crate::proof::{NoProof, Proof};
use crate::statement::Statement;

pub use extension::Extension;
use zero::{Best, one_of_many, undecided};
pub use zero::{Freedom, image_of};

/// How an attempt at a statement ended.
#[allow(clippy::large_enum_variant, reason = "one or two are alive at a time")]
#[derive(Debug, Clone)]
pub enum Attempt {
    /// The claim is established: impossible, exact, or a solution of a system.
    Proved {
        /// What the checker has accepted.
        proof: Proof,
        /// What was chosen where there are infinitely many zeros.
        freedom: Freedom,
    },
    /// Neither was established.
    Undecided(Reason),
}

/// Why nothing was established.
#[derive(Debug, Clone)]
pub enum Reason {
    /// There are common zeros over the algebraic closure, and none in K was found.
    Consistent(Box<Consistent>),
    /// Elimination did not come to an end.
    Elimination(Undecided),
    /// The only common zero makes the denominator W of the patch vanish identically: it is no patch.
    NoDenominator,
    /// What the checker would have to do is beyond its limits.
    Limited {
        /// Which one.
        limit: Limit,
        /// Whether an argument was found; if not, the checker cannot derive the equations, and none was looked for.
        found: bool,
    },
}

/// Equations that have common zeros, and what is known of them.
#[derive(Debug, Clone)]
pub struct Consistent {
    /// What the equations are equivalent to.
    pub closure: Closure,
    /// How many zeros in K were found that make the denominator W vanish identically: they are no patches.
    pub without_patch: usize,
    /// Where there are infinitely many zeros, the values that were tried.
    pub tried: Option<Tried>,
    /// A larger field in which there is a zero.
    pub extension: Option<Extension>,
}

/// What goes wrong in an attempt without being an answer.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ProveError {
    /// The checker is at fault: it found what one of its earlier checks has excluded.
    #[error("{0}")]
    Defect(Stop),
    /// The independent checker refused what the engine found: a defect of this program.
    #[error("the independent checker refused the certificate: {0}")]
    Refused(CheckError),
}

/// Why what was found is not an answer: it is too long for the checker, or an error.
enum NoAnswer {
    Limit(Limit),
    Interrupted(Interrupted),
    Error(ProveError),
}

impl From<Interrupted> for NoAnswer {
    fn from(why: Interrupted) -> Self {
        NoAnswer::Interrupted(why)
    }
}

impl From<Limit> for NoAnswer {
    fn from(limit: Limit) -> Self {
        NoAnswer::Limit(limit)
    }
}

impl From<NoProof> for NoAnswer {
    fn from(why: NoProof) -> Self {
        match why {
            NoProof::Interrupted(why) => NoAnswer::Interrupted(why),
            NoProof::Limit(limit) => NoAnswer::Limit(limit),
            NoProof::Refused(error) => NoAnswer::Error(ProveError::Refused(error)),
        }
    }
}

/// Tries to decide a statement.
///
/// # Errors
/// [`ProveError`] where the checker disagrees. What exceeds its limits is undecided.
pub fn prove(statement: &Statement, control: &Control) -> Result<Attempt, ProveError> {
    solve(&Problem::of(statement), control)
}

/// The same for a problem, whose condition is expanded once.
///
/// # Errors
/// As [`prove`] has them.
pub fn solve(problem: &Problem, control: &Control) -> Result<Attempt, ProveError> {
    // The prover has no limits of its own; what the checker cannot derive is not worth proving.
    let limited = |limit, found| match control.check() {
        Ok(()) => Ok(Attempt::Undecided(Reason::Limited { limit, found })),
        // The limit may be that the checker was stopped.
        Err(why) => Ok(interrupted(why)),
    };
    match Equations::of(problem.statement(), &mut control.work()) {
        Ok(_) => {}
        Err(Stop::Limit(limit)) => return limited(limit, false),
        Err(defect) => return Err(ProveError::Defect(defect)),
    }
    search(problem, control).or_else(|why| match why {
        NoAnswer::Limit(limit) => limited(limit, true),
        NoAnswer::Interrupted(why) => Ok(interrupted(why)),
        NoAnswer::Error(error) => Err(error),
    })
}

fn interrupted(why: Interrupted) -> Attempt {
    Attempt::Undecided(Reason::Elimination(Undecided::Interrupted(why)))
}

fn search(problem: &Problem, control: &Control) -> Result<Attempt, NoAnswer> {
    control.check()?;
    let (statement, system) = (problem.statement(), problem.system(control)?);
    let (derivation, outcome) = eliminate(&system, control);
    match outcome {
        Outcome::Unit(unit) => {
            control.observe(&Progress::Shortening);
            let argument = Argument::Impossible(steps(&derivation, unit, control)?);
            Ok(checked(statement, argument, control)?)
        }
        Outcome::Point(point) => {
            let mut best = Best::default();
            let _ = best.consider(statement, point, &Freedom::default(), control);
            Ok(best.take()?.unwrap_or(NO_DENOMINATOR))
        }
        Outcome::Open(Undecided::Consistent(closure)) if closure.dimension > 0 => {
            one_of_many(statement, &system, closure, control)
        }
        Outcome::Open(Undecided::Consistent(closure)) => {
            let points = match points_in_field(&system, &closure, control) {
                Ok(points) => points,
                Err(why) => return Ok(interrupted(why)),
            };
            let mut best = Best::default();
            for point in points {
                if best.consider(statement, point, &Freedom::default(), control).is_break() {
                    break;
                }
            }
            let none = (closure, best.without_patch);
            Ok(best.take()?.unwrap_or_else(|| undecided(statement, &system, none, None, control)))
        }
        Outcome::Open(undecided) => Ok(Attempt::Undecided(Reason::Elimination(undecided))),
    }
}

const NO_DENOMINATOR: Attempt = Attempt::Undecided(Reason::NoDenominator);

/// The certificate with this argument, and what the checker says of it.
fn checked(statement: &Statement, argument: Argument, control: &Control) -> Result<Attempt, NoProof> {
    Ok(Attempt::Proved { proof: Proof::of(statement, argument, control)?, freedom: Freedom::default() })
}

fn steps(derivation: &Derivation<'_>, unit: Source, control: &Control) -> Result<Vec<Step>, NoAnswer> {
    let Some(proof) = derivation.proof_of(unit, control)? else {
        // 1 is itself an equation of the statement. One step must conclude it, from that equation alone.
        return Ok(given_unit(derivation)?);
    };
    let mut steps = Vec::with_capacity(proof.len());
    for NamedStep { combination, conclusion } in proof {
        let mut written = Vec::with_capacity(combination.len());
        for (premise, multiplier) in combination {
            written.push((premise, polynomial_to_exact(&multiplier)?));
        }
        steps.push(Step { combination: written, conclusion: polynomial_to_exact(&conclusion)? });
    }
    Ok(steps)
}

fn given_unit(derivation: &Derivation<'_>) -> Result<Vec<Step>, Limit> {
    let one = exact::Polynomial::integer(1);
    let is_one = |(_, polynomial): &&(Premise, Polynomial)| {
        polynomial.as_constant().is_some_and(|constant| constant.is_one())
    };
    let equation = derivation.system().generators().iter().find(is_one).map(|(name, _)| *name);
    let step = equation.map(|name| Step { combination: vec![(name, one.clone())], conclusion: one });
    Ok(step.into_iter().collect())
}

/// The cofactors of the equations themselves: Σ cofactor · equation = 1, all steps multiplied out.
/// `None` where one would have more than `at_most` terms on the way.
pub fn flattened(
    statement: &Statement,
    steps: &[Step],
    at_most: usize,
    control: &Control,
) -> Option<Vec<(Premise, exact::Polynomial)>> {
    let mut work = control.work();
    let mut cofactors: Vec<std::collections::BTreeMap<Premise, exact::Polynomial>> = Vec::new();
    for step in steps {
        let mut sum = std::collections::BTreeMap::<Premise, exact::Polynomial>::new();
        for (premise, multiplier) in &step.combination {
            let of_premise = match premise {
                Premise::Step(number) => cofactors.get(*number as usize - 1)?.clone(),
                equation => [(*equation, exact::Polynomial::integer(1))].into(),
            };
            for (equation, cofactor) in of_premise {
                let product =
                    Arithmetic::new(statement.field(), &mut work).product(&cofactor, multiplier).ok()?;
                let entry = sum.entry(equation).or_default();
                *entry = Arithmetic::new(statement.field(), &mut work).sum(&[entry.clone(), product]).ok()?;
                if entry.term_count() > at_most {
                    return None;
                }
            }
        }
        sum.retain(|_, cofactor| !cofactor.is_zero());
        cofactors.push(sum);
    }
    cofactors.pop().map(|last| last.into_iter().collect())
}
