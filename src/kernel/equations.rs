//! The equations of a statement, derived from it.
//!
//! For a patch: put u = t/(1+t), v = s/(1+s) into the Bernstein polynomials and multiply by (1+t)^m (1+s)^n.
//! What is left of X is X̂(t,s) = Σ C(m,i) C(n,j) X_ij tⁱ sʲ, and of F(X,Y,Z,W), of degree e, a polynomial of
//! degree (em, en) in t and s. Undoing the substitution turns tʳ sˢ into uʳ(1−u)^(em−r) · vˢ(1−v)^(en−s), so
//! `c[r,s]` is its coefficient. These products are linearly independent: F vanishes on the patch, as a
//! polynomial, iff every `c[r,s]` is zero.

use std::collections::BTreeMap;
use std::fmt;

use num_rational::BigRational;

use crate::exact::{Arithmetic, Monomial, Polynomial, Stop, Work};
use crate::statement::{Patch, Statement, Subject};

/// The parameters t and s, beyond any unknown a statement can have.
pub(crate) const T: u16 = u16::MAX - 1;
pub(crate) const S: u16 = u16::MAX;

/// What a step may use: an equation of the statement or an earlier step. The order is that of spelling.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Premise {
    /// `c[r,s]`: the coefficient of uʳ(1−u)^(em−r)·vˢ(1−v)^(en−s) of the surface equation of degree e.
    Coefficient(u32, u32),
    /// `f[k]`: the k-th polynomial of a system, from 1.
    Equation(u32),
    /// `nonzero[k]`: the k-th assumption d, from 1, as the polynomial d·`t[k]` − 1 (Rabinowitsch).
    Nonzero(u32),
    /// The conclusion of an earlier step, from 1.
    Step(u32),
}

impl fmt::Display for Premise {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Premise::Coefficient(r, s) => write!(f, "c[{r},{s}]"),
            Premise::Equation(k) => write!(f, "f[{k}]"),
            Premise::Nonzero(k) => write!(f, "nonzero[{k}]"),
            Premise::Step(k) => write!(f, "step {k}"),
        }
    }
}

/// Every polynomial a certificate may use as a premise, by its name.
#[derive(Debug, Clone)]
pub struct Equations {
    by_name: BTreeMap<Premise, Polynomial>,
}

impl Equations {
    /// Derives the equations.
    pub fn of(statement: &Statement, work: &mut Work) -> Result<Self, Stop> {
        let arithmetic = &mut Arithmetic::new(statement.field(), work);
        let mut by_name = match statement.subject() {
            Subject::Patch(patch) => coefficients(patch, arithmetic)?,
            Subject::System(polynomials) => {
                let copies = polynomials.iter().map(|polynomial| arithmetic.copied(polynomial));
                let copies: Vec<Polynomial> = copies.collect::<Result<_, _>>()?;
                (1..).map(Premise::Equation).zip(copies).collect()
            }
        };
        for (number, assumed) in (1u32..).zip(statement.nonzero()) {
            let equation = rabinowitsch(statement.unknowns().len(), number, assumed, arithmetic)?;
            by_name.insert(Premise::Nonzero(number), equation);
        }
        Ok(Equations { by_name })
    }

    /// The polynomial with this name.
    pub fn get(&self, premise: Premise) -> Option<&Polynomial> {
        self.by_name.get(&premise)
    }

    /// All of them, in the order of their names.
    pub fn iter(&self) -> impl Iterator<Item = (Premise, &Polynomial)> {
        self.by_name.iter().map(|(&name, polynomial)| (name, polynomial))
    }
}

/// d·`t[k]` − 1, which has a zero in `t[k]` exactly where d ≠ 0.
fn rabinowitsch(
    unknowns: usize,
    number: u32,
    assumed: &Polynomial,
    arithmetic: &mut Arithmetic<'_>,
) -> Result<Polynomial, Stop> {
    // t[1] is the variable after the last unknown.
    let index = u32::try_from(unknowns).ok().and_then(|count| count.checked_add(number));
    let index = index.and_then(|index| u16::try_from(index.checked_sub(1)?).ok());
    let index = index.ok_or(Stop::Defect("a Rabinowitsch variable beyond all variables"))?;
    let (one, minus_one) = (Polynomial::integer(1), Polynomial::integer(-1));
    Ok(arithmetic.dot(&[(assumed, &Polynomial::variable(index)), (&one, &minus_one)])?)
}

