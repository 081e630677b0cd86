//! When 1 is not to be had: what the equations say instead.

use super::derivation::{Derivation, Source};
use super::eliminant::eliminant;
use super::linear::Linear;
use crate::algebra::{FieldElement, Monomial, Polynomial, Univariate};
use crate::control::{Control, Interrupted};

/// Zeros up to which eliminants are computed.
const ELIMINANTS: usize = 32;

/// A Gröbner basis (DegRevLex, after linear elimination), and what its leading monomials tell of the zeros.
#[derive(Debug, Clone)]
pub struct Closure {
    /// The linear equations, each solved for a variable that occurs nowhere else.
    pub linear: Vec<Polynomial>,
    /// A Gröbner basis of the others, in the variables that are left.
    pub basis: Vec<Polynomial>,
    /// Whether Buchberger's criterion, and that every equation has normal form 0, were verified over K itself;
    /// otherwise the basis was seen modulo a prime only.
    pub verified: bool,
    /// The dimension of the set of zeros over the algebraic closure.
    pub dimension: usize,
    /// The number of zeros there, counted with multiplicity, where it is finite.
    pub zeros: Option<usize>,
    /// Where it is finite and small, and the basis verified: for each variable the polynomial of least degree in it
    /// alone that vanishes at all zeros.
    pub eliminants: Vec<Eliminant>,
}

/// What one coordinate of finitely many zeros can be.
#[derive(Debug, Clone)]
pub struct Eliminant {
    /// The coordinate.
    pub variable: u16,
    /// The polynomial of least degree that vanishes at it, whichever the zero.
    pub polynomial: Univariate,
    /// All its roots in K.
    pub roots: Vec<FieldElement>,
    /// How many distinct real roots it has, if that was counted.
    pub real_roots: Option<usize>,
}

impl Closure {
    pub(super) fn of(
        derivation: &mut Derivation<'_>,
        linear: &Linear,
        basis: &[Source],
        control: &Control,
    ) -> Result<Closure, Interrupted> {
        let basis: Vec<Polynomial> =
            basis.iter().map(|&source| derivation.polynomial(source).clone()).collect();
        let mut verified = is_groebner_basis(&basis, control)?;
        for generator in derivation.generators() {
            control.check()?;
            let reduced = linear.substitute(derivation, generator, control)?;
            if let Some(source) = reduced {
                verified &= normal_form(derivation.polynomial(source), &basis, control)?.is_zero();
            }
        }
        let of_basis = basis.iter().filter_map(|f| f.leading_term()).map(|(monomial, _)| monomial.clone());
        let leading: Vec<Monomial> = linear.variables().map(Monomial::variable).chain(of_basis).collect();
        let variables: Vec<u16> = (0..derivation.system().variables() as u16).collect();
        let dimension = dimension(&leading, &variables, control)?;
        let zeros =
            if dimension == 0 { Some(standard_monomials(&leading, &variables, control)?) } else { None };
        let mut eliminants = Vec::new();
        if verified && zeros.is_some_and(|count| count <= ELIMINANTS) {
            let field = derivation.system().field();
            for variable in variables {
                let solved = linear.equation(derivation, variable);
                let polynomial = eliminant(variable, solved, &basis, field, control)?;
                let roots = polynomial.roots_in_field(|| control.check())?;
                eliminants.push(Eliminant { variable, polynomial, roots, real_roots: None });
            }
        }
        Ok(Closure { linear: linear.equations(derivation), basis, verified, dimension, zeros, eliminants })
    }

    /// Counts the real roots of the eliminants, until it is stopped.
    pub fn count_real_roots(&mut self, control: &Control) {
        for eliminant in &mut self.eliminants {
            eliminant.real_roots = eliminant.polynomial.count_real_roots(|| control.check()).ok();
        }
    }
}

