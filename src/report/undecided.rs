//! Why nothing was established.

use super::mathematics::Notation;
use super::text::LINE;
use crate::algebra::{FieldElement, Monomial, Polynomial, Sign, polynomial_to_exact};
use crate::control::Interrupted;
use crate::document::{Block, Document, Equations, Phrase};
use crate::elimination::{Closure, Eliminant, Tried, Undecided, VALUES};
use crate::exact::{self, Limit, Radicands};
use crate::problem::field_of;
use crate::prove::{Consistent, Extension, Reason};
use crate::statement::{Statement, Subject};

/// Polynomials of a basis that are printed.
const BASIS: usize = 16;

const UNVERIFIED: &str = "neither a contradiction nor a zero was established";

/// The reason in a few words.
pub(super) fn headline(reason: &Reason) -> &'static str {
    match reason {
        Reason::NoDenominator => "the only solution has no denominator",
        Reason::Limited { .. } => "beyond the limits of the checker",
        Reason::Elimination(Undecided::Consistent(closure)) if !closure.verified => UNVERIFIED,
        Reason::Consistent(consistent) if !consistent.closure.verified => UNVERIFIED,
        Reason::Consistent(consistent) if consistent.closure.dimension > 0 => "infinitely many complex zeros",
        Reason::Consistent(_) | Reason::Elimination(Undecided::Consistent(_)) => "there are complex zeros",
        Reason::Elimination(Undecided::TooLarge { .. }) => "the search became too large",
        Reason::Elimination(Undecided::Interrupted(_)) => "stopped early",
    }
}

/// The reason in full.
pub(super) fn reason_document(statement: &Statement, reason: &Reason) -> Result<Document, Limit> {
    let mut document = Document::new(statement.ring());
    match reason {
        Reason::NoDenominator => document.line(
            0,
            "The equations have one common zero, at which the denominator W of the patch is the zero polynomial.\n\
             That is no patch; and since there is a zero, no certificate of impossibility exists.",
        ),
        Reason::Limited { limit, found } => document.line(
            0,
            match found {
                false => format!(
                    "The independent checker could not derive the equations, whatever the argument: {limit}.\n\
                     None was looked for."
                ),
                true => format!(
                    "An argument was found, but the independent checker cannot follow it: {limit}.\n\
                     What it has not verified is not claimed."
                ),
            },
        ),
        Reason::Elimination(Undecided::TooLarge { degree, matrix: (rows, columns) }) => document.line(
            0,
            format!(
                "Among the multiples of the equations up to degree {degree} no combination that is 1 was found (modulo a prime).\n\
                 The next matrix would have {columns} columns and {rows} rows or more: that is beyond this engine."
            ),
        ),
        Reason::Elimination(Undecided::Interrupted(Interrupted { why, reached })) => {
            document.line(0, format!("Stopped: {why}. Nothing was established."));
            if let Some(reached) = reached {
                document.line(0, format!("Reached: {reached}."));
            }
        }
        // Elimination by itself says this; an attempt looks for zeros before it gives up.
        Reason::Elimination(Undecided::Consistent(closure)) => {
            closure_blocks(&mut document, statement, closure, (0, false))?;
        }
        Reason::Consistent(consistent) => {
            let Consistent { closure, without_patch, tried, extension } = consistent.as_ref();
            closure_blocks(&mut document, statement, closure, (*without_patch, extension.is_some()))?;
            if let Some(tried) = tried {
                document.gap();
                document.paragraph(0, tried_text(statement, tried));
            }
            if let Some(extension) = extension {
                document.gap();
                document.paragraph(0, extension_text(statement, extension, tried.as_ref())?);
            }
        }
    }
    Ok(document)
}

/// Which values were tried.
fn tried_text(statement: &Statement, tried: &Tried) -> String {
    let names = tried.unknowns.iter().filter_map(|&k| statement.unknowns().get(usize::from(k)));
    let names = names.map(String::as_str).collect::<Vec<_>>().join(", ");
    let field = statement.field();
    if names.is_empty() {
        return format!("No unknown was left to be chosen, and no zero in {field} was found.");
    }
    let count = tried.choices;
    let choices = if count == 1 { "1 choice".to_owned() } else { format!("{count} choices") };
    let values = VALUES.map(|(above, below)| {
        let sign = if above < 0 { "−" } else { "" };
        let above = above.unsigned_abs();
        if below == 1 { format!("{sign}{above}") } else { format!("{sign}{above}/{below}") }
    });
    let subject = match statement.subject() {
        Subject::Patch(_) => "patch",
        Subject::System(_) => "zero",
    };
    format!(
        "The values {} were tried for {names}, one unknown after another, {choices} in all: no {subject} \
         over {field} was found.",
        values.join(", ")
    )
}

