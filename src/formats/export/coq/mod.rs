//! Coq (Rocq): a file whose theorem is the geometric statement, from the definitions down to False.
//!
//! A file has four parts. The definitions (statement.v) and the net are what a reader must understand. The replay (the other .v files here)
//! is a checker of certificates that is proved correct in Coq, once for all: numbers with square roots, polynomials (the standard
//! library's), grids of Bernstein coefficients, steps. The certificate is data, and Coq computes that it is one. The theorem follows.
//! No axioms but those of Coq's real numbers; the file prints them.

mod data;
mod edges;
mod exact;
mod impossible;
mod names;
mod spell;
mod system;
mod unknowns;

use super::case::{Case, ExportError, Reasoning};
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
    /// What is proved, in words: lines of a comment.
    summary: Vec<String>,
    /// Definitions that a reader must understand.
    definitions: String,
    /// The pieces of the replay beyond the common ones.
    replay: Vec<&'static str>,
    /// The certificate, and what Coq computes of it.
    data: String,
    /// The theorems, each with its proof.
    theorems: Vec<Theorem>,
}

/// A theorem with its proof.
struct Theorem {
    /// What it says, in words; a full stop is added.
    comment: String,
    name: String,
    /// The proposition: what follows the colon, with a blank or a new line in front.
    proposition: String,
    /// Tactics, a line each.
    proof: Vec<String>,
}

impl Theorem {
    fn text(&self) -> String {
        let proof: String =
            self.proof.iter().filter(|line| !line.is_empty()).map(|line| format!("  {line}\n")).collect();
        format!(
            "(** {}. *)\nTheorem {} :{}.\nProof.\n{proof}Qed.\n\n",
            self.comment, self.name, self.proposition
        )
    }
}

/// The axioms that the theorems rest on are printed, so that nobody need believe that there are no others.
fn assumptions(theorems: &[Theorem]) -> String {
    let names: Vec<&str> = theorems.iter().map(|theorem| theorem.name.as_str()).collect();
    match names.as_slice() {
        [only] => format!("Print Assumptions {only}.\n"),
        several => {
            format!("Definition theorems := ({}).\n\nPrint Assumptions theorems.\n", several.join(", "))
        }
    }
}

pub(super) fn export(case: &Case) -> Result<String, ExportError> {
    let parts = match (&case.subject, &case.argument) {
        (Subject::Patch(patch), Reasoning::Impossible(_)) => impossible::parts(case, patch),
        (Subject::Patch(patch), Reasoning::Exact(_)) => exact::parts(case, patch),
        (Subject::System(equations), Reasoning::Impossible(_)) => system::impossible(case, equations),
        (Subject::System(equations), Reasoning::Exact(_)) => system::exact(case, equations),
    };
    let replay: String =
        REPLAY.iter().copied().chain(parts.replay).map(|piece| format!("\n{piece}")).collect();
    Ok(format!(
        "(** {title}

{summary}

    Part 1 and part 4 are to be read: what is defined, and what is proved of it. Part 2 is a checker of certificates with the proof
    that it is right; part 3 is a certificate. Coq verifies all of it:  coqc FILE.v  (written for Coq 8.16; no library but its own).
    To read it: R are the real numbers, f x y is f(x, y), [a; b] a list, /\\ is and, ~ not, <> not equal, -> implies.
    The last lines print the axioms that the theorems rest on: those of Coq's real numbers.

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

{theorems}{axioms}",
        title = case.title,
        hash = case.hash,
        summary = parts.summary.iter().map(|line| format!("    {line}")).collect::<Vec<_>>().join("\n"),
        definitions = parts.definitions,
        radicands = spell::list(case.field.values().iter().map(u32::to_string)),
        data = parts.data,
        theorems = parts.theorems.iter().map(Theorem::text).collect::<String>(),
        axioms = assumptions(&parts.theorems),
    ))
}
