//! Regular square systems over K, exactly, by p-adic lifting (Dixon 1982, doi:10.1007/BF01459082).
//!
//! With p split in K, O/pO is F_p^(2ᵏ): the system is decomposed once under each embedding, and each step of
//! the lifting gives one more p-adic digit of every coordinate of the solution. The cost is that of the size of the answer; the
//! intermediate growth of elimination over K does not occur.

use rayon::prelude::*;

use super::echelon::{Echelon, Inserted, SparseRow};
use super::lu::Decomposition;
use super::progress::Progress;
use super::reconstruct::reconstruct;
use crate::algebra::{FieldElement, Integer, MultiquadraticField, PrimeField};
use crate::control::{Control, Interrupted};

/// Entries up to this are multiplied in machine words: 2⁶⁰ · p · (terms of a sum) stays below 2¹²⁷.
const SMALL: u64 = 60;
/// p-adic digits before the first attempt at reconstruction.
const FIRST_ATTEMPT: usize = 6;
/// Equations below which threads cost more than they gain.
const SEQUENTIAL: usize = 64;
/// p-adic digits from which attempts are worth mentioning.
const MANY: usize = 30;

/// Integral x and an integer d > 0 with Σ xₖ · rowₖ = d · right in the columns in which the rows lead.
///
/// `rows` are the images modulo p, independent there; `entry(k, column)` and `right(column)` are the exact entries, `None`
/// where they are zero. `None` if p was unlucky. Whether other columns agree is for the caller to verify.
pub fn solve(
    rows: &[SparseRow],
    entry: impl Fn(usize, u32) -> Option<FieldElement>,
    right: impl Fn(u32) -> Option<FieldElement>,
    prime: &PrimeField,
    field: MultiquadraticField,
    control: &Control,
) -> Result<Option<(Vec<FieldElement>, Integer)>, Interrupted> {
    let mut echelon = Echelon::new(prime.clone());
    let mut columns = Vec::new();
    for (id, row) in (0..).zip(rows) {
        match echelon.insert(id, row, control)? {
            Inserted::Pivot(column) => columns.push(column),
            Inserted::Dependent(_) => return Ok(None),
        }
    }
    drop(echelon);
    let mut equations = Vec::with_capacity(columns.len());
    for column in columns {
        control.check()?;
        equations.push(Equation::new(rows.len(), |k| entry(k, column), right(column), field));
    }
    let Some(mut lifting) = Lifting::new(equations, prime, field, control)? else { return Ok(None) };
    let most = lifting.enough_digits();
    let mut attempt = FIRST_ATTEMPT;
    while lifting.digits.len() <= most {
        lifting.step(control)?;
        if lifting.digits.len() == attempt {
            if attempt >= MANY {
                control.observe(&Progress::Digits { digits: attempt });
            }
            if let Some(solution) = lifting.solution(control)? {
                return Ok(Some(solution));
            }
            attempt += attempt / 3;
        }
    }
    Ok(None)
}

/// One equation with integral entries: Σ entry · x = what is left of the right side.
struct Equation {
    /// (unknown, coordinates).
    entries: Vec<(usize, Vec<Integer>)>,
    /// The same where all are small.
    small: Option<Vec<(usize, Vec<i128>)>>,
    /// By coordinate.
    residue: Vec<Integer>,
}

