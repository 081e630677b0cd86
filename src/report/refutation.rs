//! A proof of impossibility, line by line.

use super::expansion::surface_text;
use super::mathematics::Notation;
use super::setting;
use super::text::LINE;
use crate::algebra::polynomial_to_exact;
use crate::certificate::{Argument, Certificate, Premise, Step};
use crate::control::Control;
use crate::document::{self, Block, Document, Equations, Phrase};
use crate::exact::{Arithmetic, Polynomial};
use crate::expand::{Basis, Coefficient, ExpansionError, coefficients_of, grouped};
use crate::problem::Problem;
use crate::prove::flattened;
use crate::statement::{Patch, Subject};

/// Distinct coefficients, steps, and cofactor terms that are printed in full.
const COEFFICIENTS: usize = 16;
const STEPS: usize = 24;
const COFACTOR_TERMS: usize = 12;
/// Characters of a name before the sign of equality, at least.
const NAME: usize = 6;

/// The setting, the condition, the elimination and the contradiction.
pub(super) fn refutation(
    problem: &Problem,
    cap: bool,
    certificate: &Certificate,
    control: &Control,
) -> Result<Document, ExpansionError> {
    let statement = problem.statement();
    let mut document = Document::new(statement.ring());
    let mut number = 0;
    let mut heading = |document: &mut Document, title: &str| {
        number += 1;
        document.heading(format!("{number}. {title}"));
    };
    if let Subject::Patch(patch) = statement.subject() {
        if cap {
            heading(&mut document, "The setting");
            setting::cube_face(&mut document, statement, patch)?;
            document.gap();
        }
        if let Some(list) = coefficients_of(problem, Basis::Bernstein, control)? {
            heading(&mut document, "The condition");
            condition(&mut document, (problem, patch), &list, control)?;
            document.gap();
        }
    }
    for (k, assumed) in (1..).zip(statement.nonzero()) {
        let enters = Phrase::words("The assumption ")
            .formula(assumed)
            .and(format!(" ≠ 0 enters as nonzero[{k}] = "))
            .factor(assumed)
            .and(format!("·t[{k}] − 1 (Rabinowitsch)."));
        document.line(3, enters);
        document.gap();
    }
    let Argument::Impossible(steps) = &certificate.argument else {
        return Ok(document);
    };
    heading(&mut document, "The elimination");
    elimination(&mut document, problem, steps, control);
    document.gap();
    heading(&mut document, "The contradiction");
    document.line(3, "If all these equations held, the last line would read 1 = 0.");
    match flattened(statement, steps, COFACTOR_TERMS, control) {
        Some(cofactors) if steps.len() > 1 => {
            document.line(3, "Multiplied out, a Nullstellensatz certificate:");
            let mut sum = Phrase::words("1 = ");
            for (k, (premise, cofactor)) in cofactors.iter().enumerate() {
                let sum_so_far = if k == 0 { sum } else { sum.and("\n  + ") };
                sum = sum_so_far.factor(cofactor).and("·").label(premise.to_string());
            }
            document.line(3, sum);
        }
        _ => {}
    }
    document.gap();
    Ok(document)
}

