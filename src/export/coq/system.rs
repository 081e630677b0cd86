//! Bare systems of equations.

use num_bigint::BigInt;
use num_traits::One;

use super::spell::{self, integer, list};
use super::{POSITIVE, Parts, SYSTEM, Unknowns, patch};
use crate::certificate::Premise;
use crate::exact::Polynomial;
use crate::export::case::Case;
use crate::export::integral::common_denominator;

pub(super) fn impossible(case: &Case, equations: &[Polynomial]) -> Parts {
    let unknowns = Unknowns::of(case);
    let common = common_denominator(equations);
    let common_assumptions = common_denominator(&case.assumptions);
    let scale = |premise| match premise {
        Premise::Equation(_) => common.clone(),
        Premise::Nonzero(_) => common_assumptions.clone(),
        _ => BigInt::one(),
    };
    let count = case.variable_count();
    let equation = |polynomial: &Polynomial| spell::expression(polynomial, &case.field, &unknowns.names);
    Parts {
        summary: format!(
            "    For all real values of the unknowns some equation fails: [an_equation_fails], at the end of this file.{}",
            unknowns.renamed(case)
        ),
        definitions: format!(
            "(** The left-hand sides of the equations. *)\nDefinition equations{} : list R :=\n  {}.\n",
            unknowns.parameters,
            spell::lines(equations.iter().map(equation))
        ),
        replay: vec![SYSTEM],
        data: format!(
            "{equations}
{assumptions}
{certificate}
Lemma refuted : system_refuted radicands {count} {common} equations {common_assumptions} assumptions certificate = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
",
            equations = patch::definition("equations", "list (list term)", &spell::lines(equations.iter().map(spell::terms))),
            assumptions = patch::assumptions(case),
            certificate = patch::certificate(case, &unknowns, scale),
            common = integer(&common),
            common_assumptions = integer(&common_assumptions),
        ),
        theorems: format!(
            "(** {for_all}some equation fails. *)
Theorem an_equation_fails : {quantified}Exists (fun value => value <> 0) {equations}.
Proof.
  {intros}
  refine (Replay.an_equation_fails Data.radicands eq_refl {count} {common} Data.equations {common_assumptions} Data.assumptions
            Data.certificate Data.refuted {values} eq_refl _ {equations} eq_refl).
  {inverses}.
Qed.

Theorem not_all_hold : {quantified}~ Forall (fun value => value = 0) {equations}.
Proof.
  {intros} apply Exists_Forall_neg; [intros value; destruct (Req_dec value 0); tauto |].
  {again}.
Qed.

Print Assumptions not_all_hold.
",
            for_all = if unknowns.names.is_empty() { "" } else { "For all real values of the unknowns " },
            quantified = unknowns.quantified,
            equations = unknowns.applied("equations"),
            intros = unknowns.intros,
            common = integer(&common),
            common_assumptions = integer(&common_assumptions),
            values = unknowns.values,
            inverses = unknowns.inverses,
            again = "eapply an_equation_fails; eassumption",
        ),
    }
}

pub(super) fn exact(case: &Case, equations: &[Polynomial]) -> Parts {
    let expression = |polynomial: &Polynomial| spell::expression(polynomial, &case.field, &[]);
    let common = integer(&common_denominator(equations));
    Parts {
        summary: format!(
            "    At these values of the unknowns all equations hold: [all_hold], at the end of this file.{}",
            patch::values(case)
        ),
        definitions: format!(
            "(** The left-hand sides of the equations at these values. *)\nDefinition equations : list R :=\n  {}.\n",
            spell::lines(equations.iter().map(expression))
        ),
        replay: vec![SYSTEM, POSITIVE],
        data: patch::definition("equations", "list (list term)", &spell::lines(equations.iter().map(spell::terms)))
            + &patch::nonzero_data(case),
        theorems: format!(
            "Theorem all_hold : Forall (fun value => value = 0) equations.
Proof. apply (Replay.vanishing_numbers Data.radicands eq_refl {common} Data.equations); [reflexivity | vm_compute; reflexivity]. Qed.
{}
Print Assumptions all_hold.
",
            patch::nonzero_theorems(case)
        ),
    }
}

/// The values of an exact claim, for the summary.
pub(super) fn spelled_values(case: &Case, values: &[Polynomial]) -> Vec<String> {
    let spelled = values.iter().map(|value| spell::expression(value, &case.field, &[]));
    let names = case.unknowns.iter().map(|unknown| super::names::name(unknown));
    names.zip(spelled).map(|(name, value)| format!("{name} is {value}")).collect()
}

/// `[…]` of lists, for a net.
pub(super) fn rows(rows: impl IntoIterator<Item = Vec<String>>) -> String {
    spell::lines(rows.into_iter().map(|row| format!("[{}]", row.join(";\n    "))))
}

/// The values as data.
pub(super) fn all_terms(polynomials: &[Polynomial]) -> String {
    list(polynomials.iter().map(spell::terms))
}
