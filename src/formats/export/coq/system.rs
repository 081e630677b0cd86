//! Bare systems of equations.

use num_bigint::BigInt;
use num_traits::One;

use super::unknowns::Unknowns;
use super::{POSITIVE, Parts, SYSTEM, Theorem, data, exact, spell};
use crate::certificate::Premise;
use crate::exact::Polynomial;
use crate::formats::export::case::Case;
use crate::formats::export::integral::common_denominator;

/// Some equation fails, whatever the unknowns.
pub(super) fn impossible(case: &Case, equations: &[Polynomial]) -> Parts {
    let unknowns = Unknowns::of(case);
    let common = common_denominator(equations);
    let common_assumptions = common_denominator(&case.assumptions);
    let scale = |premise| match premise {
        Premise::Equation(_) => common.clone(),
        Premise::Nonzero(_) => common_assumptions.clone(),
        _ => BigInt::one(),
    };
    let shape = format!("{} {}", case.variable_count(), spell::integer(&common));
    let common_assumptions = spell::integer(&common_assumptions);
    let applied = unknowns.applied("equations");
    let mut summary = vec![format!("{}some equation fails: [an_equation_fails],", unknowns.for_all())];
    summary.push(format!("at the end of this file.{}", unknowns.renamed(case)));
    Parts {
        summary,
        definitions: definitions(case, equations, &unknowns),
        replay: vec![SYSTEM],
        data: [
            data::polynomials("equations", equations),
            data::assumptions(case),
            data::certificate(case, &unknowns, scale),
            format!(
                "Lemma refuted : system_refuted radicands {shape} equations {common_assumptions} assumptions certificate = true.
Proof. vm_cast_no_check (eq_refl true). Qed.\n"
            ),
        ]
        .concat(),
        theorems: vec![
            Theorem {
                comment: format!("{}some equation fails", unknowns.for_all()),
                name: "an_equation_fails".into(),
                proposition: format!("{}\n  Exists (fun value => value <> 0) {applied}", unknowns.quantified),
                proof: vec![
                    unknowns.intros(""),
                    format!("refine (Replay.an_equation_fails Data.radicands eq_refl {shape} Data.equations {common_assumptions}"),
                    "          Data.assumptions Data.certificate Data.refuted".into(),
                    format!("          {} eq_refl _ {applied} eq_refl).", unknowns.values),
                    format!("{}.", unknowns.inverses),
                ],
            },
            Theorem {
                comment: "So they do not all hold".into(),
                name: "not_all_hold".into(),
                proposition: format!("{}\n  ~ Forall (fun value => value = 0) {applied}", unknowns.quantified),
                proof: vec![
                    unknowns.intros(""),
                    "apply Exists_Forall_neg; [intros value; destruct (Req_dec value 0); tauto |].".into(),
                    "eapply an_equation_fails; eassumption.".into(),
                ],
            },
        ],
    }
}

/// All equations hold at the values.
pub(super) fn exact(case: &Case, equations: &[Polynomial]) -> Parts {
    let constant = Unknowns::of(&Case { unknowns: Vec::new(), assumptions: Vec::new(), ..case.clone() });
    let common = spell::integer(&common_denominator(equations));
    let mut summary = vec![
        "At these values of the unknowns all equations hold: [all_hold], at the end of this file.".into(),
    ];
    summary.extend(exact::values(case));
    let holds = Theorem {
        comment: "All equations hold".into(),
        name: "all_hold".into(),
        proposition: " Forall (fun value => value = 0) equations".into(),
        proof: vec![
            format!("apply (Replay.vanishing_numbers Data.radicands eq_refl {common} Data.equations);"),
            "  [reflexivity | vm_compute; reflexivity].".into(),
        ],
    };
    Parts {
        summary,
        definitions: definitions(case, equations, &constant),
        replay: vec![SYSTEM, POSITIVE],
        data: data::polynomials("equations", equations) + &exact::nonzero_data(case),
        theorems: [holds].into_iter().chain(exact::nonzero_theorems(case)).collect(),
    }
}

fn definitions(case: &Case, equations: &[Polynomial], unknowns: &Unknowns) -> String {
    let expressions =
        equations.iter().map(|equation| spell::expression(equation, &case.field, &unknowns.names));
    format!(
        "(** The left-hand sides of the equations. *)\nDefinition equations{} : list R :=\n  {}.\n",
        unknowns.parameters,
        spell::lines(expressions)
    )
}