fn condition(
    document: &mut Document,
    (problem, patch): (&Problem, &Patch),
    list: &[Coefficient],
    control: &Control,
) -> Result<(), ExpansionError> {
    let statement = problem.statement();
    let (m, n) = patch.bidegree;
    let (last_r, last_s) = list.last().map_or((0, 0), |last| last.index);
    let unknowns = match statement.unknowns() {
        [] => "no unknowns".to_owned(),
        [one] => format!("unknown {one}"),
        many => format!("unknowns {}", many.join(", ")),
    };
    document
        .line(3, format!("Patch of bidegree ({m},{n}), {} control points, {unknowns}.", (m + 1) * (n + 1)));
    document.line(
        3,
        format!(
            "It lies on the surface iff F = {} vanishes identically in u and v.",
            surface_text(statement)
        ),
    );
    document.line(
        3,
        format!(
            "F has at most bidegree ({last_r},{last_s}); c[r,s] is its coefficient of u^r (1−u)^({last_r}−r) · v^s (1−v)^({last_s}−s)."
        ),
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
    document.line(3, format!("Of {} coefficients {vanish}{others}", list.len()));
    group_lines(document, &groups);

    // The paper's own coefficients, where they are short enough to be read.
    let monomial = coefficients_of(problem, Basis::Monomial, control)?.unwrap_or_default();
    let (groups, _) = grouped(&monomial);
    let notation = Notation::new(statement.ring());
    let readable = |(_, value): &(Vec<&str>, &Polynomial)| notation.polynomial(value).chars().count() <= LINE;
    if monomial.iter().any(|c| c.name == "a1") && groups.iter().all(readable) {
        document.line(3, "The same as coefficients a1, …, a16 of uⁱvʲ, i, j = 1, …, 4 (10, 11):");
        group_lines(document, &groups);
    }
    Ok(())
}

fn group_lines(document: &mut Document, groups: &[(Vec<&str>, &Polynomial)]) {
    let rows = groups.iter().take(COEFFICIENTS).map(|(names, value)| {
        let (first, others) = (names[0], &names[1..]);
        let remark = match others.len() {
            0 => String::new(),
            1..=3 => format!("= {}", others.join(" = ")),
            many => format!("= {many} others"),
        };
        (Phrase::default().label(first), Phrase::default().shortened(value, LINE), remark)
    });
    document.push(Block::Equations(Equations { indent: 5, width: NAME, rows: rows.collect() }));
    if groups.len() > COEFFICIENTS {
        document.line(5, format!("… and {} more (prove-cap expand)", groups.len() - COEFFICIENTS));
    }
}

fn elimination(document: &mut Document, problem: &Problem, steps: &[Step], control: &Control) {
    let ring = problem.statement().ring();
    let notation = Notation::new(ring.clone());
    let mut values: Vec<Option<Polynomial>> = vec![None; ring.variables.len()];
    let shown = steps.len().min(STEPS);
    // The first steps and the last one.
    for (number, step) in (1usize..).zip(steps) {
        if number >= shown && number < steps.len() && steps.len() > STEPS {
            if number == shown {
                document.line(3, format!("… {} more steps, all in the certificate", steps.len() - shown));
            }
            continue;
        }
        let last = number == steps.len();
        if last && let Some(line) = contradiction(problem, step, &values, control) {
            document.line(3, line);
        }
        let combination = step.combination.iter().map(|(premise, multiplier)| {
            let name = match premise {
                Premise::Step(earlier) => Phrase::words(format!("({earlier})")),
                equation => Phrase::default().label(equation.to_string()),
            };
            // A number without sign, fraction and root stands without brackets.
            let simple = notation.shortened(multiplier, LINE).chars().all(|c| c.is_ascii_digit());
            let (before, after) = if simple { ("", "") } else { ("(", ")") };
            (Phrase::words(before).shortened(multiplier, LINE).and(after), name)
        });
        let combination = combination.collect();
        let solved = solved(&step.conclusion);
        let so = solved.as_ref().map(|(variable, value)| {
            Phrase::default().formula(&Polynomial::variable(*variable)).and(" = ").formula(value)
        });
        let conclusion = Phrase::default().shortened(&step.conclusion, LINE);
        document.push(Block::Step(document::Step { number, conclusion, combination, so }));
        if let Some((variable, value)) = solved {
            values[usize::from(variable)] = Some(value);
        }
    }
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
    last: &Step,
    values: &[Option<Polynomial>],
    control: &Control,
) -> Option<Phrase> {
    let equations: Vec<Premise> = last
        .combination
        .iter()
        .map(|(premise, _)| *premise)
        .filter(|premise| !matches!(premise, Premise::Step(_)))
        .collect();
    let [equation] = equations.as_slice() else {
        return None;
    };
    let polynomial = polynomial_to_exact(&problem.equation(*equation, control).ok()??).ok()?;
    let at: Vec<Polynomial> = (0u16..)
        .zip(values)
        .map(|(index, value)| value.clone().unwrap_or_else(|| Polynomial::variable(index)))
        .collect();
    let value = Arithmetic::new(problem.statement().field(), &mut control.work())
        .substitute(&polynomial, &at)
        .ok()?;
    let when = if polynomial.is_constant() { "Identically" } else { "With these values" };
    (value.is_constant() && !value.is_zero()).then(|| {
        let words = Phrase::words(format!("{when} ")).label(equation.to_string());
        words.and(" = ").formula(&value).and(", not 0:")
    })
}
