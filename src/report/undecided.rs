//! Why nothing was established.

use std::fmt::Write as _;

use super::attempt::LINE;
use super::mathematics::Notation;
use crate::algebra::{Monomial, Polynomial, polynomial_to_exact};
use crate::control::Interrupted;
use crate::elimination::{Closure, Undecided};
use crate::exact::Limit;
use crate::prove::{Reason, field_of};
use crate::statement::Statement;

/// Polynomials of a basis that are printed.
const BASIS: usize = 16;

/// The reason in a few words.
pub(super) fn headline(reason: &Reason) -> &'static str {
    match reason {
        Reason::NoDenominator => "the only solution has no denominator",
        Reason::Limited { .. } => "beyond the limits of the checker",
        Reason::Elimination(Undecided::Consistent(closure)) if !closure.verified => {
            "neither a contradiction nor a zero was established"
        }
        Reason::Elimination(Undecided::Consistent(closure)) if closure.dimension > 0 => {
            "infinitely many complex zeros"
        }
        Reason::Elimination(Undecided::Consistent(_)) => "there are complex zeros",
        Reason::Elimination(Undecided::TooLarge { .. }) => "the search became too large",
        Reason::Elimination(Undecided::Interrupted(_)) => "stopped early",
    }
}

/// The reason in full.
pub(super) fn reason_text(statement: &Statement, reason: &Reason) -> Result<String, Limit> {
    let mut text = String::new();
    match reason {
        Reason::NoDenominator => {
            let _ = writeln!(
                text,
                "The equations have one common zero, at which the denominator W of the patch is the zero polynomial.\nThat is no patch; and since there is a zero, no certificate of impossibility exists."
            );
        }
        Reason::Limited { limit, found } => {
            let _ = match found {
                false => writeln!(
                    text,
                    "The independent checker could not derive the equations, whatever the argument: {limit}.\nNone was looked for."
                ),
                true => writeln!(
                    text,
                    "An argument was found, but the independent checker cannot follow it: {limit}.\nWhat it has not verified is not claimed."
                ),
            };
        }
        Reason::Elimination(Undecided::TooLarge { degree, matrix: (rows, columns) }) => {
            let _ = writeln!(
                text,
                "Among the multiples of the equations up to degree {degree} no combination that is 1 was found (modulo a prime).\nThe next matrix would have {columns} columns and {rows} rows or more: that is beyond this engine."
            );
        }
        Reason::Elimination(Undecided::Interrupted(Interrupted { why, reached })) => {
            let _ = writeln!(text, "Stopped: {why}. Nothing was established.");
            if let Some(reached) = reached {
                let _ = writeln!(text, "Reached: {reached}.");
            }
        }
        Reason::Elimination(Undecided::Consistent(closure)) => {
            let field = statement.field();
            let zeros = match closure.zeros {
                Some(count) => {
                    format!("finitely many over the complex numbers: {count}, counted with multiplicity")
                }
                None => format!(
                    "infinitely many over the complex numbers: a set of dimension {}",
                    closure.dimension
                ),
            };
            let _ = match closure.verified {
                true => writeln!(
                    text,
                    "A Gröbner basis, verified over {field}, does not contain 1, so the equations have common zeros,\n\
                     {zeros}.\nA certificate of impossibility therefore does not exist.\n"
                ),
                false => writeln!(
                    text,
                    "What looks like a Gröbner basis modulo a prime does not contain 1. Over {field} that was not verified. If it is\n\
                     one, the equations have common zeros, {zeros}.\n"
                ),
            };
            let everywhere = closure.linear.is_empty() && closure.basis.is_empty();
            if !everywhere {
                text += &coordinates(statement, closure)?;
            }
            let notation = Notation::new(statement.ring());
            let basis: Vec<_> = closure.linear.iter().chain(&closure.basis).collect();
            let heading = match basis.as_slice() {
                [] => {
                    "The equations hold for all values of the unknowns: give them values to have the result verified."
                }
                _ if closure.verified => "The equations are equivalent to",
                _ => "From the equations follow",
            };
            let _ = writeln!(text, "{heading}");
            for polynomial in basis.iter().take(BASIS) {
                let exact = polynomial_to_exact(polynomial)?;
                let _ = writeln!(text, "   {} = 0", notation.shortened(&exact, LINE));
            }
            if basis.len() > BASIS {
                let _ = writeln!(text, "   … and {} more", basis.len() - BASIS);
            }
        }
    }
    Ok(text)
}

/// The possible coordinates of finitely many zeros: for each unknown its eliminant and how many real roots it has.
fn coordinates(statement: &Statement, closure: &Closure) -> Result<String, Limit> {
    let field = statement.field();
    let unknowns = statement.unknowns();
    let of_unknowns = closure.eliminants.iter().filter_map(|(variable, eliminant)| {
        Some((*variable, unknowns.get(usize::from(*variable))?, eliminant))
    });
    let mut text = String::new();
    let (mut real, mut in_field) = (true, true);
    for (variable, name, eliminant) in of_unknowns {
        let terms = (0u32..).zip(eliminant.coefficients()).map(|(k, c)| {
            let powers = if k == 0 { Vec::new() } else { vec![(variable, k)] };
            (Monomial::from_powers(powers), c.clone())
        });
        let polynomial = Polynomial::from_terms(field_of(statement), terms);
        let formula = Notation::new(statement.ring()).shortened(&polynomial_to_exact(&polynomial)?, LINE);
        let roots = match eliminant.count_real_roots() {
            Some(0) => {
                real = false;
                "no real root".to_owned()
            }
            Some(1) => "1 real root".to_owned(),
            Some(count) => format!("{count} real roots"),
            None => "real roots not counted".to_owned(),
        };
        let inside = match eliminant.roots_in_field() {
            Some(roots) if roots.is_empty() => {
                in_field = false;
                format!(", none in {field}")
            }
            Some(_) => String::new(),
            None => format!(", not searched for roots in {field}"),
        };
        let _ = writeln!(text, "   {name} is a root of {formula}: {roots}{inside}");
    }
    let conclusion = match (closure.eliminants.is_empty(), real, in_field) {
        (true, ..) => format!("Whether one of the zeros is real, or lies in {field}, was not decided."),
        (_, false, _) => {
            "So no zero is real. That was computed, but this program has no certificate for it.".to_owned()
        }
        (_, _, false) => format!("So no zero lies in {field}; one over a larger field may be real."),
        _ => format!("No zero in {field} was found; that there is none was not decided."),
    };
    let _ = writeln!(text, "{conclusion}\n");
    Ok(text)
}
