//! The outcome of an attempt, as a proof that can be followed line by line.

use std::fmt::Write as _;
use std::path::PathBuf;

use super::expansion::{Basis, coefficients, grouped, surface_text};
use super::mathematics::Notation;
use super::setting;
use crate::certificate::{Argument, Certificate, Premise, Step};
use crate::checker::{Claim, Theorem};
use crate::elimination::Undecided;
use crate::exact::{Limit, Polynomial, Work};
use crate::prove::{Attempt, Reason, flattened};
use crate::statement::{COORDINATES, Statement, Subject};

/// Characters of a formula on one line.
const LINE: usize = 110;
/// Distinct coefficients, steps, and cofactor terms that are printed in full.
const COEFFICIENTS: usize = 16;
const STEPS: usize = 24;
const COFACTOR_TERMS: usize = 12;

/// Where statement and certificate were written.
#[derive(Debug, Clone)]
pub struct Files {
    /// The statement file.
    pub statement: PathBuf,
    /// The certificate file.
    pub certificate: PathBuf,
}

/// `prove-cap prove` for people. `cap` tells that the patch is bounded by the arcs over the cube face.
///
/// # Errors
/// Where a coefficient exceeds what the formats allow.
pub fn describe(
    name: &str,
    statement: &Statement,
    cap: bool,
    attempt: &Attempt,
    files: Option<&Files>,
) -> Result<String, Limit> {
    let mut text = String::new();
    match attempt {
        Attempt::Undecided(reason) => {
            let _ = writeln!(text, "UNDECIDED  {name}: {}\n", headline(reason));
            let _ = writeln!(text, "{}\n", statement.title());
            text += &reason_text(statement, reason)?;
        }
        Attempt::Proved { certificate, theorem } => match theorem.claim() {
            Claim::Impossible { .. } => {
                let subject = match statement.subject() {
                    Subject::Patch(_) => "no such patch lies on the surface",
                    Subject::System(_) => "no common zero",
                };
                let _ = writeln!(text, "PROVED  {name}: {subject}, for any values of the unknowns\n");
                let _ = writeln!(text, "{}\n", statement.title());
                text += &refutation(statement, cap, certificate)?;
            }
            Claim::Exact { .. } | Claim::Solution { .. } => {
                let _ = writeln!(text, "EXACT  {name}: {}\n", match theorem.claim() {
                    Claim::Exact { .. } => "this patch lies on the surface",
                    _ => "the system has this solution",
                });
                let _ = writeln!(text, "{}\n", statement.title());
                text += &solution(statement, theorem);
            }
        },
    }
    if let (Attempt::Proved { theorem, .. }, Some(files)) = (attempt, files) {
        let _ = writeln!(text, "Verdict of the independent checker, on the files below\n{}\n", wrapped(&format!("VERIFIED. {}", theorem.sentence())));
        let _ = writeln!(text, "Statement    {}", files.statement.display());
        let _ = writeln!(text, "Certificate  {}", files.certificate.display());
    }
    Ok(text)
}

fn refutation(statement: &Statement, cap: bool, certificate: &Certificate) -> Result<String, Limit> {
    let notation = Notation::new(statement.ring());
    let mut text = String::new();
    let mut number = 0;
    let mut heading = |text: &mut String, title: &str| {
        number += 1;
        let _ = writeln!(text, "{number}. {title}");
    };
    if cap {
        heading(&mut text, "The setting");
        text += &setting::cube_face()?;
        text.push('\n');
    }
    if let Some(list) = coefficients(statement, Basis::Bernstein)? {
        heading(&mut text, "The condition");
        text += &condition(statement, &notation, &list)?;
        text.push('\n');
    }
    for (k, assumed) in (1..).zip(statement.nonzero()) {
        let d = notation.polynomial(assumed);
        let _ = writeln!(text, "   The assumption {d} ≠ 0 enters as nonzero[{k}] = {}·t[{k}] − 1 (Rabinowitsch).\n", notation.factor(assumed));
    }
    let Argument::Impossible(steps) = &certificate.argument else { return Ok(text) };
    heading(&mut text, "The elimination");
    text += &elimination(statement, &notation, steps);
    text.push('\n');
    heading(&mut text, "The contradiction");
    let _ = writeln!(text, "   If all these equations held, the last line would read 1 = 0.");
    match flattened(statement, steps, COFACTOR_TERMS) {
        Some(cofactors) if steps.len() > 1 => {
            let sum = cofactors.iter().map(|(premise, cofactor)| format!("{}·{premise}", notation.factor(cofactor)));
            let _ = writeln!(text, "   Multiplied out, a Nullstellensatz certificate:");
            let _ = writeln!(text, "   1 = {}", sum.collect::<Vec<_>>().join("\n     + "));
        }
        _ => {}
    }
    text.push('\n');
    Ok(text)
}

