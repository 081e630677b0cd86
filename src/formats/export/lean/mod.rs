//! Lean 4 with Mathlib: the geometric theorem over ℝ, every equation of the proof by `linear_combination`.
//!
//! There was no Lean where this was written, so the text has never been compiled, and says so. What can be known without Lean
//! is that every identity it asks `ring` for is one: `tests/formats/export_lean.rs` reads them back and multiplies them out. For the same
//! reason the text uses few and old tactics: `linear_combination`, `ring`, `norm_num`, `simp only` to unfold definitions.
//!
//! Roots are variables r with r² = d until the last theorem, so that `ring` sees atoms. A theorem about the patch is proved in small pieces:
//! first along u, for any curve, then along v, row by row; the equations `c[r,s]` follow from vanishing at sample points.

mod argument;
mod forms;
mod names;
mod patch;
mod system;
mod vanish;

use std::fmt::Write;

use super::case::{Case, ExportError, Reasoning};
use super::text::harmless;
use crate::statement::Subject;
use names::Names;

pub(super) fn export(case: &Case) -> Result<String, ExportError> {
    let names = Names::of(case);
    let body = match &case.subject {
        Subject::Patch(patch) => patch::write(case, &names, patch)?,
        Subject::System(_) => system::write(case, &names)?,
    };
    Ok(format!("{}\n{OPENING}\n{}\n\nend\n\nend ProveCap\n", heading(case), body.trim_end()))
}

const OPENING: &str = "\
import Mathlib

set_option linter.unusedVariables false
set_option maxHeartbeats 0
set_option maxRecDepth 1000000

namespace ProveCap

noncomputable section
";

/// The comment on top: nothing else of it is taken from what others wrote, and that only as `harmless` leaves it.
fn heading(case: &Case) -> String {
    let mut text = format!("/-\n{}\n\nStatement sha256 {}\n\n", case.title, case.hash);
    text += "NOT COMPILED by prove-cap, which has never seen a Lean toolchain. What its tests checked is that every\n";
    text += "linear_combination and every ring below is an identity of polynomials. The verdict is Lean's:\n";
    text += "in a project that depends on Mathlib, lake env lean FILE must print no error and no warning of sorry.\n";
    for radicand in case.field.values() {
        let _ = write!(text, "\nr{radicand} is the square root of {radicand}");
    }
    for (number, name) in (1..).zip(&case.unknowns) {
        let _ = write!(text, "\nx{number} is the unknown {}", harmless(name));
        if let Reasoning::Exact(_) = case.argument {
            text += ", which has a value here";
        }
    }
    text + "\n-/"
}
