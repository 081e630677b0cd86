//! The equations of a statement, derived from it.
//!
//! For a patch: put u = t/(1+t), v = s/(1+s) into the Bernstein polynomials and multiply by (1+t)^m (1+s)^n.
//! What is left of X is X̂(t,s) = Σ C(m,i) C(n,j) X_ij tⁱ sʲ, and of F(X,Y,Z,W), of degree e, a polynomial of
//! degree (em, en) in t and s. Undoing the substitution turns tʳ sˢ into uʳ(1−u)^(em−r) · vˢ(1−v)^(en−s), so
//! `c[r,s]` is its coefficient. These products are linearly independent: F vanishes on the patch, as a
//! polynomial, iff every `c[r,s]` is zero.

use std::collections::BTreeMap;
use std::fmt;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use crate::exact::{Monomial, Polynomial, Radicands, Stop, Work, combination};
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
        let mut by_name = match statement.subject() {
            Subject::Patch(patch) => coefficients(statement, patch, work)?,
            Subject::System(polynomials) => {
                (1..).map(Premise::Equation).zip(polynomials.iter().cloned()).collect()
            }
        };
        for (number, assumed) in (1u32..).zip(statement.nonzero()) {
            by_name.insert(Premise::Nonzero(number), rabinowitsch(statement, number, assumed, work)?);
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
    statement: &Statement,
    number: u32,
    assumed: &Polynomial,
    work: &mut Work,
) -> Result<Polynomial, Stop> {
    // t[1] is the variable after the last unknown.
    let index = u32::try_from(statement.unknowns().len()).ok().and_then(|count| count.checked_add(number));
    let index = index.and_then(|index| u16::try_from(index.checked_sub(1)?).ok());
    let index = index.ok_or(Stop::Defect("a Rabinowitsch variable beyond all variables"))?;
    let product = assumed.multiply(&Polynomial::variable(index), statement.field(), work)?;
    Ok(Polynomial::sum(&[product, Polynomial::integer(-1)], statement.field(), work)?)
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
pub(crate) fn expand(field: &Radicands, patch: &Patch, work: &mut Work) -> Result<Expanded, Stop> {
    let (m, n) = patch.bidegree;
    let mut basis = Vec::new();
    for (i, j) in indices(m, n) {
        let binomials = BigRational::from_integer(binomial(m, i) * binomial(n, j));
        basis.push(Polynomial::term(binomials, parameters(i, j)?));
    }
    let mut coordinates = Vec::with_capacity(4);
    for k in 0..4usize {
        let entries = patch.net.iter().flatten().filter_map(|point| point.get(k));
        let pairs: Vec<(&Polynomial, &Polynomial)> = entries.zip(&basis).collect();
        coordinates.push(combination(&pairs, field, work)?);
    }
    let surface = patch.surface.substitute(&coordinates, field, work)?;
    let weight = coordinates.pop().unwrap_or_default();
    Ok(Expanded { surface, position: coordinates, weight })
}

fn coefficients(
    statement: &Statement,
    patch: &Patch,
    work: &mut Work,
) -> Result<BTreeMap<Premise, Polynomial>, Stop> {
    let (m, n) = patch.bidegree;
    let expanded = expand(statement.field(), patch, work)?.surface;

    let degree = patch.surface.degree();
    let (last_r, last_s) = (m.saturating_mul(degree), n.saturating_mul(degree));
    let mut collected: BTreeMap<Premise, Vec<(Monomial, BigRational)>> = BTreeMap::new();
    collected.extend(indices(last_r, last_s).map(|(r, s)| (Premise::Coefficient(r, s), Vec::new())));
    for (monomial, coefficient) in expanded.terms() {
        let (of_unknowns, of_parameters) = monomial.split(T);
        let name = Premise::Coefficient(of_parameters.exponent(T), of_parameters.exponent(S));
        collected.entry(name).or_default().push((of_unknowns, coefficient.clone()));
    }
    Ok(collected.into_iter().map(|(name, terms)| (name, Polynomial::from_terms(terms))).collect())
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

/// The binomial coefficient C(n, k), by Pascal's product: each partial product is a binomial coefficient.
fn binomial(n: u32, k: u32) -> BigInt {
    let steps = (0..k).map(|i| (BigInt::from(n) - BigInt::from(i), BigInt::from(i) + BigInt::one()));
    steps.fold(BigInt::one(), |product, (factor, divisor)| product * factor / divisor)
}
