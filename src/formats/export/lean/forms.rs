//! The polynomials that a Lean text about a patch states, computed in the form in which it states them: over Q in the generators, no
//! root² replaced.

use num_bigint::BigInt;
use num_rational::BigRational;

use super::super::case::Case;
use super::super::flat::{lift, rationals, sum_of_products};
use super::names::{COORDINATES, P, Q, ROOM, VALUES};
use crate::control::Control;
use crate::exact::{Limit, Monomial, Polynomial, Work};
use crate::statement::Patch;

pub(super) struct Forms {
    /// The surface in X, Y, Z, W.
    pub(super) surface: Polynomial,
    /// Of pʳq^(M−r) in the surface along a curve of degree m with any control values, r = 0..M.
    pub(super) along_curve: Vec<Polynomial>,
    /// X, Y, Z, W of each row, in p and q: `rows[k][i]`.
    rows: Vec<Vec<Polynomial>>,
    degree_in_v: usize,
    control: Control,
}

impl Forms {
    pub(super) fn new(case: &Case, patch: &Patch) -> Result<Forms, Limit> {
        let ((m, n), degree) = (patch.bidegree, patch.surface.degree());
        let surface = surface(case, patch)?;
        let curves = (0..4).map(|k| curve(k, m)).collect::<Result<Vec<_>, _>>()?;
        let mut work = case.control.work();
        let along = compose(&surface, &mut work, |variable| {
            variable.checked_sub(COORDINATES).and_then(|k| curves.get(usize::from(k)))
        })?;
        let mut rows = vec![Vec::new(); 4];
        for (k, rows) in rows.iter_mut().enumerate() {
            for row in &patch.net {
                let mut products = Vec::with_capacity(row.len());
                for (j, point) in (0..).zip(row) {
                    products.push((lift(case, &point[k])?, bernstein(n, j)?));
                }
                let pairs: Vec<_> = products.iter().map(|(value, basis)| (value, basis)).collect();
                rows.push(sum_of_products(&pairs, &case.control)?);
            }
        }
        let top = |d: u32| usize::try_from(d * degree).unwrap_or(usize::MAX);
        Ok(Forms {
            surface,
            along_curve: by_power(&along, top(m))?,
            rows,
            degree_in_v: top(n),
            control: case.control.clone(),
        })
    }

    /// N = e·n.
    pub(super) fn degree_in_v(&self) -> usize {
        self.degree_in_v
    }

    /// A coordinate of a curve with any control values.
    pub(super) fn curve(&self, coordinate: u16, degree: u32) -> Result<Polynomial, Limit> {
        curve(coordinate, degree)
    }

    /// `along_curve[r]` for the rows of the net: a polynomial in p and q.
    pub(super) fn along_net(&self, r: usize) -> Result<Polynomial, Limit> {
        compose(&self.along_curve[r], &mut self.control.work(), |variable| {
            let index = variable.checked_sub(VALUES)?;
            self.rows.get(usize::from(index / ROOM))?.get(usize::from(index % ROOM))
        })
    }

    /// Its coefficients at pˢq^(N−s), s = 0..N: `c[r,s]`, not reduced.
    pub(super) fn along_row(&self, r: usize) -> Result<Vec<Polynomial>, Limit> {
        by_power(&self.along_net(r)?, self.degree_in_v)
    }
}

/// The surface over Q in the roots and X, Y, Z, W.
fn surface(case: &Case, patch: &Patch) -> Result<Polynomial, Limit> {
    let mut terms = Vec::with_capacity(patch.surface.term_count());
    for (monomial, coefficient) in patch.surface.terms() {
        let roots = (0u16..).zip(case.field.values()).filter(|(root, _)| monomial.mask() >> root & 1 == 1);
        let of_coordinates = monomial.powers().iter().map(|&(k, e)| (COORDINATES + k, e));
        terms.push((
            product(roots.map(|(root, _)| (root, 1)).chain(of_coordinates).collect())?,
            coefficient.clone(),
        ));
    }
    Ok(Polynomial::from_terms(terms))
}

fn curve(coordinate: u16, degree: u32) -> Result<Polynomial, Limit> {
    let mut products = Vec::new();
    for (index, i) in (0u16..).zip(0..=degree) {
        products.push((Polynomial::variable(VALUES + coordinate * ROOM + index), bernstein(degree, i)?));
    }
    let pairs: Vec<_> = products.iter().map(|(value, basis)| (value, basis)).collect();
    // A few dozen terms.
    sum_of_products(&pairs, &Control::default())
}

/// C(n,k)·pᵏq^(n−k).
fn bernstein(n: u32, k: u32) -> Result<Polynomial, Limit> {
    let binomial = num_integer::binomial(BigInt::from(n), BigInt::from(k));
    let powers = [(P, k), (Q, n - k)].into_iter().filter(|&(_, e)| e > 0).collect();
    Ok(Polynomial::term(BigRational::from_integer(binomial), product(powers)?))
}

fn product(powers: Vec<(u16, u32)>) -> Result<Monomial, Limit> {
    Monomial::new(0, powers).unwrap_or_else(|| Ok(Monomial::one()))
}

/// The polynomial with others in the place of some variables.
fn compose<'a>(
    polynomial: &Polynomial,
    work: &mut Work,
    image: impl Fn(u16) -> Option<&'a Polynomial>,
) -> Result<Polynomial, Limit> {
    let field = rationals();
    let mut products = Vec::with_capacity(polynomial.term_count());
    for (monomial, coefficient) in polynomial.terms() {
        let mut value = Polynomial::rational(coefficient.clone());
        for &(variable, exponent) in monomial.powers() {
            let factor = image(variable).cloned().unwrap_or_else(|| Polynomial::variable(variable));
            value = value.multiply(&factor.power(exponent, &field, work)?, &field, work)?;
        }
        products.push(value);
    }
    Polynomial::sum(&products, &field, work)
}

/// The coefficients at pʳ(q^…), r = 0..top, of a form in p and q.
fn by_power(polynomial: &Polynomial, top: usize) -> Result<Vec<Polynomial>, Limit> {
    let mut parts = vec![Vec::new(); top + 1];
    for (monomial, coefficient) in polynomial.terms() {
        let others = monomial.powers().iter().copied().filter(|&(variable, _)| variable < P).collect();
        let r = usize::try_from(monomial.exponent(P)).unwrap_or(usize::MAX);
        parts[r].push((product(others)?, coefficient.clone()));
    }
    Ok(parts.into_iter().map(Polynomial::from_terms).collect())
}
