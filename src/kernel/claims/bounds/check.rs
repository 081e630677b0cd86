//! Claim `bounds`: subdivisions that show how far a patch is from its surface.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::{Bounded, Bounds, End, Rejection};
use crate::claims::exact::evaluated;
use crate::claims::subdivision::{
    self, Along, NOT_NEGATIVE, POSITIVE, Quantity, Side, UnitSquare, decimal_value, on_ratio, subject,
    threshold,
};
use crate::equations::expand;
use crate::exact::{Limit, Polynomial, Radicands, Work};
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
    let net = evaluated(patch, &bounds.values, statement, work).at(at)?;
    let field = statement.field();
    let net = match bounds.plain() {
        true => net,
        false => reparametrised(&net, &bounds.odds, field, work).at(at)?,
    };
    let patch = Patch { net, ..patch.clone() };
    let expanded = expand(field, &patch, work).at(at)?;
    let (m, n) = patch.bidegree;
    let degree = patch.surface.degree();
    let square = UnitSquare::new(field);
    let degrees = [m.saturating_mul(degree), n.saturating_mul(degree)];
    let along = Along { power: expanded.weight.power(degree, field, work).at(at)?, expanded, field };

    let weight = square.form(&along.expanded.weight, [m, n], work).at(at)?;
    let boxes = square.subdivide("denominator", weight, &bounds.denominator, POSITIVE, work);
    let boxes = boxes.map_err(|error| error.map(Rejection::from))?;
    let scene = Scene { bounds, along, square, degrees };
    let lower = scene.holds("lower", Side::Lower, &bounds.lower, work)?;
    let lower_is_best = scene.is_best("lower", Side::Lower, &bounds.lower, work)?;
    let upper = scene.holds("upper", Side::Upper, &bounds.upper, work)?;
    let upper_is_best = scene.is_best("upper", Side::Upper, &bounds.upper, work)?;
    Ok(Bounded {
        values: bounds.values.clone(),
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
    field: &Radicands,
    work: &mut Work,
) -> Result<Vec<Vec<HomogeneousPoint>>, Limit> {
    let [of_u, of_v] = [of_u, of_v].map(|odds| Polynomial::rational(odds.clone()));
    let mut of_row = Polynomial::integer(1);
    let mut rows = Vec::with_capacity(net.len());
    for row in net {
        let mut factor = of_row.clone();
        let mut points = Vec::with_capacity(row.len());
        for [x, y, z, w] in row {
            let mut times = |entry: &Polynomial| entry.multiply(&factor, field, work);
            points.push([times(x)?, times(y)?, times(z)?, times(w)?]);
            factor = factor.multiply(&of_v, field, work)?;
        }
        rows.push(points);
        of_row = of_row.multiply(&of_u, field, work)?;
    }
    Ok(rows)
}

/// F, W and Wᵉ along the patch at the stated values.
struct Scene<'a> {
    bounds: &'a Bounds,
    along: Along<'a>,
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
        work: &mut Work,
    ) -> Result<usize, Failure<Rejection>> {
        let Bounds { quantity, places, .. } = *self.bounds;
        // No radius is negative: the bound 0 needs no boxes.
        let vacuous = side == Side::Lower && quantity == Quantity::Radius && end.bound.is_zero();
        if vacuous && end.tree.as_slice() == [false] {
            return Ok(1);
        }
        let bound = threshold(quantity, &end.bound, places).map_err(Rejection::from)?;
        let form = self.along.side(side, bound, work).at(Place::Values)?;
        let form = self.square.form(&form, self.degrees, work).at(Place::Values)?;
        let boxes = self.square.subdivide(name, form, &end.tree, NOT_NEGATIVE, work);
        boxes.map_err(|error: Failure<subdivision::Rejection>| error.map(Rejection::from))
    }

    /// Whether the quantity at the stated point is strictly inside the next decimal, so that this is no bound; if it equals
    /// that, the next decimal may be a bound, and no later one is.
    fn is_best(
        &self,
        name: &'static str,
        side: Side,
        end: &End,
        work: &mut Work,
    ) -> Result<bool, Failure<Rejection>> {
        let Bounds { quantity, places, .. } = *self.bounds;
        let (next, opposite) = match side {
            Side::Lower => (&end.bound + BigInt::one(), Side::Upper),
            _ => (&end.bound - BigInt::one(), Side::Lower),
        };
        // No radius is negative: every one is inside.
        if quantity == Quantity::Radius && next.is_negative() {
            return Ok(true);
        }
        let value = on_ratio(quantity, &decimal_value(&next, places));
        let form = self.along.side(opposite, value, work).at(Place::Values)?;
        let form = self.square.form(&form, self.degrees, work).at(Place::Values)?;
        match self.square.at(form, &end.at, &self.bounds.odds, work).at(Place::Values)? {
            Ordering::Greater => Ok(true),
            Ordering::Equal => Ok(false),
            Ordering::Less => Err(Rejection::NotReached { end: name }.into()),
        }
    }
}
