//! The smallest change of a printed formula that makes it right.
//!
//! A formula has *sites*: signs, numbers, roots, exponents, names. Changing one site changes the value by some
//! polynomial; a correction is a set of at most three changes whose effects cancel the difference exactly. Among
//! these the cheapest counts: as few characters as possible.

use std::collections::BTreeMap;
use std::ops::Range;

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::site::{Site, change_site, count_sites, site};
use crate::exact::{Monomial, Polynomial, Work};
use crate::formats::listing::{Expression, Kind, Scope, Symbol};
use crate::statement::Place;

/// The most sites that are changed.
const CHANGES: usize = 3;
/// Sites of the longest formula that is explained: nobody reads longer ones.
const SITES: usize = 1000;
/// Combinations that are tried.
const TRIES: usize = 4000;

/// One change of a printed formula.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Correction {
    /// Where.
    pub place: Place,
    /// What.
    pub change: Change,
}

/// What is changed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Change {
    /// The sign of a term; whether it becomes a minus.
    Sign {
        /// Whether minus is right.
        minus: bool,
    },
    /// A number.
    Number {
        /// As printed.
        printed: BigRational,
        /// What is right.
        right: BigRational,
    },
    /// The number under a root.
    Radicand {
        /// As printed.
        printed: BigRational,
        /// What is right.
        right: u64,
    },
    /// A factor √n is missing beside this number.
    MissingRoot {
        /// The number it belongs to.
        beside: BigRational,
        /// n.
        root: u64,
    },
    /// This root does not belong there.
    SuperfluousRoot,
    /// An exponent.
    Exponent {
        /// As printed; 1 where none is.
        printed: u32,
        /// What is right.
        right: u32,
    },
    /// A name.
    Name {
        /// As printed.
        printed: Symbol,
        /// What is right.
        right: Symbol,
    },
}

impl Change {
    fn cost(&self) -> usize {
        match self {
            Change::Sign { .. } | Change::Radicand { .. } | Change::Exponent { .. } => 1,
            Change::Number { printed, right } => {
                edit_distance(&printed.to_string(), &right.to_string()).max(1)
            }
            Change::Name { .. } | Change::MissingRoot { .. } | Change::SuperfluousRoot => 2,
        }
    }
}

/// A basis element: a root with a power product.
type Effect = BTreeMap<Monomial, BigRational>;

/// A change of one site and what it adds to the value.
struct Candidate {
    site: usize,
    change: Option<Change>,
    effect: Effect,
    /// For a number whose value is free: the effect is that of adding 1 to it (to its reciprocal below a slash).
    free: Option<(BigRational, bool)>,
}

/// The cheapest correction that is found, or nothing; and whether the search came to its end.
pub(super) fn corrections(
    printed: &Expression,
    text: &str,
    truth: &Polynomial,
    scope: &Scope,
    work: &mut Work,
) -> (Vec<Correction>, bool) {
    let search = Search { printed, scope, truth };
    let Some(candidates) = search.candidates(work) else { return (Vec::new(), false) };
    let Some(value) = search.value(printed, work) else { return (Vec::new(), false) };
    let missing = difference(&effect_of(truth), &effect_of(&value));
    let mut best: Option<(usize, Vec<(usize, Change)>)> = None;
    let mut tries = TRIES;
    search.extend(&candidates, &missing, &mut Vec::new(), &mut best, &mut tries, work);
    let searched = tries > 0;
    let changes = best.map_or(Vec::new(), |(_, changes)| changes);
    let place = |site: usize| Place::of(text, site_span(printed, site));
    let found = changes.into_iter().map(|(site, change)| Correction { place: place(site), change });
    (found.collect(), searched)
}

fn site_span(printed: &Expression, index: usize) -> Range<usize> {
    match site(printed, index) {
        Some(Site::Sign(signed)) if signed.sign.is_empty() => signed.term.span.clone(),
        Some(Site::Sign(signed)) => signed.sign.clone(),
        Some(Site::Exponent { whole, .. }) => whole.span.clone(),
        Some(Site::Number { part, .. } | Site::Root(part) | Site::Name(part)) => part.span.clone(),
        None => printed.span.clone(),
    }
}

struct Search<'a> {
    printed: &'a Expression,
    scope: &'a Scope,
    truth: &'a Polynomial,
}

