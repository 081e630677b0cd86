//! How the unknowns of a statement and its assumptions stand in a Coq file.

use super::{names, spell};
use crate::exact::Polynomial;
use crate::formats::export::case::Case;
use crate::formats::export::text::harmless;

/// What theorems say of the unknowns, in Coq.
pub(super) struct Unknowns {
    /// Their names, in order.
    pub names: Vec<String>,
    /// `forall w z : R,`, then a line for each assumption: `w <> 0 ->`; or nothing.
    pub quantified: String,
    /// ` (w z : R)` behind the name of a definition.
    pub parameters: String,
    /// What a proof introduces first: `w z H_1`.
    pub introduced: Vec<String>,
    /// The values of all variables: unknowns, then 1/d for each assumption d ≠ 0.
    pub values: String,
    /// Proves that each 1/d is the inverse of d.
    pub inverses: String,
}

impl Unknowns {
    pub(super) fn of(case: &Case) -> Unknowns {
        let names: Vec<String> = case.unknowns.iter().map(|unknown| names::name(unknown)).collect();
        let joined = names.join(" ");
        let spelled = |assumed: &Polynomial| spell::expression(assumed, &case.field, &names);
        let conditions = case.assumptions.iter().map(|assumed| format!("\n  {} <> 0 ->", spelled(assumed)));
        let hypotheses: Vec<String> = (1..=case.assumptions.len()).map(|k| format!("H_{k}")).collect();
        let inverse = |assumed| format!("/ {}", spell::argument(assumed, &case.field, &names));
        let inverses = hypotheses.iter().map(|name| format!("constructor; [exact (Rinv_r _ {name}) |]; "));
        Unknowns {
            quantified: match names.is_empty() {
                true => conditions.collect(),
                false => format!(" forall {joined} : R,{}", conditions.collect::<String>()),
            },
            parameters: if names.is_empty() { String::new() } else { format!(" ({joined} : R)") },
            values: spell::list(names.iter().cloned().chain(case.assumptions.iter().map(inverse))),
            inverses: format!("{}constructor", inverses.collect::<String>()),
            introduced: [names.clone(), hypotheses].concat(),
            names,
        }
    }

    /// A function applied to the unknowns, as an argument.
    pub(super) fn applied(&self, function: &str) -> String {
        if self.names.is_empty() { function.into() } else { format!("({function} {})", self.names.join(" ")) }
    }

    /// `intros w z H_1 more.`, or nothing.
    pub(super) fn intros(&self, more: &str) -> String {
        let all = [self.introduced.join(" "), more.to_owned()].join(" ");
        if all.trim().is_empty() { String::new() } else { format!("intros {}.", all.trim()) }
    }

    /// `For all real values of the unknowns `, if there are any.
    pub(super) fn for_all(&self) -> &'static str {
        if self.names.is_empty() { "" } else { "For all real values of the unknowns " }
    }

    /// A table of names for people, where some could not be kept.
    pub(super) fn renamed(&self, case: &Case) -> String {
        let changed = case.unknowns.iter().zip(&self.names).filter(|(unknown, name)| unknown != name);
        let rows: Vec<String> =
            changed.map(|(unknown, name)| format!("{name} for {}", harmless(unknown))).collect();
        if rows.is_empty() { String::new() } else { format!("\n    Names: {}.", rows.join(", ")) }
    }
}
