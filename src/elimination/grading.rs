//! Sign symmetries: changes of sign of variables that map the equations' span to itself.
//!
//! Such a change splits every polynomial into a part that keeps its sign and one that changes it. If the span of the
//! equations is mapped to itself, both parts lie in it, and everything that follows falls apart into smaller pieces
//! by itself: a multiple of a homogeneous polynomial has no column in common with those of another class.
//!
//! The symmetries are found from the reduced echelon form modulo p. A subspace is the sum of its parts if and only
//! if each row of its reduced echelon form is homogeneous, because that form is unique; and that a row is homogeneous is
//! a system of linear conditions over F₂ on the signs.

use std::collections::{BTreeMap, BTreeSet};

use super::derivation::{Derivation, Source};
use super::echelon::{Echelon, Inserted, SparseRow};
use super::solve::solve;
use crate::algebra::{FieldElement, Integer, Monomial, Polynomial, PrimeField, splitting_primes};
use crate::control::{Control, Interrupted};

/// Numerators and denominators up to this are small.
const SMALL: i64 = 16;
/// The classes are kept in the bits of a word.
const SYMMETRIES: usize = 64;

/// The changes of sign: for each the variables that it turns round.
struct Grading {
    odd: Vec<BTreeSet<u16>>,
}

/// The number of independent symmetries, and the equations, each replaced by its homogeneous parts.
pub(super) fn homogeneous_parts(
    derivation: &mut Derivation<'_>,
    equations: &[Source],
    control: &Control,
) -> Result<(usize, Vec<Source>), Interrupted> {
    let images = splitting_primes(derivation.system().field()).find_map(|prime| {
        let rows: Option<Vec<_>> =
            equations.iter().map(|&f| prime.reduce_polynomial(derivation.polynomial(f))).collect();
        Some(Span::new(rows?, prime))
    });
    let span = images.expect("some prime divides no denominator");
    let grading = span.grading(control)?;
    let mut parts = Vec::new();
    let mut seen = BTreeSet::new();
    for (index, &source) in equations.iter().enumerate() {
        control.check()?;
        let classes = grading.parts(derivation.polynomial(source));
        if classes.len() == 1 {
            parts.push(source);
            continue;
        }
        for part in classes.into_values() {
            // Mirror images have the same parts, up to a factor.
            if !seen.insert(span.monic_image(&part)) {
                continue;
            }
            match span.express(index, &part, equations, derivation, control)? {
                Some(combination) => parts.extend(derivation.derive(combination, control)?),
                // The prime was unlucky; without the parts the search is slower, not wrong.
                None => return Ok((0, equations.to_vec())),
            }
        }
    }
    Ok((grading.odd.len(), parts))
}

impl Grading {
    fn parts(&self, polynomial: &Polynomial) -> BTreeMap<u64, Polynomial> {
        let mut terms: BTreeMap<u64, Vec<(Monomial, FieldElement)>> = BTreeMap::new();
        for (monomial, value) in polynomial.terms() {
            let signs = self.odd.iter().map(|odd| is_odd(monomial, odd));
            let class = signs.enumerate().fold(0, |class, (bit, odd)| class | u64::from(odd) << bit);
            terms.entry(class).or_default().push((monomial.clone(), value.clone()));
        }
        let field = polynomial.field();
        terms.into_iter().map(|(class, terms)| (class, Polynomial::from_terms(field, terms))).collect()
    }
}

fn is_odd(monomial: &Monomial, odd: &BTreeSet<u16>) -> bool {
    let turned = monomial.powers().iter().filter(|(variable, _)| odd.contains(variable));
    turned.map(|&(_, exponent)| exponent).sum::<u32>() % 2 == 1
}

/// The equations modulo a prime, as rows of a matrix.
struct Span {
    prime: PrimeField,
    columns: BTreeMap<Monomial, u32>,
    rows: Vec<SparseRow>,
}

impl Span {
    fn new(images: Vec<Vec<(Monomial, u64)>>, prime: PrimeField) -> Self {
        let monomials: BTreeSet<&Monomial> = images.iter().flatten().map(|(monomial, _)| monomial).collect();
        let columns: BTreeMap<Monomial, u32> = monomials.into_iter().cloned().zip(0..).collect();
        let row = |image: Vec<(Monomial, u64)>| {
            image
                .into_iter()
                .filter(|&(_, value)| value != 0)
                .map(|(m, value)| (columns[&m], value))
                .collect()
        };
        Span { prime, rows: images.into_iter().map(row).collect(), columns }
    }

    /// All changes of sign that make every row of the reduced echelon form homogeneous.
    fn grading(&self, control: &Control) -> Result<Grading, Interrupted> {
        let mut echelon = Echelon::new(self.prime.clone());
        for (id, row) in (0..).zip(&self.rows) {
            echelon.insert(id, row, control)?;
        }
        let monomials: Vec<&Monomial> = self.columns.keys().collect();
        // Over F₂: the difference of any two monomials of a row is even.
        let mut conditions: Vec<BTreeSet<u16>> = Vec::new();
        for row in echelon.reduced_rows(control)? {
            control.check()?;
            let parity = |column: u32| -> BTreeSet<u16> {
                let powers = monomials[column as usize].powers().iter();
                powers.filter(|(_, exponent)| exponent % 2 == 1).map(|&(variable, _)| variable).collect()
            };
            let Some((&(first, _), others)) = row.split_first() else { continue };
            let first = parity(first);
            for &(column, _) in others {
                add_condition(&mut conditions, &first ^ &parity(column));
            }
        }
        // Each condition is solved for its first variable; the others are free.
        let solved: BTreeSet<u16> = conditions.iter().filter_map(|c| c.first().copied()).collect();
        let used: BTreeSet<u16> =
            monomials.iter().flat_map(|m| m.powers()).map(|&(variable, _)| variable).collect();
        let free = used.difference(&solved).copied().take(SYMMETRIES);
        let odd = free.map(|one| {
            let determined = conditions.iter().filter(|c| c.contains(&one)).filter_map(|c| c.first());
            determined.copied().chain([one]).collect()
        });
        Ok(Grading { odd: odd.collect() })
    }