impl Equation {
    fn new(
        unknowns: usize,
        entry: impl Fn(usize) -> Option<FieldElement>,
        right: Option<FieldElement>,
        field: MultiquadraticField,
    ) -> Self {
        let exact: Vec<(usize, FieldElement)> = (0..unknowns).filter_map(|k| Some((k, entry(k)?))).collect();
        let right = right.unwrap_or_else(|| field.zero());
        let of_entries = exact.iter().map(|(_, value)| value.denominator());
        let denominator = of_entries.fold(right.denominator().clone(), |lcm, d| lcm.lcm(d));
        let integral = |value: &FieldElement| -> Vec<Integer> {
            let factor = denominator.exact_quotient(value.denominator());
            value.numerators().iter().map(|numerator| numerator * &factor).collect()
        };
        let entries: Vec<(usize, Vec<Integer>)> =
            exact.iter().map(|(k, value)| (*k, integral(value))).collect();
        let roots = field.under_root(field.degree() - 1).bits();
        let small = |(k, value): &(usize, Vec<Integer>)| {
            let words: Option<Vec<i128>> = value.iter().map(|v| Some(i128::from(v.to_i64()?))).collect();
            words.filter(|_| value.iter().all(|v| v.bits() + roots <= SMALL)).map(|words| (*k, words))
        };
        Equation { small: entries.iter().map(small).collect(), residue: integral(&right), entries }
    }

    /// Subtracts Σ entry · digit and divides by p.
    fn advance(&mut self, digits: &[Vec<i64>], p: &Integer, roots: &[Integer]) {
        let degree = roots.len();
        let sum: Vec<Integer> = match &self.small {
            Some(entries) => {
                let mut sum = vec![0i128; degree];
                for (k, entry) in entries {
                    for (s, &a) in entry.iter().enumerate().filter(|&(_, &a)| a != 0) {
                        for (t, &b) in digits[*k].iter().enumerate() {
                            let root =
                                if s & t == 0 { 1 } else { i128::from(roots[s & t].to_i64().unwrap_or(0)) };
                            sum[s ^ t] += a * root * i128::from(b);
                        }
                    }
                }
                sum.into_iter().map(Integer::from).collect()
            }
            None => {
                let mut sum = vec![Integer::zero(); degree];
                for (k, entry) in &self.entries {
                    for (s, a) in entry.iter().enumerate().filter(|(_, a)| !a.is_zero()) {
                        for (t, &b) in digits[*k].iter().enumerate().filter(|&(_, &b)| b != 0) {
                            let digit = &Integer::from(b) * &roots[s & t];
                            sum[s ^ t] += &(a * &digit);
                        }
                    }
                }
                sum
            }
        };
        for (residue, subtract) in self.residue.iter_mut().zip(sum) {
            *residue -= &subtract;
            *residue = residue.exact_quotient(p);
        }
    }
}

struct Lifting {
    equations: Vec<Equation>,
    field: MultiquadraticField,
    /// One for each embedding.
    embeddings: Vec<(PrimeField, Decomposition)>,
    p: Integer,
    /// What stands under the root that a product of two basis elements brings, by the common subset.
    roots: Vec<Integer>,
    /// By step, unknown, coordinate.
    digits: Vec<Vec<Vec<i64>>>,
}

impl Lifting {
    fn new(
        equations: Vec<Equation>,
        prime: &PrimeField,
        field: MultiquadraticField,
        control: &Control,
    ) -> Result<Option<Self>, Interrupted> {
        let size = equations.len();
        let decompose = |embedding: PrimeField| {
            let mut matrix = vec![0u32; size * size];
            for (row, equation) in matrix.chunks_exact_mut(size.max(1)).zip(&equations) {
                control.check()?;
                for (k, entry) in &equation.entries {
                    row[*k] = embedding.combine(entry) as u32;
                }
            }
            let decomposition = Decomposition::new(embedding.clone(), size, matrix, control)?;
            Ok(decomposition.map(|decomposition| (embedding, decomposition)))
        };
        let embeddings = prime.embeddings();
        let embeddings: Result<Vec<Option<_>>, Interrupted> = if size < SEQUENTIAL {
            embeddings.into_iter().map(decompose).collect()
        } else {
            embeddings.into_par_iter().map(decompose).collect()
        };
        let Some(embeddings) = embeddings?.into_iter().collect() else { return Ok(None) };
        Ok(Some(Lifting {
            embeddings,
            p: Integer::from(prime.modulus() as i64),
            roots: (0..field.degree()).map(|subset| field.under_root(subset)).collect(),
            field,
            equations,
            digits: Vec::new(),
        }))
    }

