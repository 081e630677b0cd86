//! A zero over a larger field Q(√p₁, …, √pₖ), where the field of the statement has none.

use crate::algebra::{FieldElement, MultiquadraticField, Univariate, polynomial_from_exact};
use crate::control::{Control, Interrupted};
use crate::elimination::{Closure, Eliminant, System, zeros_in_field};
use crate::exact::limits;
use crate::problem::field_of;
use crate::statement::{Statement, Subject};

/// Radicands that are tried for eliminants of degree 3 and more.
const PRIMES: [u32; 6] = [2, 3, 5, 7, 11, 13];

/// Radicands with which the statement has a zero, which was verified by substitution.
#[derive(Debug, Clone)]
pub struct Extension {
    /// All radicands, increasing.
    pub radicands: Vec<u32>,
    /// For coordinates that have no value in the smaller field: their values in the larger one, by unknown.
    pub values: Vec<(usize, Vec<FieldElement>)>,
}

/// Looks for a larger field in which the system, with finitely many zeros and none in K, has one.
pub(super) fn find(
    statement: &Statement,
    system: &System,
    closure: &Closure,
    control: &Control,
) -> Result<Option<Extension>, Interrupted> {
    let Some(eliminant) = rootless(closure) else { return Ok(None) };
    for larger in larger_fields(&eliminant.polynomial, control)? {
        if let Some(extension) = within(statement, system, larger, control)? {
            return Ok(Some(extension));
        }
    }
    Ok(None)
}

fn rootless(closure: &Closure) -> Option<&Eliminant> {
    let without = closure.eliminants.iter().filter(|eliminant| eliminant.roots.is_empty());
    without.min_by_key(|eliminant| eliminant.polynomial.degree())
}

/// The zero over a larger field, or one still larger.
fn within(
    statement: &Statement,
    system: &System,
    larger: MultiquadraticField,
    control: &Control,
) -> Result<Option<Extension>, Interrupted> {
    let lifted = system.over(larger);
    let (zeros, closure) = zeros_in_field(&lifted, control)?;
    if zeros.iter().any(|zero| is_solution(statement, &lifted, zero)) {
        let smaller = field_of(statement);
        let mut values: Vec<(usize, Vec<FieldElement>)> = Vec::new();
        for unknown in 0..statement.unknowns().len() {
            let mut of_unknown: Vec<FieldElement> = match &closure {
                Some(closure) => {
                    let of = closure.eliminants.iter().find(|e| usize::from(e.variable) == unknown);
                    of.map(|eliminant| eliminant.roots.clone()).unwrap_or_default()
                }
                None => zeros.iter().map(|zero| zero[unknown].clone()).collect(),
            };
            of_unknown.dedup();
            if !of_unknown.is_empty() && of_unknown.iter().all(|value| !value.lies_in(smaller)) {
                values.push((unknown, of_unknown));
            }
        }
        return Ok(Some(Extension { radicands: larger.radicands().to_vec(), values }));
    }
    match closure {
        Some(closure) => find(statement, &lifted, &closure, control),
        None => Ok(None),
    }
}

/// Whether all equations vanish at the zero, and it makes a patch.
fn is_solution(statement: &Statement, lifted: &System, zero: &[FieldElement]) -> bool {
    let vanish = lifted.generators().iter().all(|(_, equation)| equation.evaluate(zero).is_zero());
    let field = field_of(statement);
    let denominator = |point: &crate::statement::HomogeneousPoint| {
        !polynomial_from_exact(field, &point[3]).over(lifted.field()).evaluate(zero).is_zero()
    };
    vanish
        && match statement.subject() {
            Subject::Patch(patch) => patch.net.iter().flatten().any(denominator),
            Subject::System(_) => true,
        }
}

/// Fields above that of a polynomial without roots in which it has one, smallest first.
///
/// For degree 2 the one there is: ax² + bx + c has roots in K(√d) for rational d if and only if b² − 4ac is a square of
/// K or d times one. For higher degrees one or two of [`PRIMES`] are tried.
fn larger_fields(
    polynomial: &Univariate,
    control: &Control,
) -> Result<Vec<MultiquadraticField>, Interrupted> {
    let field = polynomial.field();
    let squarefree = polynomial.squarefree(|| control.check())?;
    if let Some(discriminant) = squarefree.discriminant() {
        let radicands = discriminant.radicands_of_root(limits::RADICAND.number());
        return Ok(radicands.and_then(|radicands| field.with(&radicands)).into_iter().collect());
    }
    if squarefree.count_real_roots(|| control.check())? == 0 {
        return Ok(Vec::new());
    }
    let singles = PRIMES.iter().map(|&p| vec![p]);
    let pairs = PRIMES.iter().enumerate().flat_map(|(k, &q)| PRIMES[..k].iter().map(move |&p| vec![p, q]));
    let mut found: Vec<MultiquadraticField> = Vec::new();
    for radicands in singles.chain(pairs) {
        control.check()?;
        let Some(larger) = field.with(&radicands) else { continue };
        if !squarefree.over(larger).roots_in_field(|| control.check())?.is_empty() {
            found.push(larger);
        }
    }
    found.dedup();
    Ok(found)
}
