//! A proof of impossibility, line by line.

use std::fmt::Write as _;

use super::attempt::LINE;
use super::expansion::surface_text;
use super::mathematics::Notation;
use super::setting;
use crate::algebra::polynomial_to_exact;
use crate::certificate::{Argument, Certificate, Premise, Step};
use crate::control::Control;
use crate::exact::{Arithmetic, Polynomial};
use crate::expand::{Basis, Coefficient, ExpansionError, coefficients_of, grouped};
use crate::problem::Problem;
use crate::prove::flattened;
use crate::statement::Subject;

/// Distinct coefficients, steps, and cofactor terms that are printed in full.
const COEFFICIENTS: usize = 16;
const STEPS: usize = 24;
const COFACTOR_TERMS: usize = 12;

/// The setting, the condition, the elimination and the contradiction.
pub(super) fn refutation(
    problem: &Problem,
    cap: bool,
    certificate: &Certificate,
    control: &Control,
) -> Result<String, ExpansionError> {
    let statement = problem.statement();
    let notation = Notation::new(statement.ring());
    let mut text = String::new();
    let mut number = 0;
    let mut heading = |text: &mut String, title: &str| {
        number += 1;
        let _ = writeln!(text, "{number}. {title}");
    };
    if cap && let Subject::Patch(patch) = statement.subject() {
        heading(&mut text, "The setting");
        text += &setting::cube_face(statement, patch)?;
        text.push('\n');
    }
    if let Some(list) = coefficients_of(problem, Basis::Bernstein, control)? {
        heading(&mut text, "The condition");
        text += &condition(problem, &notation, &list, control)?;
        text.push('\n');
    }
    for (k, assumed) in (1..).zip(statement.nonzero()) {
        let d = notation.polynomial(assumed);
        let _ = writeln!(
            text,
            "   The assumption {d} ≠ 0 enters as nonzero[{k}] = {}·t[{k}] − 1 (Rabinowitsch).\n",
            notation.factor(assumed)
        );
    }
    let Argument::Impossible(steps) = &certificate.argument else {
        return Ok(text);
    };
    heading(&mut text, "The elimination");
    text += &elimination(problem, &notation, steps, control);
    text.push('\n');
    heading(&mut text, "The contradiction");
    let _ = writeln!(text, "   If all these equations held, the last line would read 1 = 0.");
    match flattened(statement, steps, COFACTOR_TERMS, control) {
        Some(cofactors) if steps.len() > 1 => {
            let sum = cofactors
                .iter()
                .map(|(premise, cofactor)| format!("{}·{premise}", notation.factor(cofactor)));
            let _ = writeln!(text, "   Multiplied out, a Nullstellensatz certificate:");
            let _ = writeln!(text, "   1 = {}", sum.collect::<Vec<_>>().join("\n     + "));
        }
        _ => {}
    }
    text.push('\n');
    Ok(text)
}

fn condition(
    problem: &Problem,
    notation: &Notation,
    list: &[Coefficient],
    control: &Control,
) -> Result<String, ExpansionError> {
    let statement = problem.statement();
    let Subject::Patch(patch) = statement.subject() else {
        return Ok(String::new());
    };
    let (m, n) = patch.bidegree;
    let mut text = String::new();
    let (last_r, last_s) = list.last().map_or((0, 0), |last| last.index);
    let _ = writeln!(
        text,
        "   Patch of bidegree ({m},{n}), {} control points, {}.",
        (m + 1) * (n + 1),
        match statement.unknowns() {
            [] => "no unknowns".to_owned(),
            [one] => format!("unknown {one}"),
            many => format!("unknowns {}", many.join(", ")),
        }
    );
    let _ = writeln!(
        text,
        "   It lies on the surface iff F = {} vanishes identically in u and v.",
        surface_text(statement)
    );
    let _ = writeln!(
        text,
        "   F has at most bidegree ({last_r},{last_s}); c[r,s] is its coefficient of u^r (1−u)^({last_r}−r) · v^s (1−v)^({last_s}−s)."
    );
    let (groups, zero) = grouped(list);
    let vanish = match zero {
        0 => "none vanishes".to_owned(),
        1 => "1 vanishes".to_owned(),
        many => format!("{many} vanish"),
    };
    let others = match (list.len() - zero, groups.len()) {
        (0, _) => String::new(),
        (1, _) => "; the other is".to_owned(),
        (_, 1) if zero == 0 => "; they are all equal:".to_owned(),
        (many, 1) => format!("; the other {many} are equal:"),
        (_, different) if zero == 0 => format!("; they are {different} different polynomials:"),
        (_, different) => format!("; the others are {different} different polynomials:"),
    };
    let _ = writeln!(text, "   Of {} coefficients {vanish}{others}", list.len());
    text += &group_lines(notation, &groups);

    // The paper's own coefficients, where they are short enough to be read.
    let monomial = coefficients_of(problem, Basis::Monomial, control)?.unwrap_or_default();
    let (groups, _) = grouped(&monomial);
    let readable = |(_, value): &(Vec<&str>, &Polynomial)| notation.polynomial(value).chars().count() <= LINE;
    if monomial.iter().any(|c| c.name == "a1") && groups.iter().all(readable) {
        let _ = writeln!(text, "   The same as coefficients a1, …, a16 of uⁱvʲ, i, j = 1, …, 4 (10, 11):");
        text += &group_lines(notation, &groups);
    }
    Ok(text)
}