impl Search<'_> {
    fn value(&self, expression: &Expression, work: &mut Work) -> Option<Polynomial> {
        expression.value_within(self.scope, work).ok()
    }

    /// All changes of one site. `None` where the allowance runs out.
    fn candidates(&self, work: &mut Work) -> Option<Vec<Candidate>> {
        let sites = count_sites(self.printed);
        if sites > SITES {
            return None;
        }
        let base = effect_of(&self.value(self.printed, work)?);
        let mut found = Vec::new();
        let radicands: Vec<u64> = self.scope.field.values().iter().map(|&d| d.into()).collect();
        let roots: Vec<u64> = (1..1usize << radicands.len())
            .map(|mask| (0..radicands.len()).filter(|b| mask >> b & 1 == 1).map(|b| radicands[b]).product())
            .collect();
        for index in 0..sites {
            let mut changes = Vec::new();
            match site(self.printed, index)? {
                Site::Sign(signed) => changes.push(Change::Sign { minus: !signed.minus }),
                Site::Number { part, in_root, below } => {
                    let Kind::Number(printed) = &part.kind else { continue };
                    if in_root {
                        let right = |&right: &u64| Change::Radicand { printed: printed.clone(), right };
                        changes.extend(roots.iter().map(right));
                    } else {
                        let missing = |&root: &u64| Change::MissingRoot { beside: printed.clone(), root };
                        changes.extend(roots.iter().map(missing));
                        let free = self.free_number(index, printed, below, work);
                        found.extend(free.map(|effect| Candidate {
                            site: index,
                            change: None,
                            effect,
                            free: Some((printed.clone(), below)),
                        }));
                    }
                }
                Site::Root(_) => changes.push(Change::SuperfluousRoot),
                Site::Exponent { exponent, .. } => {
                    let near = [exponent.saturating_sub(1), exponent + 1, exponent + 2];
                    let right = |right| Change::Exponent { printed: exponent, right };
                    changes.extend(near.into_iter().filter(|&right| right > 0).map(right));
                }
                Site::Name(part) => {
                    let Kind::Name(printed) = &part.kind else { continue };
                    let others = self.scope.names.keys().filter(|other| *other != printed);
                    changes.extend(
                        others.map(|right| Change::Name { printed: printed.clone(), right: right.clone() }),
                    );
                }
            }
            for change in changes {
                let changed = change_site(self.printed, index, &change);
                if let Some(value) = self.value(&changed, work) {
                    let effect = difference(&effect_of(&value), &base);
                    found.push(Candidate { site: index, change: Some(change), effect, free: None });
                }
            }
        }
        Some(found)
    }

    /// What adding 1 to a number (to its reciprocal, below a slash) adds to the value, if that is linear.
    fn free_number(
        &self,
        index: usize,
        printed: &BigRational,
        below: bool,
        work: &mut Work,
    ) -> Option<Effect> {
        if below && printed.is_zero() {
            return None;
        }
        let mut values = Vec::new();
        for step in 0..3 {
            let right = moved(printed, below, &BigRational::from_integer(step.into()))?;
            let change = Change::Number { printed: printed.clone(), right };
            values.push(effect_of(&self.value(&change_site(self.printed, index, &change), work)?));
        }
        let (first, second) = (difference(&values[1], &values[0]), difference(&values[2], &values[1]));
        (first == second).then_some(first)
    }

    /// Adds changes until nothing is missing.
    fn extend(
        &self,
        candidates: &[Candidate],
        missing: &Effect,
        chosen: &mut Vec<(usize, Change)>,
        best: &mut Option<(usize, Vec<(usize, Change)>)>,
        tries: &mut usize,
        work: &mut Work,
    ) {
        let cost: usize = chosen.iter().map(|(_, change)| change.cost()).sum();
        if best.as_ref().is_some_and(|(least, _)| cost >= *least) {
            return;
        }
        let Some((first, wanted)) = missing.first_key_value() else {
            // Effects of several changes need not add up: the whole is evaluated.
            let mut changed = self.printed.clone();
            for (site, change) in chosen.iter() {
                changed = change_site(&changed, *site, change);
            }
            if self.value(&changed, work).as_ref() == Some(self.truth) {
                *best = Some((cost, chosen.clone()));
            }
            return;
        };
        if chosen.len() == CHANGES {
            return;
        }
        for candidate in candidates {
            let Some(amount) = candidate.effect.get(first) else { continue };
            let terms = (candidate.effect.len() + missing.len()) as u64;
            if work.charge(terms.saturating_mul(300)).is_err() {
                *tries = 0;
                return;
            }
            if *tries == 0 || chosen.iter().any(|(site, _)| *site == candidate.site) {
                continue;
            }
            let share = if candidate.free.is_some() { wanted / amount } else { BigRational::one() };
            let effect: Effect =
                candidate.effect.iter().map(|(m, value)| (m.clone(), value * &share)).collect();
            let left = difference(missing, &effect);
            // Every change must bring the printed formula nearer to the true one.
            if left.len() >= missing.len() || left.keys().any(|m| !missing.contains_key(m)) {
                continue;
            }
            let change = match (&candidate.change, &candidate.free) {
                (Some(change), _) => change.clone(),
                (None, Some((printed, below))) => match moved(printed, *below, &share) {
                    Some(right) => Change::Number { printed: printed.clone(), right },
                    None => continue,
                },
                (None, None) => continue,
            };
            *tries -= 1;
            chosen.push((candidate.site, change));
            self.extend(candidates, &left, chosen, best, tries, work);
            chosen.pop();
        }
    }
}

/// printed + step, or below a slash 1/(1/printed + step).
fn moved(printed: &BigRational, below: bool, step: &BigRational) -> Option<BigRational> {
    if !below {
        return Some(printed + step);
    }
    let reciprocal = printed.recip() + step;
    (!reciprocal.is_zero()).then(|| reciprocal.recip())
}

fn effect_of(polynomial: &Polynomial) -> Effect {
    polynomial.terms().map(|(monomial, value)| (monomial.clone(), value.clone())).collect()
}

fn difference(a: &Effect, b: &Effect) -> Effect {
    let mut difference = a.clone();
    for (monomial, value) in b {
        let entry = difference.entry(monomial.clone()).or_insert_with(BigRational::zero);
        *entry -= value;
    }
    difference.retain(|_, value| !value.is_zero());
    difference
}

/// Characters to insert, delete or replace (Levenshtein).
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, c) in a.chars().enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], i + 1);
        for (j, d) in b.iter().enumerate() {
            let replace = diagonal + usize::from(c != *d);
            diagonal = row[j + 1];
            row[j + 1] = replace.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::edit_distance;

    #[test]
    fn the_distance_counts_single_characters() {
        assert_eq!(edit_distance("80/3", "40/3"), 1);
        assert_eq!(edit_distance("80/3", "-80/3"), 1);
        assert_eq!(edit_distance("7", "7"), 0);
        assert_eq!(edit_distance("", "12"), 2);
    }
}
