//! The practical algebraic calculus (Kaufmann, Fleury, Biere, FMCAD 2020), for `pacheck -e`.
//!
//! A proof in it is a straight line of sums and products of polynomials with integer coefficients, each with what it
//! comes to. It knows no patches, no roots, no fractions, no quantifiers and no comments. So the axioms are the *expanded*
//! equations, scaled to integers (that they belong to the patch is not proved), √d is a variable s with the axiom
//! s² − d, and the last line is a non-zero integer: the target. Whoever believes the checker knows that the
//! axioms have no common zero in any field of characteristic 0.
//!
//! What the checker makes of it, as found by running it: it exits 0 also where the target is not inferred, so that only the line
//! `TARGET CHECKED` is a yes; without `-e` it computes with x² = x; it refuses exponents from 11 on (but for those like 20), which
//! are therefore written as products of powers; and a multiplier may contain only variables that an axiom contains.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::case::{Case, ExportError, Reasoning};
use super::flat::{lift, quotients, root_equations, sum_of_products, used_equations};
use super::integral::scaled;
use crate::certificate::{Premise, Step};
use crate::control::Control;
use crate::exact::{Limit, Monomial, Polynomial};

/// The largest exponent that is written as such: more than one digit may be refused.
const EXPONENT: u32 = 9;

/// The three files as one text, each after a line `==> ENDING <==`.
pub(super) fn export(case: &Case) -> Result<String, ExportError> {
    Ok(files(case)?.map(|(ending, text)| format!("==> {ending} <==\n{text}")).join("\n"))
}

