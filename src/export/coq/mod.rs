//! Coq (Rocq): a file whose theorem is the geometric statement, from the definitions down to False.
//!
//! A file has four parts. The definitions (statement.v) and the net are what a reader must understand. The replay (the other .v files here)
//! is a checker of certificates that is proved correct in Coq, once for all: numbers with square roots, polynomials (the standard
//! library's), grids of Bernstein coefficients, steps. The certificate is data, and Coq computes that it is one. The theorem follows.
//! No axioms but those of Coq's real numbers; the file prints them.

mod edges;
mod names;
mod patch;
mod spell;
mod system;

use super::case::{Case, ExportError, Reasoning};
use crate::exact::Polynomial;
use crate::statement::Subject;

const STATEMENT: &str = include_str!("statement.v");
const REPLAY: [&str; 6] = [
    include_str!("numbers.v"),
    include_str!("terms.v"),
    include_str!("lists.v"),
    include_str!("replay.v"),
    include_str!("patch.v"),
    include_str!("impossible.v"),
];
const SYSTEM: &str = include_str!("system.v");
const EXACT: &str = include_str!("exact.v");
const POSITIVE: &str = include_str!("positive.v");

/// What a claim contributes to its file.
struct Parts {
    /// What is proved, in words.
    summary: String,
    /// Definitions that a reader must understand.
    definitions: String,
    /// The pieces of the replay beyond the common ones.
    replay: Vec<&'static str>,
    /// The certificate, and what Coq computes of it.
    data: String,
    /// The theorems.
    theorems: String,
}

pub(super) fn export(case: &Case) -> Result<String, ExportError> {
    let parts = match (&case.subject, &case.argument) {
        (Subject::Patch(patch), Reasoning::Impossible(_)) => patch::impossible(case, patch),
        (Subject::Patch(patch), Reasoning::Exact(_)) => patch::exact(case, patch),
        (Subject::System(equations), Reasoning::Impossible(_)) => system::impossible(case, equations),
        (Subject::System(equations), Reasoning::Exact(_)) => system::exact(case, equations),
    };
    let replay: String =
        REPLAY.iter().copied().chain(parts.replay).map(|piece| format!("\n{piece}")).collect();
    Ok(format!(
        "(** {title}

{summary}

    Part 1 and part 4 are to be read: what is defined, and what is proved of it. Part 2 is a checker of certificates with the proof
    that it is right; part 3 is a certificate. Coq verifies all of it:  coqc FILE.v  (8.16 or later; no library but its own).
    The last line lists the axioms that the theorem rests on: those of Coq's real numbers.

    Written by prove-cap; statement sha256 {hash} *)

(** * 1. Definitions *)

{STATEMENT}
{definitions}
(** * 2. A checker of certificates, proved correct *)

Module Replay.
{replay}
End Replay.

(** * 3. The certificate *)

Module Data.

Import Replay.
Local Open Scope nat_scope.

Definition radicands : list BinInt.Z := {radicands}%Z.

{data}
End Data.

(** * 4. The theorem *)

{theorems}",
        title = case.title,
        hash = case.hash,
        summary = parts.summary,
        definitions = parts.definitions,
        radicands = spell::list(case.field.values().iter().map(u32::to_string)),
        data = parts.data,
        theorems = parts.theorems,
    ))
}

/// What theorems say of the unknowns, in Coq.
struct Unknowns {
    /// Their names, in order.
    names: Vec<String>,
    /// `forall w z : R, w <> 0 -> `, or nothing.
    quantified: String,
    /// ` (w z : R)` behind the name of a definition.
    parameters: String,
    /// ` w z` behind the name in use.
    arguments: String,
    /// `intros w z H1.`: the start of a proof.
    intros: String,
    /// The values of all variables: unknowns, then 1/d for each assumption d ≠ 0.
    values: String,
    /// Proves that each 1/d is the inverse of d.
    inverses: String,
}

impl Unknowns {
    fn of(case: &Case) -> Unknowns {
        let names: Vec<String> = case.unknowns.iter().map(|unknown| names::name(unknown)).collect();
        let joined = names.join(" ");
        let of_assumption = |assumed: &Polynomial| spell::argument(assumed, &case.field, &names);
        let hypotheses = (1..=case.assumptions.len()).map(|k| format!("H_{k}")).collect::<Vec<_>>();
        let conditions: String =
            case.assumptions.iter().map(|assumed| format!("{} <> 0 -> ", of_assumption(assumed))).collect();
        let forall = if names.is_empty() { String::new() } else { format!("forall {joined} : R, ") };
        let introduced = [joined.clone(), hypotheses.join(" ")].join(" ");
        let inverses: String =
            hypotheses.iter().map(|name| format!("constructor; [exact (Rinv_r _ {name}) |]; ")).collect();
        Unknowns {
            quantified: format!("{forall}{conditions}"),
            parameters: if names.is_empty() { String::new() } else { format!(" ({joined} : R)") },
            arguments: if names.is_empty() { String::new() } else { format!(" {joined}") },
            intros: if introduced.trim().is_empty() {
                String::new()
            } else {
                format!("intros {}.", introduced.trim())
            },
            values: spell::list(
                names
                    .iter()
                    .cloned()
                    .chain(case.assumptions.iter().map(|assumed| format!("/ {}", of_assumption(assumed)))),
            ),
            inverses: format!("{inverses}constructor"),
            names,
        }
    }

    /// A function applied to the unknowns, as an argument.
    fn applied(&self, function: &str) -> String {
        if self.names.is_empty() { function.into() } else { format!("({function}{})", self.arguments) }
    }

    /// A table of names for people, where some could not be kept.
    fn renamed(&self, case: &Case) -> String {
        let changed = case.unknowns.iter().zip(&self.names).filter(|(unknown, name)| unknown != name);
        let rows: Vec<String> = changed
            .map(|(unknown, name)| {
                format!("{name} is called {} in the statement", super::text::harmless(unknown))
            })
            .collect();
        if rows.is_empty() { String::new() } else { format!("\n    Names: {}.", rows.join("; ")) }
    }
}
