//! Which single change of a printed net puts it on the surface.
//!
//! One number at a time is taken as an unknown t; then every coefficient of the surface condition is a polynomial in
//! t, and a common root in K is what the number should be. In the same way the first three numbers of a point are
//! multiplied by t: with t the weight or its inverse, the point is given in the wrong convention.
//!
//! A control point enters only the coefficients near it: one that is far from a coefficient that does not vanish cannot
//! be all that is wrong. In a net of rounded numbers hardly any coefficient vanishes, so that no point is left to be tried.

use std::convert::Infallible;

use itertools::iproduct;

use super::NetAudit;
use crate::algebra::{FieldElement, Polynomial as Univariable, Univariate, polynomial_to_exact};
use crate::audit::AuditError;
use crate::bezier::{BernsteinForm, surface_condition_within};
use crate::control::{Control, Interrupted};
use crate::exact::Polynomial;
use crate::formats::net::{Convention, PrintedNet, premultiplied};
use crate::problem::field_of;
use crate::statement::{Patch, Statement, Subject};

/// A change that makes the net right, and the only one needed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NetCorrection {
    /// The control point; none where the whole net is concerned.
    pub point: Option<(usize, usize)>,
    /// What is changed.
    pub change: NetChange,
}

/// What is changed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NetChange {
    /// One number of the point.
    Entry {
        /// 0, 1, 2, 3 in the order of printing.
        coordinate: usize,
        /// As printed.
        printed: Polynomial,
        /// What is right.
        right: Polynomial,
    },
    /// The first three numbers are to be multiplied by this.
    Scale(Polynomial),
    /// The point, or the net, is given in the other convention.
    Convention {
        /// The one that is meant.
        meant: Convention,
    },
}

/// Products of control points that are worth computing for an explanation: hundreds of expansions of nets of usual size.
const PRODUCTS: u64 = 40_000_000;

/// All single changes, those of a sign first; whether the search came to its end.
pub(super) fn search(net: &PrintedNet, audit: &mut NetAudit, control: &Control) -> Result<bool, AuditError> {
    let (mut found, mut searched) = (Vec::new(), true);
    let outcome = collect(net, audit, &mut found, &mut searched, control);
    // A point that is all zeros but for one number can be mended in two ways that are the same.
    let is_sign = |correction: &NetCorrection| match &correction.change {
        NetChange::Entry { printed, right, .. } => printed.negate() == *right,
        NetChange::Scale(_) => false,
        NetChange::Convention { .. } => true,
    };
    found.sort_by_key(|correction| !is_sign(correction));
    audit.corrections = found;
    outcome.map(|()| searched)
}

fn collect(
    net: &PrintedNet,
    audit: &NetAudit,
    found: &mut Vec<NetCorrection>,
    searched: &mut bool,
    control: &Control,
) -> Result<(), AuditError> {
    let Subject::Patch(patch) = audit.statement.subject() else { return Ok(()) };
    let search = Search { net, statement: &audit.statement, patch, control };
    found.extend(search.other_convention()?);
    let mut left = PRODUCTS;
    for (i, j) in iproduct!(0..net.points.len(), 0..net.points[0].len()) {
        control.check()?;
        if audit.residual.iter().any(|(r, s, _)| !reaches(patch, (i, j), (*r, *s))) {
            continue;
        }
        // The coordinates one by one, and all together.
        match left.checked_sub(5 * products(patch)) {
            Some(rest) => left = rest,
            None => {
                *searched = false;
                return Ok(());
            }
        }
        for coordinate in 0..4 {
            found.extend(search.entry(i, j, coordinate)?);
        }
        found.extend(search.scale(i, j)?);
    }
    Ok(())
}

/// Whether the control point (i,j) enters the coefficient c[r,s]: with e − 1 others its indices add up to (r,s).
fn reaches(patch: &Patch, (i, j): (usize, usize), (r, s): (u32, u32)) -> bool {
    let others = patch.surface.degree().saturating_sub(1);
    let within = |i: usize, r: u32, m: u32| {
        u32::try_from(i).is_ok_and(|i| i <= r && r <= i.saturating_add(others.saturating_mul(m)))
    };
    within(i, r, patch.bidegree.0) && within(j, s, patch.bidegree.1)
}

/// About how many products of control points the expansion takes.
fn products(patch: &Patch) -> u64 {
    let points = u64::from(patch.bidegree.0 + 1) * u64::from(patch.bidegree.1 + 1);
    let terms = patch.surface.terms().count() as u64;
    (1..patch.surface.degree()).map(|k| u64::from(k * k)).sum::<u64>().max(1) * points * points * terms
}