fn condition(
    statement: &Statement,
    notation: &Notation,
    list: &[super::expansion::Coefficient],
) -> Result<String, Limit> {
    let Subject::Patch(patch) = statement.subject() else { return Ok(String::new()) };
    let (m, n) = patch.bidegree;
    let mut text = String::new();
    let (last_r, last_s) = list.last().map_or((0, 0), |last| last.index);
    let _ = writeln!(text, "   Patch of bidegree ({m},{n}), {} control points, unknowns {}.", (m + 1) * (n + 1), statement.unknowns().join(", "));
    let _ = writeln!(text, "   It lies on the surface iff F = {} vanishes identically in u and v.", surface_text(statement));
    let _ = writeln!(text, "   F has bidegree ({last_r},{last_s}); c[r,s] is its coefficient of u^r (1−u)^({last_r}−r) · v^s (1−v)^({last_s}−s).");
    let (groups, zero) = grouped(list);
    let _ = writeln!(text, "   Of {} coefficients {zero} vanish; the others are {} different polynomials:", list.len(), groups.len());
    text += &group_lines(notation, &groups);

    if let Some(monomial) = coefficients(statement, Basis::Monomial)?.filter(|list| list.iter().any(|c| c.name == "a1")) {
        let (groups, _) = grouped(&monomial);
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
            many => writeln!(text, "     {first:<6} = {formula}   (= {} others)", many),
        };
    }
    if groups.len() > COEFFICIENTS {
        let _ = writeln!(text, "     … and {} more (prove-cap expand)", groups.len() - COEFFICIENTS);
    }
    text
}

fn elimination(statement: &Statement, notation: &Notation, steps: &[Step]) -> String {
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
        if last && let Some(line) = contradiction(statement, notation, step, &values) {
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
            let _ = writeln!(text, "          {sign} {} · {name}", bracketed(notation.shortened(multiplier, LINE)));
        }
        if let Some((variable, value)) = solved(&step.conclusion) {
            let name = &statement.ring().variables[usize::from(variable)];
            let _ = writeln!(text, "         so {name} = {}", notation.polynomial(&value));
            values[usize::from(variable)] = Some(value);
        }
    }
    text
}

/// A paragraph, broken at spaces and indented.
fn wrapped(paragraph: &str) -> String {
    let mut lines: Vec<String> = vec![String::new()];
    for word in paragraph.split(' ') {
        let line = lines.last_mut().expect("never empty");
        if !line.is_empty() && line.chars().count() + word.chars().count() >= LINE {
            lines.push(word.to_owned());
        } else {
            line.push_str(if line.is_empty() { "" } else { " " });
            line.push_str(word);
        }
    }
    format!("   {}", lines.join("\n   "))
}

fn bracketed(formula: String) -> String {
    let simple = formula.chars().all(|c| c.is_ascii_digit());
    if simple { formula } else { format!("({formula})") }
}

/// variable = value, if that is what the vanishing of a conclusion says.
fn solved(conclusion: &Polynomial) -> Option<(u16, Polynomial)> {
    let (monomial, coefficient) = conclusion.terms().next()?;
    let [(variable, 1)] = monomial.powers() else { return None };
    let constant = conclusion.terms().skip(1).map(|(m, value)| (m.clone(), -value));
    let value = Polynomial::from_terms(constant);
    let monic = monomial.mask() == 0 && *coefficient == num_rational::BigRational::from_integer(1.into());
    (monic && value.is_constant()).then_some((*variable, value))
}

/// What the one equation of the last step comes to at the values found before.
fn contradiction(
    statement: &Statement,
    notation: &Notation,
    last: &Step,
    values: &[Option<Polynomial>],
) -> Option<String> {
    let equations: Vec<Premise> =
        last.combination.iter().map(|(premise, _)| *premise).filter(|premise| !matches!(premise, Premise::Step(_))).collect();
    let [equation] = equations.as_slice() else { return None };
    let mut work = Work::full();
    let all = crate::checker::Equations::of(statement, &mut work).ok()?;
    let polynomial = all.get(*equation)?;
    let at: Vec<Polynomial> = (0u16..)
        .zip(values)
        .map(|(index, value)| value.clone().unwrap_or_else(|| Polynomial::variable(index)))
        .collect();
    let value = polynomial.substitute(&at, statement.field(), &mut work).ok()?;
    (value.is_constant() && !value.is_zero())
        .then(|| format!("   With these values {equation} = {}, not 0:\n", notation.polynomial(&value)))
}

