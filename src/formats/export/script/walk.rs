//! The walk over a case: data as calls, polynomials as sums.

use std::fmt::Write;

use num_rational::BigRational;
use num_traits::{One, Signed};

use super::super::case::{Case, Reasoning};
use super::super::text::harmless;
use super::generators;
use crate::certificate::{Premise, Step};
use crate::exact::Polynomial;
use crate::statement::{COORDINATES, Subject};

/// A sum is broken off after this many characters: parsers have limits on lines and on nesting.
const SUM: usize = 400;

/// How a language writes what the walk writes.
pub(in crate::formats::export) struct Dialect {
    /// What opens and closes a comment of one line.
    pub(in crate::formats::export) comment: [&'static str; 2],
    /// What ends a statement.
    pub(in crate::formats::export) end: &'static str,
    /// How a long sum is written.
    pub(in crate::formats::export) sums: Sums,
}

/// How a sum that is too long for one expression is written.
pub(in crate::formats::export) enum Sums {
    /// In pieces: `P = …` with this sign, then `P = P + …`.
    Pieces(&'static str),
    /// As text that the script parses by itself.
    Text,
}

/// The surface equation as sums in X, Y, Z, W, each short enough.
pub(in crate::formats::export) fn surface(case: &Case) -> Vec<String> {
    let Subject::Patch(patch) = &case.subject else { return Vec::new() };
    let roots = generators(case).into_iter().take(case.root_count());
    sums(case, &patch.surface, &roots.chain(COORDINATES.map(String::from)).collect::<Vec<_>>())
}

/// A polynomial as sums of terms, each short enough: `3/8*r2*x1^2 - 4`.
fn sums(case: &Case, polynomial: &Polynomial, names: &[String]) -> Vec<String> {
    let mut sums = vec![String::new()];
    for term in case.terms(polynomial) {
        let positive = term.coefficient.is_positive();
        if sums.last().is_some_and(|sum| sum.len() > SUM) {
            sums.push(String::new());
        }
        let Some(sum) = sums.last_mut() else { continue };
        sum.push_str(match (sum.is_empty(), positive) {
            (true, true) => "",
            (true, false) => "-",
            (false, true) => " + ",
            (false, false) => " - ",
        });
        sum.push_str(&factors(&term.coefficient.abs(), &term.powers, names));
    }
    if let [sum] = &mut sums[..]
        && sum.is_empty()
    {
        sum.push('0');
    }
    sums
}

fn factors(coefficient: &BigRational, powers: &[(usize, u32)], names: &[String]) -> String {
    let mut factors = Vec::new();
    if !coefficient.is_one() || powers.is_empty() {
        factors.push(coefficient.to_string());
    }
    for &(generator, exponent) in powers {
        let name = &names[generator];
        factors.push(if exponent == 1 { name.clone() } else { format!("{name}^{exponent}") });
    }
    factors.join("*")
}

/// The walk: a case with the dialect it is written in.
pub(super) struct Walk<'a> {
    case: &'a Case,
    dialect: &'a Dialect,
    names: Vec<String>,
    text: String,
}

impl<'a> Walk<'a> {
    pub(super) fn new(case: &'a Case, dialect: &'a Dialect) -> Walk<'a> {
        Walk { case, dialect, names: generators(case), text: String::new() }
    }

    /// What the script is, how it is run, what its names stand for.
    pub(super) fn header(mut self, run: &str) -> String {
        let case = self.case;
        self.comment(&case.title);
        self.comment(&format!("Statement {}, written by prove-cap", case.hash));
        self.comment(&format!("Run: {run}"));
        self.comment("The line that comes out begins with VERIFIED (exit status 0) or REJECTED (1).");
        for radicand in case.field.values() {
            self.comment(&format!("r{radicand} is a square root of {radicand}"));
        }
        match &case.argument {
            Reasoning::Impossible(_) => {
                for (k, unknown) in (1..).zip(&case.unknowns) {
                    self.comment(&format!("x{k} stands for the unknown {}", harmless(unknown)));
                }
                for k in 1..=case.assumptions.len() {
                    self.comment(&format!("t{k} is the inverse of assumption {k}"));
                }
            }
            Reasoning::Exact(values) => {
                for (unknown, value) in case.unknowns.iter().zip(values) {
                    let value = sums(case, value, &self.names).join(" + ");
                    self.comment(&format!("Put in already: {} = {value}", harmless(unknown)));
                }
            }
        }
        self.text
    }