    /// `part` of equation number `whole` as an exact combination of the equations, preferably of those that have the
    /// same monomials as the whole: they are usually its mirror images.
    fn express(
        &self,
        whole: usize,
        part: &Polynomial,
        equations: &[Source],
        derivation: &Derivation<'_>,
        control: &Control,
    ) -> Result<Option<Vec<(Source, Polynomial)>>, Interrupted> {
        let support = |index: usize| self.rows[index].iter().map(|&(column, _)| column);
        let Some(image) = self.prime.reduce_polynomial(part) else { return Ok(None) };
        let target: SparseRow = image.into_iter().map(|(m, value)| (self.columns[&m], value)).collect();
        let mut order: Vec<usize> = (0..equations.len()).collect();
        order.sort_by_key(|&k| (k != whole, !support(k).eq(support(whole)), self.rows[k].len(), k));
        let images = order.iter().take_while(|&&k| support(k).eq(support(whole))).count();
        let mut relation = None;
        for count in [images, order.len()] {
            let mut echelon = Echelon::new(self.prime.clone());
            for &index in &order[..count] {
                echelon.insert(index as u32, &self.rows[index], control)?;
            }
            if let Inserted::Dependent(dependence) = echelon.insert(u32::MAX, &target, control)? {
                relation = Some(echelon.relation(&dependence, control)?);
                break;
            }
        }
        let Some(relation) = relation else { return Ok(None) };
        let relation: Vec<(usize, u64)> = relation
            .into_iter()
            .filter(|&(id, _)| id != u32::MAX)
            .map(|(id, factor)| (id as usize, self.prime.subtract(0, factor)))
            .collect();
        let small: Option<Vec<FieldElement>> =
            relation.iter().map(|&(_, factor)| self.small_fraction(factor, part)).collect();
        let factors = match small {
            Some(factors) => factors,
            None => match self.solve(&relation, part, equations, derivation, control)? {
                Some(factors) => factors,
                None => return Ok(None),
            },
        };
        let combination: Vec<_> = relation
            .iter()
            .zip(factors)
            .map(|(&(index, _), factor)| (equations[index], Polynomial::constant(factor)))
            .collect();
        let products = combination.iter().map(|(f, by)| (by, derivation.polynomial(*f)));
        let sum = Polynomial::sum_of_products(part.field(), products, control)?;
        Ok((sum == *part).then_some(combination))
    }

    /// The image of a polynomial with leading coefficient 1; empty where p divides a denominator.
    fn monic_image(&self, polynomial: &Polynomial) -> SparseRow {
        let Some(image) = self.prime.reduce_polynomial(polynomial) else { return SparseRow::new() };
        let scale = image.first().map_or(1, |&(_, leading)| self.prime.inverse(leading));
        image.into_iter().map(|(m, value)| (self.columns[&m], self.prime.multiply(value, scale))).collect()
    }

    /// The fraction with small numerator and denominator that has this image: what one gets for mirror images.
    fn small_fraction(&self, image: u64, part: &Polynomial) -> Option<FieldElement> {
        let p = self.prime.modulus();
        (1..=SMALL as u64).find_map(|denominator| {
            let residue = self.prime.multiply(image, denominator);
            let numerator = if residue > p / 2 { residue as i64 - p as i64 } else { residue as i64 };
            let fraction =
                || part.field().rational(Integer::from(numerator), Integer::from(denominator as i64));
            (numerator.abs() <= SMALL).then(fraction)
        })
    }

    /// The factors by exact solution, where they are not small fractions.
    fn solve(
        &self,
        relation: &[(usize, u64)],
        part: &Polynomial,
        equations: &[Source],
        derivation: &Derivation<'_>,
        control: &Control,
    ) -> Result<Option<Vec<FieldElement>>, Interrupted> {
        let rows: Vec<SparseRow> = relation.iter().map(|&(index, _)| self.rows[index].clone()).collect();
        let monomials: Vec<&Monomial> = self.columns.keys().collect();
        let entry = |k: usize, column: u32| {
            derivation.polynomial(equations[relation[k].0]).coefficient(monomials[column as usize]).cloned()
        };
        let right = |column: u32| part.coefficient(monomials[column as usize]).cloned();
        let solution = solve(&rows, entry, right, &self.prime, part.field(), control)?;
        Ok(solution.map(|(factors, denominator)| {
            let inverse = part.field().rational(Integer::one(), denominator);
            factors.iter().map(|factor| factor * &inverse).collect()
        }))
    }
}

/// Keeps the conditions in reduced echelon form.
fn add_condition(conditions: &mut Vec<BTreeSet<u16>>, mut fresh: BTreeSet<u16>) {
    for condition in conditions.iter() {
        if condition.first().is_some_and(|pivot| fresh.contains(pivot)) {
            fresh = &fresh ^ condition;
        }
    }
    let Some(pivot) = fresh.first().copied() else { return };
    for condition in conditions.iter_mut().filter(|condition| condition.contains(&pivot)) {
        *condition = &*condition ^ &fresh;
    }
    conditions.push(fresh);
}