/// F(X̂, Ŷ, Ẑ, Ŵ) and its arguments, polynomials in t, s and the unknowns.
pub(crate) struct Expanded {
    pub(crate) surface: Polynomial,
    /// X̂, Ŷ, Ẑ.
    pub(crate) position: Vec<Polynomial>,
    /// Ŵ.
    pub(crate) weight: Polynomial,
}

/// Substitutes the net into the surface.
pub(crate) fn expand(patch: &Patch, arithmetic: &mut Arithmetic<'_>) -> Result<Expanded, Stop> {
    let (m, n) = patch.bidegree;
    let mut basis = Vec::new();
    for (i, j) in indices(m, n) {
        let (of_u, of_v) = (binomial(m, i)?, binomial(n, j)?);
        let both = of_u.checked_mul(of_v).ok_or(BINOMIALS)?;
        basis.push(Polynomial::term(BigRational::from_integer(both.into()), parameters(i, j)?));
    }
    let mut coordinates = Vec::with_capacity(4);
    for k in 0..4usize {
        let entries = patch.net.iter().flatten().filter_map(|point| point.get(k));
        let pairs: Vec<(&Polynomial, &Polynomial)> = entries.zip(&basis).collect();
        coordinates.push(arithmetic.dot(&pairs)?);
    }
    let surface = arithmetic.substitute(&patch.surface, &coordinates)?;
    let weight = coordinates.pop().unwrap_or_default();
    Ok(Expanded { surface, position: coordinates, weight })
}

fn coefficients(
    patch: &Patch,
    arithmetic: &mut Arithmetic<'_>,
) -> Result<BTreeMap<Premise, Polynomial>, Stop> {
    let (m, n) = patch.bidegree;
    let expanded = expand(patch, arithmetic)?.surface;

    let degree = patch.surface.degree();
    let (last_r, last_s) = (m.saturating_mul(degree), n.saturating_mul(degree));
    // A place for each equation, and the terms, copied once more.
    let places = u64::from(last_r).saturating_add(1).saturating_mul(u64::from(last_s).saturating_add(1));
    arithmetic.work.keep(places.saturating_mul(256))?;
    arithmetic.charge_copy(&expanded)?;
    arithmetic.charge_copy(&expanded)?;
    let mut collected: BTreeMap<Premise, Vec<(Monomial, BigRational)>> = BTreeMap::new();
    collected.extend(indices(last_r, last_s).map(|(r, s)| (Premise::Coefficient(r, s), Vec::new())));
    for (monomial, coefficient) in expanded.terms() {
        let (of_unknowns, of_parameters) = monomial.split(T);
        let name = Premise::Coefficient(of_parameters.exponent(T), of_parameters.exponent(S));
        collected.entry(name).or_default().push((of_unknowns, coefficient.clone()));
    }
    let mut by_name = BTreeMap::new();
    for (name, terms) in collected {
        by_name.insert(name, arithmetic.gathered(terms)?);
    }
    Ok(by_name)
}

/// (0,0), (0,1), …, (m,n).
fn indices(m: u32, n: u32) -> impl Iterator<Item = (u32, u32)> {
    (0..=m).flat_map(move |i| (0..=n).map(move |j| (i, j)))
}

/// tⁱ sʲ.
fn parameters(i: u32, j: u32) -> Result<Monomial, Stop> {
    let powers = [(T, i), (S, j)].into_iter().filter(|&(_, exponent)| exponent > 0).collect();
    Ok(Monomial::new(0, powers).ok_or(Stop::Defect("parameters out of order"))??)
}

/// Degrees are at most 32, and C(32, 16)² has 59 bits.
const BINOMIALS: Stop = Stop::Defect("a binomial coefficient of more than 64 bits");

/// The binomial coefficient C(n, k), by Pascal's product: each partial product is a binomial coefficient.
fn binomial(n: u32, k: u32) -> Result<u64, Stop> {
    (0..k).try_fold(1u64, |product, i| {
        let factor = u64::from(n.checked_sub(i).ok_or(BINOMIALS)?);
        let divisor = u64::from(i).checked_add(1).ok_or(BINOMIALS)?;
        product.checked_mul(factor).and_then(|product| product.checked_div(divisor)).ok_or(BINOMIALS)
    })
}
