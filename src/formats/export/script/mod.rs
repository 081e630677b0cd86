//! What the scripts for computer-algebra systems have in common: the statement and the argument as a straight line of calls.
//!
//! All five languages write `add(c(1,2), 3/8*r2*x1 - 4);` in nearly the same way, so one walk serves them. What a call *does* (the expansion
//! of the patch, the replay of a step, the verdict) is written anew in each language, in its own file. Unknowns are renamed: their names, which
//! anybody may choose, stand in comments only.

mod walk;

use super::case::{Case, Reasoning};
use crate::statement::Subject;

use walk::Walk;
pub(super) use walk::{Dialect, Sums, surface};

/// The parts of a script, in a language, in their order. Words in capitals are filled in: see [`write`].
pub(super) struct Parts {
    pub(super) dialect: Dialect,
    /// How the script is run.
    pub(super) run: &'static str,
    /// The ring, the verdict, reduction modulo the roots' squares, and `assumed(inverse, polynomial)`.
    pub(super) opening: &'static str,
    /// `point(i, j, X, Y, Z, W)`, the surface and its coefficients.
    pub(super) patch: &'static str,
    /// Or `equation(polynomial)`.
    pub(super) system: &'static str,
    /// `add(premise, multiplier)`, `conclude(number, polynomial)` and what looks premises up.
    pub(super) replay: &'static str,
    /// `c(r, s)` and `f(k)`, which become `LOOKUP` there.
    pub(super) lookup: [&'static str; 2],
    /// What stands before the statement.
    pub(super) begin: &'static str,
    /// After the points of a net: the surface equation.
    pub(super) expansion: &'static str,
    /// After the steps: the last conclusion is 1.
    pub(super) impossible: &'static str,
    /// Instead of steps: no assumption is zero.
    pub(super) exact: &'static str,
    /// And all `c[r,s]` or all `f[k]` are.
    pub(super) zeros: [&'static str; 2],
    /// The last lines.
    pub(super) closing: &'static str,
}

/// The script for a case, with these values in place of more words.
pub(super) fn write(case: &Case, parts: &Parts, values: &[(&str, String)]) -> String {
    let (em, en) = highest(case);
    let (degrees, count) = match &case.subject {
        Subject::Patch(patch) => (patch.bidegree, (u64::from(em) + 1) * (u64::from(en) + 1)),
        Subject::System(polynomials) => ((0, 0), polynomials.len() as u64),
    };
    let steps = case.steps().len();
    let shared = [
        ("DEGREE_U", degrees.0.to_string()),
        ("DEGREE_V", degrees.1.to_string()),
        ("HIGHEST_U", em.to_string()),
        ("HIGHEST_V", en.to_string()),
        ("COUNT", count.to_string()),
        ("STEPS", steps.to_string()),
        ("LENGTH", if steps == 1 { "1 step".to_owned() } else { format!("{steps} steps") }),
    ];
    let fill = |template: &str| fill(&fill(template, values), &shared);
    let walk = || Walk::new(case, &parts.dialect);
    let (definitions, expansion, kind) = match case.subject {
        Subject::Patch(_) => (parts.patch, parts.expansion, 0),
        Subject::System(_) => (parts.system, "", 1),
    };

    let mut text = walk().header(parts.run);
    text.push_str(&fill(parts.opening));
    text.push_str(&fill(definitions));
    let is_refutation = matches!(case.argument, Reasoning::Impossible(_));
    if is_refutation {
        text.push_str(&fill(&parts.replay.replace("LOOKUP", parts.lookup[kind])));
    }
    text.push_str(parts.begin);
    text.push_str(&walk().statement());
    text.push_str(&fill(expansion));
    if is_refutation {
        text.push_str(&walk().steps());
        text.push_str(&fill(parts.impossible));
    } else {
        text.push_str(&fill(parts.exact));
        text.push_str(&fill(parts.zeros[kind]));
    }
    text.push_str(parts.closing);
    text
}

/// The names of all generators, in the order of [`super::case::Term`].
pub(super) fn generators(case: &Case) -> Vec<String> {
    let roots = case.field.values().iter().map(|radicand| format!("r{radicand}"));
    let variables = match &case.argument {
        Reasoning::Impossible(_) => (case.unknowns.len(), case.assumptions.len()),
        Reasoning::Exact(_) => (0, 0),
    };
    let unknowns = (1..=variables.0).map(|k| format!("x{k}"));
    roots.chain(unknowns).chain((1..=variables.1).map(|k| format!("t{k}"))).collect()
}

/// For each root its name and its square, put into a pattern with `ROOT` and `SQUARE`.
pub(super) fn roots(case: &Case, pattern: &str) -> Vec<String> {
    let square = |d: &u32| pattern.replace("ROOT", &format!("r{d}")).replace("SQUARE", &d.to_string());
    case.field.values().iter().map(square).collect()
}

/// A template with values in place of its words in capitals.
fn fill(template: &str, values: &[(&str, String)]) -> String {
    values.iter().fold(template.to_owned(), |text, (word, value)| text.replace(word, value))
}

/// Items with commas, on lines that are not too long.
pub(super) fn wrapped(items: &[String]) -> String {
    let mut text = String::new();
    let mut width = 0;
    for (position, item) in items.iter().enumerate() {
        if position > 0 {
            text.push(',');
            let full = width > 80;
            text.push(if full { '\n' } else { ' ' });
            width = if full { 0 } else { width + 2 };
        }
        text.push_str(item);
        width += item.len();
    }
    text
}

/// The equations' highest indices (em, en) in `c[r,s]`.
fn highest(case: &Case) -> (u32, u32) {
    let Subject::Patch(patch) = &case.subject else { return (0, 0) };
    let (m, n) = patch.bidegree;
    let e = patch.surface.degree();
    (e * m, e * n)
}
