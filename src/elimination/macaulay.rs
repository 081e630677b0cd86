//! Degree by degree: multiples of the equations, reduced modulo a prime, and what falls in degree kept.
//!
//! The rows of the Macaulay matrix of degree D are the multiples m·f of degree ≤ D (Macaulay 1902; Lazard,
//! EUROCAL 1983, doi:10.1007/3-540-12868-9_99). A row of the echelon form whose degree is below D is a new
//! polynomial of the ideal of lower degree than the products it comes from; it joins the equations and is
//! multiplied in turn ("mutants", Ding et al., SCC 2008). The search ends with 1, with a linear polynomial where those are substituted at once, with a Gröbner basis (every critical pair of its leading monomials has degree ≤ D), or with its patience.

use std::collections::HashMap;

use super::derivation::{Derivation, Source};
use super::echelon::{Echelon, Inserted, SparseRow};
use super::lift::{Multiple, lift};
use super::progress::Progress;
use super::strategy::{PLAIN, Strategy};
use crate::algebra::{Monomial, PrimeField, splitting_primes};
use crate::control::{Control, Interrupted};

/// Columns of a matrix that this engine is willing to reduce.
const COLUMNS: usize = 100_000;
/// Rows likewise.
const ROWS: usize = 1_000_000;
/// How many primes may mislead before the search is given up.
const PRIMES: usize = 5;

/// How a search ended. Sources are exact; everything modulo p has been left behind.
pub(super) enum Search {
    Unit(Source),
    Linear(Vec<Source>),
    Closed(Vec<Source>),
    TooLarge { degree: u32, matrix: (usize, usize) },
}

/// The search space: which polynomials, in which variables.
pub(super) struct Macaulay {
    equations: Vec<Source>,
    variables: Vec<u16>,
    strategy: Strategy,
}

/// A polynomial to be multiplied.
struct Element {
    origin: Origin,
    /// Its image modulo p, by decreasing monomial.
    image: Vec<(Monomial, u64)>,
}

enum Origin {
    Known(Source),
    /// The combination of these rows that has no monomial above `leading`; the last row occurs with factor 1.
    Fallen {
        rows: Vec<u32>,
        leading: u32,
    },
}

/// A prime that does not show the truth: another one must be tried.
pub(super) struct Unlucky;

impl Macaulay {
    pub(super) fn new(derivation: &Derivation<'_>, equations: &[Source], strategy: Strategy) -> Self {
        let mut variables: Vec<u16> =
            equations.iter().flat_map(|&source| derivation.polynomial(source).variables()).collect();
        variables.sort_unstable();
        variables.dedup();
        Macaulay { equations: equations.to_vec(), variables, strategy }
    }

    pub(super) fn search(
        &self,
        derivation: &mut Derivation<'_>,
        control: &Control,
    ) -> Result<Search, Interrupted> {
        let mut reached = 0;
        for prime in splitting_primes(derivation.system().field()).take(PRIMES) {
            let images: Option<Vec<Element>> = self
                .equations
                .iter()
                .map(|&source| {
                    let image = prime.reduce_polynomial(derivation.polynomial(source))?;
                    let nonzero = image.iter().all(|&(_, value)| value != 0);
                    nonzero.then_some(Element { origin: Origin::Known(source), image })
                })
                .collect();
            let Some(elements) = images else { continue };
            let mut matrix = Matrix::new(prime, self.variables.clone(), elements, self.strategy);
            match matrix.run(derivation, control)? {
                Ok(search) => return Ok(search),
                Err(Unlucky) => reached = matrix.degree,
            }
        }
        Ok(Search::TooLarge { degree: reached, matrix: (0, 0) })
    }
}

/// The Macaulay matrix modulo one prime, growing degree by degree.
struct Matrix {
    prime: PrimeField,
    variables: Vec<u16>,
    elements: Vec<Element>,
    /// Up to which degree each element has been multiplied.
    multiplied: Vec<Option<u32>>,
    strategy: Strategy,
    degree: u32,
    /// All monomials up to `degree`, increasing: the columns.
    monomials: Vec<Monomial>,
    columns: HashMap<Monomial, u32>,
    rows: Vec<(usize, Monomial)>,
    echelon: Echelon,
    /// The exact polynomials of elements that have been lifted.
    lifted: HashMap<usize, Source>,
}

impl Matrix {
    fn new(prime: PrimeField, variables: Vec<u16>, elements: Vec<Element>, strategy: Strategy) -> Self {
        let echelon = Echelon::new(prime.clone());
        Matrix {
            prime,
            variables,
            multiplied: vec![None; elements.len()],
            elements,
            strategy,
            degree: 0,
            monomials: vec![Monomial::one()],
            columns: HashMap::from([(Monomial::one(), 0)]),
            rows: Vec::new(),
            echelon,
            lifted: HashMap::new(),
        }
    }