struct Search<'a> {
    net: &'a PrintedNet,
    statement: &'a Statement,
    patch: &'a Patch,
    control: &'a Control,
}

impl Search<'_> {
    /// The whole net read in the other convention.
    fn other_convention(&self) -> Result<Vec<NetCorrection>, AuditError> {
        let meant = self.net.convention.other();
        let other = PrintedNet { convention: meant, ..self.net.clone() };
        let patch = Patch { net: other.homogeneous()?, ..self.patch.clone() };
        let form = surface_condition_within(field_of(self.statement), &patch, self.control)?;
        let vanishes = form.coefficients().all(|(_, _, value)| value.is_zero());
        let correction = NetCorrection { point: None, change: NetChange::Convention { meant } };
        Ok(if vanishes { vec![correction] } else { Vec::new() })
    }

    /// The net with t for one number.
    fn entry(&self, i: usize, j: usize, coordinate: usize) -> Result<Vec<NetCorrection>, AuditError> {
        let mut point = self.net.points[i][j].clone();
        let printed = std::mem::replace(&mut point[coordinate], Polynomial::variable(0));
        let mut work = self.control.work();
        let homogeneous = premultiplied(&point, self.net.convention, &self.net.field, &mut work)?;
        let mut found = Vec::new();
        for right in self.roots(i, j, homogeneous)? {
            let right = constant(&right)?;
            if right != printed {
                let change = NetChange::Entry { coordinate, printed: printed.clone(), right };
                found.push(NetCorrection { point: Some((i, j)), change });
            }
        }
        Ok(found)
    }

    /// The net with the first three numbers of a point multiplied by t.
    fn scale(&self, i: usize, j: usize) -> Result<Vec<NetCorrection>, AuditError> {
        let mut work = self.control.work();
        let field = &self.net.field;
        let t = Polynomial::variable(0);
        let mut point = self.patch.net[i][j].clone();
        // Of a point with one coordinate alone that number itself has been tried.
        if point[..3].iter().filter(|entry| !entry.is_zero()).count() < 2 {
            return Ok(Vec::new());
        }
        let weight = point[3].clone();
        for coordinate in &mut point[..3] {
            *coordinate = coordinate.multiply(&t, field, &mut work)?;
        }
        let inverse = weight.inverse(field, &mut work)?;
        let meant = match self.net.convention {
            Convention::Homogeneous => Some(weight),
            Convention::Cartesian => inverse,
        };
        let mut found = Vec::new();
        for factor in self.roots(i, j, point)? {
            let factor = constant(&factor)?;
            if factor.is_one() {
                continue;
            }
            let change = match meant.as_ref() == Some(&factor) {
                true => NetChange::Convention { meant: self.net.convention.other() },
                false => NetChange::Scale(factor),
            };
            found.push(NetCorrection { point: Some((i, j)), change });
        }
        Ok(found)
    }

    /// The values of t in K for which the patch lies on the surface.
    fn roots(&self, i: usize, j: usize, point: [Polynomial; 4]) -> Result<Vec<FieldElement>, Interrupted> {
        let mut patch = self.patch.clone();
        patch.net[i][j] = point;
        let form = surface_condition_within(field_of(self.statement), &patch, self.control)?;
        Ok(common_roots(&form))
    }
}

fn constant(value: &FieldElement) -> Result<Polynomial, AuditError> {
    Ok(polynomial_to_exact(&Univariable::constant(value.clone()))?)
}

/// The common roots in K of all coefficients, polynomials in one unknown of which one has degree 1 or 2.
fn common_roots(form: &BernsteinForm) -> Vec<FieldElement> {
    let field = form.field();
    let univariate = |polynomial: &Univariable| {
        let mut coefficients = vec![field.zero(); polynomial.degree().unwrap_or(0) as usize + 1];
        for (monomial, value) in polynomial.terms() {
            coefficients[monomial.degree() as usize] = value.clone();
        }
        Univariate::new(field, coefficients)
    };
    let equations: Vec<Univariate> = form
        .coefficients()
        .filter(|(_, _, value)| !value.is_zero())
        .map(|(_, _, value)| univariate(value))
        .collect();
    let Some(shortest) = equations.iter().min_by_key(|equation| equation.degree()) else { return Vec::new() };
    if shortest.degree() == 0 {
        return Vec::new();
    }
    let Ok(mut roots) = shortest.roots_in_field(|| Ok::<(), Infallible>(()));
    roots.dedup();
    roots.retain(|root| equations.iter().all(|equation| equation.evaluate(root).is_zero()));
    roots
}
