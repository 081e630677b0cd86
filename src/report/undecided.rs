//! Why nothing was established.

use std::fmt::Write as _;

use super::attempt::LINE;
use super::mathematics::Notation;
use crate::elimination::Undecided;
use crate::exact::Limit;
use crate::prove::Reason;
use crate::statement::Statement;

/// Polynomials of a basis that are printed.
const BASIS: usize = 16;

/// The reason in a few words.
pub(super) fn headline(reason: &Reason) -> &'static str {
    match reason {
        Reason::NoDenominator => "the only solution has no denominator",
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
        Reason::Elimination(Undecided::TooLarge { degree, matrix: (rows, columns) }) => {
            let _ = writeln!(
                text,
                "1 is no combination of multiples of the equations up to degree {degree}. The next matrix would have\n{rows} rows and {columns} columns, more than this engine reduces."
            );
        }
        Reason::Elimination(Undecided::Interrupted(why)) => {
            let _ = writeln!(text, "Stopped: {why}. Nothing was established.");
        }
        Reason::Elimination(Undecided::Consistent(closure)) => {
            let field = statement.field();
            let evidence = if closure.verified {
                format!("A Gröbner basis, verified over {field}, does not contain 1")
            } else {
                "A Gröbner basis modulo a prime, not verified, does not contain 1".to_owned()
            };
            let zeros = match closure.zeros {
                Some(count) => {
                    format!("finitely many over the complex numbers: {count}, counted with multiplicity")
                }
                None => format!(
                    "infinitely many over the complex numbers: a set of dimension {}",
                    closure.dimension
                ),
            };
            let _ = writeln!(text, "{evidence}, so the equations have common zeros,\n{zeros}.");
            let _ = writeln!(
                text,
                "A certificate of impossibility therefore does not exist. Whether one of the zeros is real, or lies in\n{field}, was not decided.\n"
            );
            let notation = Notation::new(statement.ring());
            let basis: Vec<_> = closure.linear.iter().chain(&closure.basis).collect();
            let _ = writeln!(text, "The equations are equivalent to");
            for polynomial in basis.iter().take(BASIS) {
                let exact = crate::algebra::polynomial_to_exact(polynomial)?;
                let _ = writeln!(text, "   {} = 0", notation.shortened(&exact, LINE));
            }
            if basis.len() > BASIS {
                let _ = writeln!(text, "   … and {} more", basis.len() - BASIS);
            }
        }
    }
    Ok(text)
}