    fn run(
        &mut self,
        derivation: &mut Derivation<'_>,
        control: &Control,
    ) -> Result<Result<Search, Unlucky>, Interrupted> {
        let highest = self.elements.iter().map(|element| self.degree_of(element)).max().unwrap_or(0);
        loop {
            let (rows, columns) = self.size_at(self.degree + 1);
            let plain = self.strategy == Strategy::Plain;
            if columns > if plain { PLAIN } else { COLUMNS } || rows > ROWS {
                return Ok(Ok(Search::TooLarge { degree: self.degree, matrix: (rows, columns) }));
            }
            self.degree += 1;
            let more = Monomial::all_of_degree(&self.variables, self.degree);
            for monomial in more {
                self.columns.insert(monomial.clone(), self.monomials.len() as u32);
                self.monomials.push(monomial);
            }
            loop {
                self.multiply(control)?;
                let fallen = self.fallen(control)?;
                let rank = self.echelon.pivots().count();
                control.observe(&Progress::Reduced { degree: self.degree, rank, fallen: fallen.len() });
                if fallen.first() == Some(&0) {
                    let unit = self.element_leading_in(0, control)?;
                    let unit = match self.realize(unit, derivation, control)? {
                        Ok(source) => super::linear::unit_from(derivation, source, control)?,
                        Err(Unlucky) => None,
                    };
                    return Ok(unit.map(Search::Unit).ok_or(Unlucky));
                }
                let linear: Vec<u32> =
                    fallen.iter().copied().filter(|&c| self.monomials[c as usize].degree() == 1).collect();
                if plain && !linear.is_empty() {
                    return Ok(self.realize_all(&linear, derivation, control)?.map(Search::Linear));
                }
                if fallen.is_empty() {
                    break;
                }
                for column in fallen {
                    self.element_leading_in(column, control)?;
                }
            }
            if self.degree >= highest
                && let Some(basis) = self.closed(control)?
            {
                return Ok(self.realize_all(&basis, derivation, control)?.map(Search::Closed));
            }
        }
    }

    fn degree_of(&self, element: &Element) -> u32 {
        element.image.first().map_or(0, |(monomial, _)| monomial.degree())
    }

    /// Rows and columns of the matrix of the next degree.
    fn size_at(&self, degree: u32) -> (usize, usize) {
        let variables = self.variables.len() as u32;
        let count = |degree: u32| {
            (1..=u64::from(degree)).fold(1u64, |c, k| c.saturating_mul(u64::from(variables) + k) / k)
        };
        let multiples = |element: &Element| degree.checked_sub(self.degree_of(element)).map_or(0, count);
        let rows = self.elements.iter().map(multiples).fold(0, u64::saturating_add);
        (rows as usize, count(degree) as usize)
    }

    /// Inserts all multiples up to the present degree that are not there yet, those of low degree first.
    fn multiply(&mut self, control: &Control) -> Result<(), Interrupted> {
        let mut fresh = Vec::new();
        for index in 0..self.elements.len() {
            let own = self.degree_of(&self.elements[index]);
            let Some(top) = self.degree.checked_sub(own) else {
                continue;
            };
            let from = self.multiplied[index].map_or(0, |done| done + 1);
            for by in from..=top {
                let multipliers = Monomial::all_of_degree(&self.variables, by);
                fresh.extend(multipliers.into_iter().map(|monomial| (own + by, index, monomial)));
            }
            self.multiplied[index] = Some(top);
        }
        fresh.sort_by_key(|&(degree, index, _)| (degree, index));
        let (rows, columns) = (self.rows.len() + fresh.len(), self.monomials.len());
        control.observe(&Progress::Matrix { degree: self.degree, rows, columns });
        for (_, index, monomial) in fresh {
            control.check()?;
            let row = self.row(index, &monomial);
            let id = self.rows.len() as u32;
            self.rows.push((index, monomial));
            self.echelon.insert(id, &row, control)?;
        }
        Ok(())
    }

    fn row(&self, index: usize, multiplier: &Monomial) -> SparseRow {
        let terms = self.elements[index].image.iter();
        terms.map(|(monomial, value)| (self.columns[&monomial.product(multiplier)], *value)).collect()
    }

    /// The leading columns below the present degree that no element accounts for, minimal under divisibility.
    fn fallen(&self, control: &Control) -> Result<Vec<u32>, Interrupted> {
        let mut leading: Vec<Monomial> =
            self.elements.iter().filter_map(|element| Some(element.image.first()?.0.clone())).collect();
        let mut fallen = Vec::new();
        for column in self.echelon.pivots() {
            let monomial = &self.monomials[column as usize];
            if monomial.degree() >= self.degree {
                break;
            }
            control.check()?;
            if leading.iter().all(|other| monomial.quotient(other).is_none()) {
                leading.push(monomial.clone());
                fallen.push(column);
            }
        }
        Ok(fallen)
    }