    /// Digits that suffice for certain, with room for the last attempt: Hadamard's bound for the equations over Q.
    fn enough_digits(&self) -> usize {
        let entries = self.equations.iter().flat_map(|e| e.entries.iter().flat_map(|(_, value)| value));
        let longest = entries.chain(self.equations.iter().flat_map(|e| &e.residue)).map(Integer::bits).max();
        let roots = self.roots.last().map_or(0, Integer::bits);
        let size = (self.equations.len() * self.roots.len()) as u64;
        let determinant = size * (longest.unwrap_or(0) + roots + u64::from(size.max(1).ilog2()) + 1);
        // Numerator and denominator, at 30 bits a digit, then the next attempt.
        let digits = usize::try_from(2 * determinant / 30 + 4).unwrap_or(usize::MAX / 2);
        FIRST_ATTEMPT + digits + digits / 3
    }

    /// One more p-adic digit of every coordinate.
    fn step(&mut self, control: &Control) -> Result<(), Interrupted> {
        control.check()?;
        let solve = |(embedding, decomposition): &(PrimeField, Decomposition)| {
            let right: Vec<u64> = self.equations.iter().map(|e| embedding.combine(&e.residue)).collect();
            decomposition.solve(&right)
        };
        let images: Vec<Vec<u64>> = if self.equations.len() < SEQUENTIAL {
            self.embeddings.iter().map(solve).collect()
        } else {
            self.embeddings.par_iter().map(solve).collect()
        };
        let (prime, _) = &self.embeddings[0];
        let unknowns = 0..self.equations.len();
        let digits: Vec<Vec<i64>> = unknowns
            .map(|k| prime.coordinates(&images.iter().map(|image| image[k]).collect::<Vec<_>>()))
            .collect();
        let (p, roots) = (&self.p, &self.roots);
        self.equations
            .par_iter_mut()
            .with_min_len(SEQUENTIAL)
            .try_for_each(|equation| control.check().map(|()| equation.advance(&digits, p, roots)))?;
        self.digits.push(digits);
        Ok(())
    }

    /// The solution, if the digits suffice.
    fn solution(&self, control: &Control) -> Result<Option<(Vec<FieldElement>, Integer)>, Interrupted> {
        let mut powers = vec![self.p.clone()];
        while 1 << powers.len() < self.digits.len() {
            let last = powers.last().expect("at least p");
            powers.push(last * last);
        }
        let mut modulus = Integer::one();
        for _ in &self.digits {
            control.check()?;
            modulus = &modulus * &self.p;
        }
        let degree = self.field.degree();
        let residues: Result<Vec<Integer>, Interrupted> = (0..self.equations.len() * degree)
            .into_par_iter()
            .with_min_len(SEQUENTIAL)
            .map(|index| {
                control.check()?;
                let digits: Vec<i64> =
                    self.digits.iter().map(|digits| digits[index / degree][index % degree]).collect();
                Ok(evaluate(&digits, &powers))
            })
            .collect();
        let Some((numerators, denominator)) = reconstruct(&residues?, &modulus, control)? else {
            return Ok(None);
        };
        let integral = |coordinates: &[Integer]| self.field.element(coordinates.to_vec(), Integer::one());
        Ok(Some((numerators.chunks(degree).map(integral).collect(), denominator)))
    }
}

/// Σ digitₖ·pᵏ, by halves; `powers` are p, p², p⁴, …
fn evaluate(digits: &[i64], powers: &[Integer]) -> Integer {
    match digits {
        [] => Integer::zero(),
        [digit] => Integer::from(*digit),
        _ => {
            let level = (digits.len() - 1).ilog2() as usize;
            let (low, high) = digits.split_at(1 << level);
            &evaluate(low, powers) + &(&evaluate(high, powers) * &powers[level])
        }
    }
}