/// Buchberger's criterion over K: every S-polynomial of a critical pair has normal form 0.
fn is_groebner_basis(basis: &[Polynomial], control: &Control) -> Result<bool, Interrupted> {
    for (k, f) in basis.iter().enumerate() {
        for g in &basis[..k] {
            control.check()?;
            let (Some((a, x)), Some((b, y))) = (f.leading_term(), g.leading_term()) else {
                return Ok(false);
            };
            if a.is_coprime_to(b) {
                continue;
            }
            let lcm = a.lcm(b);
            let (to_f, to_g) = (lcm.quotient(a).expect("divides"), lcm.quotient(b).expect("divides"));
            let s_polynomial = f.shifted(&to_f).scaled(y).add_scaled(&-x, &g.shifted(&to_g));
            if !normal_form(&s_polynomial, basis, control)?.is_zero() {
                return Ok(false);
            }
        }
    }
    Ok(true)
}

/// The remainder of the division by several polynomials (Cox, Little, O'Shea, section 2.3).
pub(super) fn normal_form(
    polynomial: &Polynomial,
    divisors: &[Polynomial],
    control: &Control,
) -> Result<Polynomial, Interrupted> {
    let mut rest = polynomial.clone();
    let mut remainder = Polynomial::zero(polynomial.field());
    while let Some((monomial, value)) = rest.leading_term().cloned() {
        control.check()?;
        let divisor = divisors.iter().find_map(|divisor| {
            let (leading, coefficient) = divisor.leading_term()?;
            Some((divisor, monomial.quotient(leading)?, coefficient.inverse()?))
        });
        match divisor {
            Some((divisor, quotient, inverse)) => {
                rest = rest.add_scaled(&-&(&value * &inverse), &divisor.shifted(&quotient));
            }
            None => {
                let term = Polynomial::term(value, monomial);
                rest = rest.add_scaled(&polynomial.field().integer(-1), &term);
                remainder = remainder.add(&term);
            }
        }
    }
    Ok(remainder)
}

/// The size of the largest set of variables that no leading monomial lies in (Cox, Little, O'Shea, section 9.3).
fn dimension(leading: &[Monomial], variables: &[u16], control: &Control) -> Result<usize, Interrupted> {
    // A variable that leads by itself is in no such set; one that never occurs is in all of them.
    let free =
        variables.iter().filter(|&&v| leading.iter().all(|monomial| monomial.exponent(v) == 0)).count();
    let undecided: Vec<u16> = variables
        .iter()
        .copied()
        .filter(|&v| leading.iter().any(|monomial| monomial.exponent(v) > 0))
        .filter(|&v| !leading.contains(&Monomial::variable(v)))
        .collect();
    Ok(free + largest_independent(leading, &undecided, &mut Vec::new(), control)?)
}

fn largest_independent(
    leading: &[Monomial],
    undecided: &[u16],
    chosen: &mut Vec<u16>,
    control: &Control,
) -> Result<usize, Interrupted> {
    control.check()?;
    let Some((&next, rest)) = undecided.split_first() else {
        return Ok(chosen.len());
    };
    let without = largest_independent(leading, rest, chosen, control)?;
    chosen.push(next);
    let inside = |monomial: &Monomial| monomial.powers().iter().all(|(v, _)| chosen.contains(v));
    let dependent = leading.iter().any(inside);
    let with = if dependent { 0 } else { largest_independent(leading, rest, chosen, control)? };
    chosen.pop();
    Ok(with.max(without))
}

/// How many monomials no leading monomial divides; finite in dimension 0.
fn standard_monomials(
    leading: &[Monomial],
    variables: &[u16],
    control: &Control,
) -> Result<usize, Interrupted> {
    let mut count = 0;
    let mut layer = vec![Monomial::one()];
    while !layer.is_empty() {
        count += layer.len();
        let mut next = Vec::new();
        for monomial in &layer {
            control.check()?;
            let multiples = variables.iter().map(|&v| monomial.product(&Monomial::variable(v)));
            next.extend(multiples.filter(|m| leading.iter().all(|other| m.quotient(other).is_none())));
        }
        next.sort();
        next.dedup();
        layer = next;
    }
    Ok(count)
}
