//! A bare system of equations: no real zero, or this one.

use std::fmt::Write;

use super::super::case::{Case, ExportError, Reasoning};
use super::super::flat::{lift, rationals, used_equations};
use super::argument::{
    Known, assumptions, constant_is_not_zero, inverse_equations, inverse_hypotheses, name,
    nonzero_hypotheses, steps,
};
use super::names::{Names, reals, spaced};
use crate::certificate::Premise;
use crate::exact::Polynomial;
use crate::statement::Subject;

pub(super) fn write(case: &Case, names: &Names) -> Result<String, ExportError> {
    // As the statement has them, the unknowns in them also where they have values.
    let Subject::System(equations) = case.statement.subject() else { return Ok(String::new()) };
    let lifted = equations.iter().map(|f| lift(case, f)).collect::<Result<Vec<_>, _>>()?;
    let mut text = String::new();
    for (k, equation) in (1..).zip(&lifted) {
        let _ = writeln!(text, "def f{k}{} : ℝ := {}\n", reals(&names.arguments()), names.spell(equation));
    }
    text += &match &case.argument {
        Reasoning::Impossible(_) => impossible(case, names, lifted.len())?,
        Reasoning::Exact(values) => exact(case, names, &lifted, values)?,
    };
    Ok(text)
}

fn impossible(case: &Case, names: &Names, count: usize) -> Result<String, ExportError> {
    let mut known: Known = used_equations(case)?.into_iter().collect();
    let arguments = names.arguments();
    let used: Vec<u32> = known.keys().filter_map(|premise| equation_number(*premise)).collect();
    let hypotheses = used.iter().map(|k| format!("(h{k} : f{k}{arguments} = 0)"));
    let mut text = assumptions(case, names)?;
    let _ = writeln!(
        text,
        "theorem refutation{}{}{}{} : False := by",
        reals(&(arguments.clone() + &spaced(&names.inverses))),
        names.root_hypotheses(),
        inverse_hypotheses(names),
        spaced(hypotheses),
    );
    for (premise, equation) in &known {
        if let Some(k) = equation_number(*premise) {
            let _ = writeln!(text, "  have {} : ({} : ℝ) = 0 := h{k}", name(*premise), names.spell(equation));
        }
    }
    text += &inverse_equations(names, &known);
    text += &steps(case, names, &mut known)?;
    let (assumed, inverses, proofs) = nonzero_hypotheses(names);
    let true_arguments = names.true_roots() + &spaced(&names.unknowns);
    let all = (1..=count).map(|k| format!("f{k}{true_arguments} = 0")).collect::<Vec<_>>();
    let pattern = (1..=count).map(|k| format!("h{k}")).collect::<Vec<_>>();
    let (all, pattern) = match count {
        0 => ("True".to_owned(), "_".to_owned()),
        1 => (all.concat(), pattern.concat()),
        _ => (all.join(" ∧ "), format!("⟨{}⟩", pattern.join(", "))),
    };
    let _ = writeln!(
        text,
        "\n/-- The system has no real zero. -/\ntheorem impossible{}{assumed} :\n    ¬ ({all}) :=\n  \
         fun {pattern} => refutation{true_arguments}{inverses}{}{proofs}{}",
        reals(&spaced(&names.unknowns)),
        names.root_proofs(),
        spaced(used.iter().map(|k| format!("h{k}"))),
    );
    Ok(text)
}

fn equation_number(premise: Premise) -> Option<u32> {
    match premise {
        Premise::Equation(k) => Some(k),
        _ => None,
    }
}

fn exact(
    case: &Case,
    names: &Names,
    lifted: &[Polynomial],
    values: &[Polynomial],
) -> Result<String, ExportError> {
    let values = values.iter().map(|value| lift(case, value)).collect::<Result<Vec<_>, _>>()?;
    let roots = (0u16..).zip(&names.roots).map(|(root, _)| Polynomial::variable(root));
    let images: Vec<Polynomial> = roots.chain(values.iter().cloned()).collect();
    let spelled = spaced(values.iter().map(|value| format!("({})", names.spell(value))));
    let mut text = String::new();
    for (k, equation) in (1..).zip(lifted) {
        let value = equation.substitute(&images, &rationals(), &mut case.control.work())?;
        let terms = names.root_terms(&value, '+')?;
        let proof = match terms.strip_prefix(" + ") {
            _ if equation.is_zero() => "rfl".to_owned(),
            Some(terms) => format!("by\n  simp only [f{k}]\n  linear_combination {terms}"),
            None => format!("by\n  simp only [f{k}]\n  ring"),
        };
        let _ = writeln!(
            text,
            "theorem zero{k}{}{} :\n    f{k}{}{spelled} = 0 := {proof}\n",
            reals(&spaced(&names.roots)),
            names.root_hypotheses(),
            spaced(&names.roots),
        );
    }
    for (number, assumed) in (1..).zip(&case.assumptions) {
        text += "/-- What was assumed not to be zero is not, for these values. -/\n";
        text += &constant_is_not_zero(case, names, &format!("assumption{number}"), assumed)?;
        text += "\n";
    }
    let (true_roots, unknowns) = (names.true_roots(), spaced(&names.unknowns));
    let all = (1..=lifted.len()).map(|k| format!("f{k}{true_roots}{unknowns} = 0")).collect::<Vec<_>>();
    let exists = if unknowns.is_empty() { String::new() } else { format!("∃{unknowns} : ℝ, ") };
    let given = values.iter().map(|_| "_".to_owned());
    let proofs = (1..=lifted.len()).map(|k| format!("zero{k}{true_roots}{}", names.root_proofs()));
    let witness: Vec<String> = given.chain(proofs).collect();
    let witness = if witness.len() == 1 { witness.concat() } else { format!("⟨{}⟩", witness.join(", ")) };
    let _ = writeln!(
        text,
        "/-- The system has a real zero; zero1, ... name it. -/\ntheorem solvable : {exists}{} :=\n  {witness}",
        if all.is_empty() { "True".to_owned() } else { all.join(" ∧ ") },
    );
    Ok(text)
}