/// The files that `pacheck -e X.polys X.proof X.target` reads, as (ending, text).
///
/// # Errors
/// [`ExportError::Inexpressible`] for an exact claim, [`ExportError::Premise`] for a step that uses what there is not.
pub fn files(case: &Case) -> Result<[(&'static str, String); 3], ExportError> {
    if let Reasoning::Exact(_) = case.argument {
        let what = "that equations have a solution: all it can say is that a polynomial follows from others"
            .to_owned();
        return Err(ExportError::Inexpressible { format: "pac", what });
    }
    let mut proof = Proof::new(case)?;
    // An empty argument, which is none, is left with a target that it does not reach.
    let mut target = BigInt::one();
    for (position, step) in case.steps().iter().enumerate() {
        target = proof.step(case, step, position + 1 == case.steps().len())?;
    }
    Ok([("polys", proof.axioms), ("proof", proof.rules), ("target", format!("{target};\n"))])
}

/// A polynomial that has been written, with its number in the files.
struct Line {
    number: usize,
    polynomial: Polynomial,
    /// What it was multiplied with to become integral.
    scale: BigRational,
}

struct Proof {
    names: Vec<String>,
    axioms: String,
    rules: String,
    last: usize,
    radicands: Vec<u32>,
    roots: Vec<Line>,
    equations: Vec<(Premise, Line)>,
    steps: Vec<Line>,
}

impl Proof {
    fn new(case: &Case) -> Result<Proof, ExportError> {
        let radicands = case.field.values().to_vec();
        let roots = radicands.iter().map(|radicand| format!("s{radicand}"));
        let unknowns = (1..=case.unknowns.len()).map(|number| format!("x{number}"));
        let inverses = (1..=case.assumptions.len()).map(|number| format!("t{number}"));
        let mut proof = Proof {
            names: roots.chain(unknowns).chain(inverses).collect(),
            axioms: String::new(),
            rules: String::new(),
            last: 0,
            roots: Vec::new(),
            equations: Vec::new(),
            steps: Vec::new(),
            radicands,
        };
        for equation in root_equations(&proof.radicands)? {
            let line = proof.axiom(equation);
            proof.roots.push(line);
        }
        let mut known = vec![false; proof.names.len()];
        for (name, equation) in used_equations(case)? {
            mark(&equation, &mut known);
            let line = proof.axiom(equation);
            proof.equations.push((name, line));
        }
        let mut needed = vec![false; proof.names.len()];
        for (_, multiplier) in case.steps().iter().flat_map(|step| &step.combination) {
            mark(&lift(case, multiplier)?, &mut needed);
        }
        // A variable of multipliers only would be refused; 0 is a consequence of everything.
        for generator in proof.radicands.len()..proof.names.len() {
            if needed[generator] && !known[generator] {
                proof.last += 1;
                proof.axioms += &format!("{} {1}-{1};\n", proof.last, proof.names[generator]);
            }
        }
        Ok(proof)
    }

    fn axiom(&mut self, polynomial: Polynomial) -> Line {
        let scale = scale_of(polynomial.terms().map(|(_, coefficient)| coefficient));
        let polynomial = scaled(&polynomial, &scale);
        self.last += 1;
        self.axioms += &format!("{} {};\n", self.last, self.spell(&polynomial));
        Line { number: self.last, polynomial, scale }
    }

    /// Products, then their sum, then what it comes to *according to the certificate*. Returns what 1 would be there.
    fn step(&mut self, case: &Case, step: &Step, last: bool) -> Result<BigInt, ExportError> {
        case.control.check()?;
        let mut factors = Vec::with_capacity(step.combination.len());
        for (premise, multiplier) in &step.combination {
            let line = self.premise(*premise)?;
            let factor = scaled(&lift(case, multiplier)?, &line.scale.recip());
            factors.push((line.number, line.polynomial.clone(), factor));
        }
        let conclusion = lift(case, &step.conclusion)?;
        let one = BigRational::one();
        let coefficients = factors.iter().flat_map(|(_, _, factor)| factor.terms()).chain(conclusion.terms());
        let coefficients = coefficients.map(|(_, coefficient)| coefficient);
        let scale = scale_of(coefficients.chain(last.then_some(&one)));
        let conclusion = scaled(&conclusion, &scale);

        for (_, _, factor) in &mut factors {
            *factor = scaled(factor, &scale);
        }
        let pairs: Vec<_> = factors.iter().map(|(_, premise, factor)| (factor, premise)).collect();
        let quotients = quotients(&sum_of_products(&pairs, &case.control)?, &self.radicands)?;
        for (root, quotient) in self.roots.iter().zip(quotients) {
            if !quotient.is_zero() {
                factors.push((root.number, root.polynomial.clone(), quotient.negate()));
            }
        }
        self.combine(factors, &conclusion, &case.control)?;
        let number = self.last;
        self.steps.push(Line { number, polynomial: conclusion, scale: scale.clone() });
        Ok(scale.to_integer())
    }

    /// Writes Σ factor·polynomial, pair by pair so that the sums stay short, the last line with the stated conclusion.
    fn combine(
        &mut self,
        factors: Vec<(usize, Polynomial, Polynomial)>,
        conclusion: &Polynomial,
        control: &Control,
    ) -> Result<(), Limit> {
        let only = factors.len() == 1;
        let mut summands = Vec::with_capacity(factors.len());
        for (number, polynomial, factor) in factors {
            let product = sum_of_products(&[(&polynomial, &factor)], control)?;
            let rule = format!("* {number}, {}", self.spell(&factor));
            summands.push((self.rule(&rule, if only { conclusion } else { &product }), product));
        }
        while summands.len() > 1 {
            let final_round = summands.len() == 2;
            let mut sums = Vec::with_capacity(summands.len().div_ceil(2));
            for pair in summands.chunks(2) {
                let [(a, p), (b, q)] = pair else {
                    sums.extend_from_slice(pair);
                    continue;
                };
                let one = Polynomial::integer(1);
                let sum = sum_of_products(&[(&one, p), (&one, q)], control)?;
                let stated = if final_round { conclusion } else { &sum };
                sums.push((self.rule(&format!("+ {a}, {b}"), stated), sum));
            }
            summands = sums;
        }
        Ok(())
    }

    fn rule(&mut self, rule: &str, conclusion: &Polynomial) -> usize {
        self.last += 1;
        self.rules += &format!("{} {rule}, {};\n", self.last, self.spell(conclusion));
        self.last
    }

    fn premise(&self, premise: Premise) -> Result<&Line, ExportError> {
        let line = match premise {
            Premise::Step(number) => {
                usize::try_from(number).ok().and_then(|number| self.steps.get(number.checked_sub(1)?))
            }
            _ => self.equations.iter().find(|(name, _)| *name == premise).map(|(_, line)| line),
        };
        line.ok_or(ExportError::Premise(premise))
    }

    fn spell(&self, polynomial: &Polynomial) -> String {
        let mut text = String::new();
        for (monomial, coefficient) in polynomial.terms() {
            let sign = if coefficient.is_negative() { "-" } else { "+" };
            text += if text.is_empty() && sign == "+" { "" } else { sign };
            let mut factors = powers(monomial, &self.names);
            let size = coefficient.numer().abs();
            if factors.is_empty() || !size.is_one() {
                factors.insert(0, size.to_string());
            }
            text += &factors.join("*");
        }
        if text.is_empty() { "0".to_owned() } else { text }
    }
}

/// The powers of a monomial, large ones in pieces.
fn powers(monomial: &Monomial, names: &[String]) -> Vec<String> {
    let mut factors = Vec::new();
    for &(variable, exponent) in monomial.powers() {
        let name = &names[usize::from(variable)];
        factors.extend((0..exponent / EXPONENT).map(|_| format!("{name}^{EXPONENT}")));
        match exponent % EXPONENT {
            0 => {}
            1 => factors.push(name.clone()),
            rest => factors.push(format!("{name}^{rest}")),
        }
    }
    factors
}

fn mark(polynomial: &Polynomial, seen: &mut [bool]) {
    for (variable, _) in polynomial.terms().flat_map(|(monomial, _)| monomial.powers()) {
        seen[usize::from(*variable)] = true;
    }
}

/// The least positive rational that makes all of these integers: lcm of denominators / gcd of numerators.
fn scale_of<'a>(coefficients: impl Iterator<Item = &'a BigRational>) -> BigRational {
    let (mut numerators, mut denominators) = (BigInt::zero(), BigInt::one());
    for coefficient in coefficients {
        numerators = numerators.gcd(coefficient.numer());
        denominators = denominators.lcm(coefficient.denom());
    }
    BigRational::new(denominators, if numerators.is_zero() { BigInt::one() } else { numerators })
}