fn solution(statement: &Statement, theorem: &Theorem) -> String {
    let notation = Notation::new(statement.ring());
    let mut text = String::new();
    let (values, net) = match theorem.claim() {
        Claim::Exact { values, net, .. } => (values, Some(net)),
        Claim::Solution { values } => (values, None),
        _ => return text,
    };
    if !values.is_empty() {
        let _ = writeln!(text, "The unknowns");
        let width = statement.unknowns().iter().map(String::len).max().unwrap_or(0);
        for (name, value) in statement.unknowns().iter().zip(values) {
            let _ = writeln!(text, "   {name:<width$} = {}", notation.polynomial(value));
        }
        text.push('\n');
    }
    let Some(net) = net else { return text };
    let _ = writeln!(text, "The control net, premultiplied (X, Y, Z, W) = (wx, wy, wz, w)");
    let cells = net.iter().map(|row| row.iter().map(|point| point.each_ref().map(|entry| notation.polynomial(entry))));
    let cells: Vec<Vec<[String; 4]>> = cells.map(Iterator::collect).collect();
    let widths: [usize; 4] = std::array::from_fn(|k| {
        let entries = cells.iter().flatten().map(|point| point[k].chars().count());
        entries.max().unwrap_or(0).max(COORDINATES[k].len())
    });
    let header: Vec<String> = COORDINATES.iter().zip(widths).map(|(name, width)| format!("{name:>width$}")).collect();
    let _ = writeln!(text, "    i  j   {}", header.join("   "));
    for (i, row) in cells.iter().enumerate() {
        for (j, point) in row.iter().enumerate() {
            let padded: Vec<String> = point.iter().zip(widths).map(|(entry, width)| format!("{entry:>width$}")).collect();
            let _ = writeln!(text, "   {i:>2} {j:>2}   {}", padded.join("   "));
        }
    }
    text.push('\n');
    text
}

fn headline(reason: &Reason) -> &'static str {
    match reason {
        Reason::NoDenominator => "the only solution has no denominator",
        Reason::Elimination(Undecided::Consistent(closure)) if closure.dimension > 0 => "infinitely many complex zeros",
        Reason::Elimination(Undecided::Consistent(_)) => "there are complex zeros",
        Reason::Elimination(Undecided::TooLarge { .. }) => "the search became too large",
        Reason::Elimination(Undecided::Interrupted(_)) => "stopped early",
    }
}

fn reason_text(statement: &Statement, reason: &Reason) -> Result<String, Limit> {
    let mut text = String::new();
    match reason {
        Reason::NoDenominator => {
            let _ = writeln!(text, "The equations have one common zero, at which the denominator W of the patch is the zero polynomial.\nThat is no patch; and since there is a zero, no certificate of impossibility exists.");
        }
        Reason::Elimination(Undecided::TooLarge { degree, matrix: (rows, columns) }) => {
            let _ = writeln!(text, "1 is no combination of multiples of the equations up to degree {degree}. The next matrix would have\n{rows} rows and {columns} columns, more than this engine reduces.");
        }
        Reason::Elimination(Undecided::Interrupted(why)) => {
            let _ = writeln!(text, "Stopped: {why}. Nothing was established.");
        }
        Reason::Elimination(Undecided::Consistent(closure)) => {
            let field = statement.field();
            let evidence = if closure.verified {
                format!("A Gröbner basis, verified over {field}, does not contain 1")
            } else {
                "A Gröbner basis modulo a prime, not verified, does not contain 1".to_owned()
            };
            let zeros = match closure.zeros {
                Some(count) => format!("finitely many over the complex numbers: {count}, counted with multiplicity"),
                None => format!("infinitely many over the complex numbers: a set of dimension {}", closure.dimension),
            };
            let _ = writeln!(text, "{evidence}, so the equations have common zeros,\n{zeros}.");
            let _ = writeln!(text, "A certificate of impossibility therefore does not exist. Whether one of the zeros is real was not decided,\nand none was found in {field}.\n");
            let notation = Notation::new(statement.ring());
            let basis: Vec<_> = closure.linear.iter().chain(&closure.basis).collect();
            let _ = writeln!(text, "The equations are equivalent to");
            for polynomial in basis.iter().take(COEFFICIENTS) {
                let exact = crate::algebra::polynomial_to_exact(polynomial)?;
                let _ = writeln!(text, "   {} = 0", notation.shortened(&exact, LINE));
            }
            if basis.len() > COEFFICIENTS {
                let _ = writeln!(text, "   … and {} more", basis.len() - COEFFICIENTS);
            }
        }
    }
    Ok(text)
}