    /// Makes the row that leads in `column` an element, from as few and as simple rows as a greedy choice finds.
    fn element_leading_in(&mut self, column: u32, control: &Control) -> Result<usize, Interrupted> {
        let combination = &self.echelon.combination(column, control)?;
        // The row inserted last is the one that made this column a leading one.
        let last = combination.iter().map(|&(id, _)| id).max().expect("a row is made of rows");
        let mut others: Vec<u32> = combination.iter().map(|&(id, _)| id).filter(|&id| id != last).collect();
        let length = |id: u32| self.elements[self.rows[id as usize].0].image.len();
        others.sort_by_key(|&id| (self.rows[id as usize].1.degree(), length(id), id));

        let mut above = Echelon::new(self.prime.clone());
        for &id in &others {
            above.insert(id, &self.truncated(id, column), control)?;
        }
        let factors = match above.insert(last, &self.truncated(last, column), control)? {
            Inserted::Dependent(dependence) => above.relation(&dependence, control)?,
            Inserted::Pivot(_) => {
                unreachable!("above its leading column a row is a combination of the others")
            }
        };
        let mut sum = vec![0; column as usize + 1];
        for &(id, factor) in &factors {
            control.check()?;
            let (index, multiplier) = &self.rows[id as usize];
            for (at, value) in self.row(*index, multiplier).into_iter().filter(|&(at, _)| at <= column) {
                // Subtracting −factor times the entry adds factor times it.
                let negative = self.prime.modulus() - factor;
                sum[at as usize] = self.prime.subtract_product(sum[at as usize], negative, value);
            }
        }
        let terms = sum.into_iter().enumerate().rev().filter(|&(_, value)| value != 0);
        let image = terms.map(|(at, value)| (self.monomials[at].clone(), value)).collect();
        let mut rows: Vec<u32> = factors.iter().map(|&(id, _)| id).filter(|&id| id != last).collect();
        rows.push(last);
        self.elements.push(Element { origin: Origin::Fallen { rows, leading: column }, image });
        self.multiplied.push(None);
        Ok(self.elements.len() - 1)
    }

    /// The part of a row above a column.
    fn truncated(&self, id: u32, column: u32) -> SparseRow {
        let (index, multiplier) = &self.rows[id as usize];
        self.row(*index, multiplier).into_iter().filter(|&(at, _)| at > column).collect()
    }

    /// The minimal leading columns, if every critical pair of their monomials is within the present degree
    /// (then the echelon form has reduced every S-polynomial: Buchberger's criterion).
    fn closed(&self, control: &Control) -> Result<Option<Vec<u32>>, Interrupted> {
        let mut minimal: Vec<u32> = Vec::new();
        let monomial = |column: u32| &self.monomials[column as usize];
        for column in self.echelon.pivots() {
            control.check()?;
            if minimal.iter().all(|&other| monomial(column).quotient(monomial(other)).is_none()) {
                minimal.push(column);
            }
        }
        for (k, &a) in minimal.iter().enumerate() {
            control.check()?;
            let mut critical =
                minimal[..k].iter().map(|&b| monomial(b)).filter(|b| !monomial(a).is_coprime_to(b));
            if critical.any(|b| monomial(a).lcm(b).degree() > self.degree) {
                return Ok(None);
            }
        }
        Ok(Some(minimal))
    }

    fn realize_all(
        &mut self,
        columns: &[u32],
        derivation: &mut Derivation<'_>,
        control: &Control,
    ) -> Result<Result<Vec<Source>, Unlucky>, Interrupted> {
        let mut found = Vec::new();
        for &column in columns {
            let element = self.element_leading_in(column, control)?;
            match self.realize(element, derivation, control)? {
                Ok(source) => found.push(source),
                Err(Unlucky) => return Ok(Err(Unlucky)),
            }
        }
        Ok(Ok(found))
    }

    /// The exact polynomial of an element, computed from those it comes from.
    fn realize(
        &mut self,
        element: usize,
        derivation: &mut Derivation<'_>,
        control: &Control,
    ) -> Result<Result<Source, Unlucky>, Interrupted> {
        if let Some(&source) = self.lifted.get(&element) {
            return Ok(Ok(source));
        }
        let (rows, leading) = match &self.elements[element].origin {
            Origin::Known(source) => return Ok(Ok(*source)),
            Origin::Fallen { rows, leading } => (rows.clone(), *leading),
        };
        let mut multiples = Vec::new();
        for &id in &rows {
            let (index, multiplier) = self.rows[id as usize].clone();
            match self.realize(index, derivation, control)? {
                Ok(source) => {
                    multiples.push(Multiple { source, multiplier, row: self.truncated(id, leading) });
                }
                Err(Unlucky) => return Ok(Err(Unlucky)),
            }
        }
        let leading = &self.monomials[leading as usize];
        control.observe(&Progress::Lifting { rows: rows.len(), degree: leading.degree() });
        let lifted = lift(derivation, &multiples, leading, &self.monomials, &self.prime, control)?;
        Ok(lifted.inspect(|&source| {
            self.lifted.insert(element, source);
        }))
    }
}