/// The field in which there is a zero; where there are infinitely many, after the choice that leaves finitely many.
fn extension_text(
    statement: &Statement,
    extension: &Extension,
    tried: Option<&Tried>,
) -> Result<String, Limit> {
    let mut ring = statement.ring();
    let Ok(field) = Radicands::new(extension.radicands.clone()) else { return Ok(String::new()) };
    ring.field = field;
    let notation = Notation::new(ring);
    let spell = |value: &FieldElement| {
        Ok::<_, Limit>(notation.polynomial(&polynomial_to_exact(&Polynomial::constant(value.clone()))?))
    };
    let mut found = Vec::new();
    for (unknown, values) in &extension.values {
        let Some(name) = statement.unknowns().get(*unknown) else { continue };
        let value = match values.as_slice() {
            [a, b] if *a == -b && a.sign() == Sign::Negative => format!("±{}", spell(b)?),
            [a, b] if *a == -b && spell(a)?.split(' ').count() == 1 => format!("±{}", spell(a)?),
            _ => values.iter().map(spell).collect::<Result<Vec<_>, _>>()?.join(" or "),
        };
        found.push(format!("{name} = {value}"));
    }
    let mut chosen = Vec::new();
    let isolated = tried.and_then(|tried| tried.isolated.as_ref());
    for (unknown, value) in isolated.into_iter().flat_map(|isolated| &isolated.chosen) {
        let Some(name) = statement.unknowns().get(usize::from(*unknown)) else { continue };
        chosen.push(format!("{name} = {}", spell(value)?));
    }
    let chosen = if chosen.is_empty() { String::new() } else { format!("With {}: ", chosen.join(", ")) };
    let radicands = format!("with radicands = {:?} this is EXACT (prove --extend)", extension.radicands);
    Ok(match found.is_empty() {
        true if chosen.is_empty() => format!("But {radicands}."),
        true => format!("{chosen}{radicands}."),
        false => format!("{chosen}{}; {radicands}.", found.join(", ")),
    })
}

/// What the equations are equivalent to, and what that says of their zeros.
fn closure_blocks(
    document: &mut Document,
    statement: &Statement,
    closure: &Closure,
    (without_patch, larger): (usize, bool),
) -> Result<(), Limit> {
    let field = statement.field();
    let zeros = match closure.zeros {
        Some(count) => {
            format!("finitely many over the complex numbers: {count}, counted with multiplicity")
        }
        None => format!("infinitely many over the complex numbers: a set of dimension {}", closure.dimension),
    };
    document.line(
        0,
        match closure.verified {
            true => format!(
                "A Gröbner basis, verified over {field}, does not contain 1, so the equations have common zeros,\n\
                 {zeros}.\nA certificate of impossibility therefore does not exist."
            ),
            false => format!(
                "What looks like a Gröbner basis modulo a prime does not contain 1. Over {field} that was not verified. If it is\n\
                 one, the equations have common zeros, {zeros}."
            ),
        },
    );
    document.gap();
    let everywhere = closure.linear.is_empty() && closure.basis.is_empty();
    if !everywhere {
        coordinates(document, statement, closure, (without_patch, larger))?;
    }
    let basis: Vec<_> = closure.linear.iter().chain(&closure.basis).collect();
    document.line(
        0,
        match basis.as_slice() {
            [] => "The equations hold for all values of the unknowns.",
            _ if closure.verified => "The equations are equivalent to",
            _ => "From the equations follow",
        },
    );
    let mut rows = Vec::new();
    for polynomial in basis.iter().take(BASIS) {
        let left = Phrase::default().shortened(&polynomial_to_exact(polynomial)?, LINE);
        rows.push((left, Phrase::words("0"), String::new()));
    }
    document.push(Block::Equations(Equations { indent: 3, width: 0, rows }));
    if basis.len() > BASIS {
        document.line(3, format!("… and {} more", basis.len() - BASIS));
    }
    Ok(())
}

/// The possible coordinates of finitely many zeros: for each unknown its eliminant and how many real roots it has.
///
/// Then what that says of the zeros: so many in K make no patch, and `larger` says that one over a larger field was found.
fn coordinates(
    document: &mut Document,
    statement: &Statement,
    closure: &Closure,
    (without_patch, larger): (usize, bool),
) -> Result<(), Limit> {
    let field = statement.field();
    let unknowns = statement.unknowns();
    let of_unknowns =
        closure.eliminants.iter().filter(|eliminant| usize::from(eliminant.variable) < unknowns.len());
    let (mut real, mut in_field) = (true, true);
    for Eliminant { variable, polynomial: eliminant, roots: inside, real_roots } in of_unknowns {
        let terms = (0u32..).zip(eliminant.coefficients()).map(|(k, c)| {
            let powers = if k == 0 { Vec::new() } else { vec![(*variable, k)] };
            (Monomial::from_powers(powers), c.clone())
        });
        let polynomial = Polynomial::from_terms(field_of(statement), terms);
        let formula = polynomial_to_exact(&polynomial)?;
        let roots = match real_roots {
            Some(0) => {
                real = false;
                "no real root".to_owned()
            }
            Some(1) => "1 real root".to_owned(),
            Some(count) => format!("{count} real roots"),
            None => "real roots not counted".to_owned(),
        };
        let inside = if inside.is_empty() {
            in_field = false;
            format!(", none in {field}")
        } else {
            String::new()
        };
        let unknown = Phrase::default().formula(&exact::Polynomial::variable(*variable));
        let root = unknown.and(" is a root of ").shortened(&formula, LINE).and(format!(": {roots}{inside}"));
        document.line(3, root);
    }
    let conclusion = match (closure.eliminants.is_empty(), real, in_field) {
        _ if without_patch == 1 => format!(
            "At the one zero in {field} that was found the denominator W vanishes identically: that is no patch."
        ),
        _ if without_patch > 1 => format!(
            "At the {without_patch} zeros in {field} that were found the denominator W vanishes identically: they are no patches."
        ),
        // The line on the larger field says more.
        (true, ..) if larger => return Ok(()),
        (true, ..) => format!("Whether one of the zeros is real, or lies in {field}, was not decided."),
        (_, false, _) => {
            "So no zero is real. That was computed, but this program has no certificate for it.".to_owned()
        }
        (_, _, false) => format!("So no zero lies in {field}."),
        _ => format!("No zero in {field} was found; that there is none was not decided."),
    };
    document.line(0, conclusion);
    document.gap();
    Ok(())
}
