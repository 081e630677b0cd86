//! Claim `bounds`: subdivisions that show how far a patch is from its surface.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::{Bounded, Bounds, End, Rejection};
use crate::claims::exact::{copies, evaluated};
use crate::claims::subdivision::{
    self, Along, Form, NOT_NEGATIVE, POSITIVE, Quantity, Side, UnitSquare, on_ratio, subject, threshold,
};
use crate::exact::{Arithmetic, Limit, Polynomial, Stop, Work};
use crate::failure::{At, Failure, Place};
use crate::statement::{HomogeneousPoint, Patch, Statement};

/// Follows the subdivisions, and tries the points.
pub(in crate::claims) fn verify(
    statement: &Statement,
    bounds: &Bounds,
    work: &mut Work,
) -> Result<Bounded, Failure<Rejection>> {
    let patch = subject(statement, bounds.quantity).map_err(Rejection::from)?;
    let at = Place::Values;
    let arithmetic = &mut Arithmetic::new(statement.field(), work);
    let net = evaluated(patch, &bounds.values, arithmetic).at(at)?;
    let net = match bounds.plain() {
        true => net,
        false => reparametrised(&net, &bounds.odds, arithmetic).at(at)?,
    };
    let (m, n) = patch.bidegree;
    let degree = patch.surface.degree();
    let patch = Patch { net, surface: arithmetic.copied(&patch.surface).at(at)?, bidegree: patch.bidegree };
    let square = UnitSquare::new(statement.field(), arithmetic.work).at(at)?;
    let degrees = [m.saturating_mul(degree), n.saturating_mul(degree)];
    let along = Along::of(&patch, arithmetic).at(at)?;

    let weight = square.form(&along.expanded.weight, [m, n], arithmetic.work).at(at)?;
    let boxes = square.subdivide("denominator", weight, &bounds.denominator, POSITIVE, arithmetic.work);
    let boxes = boxes.map_err(|error| error.map(Rejection::from))?;
    let scene = Scene { bounds, along, square, degrees };
    let lower = scene.holds("lower", Side::Lower, &bounds.lower, arithmetic)?;
    let lower_is_best = scene.is_best("lower", Side::Lower, &bounds.lower, arithmetic)?;
    let upper = scene.holds("upper", Side::Upper, &bounds.upper, arithmetic)?;
    let upper_is_best = scene.is_best("upper", Side::Upper, &bounds.upper, arithmetic)?;
    Ok(Bounded {
        values: copies(&bounds.values, arithmetic).at(at)?,
        quantity: bounds.quantity,
        places: bounds.places,
        between: [bounds.lower.bound.clone(), bounds.upper.bound.clone()],
        at: [bounds.lower.at.clone(), bounds.upper.at.clone()],
        best: [lower_is_best, upper_is_best],
        boxes: boxes.saturating_add(lower).saturating_add(upper),
    })
}

/// The net of the same patch in other parameters: with odds t = λt′ and s = μs′ the point at (i, j) is multiplied by λⁱμʲ.
fn reparametrised(
    net: &[Vec<HomogeneousPoint>],
    [of_u, of_v]: &[BigRational; 2],
    arithmetic: &mut Arithmetic<'_>,
) -> Result<Vec<Vec<HomogeneousPoint>>, Limit> {
    let [of_u, of_v] = [of_u, of_v].map(|odds| Polynomial::rational(odds.clone()));
    let mut of_row = Polynomial::integer(1);
    let mut rows = Vec::with_capacity(net.len());
    for row in net {
        let mut factor = arithmetic.copied(&of_row)?;
        let mut points = Vec::with_capacity(row.len());
        for [x, y, z, w] in row {
            let mut times = |entry: &Polynomial| arithmetic.product(entry, &factor);
            points.push([times(x)?, times(y)?, times(z)?, times(w)?]);
            factor = arithmetic.product(&factor, &of_v)?;
        }
        rows.push(points);
        of_row = arithmetic.product(&of_row, &of_u)?;
    }
    Ok(rows)
}

/// F, W and Wᵉ along the patch at the stated values.
struct Scene<'a> {
    bounds: &'a Bounds,
    along: Along,
    square: UnitSquare<'a>,
    /// Of F and Wᵉ in u and v.
    degrees: [u32; 2],
}

impl Scene<'_> {
    /// That the bound holds on the whole square, shown on so many boxes.
    fn holds(
        &self,
        name: &'static str,
        side: Side,
        end: &End,
        arithmetic: &mut Arithmetic<'_>,
    ) -> Result<usize, Failure<Rejection>> {
        let Bounds { quantity, places, .. } = *self.bounds;
        // No radius is negative: the bound 0 needs no boxes.
        let vacuous = side == Side::Lower && quantity == Quantity::Radius && end.bound.is_zero();
        if vacuous && end.tree.as_slice() == [false] {
            return Ok(1);
        }
        let bound = threshold(quantity, &end.bound, places, arithmetic.work);
        let bound = bound.map_err(|error| error.map(Rejection::from))?;
        let form = self.form(side, bound, arithmetic).at(Place::Values)?;
        let boxes = self.square.subdivide(name, form, &end.tree, NOT_NEGATIVE, arithmetic.work);
        boxes.map_err(|error: Failure<subdivision::Rejection>| error.map(Rejection::from))
    }

    /// A side, as a form on the square.
    fn form(&self, side: Side, bound: BigRational, arithmetic: &mut Arithmetic<'_>) -> Result<Form, Stop> {
        let polynomial = self.along.side(side, bound, arithmetic)?;
        self.square.form(&polynomial, self.degrees, arithmetic.work)
    }

    /// Whether the quantity at the stated point is strictly inside the next decimal, so that this is no bound; if it equals
    /// that, the next decimal may be a bound, and no later one is.
    fn is_best(
        &self,
        name: &'static str,
        side: Side,
        end: &End,
        arithmetic: &mut Arithmetic<'_>,
    ) -> Result<bool, Failure<Rejection>> {
        let Bounds { quantity, places, .. } = *self.bounds;
        let (inwards, opposite) = match side {
            Side::Lower => (1, Side::Upper),
            _ => (-1, Side::Lower),
        };
        let next = arithmetic.work.sum(&end.bound, &BigInt::from(inwards)).at(Place::Values)?;
        // No radius is negative: every one is inside.
        if quantity == Quantity::Radius && next.is_negative() {
            return Ok(true);
        }
        let value = on_ratio(quantity, &next, places, arithmetic.work).at(Place::Values)?;
        let form = self.form(opposite, value, arithmetic).at(Place::Values)?;
        match self.square.at(form, &end.at, &self.bounds.odds, arithmetic.work).at(Place::Values)? {
            Ordering::Greater => Ok(true),
            Ordering::Equal => Ok(false),
            Ordering::Less => Err(Rejection::NotReached { end: name }.into()),
        }
    }
}