    /// The statement: a net or a list of equations, then the assumptions.
    pub(super) fn statement(mut self) -> String {
        let case = self.case;
        match &case.subject {
            Subject::Patch(patch) => {
                self.comment("The control net: i, j, X, Y, Z, W");
                for (i, row) in patch.net.iter().enumerate() {
                    for (j, point) in row.iter().enumerate() {
                        self.call(&format!("point({i}, {j}, "), point);
                    }
                }
            }
            Subject::System(polynomials) => {
                self.comment("The equations");
                for polynomial in polynomials {
                    self.call("equation(", [polynomial]);
                }
            }
        }
        if !case.assumptions.is_empty() {
            self.comment("What is assumed not to vanish");
        }
        let inverses = case.root_count() + case.unknowns.len();
        for (k, assumed) in case.assumptions.iter().enumerate() {
            // For an exact claim nothing is left to be inverted.
            let inverse = self.names.get(inverses + k).map_or("0", String::as_str);
            let inverse = match self.dialect.sums {
                Sums::Text => format!("\"{inverse}\""),
                Sums::Pieces(_) => inverse.to_owned(),
            };
            self.call(&format!("assumed({inverse}, "), [assumed]);
        }
        self.text
    }

    /// The steps.
    pub(super) fn steps(mut self) -> String {
        let case = self.case;
        for (number, step) in (1..).zip(case.steps()) {
            self.step(number, step);
        }
        self.text
    }

    fn step(&mut self, number: usize, step: &Step) {
        self.comment(&format!("Step {number}"));
        for (premise, multiplier) in &step.combination {
            let premise = self.premise(premise);
            self.call(&format!("add({premise}, "), [multiplier]);
        }
        self.call(&format!("conclude({number}, "), [&step.conclusion]);
    }

    /// A premise as a call that looks it up. One of another kind of statement does not exist, which the script is to find out.
    fn premise(&self, premise: &Premise) -> String {
        match (premise, &self.case.subject) {
            (Premise::Coefficient(r, s), Subject::Patch(_)) => format!("c({r}, {s})"),
            (Premise::Equation(k), Subject::System(_)) => format!("f({k})"),
            (Premise::Nonzero(k), _) => format!("nonzero({k})"),
            (Premise::Step(k), _) => format!("earlier({k})"),
            (Premise::Coefficient(..), Subject::System(_)) | (Premise::Equation(_), Subject::Patch(_)) => {
                "foreign()".to_owned()
            }
        }
    }

    /// A statement that calls something with polynomials for its last arguments.
    fn call<'p>(&mut self, opening: &str, polynomials: impl IntoIterator<Item = &'p Polynomial>) {
        let end = self.dialect.end;
        let mut arguments = Vec::new();
        for (position, polynomial) in polynomials.into_iter().enumerate() {
            let sums = sums(self.case, polynomial, &self.names);
            let argument = match (&self.dialect.sums, &sums[..]) {
                (Sums::Text, [sum]) => format!("\"{sum}\""),
                (Sums::Text, sums) => format!("\"\"\"\n{}\"\"\"", sums.join("\n + ").replace("+ -", "- ")),
                (Sums::Pieces(_), [sum]) => sum.clone(),
                (Sums::Pieces(set), sums) => {
                    let name = format!("P{}", position + 1);
                    for (piece, sum) in sums.iter().enumerate() {
                        let before = if piece == 0 { String::new() } else { format!("{name} + ") };
                        // An own bracket, since the sum may begin with a sign.
                        let _ = writeln!(self.text, "{name} {set} {before}({sum}){end}");
                    }
                    name
                }
            };
            arguments.push(argument);
        }
        let _ = writeln!(self.text, "{opening}{}){end}", arguments.join(", "));
    }

    fn comment(&mut self, text: &str) {
        let [open, close] = self.dialect.comment;
        let _ = writeln!(self.text, "{}", format!("{open} {text} {close}").trim_end());
    }
}
