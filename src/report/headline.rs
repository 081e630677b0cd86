//! The first line of a proof: what was established, of which surface.

use super::mathematics::Notation;
use crate::bezier::Image;
use crate::checker::{Claim, Theorem};
use crate::prove::image_of;
use crate::statement::{Statement, Subject};

/// Characters of a surface in a first line; a longer one is cut there, and stands in full below.
const SURFACE: usize = 60;
/// Unknowns, and characters of assumptions, that a first line names.
const NAMED: usize = 4;
const ASSUMED: usize = 40;

/// What is said where a file leaves the surface out.
const DEFAULT: &str = "(the file names none: the unit sphere)";

/// The surface of a patch in a sentence: `the unit sphere X² + Y² + Z² − W² = 0`, or, where the file names none, with that said.
pub fn surface_phrase(statement: &Statement) -> String {
    let Subject::Patch(patch) = statement.subject() else { return String::new() };
    let equation = Notation::new(statement.coordinate_ring()).shortened(&patch.surface, SURFACE);
    match (statement.names_surface(), patch.is_on_unit_sphere()) {
        (true, true) => format!("the unit sphere {equation} = 0"),
        (true, false) => format!("the surface {equation} = 0"),
        (false, _) => format!("the surface {equation} = 0 {DEFAULT}"),
    }
}

/// The surface of a patch in full, for a line of its own: `X² + Y² − W² = 0`; nothing for a system.
pub fn surface_equation(statement: &Statement) -> String {
    let Subject::Patch(patch) = statement.subject() else { return String::new() };
    let equation = Notation::new(statement.coordinate_ring()).polynomial(&patch.surface);
    let default = if statement.names_surface() { String::new() } else { format!(" {DEFAULT}") };
    format!("{equation} = 0{default}")
}

/// What follows the name in the first line. `source` is what the user called the statement on the command line.
pub(super) fn headline(source: &str, theorem: &Theorem) -> String {
    let statement = theorem.statement();
    let unknowns = statement.unknowns();
    let patch = matches!(statement.subject(), Subject::Patch(_));
    match theorem.claim() {
        Claim::Impossible { .. } if patch && unknowns.is_empty() => format!(
            "this patch does not lie on {}; {}",
            surface_phrase(statement),
            how_far(statement, source)
        ),
        Claim::Impossible { .. } if patch => format!(
            "no such patch lies on {}, for any {}{}",
            surface_phrase(statement),
            values_of(unknowns),
            assuming(statement)
        ),
        Claim::Impossible { .. } if unknowns.is_empty() => {
            "the equations of the system do not all hold".to_owned()
        }
        Claim::Impossible { .. } => {
            format!("no common zero, for any {}{}", values_of(unknowns), assuming(statement))
        }
        Claim::Exact(exact) => {
            let patch = if unknowns.is_empty() { "this patch" } else { "at the values below the patch" };
            let lies = match image_of(statement, &exact.net) {
                Image::Surface => "lies on",
                Image::Curve => "shrinks to a curve, which lies on",
                Image::Point => "shrinks to a point, which lies on",
            };
            format!("{patch} {lies} {}", surface_phrase(statement))
        }
        Claim::Solution { .. } if unknowns.is_empty() => "the equations of the system hold".to_owned(),
        Claim::Solution { .. } => "the system has this solution".to_owned(),
        // Elimination proves nothing of this kind; what it is would be said like this.
        _ => theorem.kind().to_owned(),
    }
}

/// Where to go on with a patch that has no unknowns and is not on its surface.
fn how_far(statement: &Statement, source: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-_./".contains(c);
    let quoted = match source.chars().all(plain) {
        true => source.to_owned(),
        false => format!("'{}'", source.replace('\'', r"'\''")),
    };
    let Subject::Patch(patch) = statement.subject() else { return String::new() };
    match patch.is_on_unit_sphere() {
        true => format!("how far: `prove-cap bound {quoted}`"),
        false => format!(
            "how large F/W{} is on it: `prove-cap bound {quoted}`",
            super::mathematics::superscript(patch.surface.degree())
        ),
    }
}

/// `value of w`, `values of w, z`, `values of its 16 unknowns`.
fn values_of(unknowns: &[String]) -> String {
    match unknowns {
        [one] => format!("value of {one}"),
        few if few.len() <= NAMED => format!("values of {}", few.join(", ")),
        many => format!("values of its {} unknowns", many.len()),
    }
}

/// ` with d ≠ 0`, or nothing.
fn assuming(statement: &Statement) -> String {
    let notation = Notation::new(statement.ring());
    // Of constants there is nothing to assume: the reader has refused 0.
    let all: Vec<_> = statement.nonzero().iter().filter(|polynomial| !polynomial.is_constant()).collect();
    let assumed: Vec<String> =
        all.iter().map(|polynomial| format!("{} ≠ 0", notation.polynomial(polynomial))).collect();
    let text = assumed.join(", ");
    match (all.len(), text.chars().count() <= ASSUMED) {
        (0, _) => String::new(),
        (_, true) => format!(" with {text}"),
        (1, false) => " that the assumption below allows".to_owned(),
        (many, false) => format!(" that the {many} assumptions below allow"),
    }
}