fn group_lines(notation: &Notation, groups: &[(Vec<&str>, &Polynomial)]) -> String {
    let mut text = String::new();
    for (names, value) in groups.iter().take(COEFFICIENTS) {
        let formula = notation.shortened(value, LINE);
        let (first, others) = (names[0], &names[1..]);
        let _ = match others.len() {
            0 => writeln!(text, "     {first:<6} = {formula}"),
            1..=3 => writeln!(text, "     {first:<6} = {formula}   (= {})", others.join(" = ")),
            many => writeln!(text, "     {first:<6} = {formula}   (= {many} others)"),
        };
    }
    if groups.len() > COEFFICIENTS {
        let _ = writeln!(text, "     … and {} more (prove-cap expand)", groups.len() - COEFFICIENTS);
    }
    text
}

fn elimination(problem: &Problem, notation: &Notation, steps: &[Step], control: &Control) -> String {
    let statement = problem.statement();
    let mut text = String::new();
    let mut values: Vec<Option<Polynomial>> = vec![None; statement.ring().variables.len()];
    let shown = steps.len().min(STEPS);
    // The first steps and the last one.
    for (number, step) in (1usize..).zip(steps) {
        if number >= shown && number < steps.len() && steps.len() > STEPS {
            if number == shown {
                let _ = writeln!(text, "   … {} more steps, all in the certificate", steps.len() - shown);
            }
            continue;
        }
        let last = number == steps.len();
        if last && let Some(line) = contradiction(problem, notation, step, &values, control) {
            text += &line;
        }
        let label = format!("   ({number})");
        let _ = writeln!(text, "{label:<8} {} =", notation.shortened(&step.conclusion, LINE));
        for (k, (premise, multiplier)) in step.combination.iter().enumerate() {
            let name = match premise {
                Premise::Step(earlier) => format!("({earlier})"),
                equation => equation.to_string(),
            };
            let sign = if k == 0 { " " } else { "+" };
            let _ = writeln!(
                text,
                "          {sign} {} · {name}",
                bracketed(notation.shortened(multiplier, LINE))
            );
        }
        if let Some((variable, value)) = solved(&step.conclusion) {
            let name = &statement.ring().variables[usize::from(variable)];
            let _ = writeln!(text, "         so {name} = {}", notation.polynomial(&value));
            values[usize::from(variable)] = Some(value);
        }
    }
    text
}

fn bracketed(formula: String) -> String {
    let simple = formula.chars().all(|c| c.is_ascii_digit());
    if simple { formula } else { format!("({formula})") }
}

/// variable = value, if that is what the vanishing of a conclusion says.
fn solved(conclusion: &Polynomial) -> Option<(u16, Polynomial)> {
    let (monomial, coefficient) = conclusion.terms().next()?;
    let [(variable, 1)] = monomial.powers() else {
        return None;
    };
    let constant = conclusion.terms().skip(1).map(|(m, value)| (m.clone(), -value));
    let value = Polynomial::from_terms(constant);
    let monic = monomial.mask() == 0 && *coefficient == num_rational::BigRational::from_integer(1.into());
    (monic && value.is_constant()).then_some((*variable, value))
}

/// What the one equation of the last step comes to at the values found before.
fn contradiction(
    problem: &Problem,
    notation: &Notation,
    last: &Step,
    values: &[Option<Polynomial>],
    control: &Control,
) -> Option<String> {
    let equations: Vec<Premise> = last
        .combination
        .iter()
        .map(|(premise, _)| *premise)
        .filter(|premise| !matches!(premise, Premise::Step(_)))
        .collect();
    let [equation] = equations.as_slice() else {
        return None;
    };
    let polynomial = polynomial_to_exact(&problem.equation(*equation)?).ok()?;
    let at: Vec<Polynomial> = (0u16..)
        .zip(values)
        .map(|(index, value)| value.clone().unwrap_or_else(|| Polynomial::variable(index)))
        .collect();
    let value = Arithmetic::new(problem.statement().field(), &mut control.work())
        .substitute(&polynomial, &at)
        .ok()?;
    let when = if polynomial.is_constant() { "Identically" } else { "With these values" };
    (value.is_constant() && !value.is_zero())
        .then(|| format!("   {when} {equation} = {}, not 0:\n", notation.polynomial(&value)))
}
