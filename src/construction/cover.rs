//! Whether a net covers the polygon between its corners: the certificate, and what the checker makes of it.

use num_rational::BigRational;

use crate::algebra::{FieldElement, Integer, Polynomial};
use crate::approximation::{NoTree, around, positive_tree};
use crate::bezier::BernsteinForm;
use crate::certificate::{Argument, Cover, EdgeTree, Tree};
use crate::checker::CheckError;
use crate::control::{Control, Interrupted};
use crate::exact::Limit;
use crate::geometry::{Point, Vector, dot};
use crate::proof::{NoProof, Proof};
use crate::statement::Statement;

/// Boxes before a net is given up.
const BOXES: usize = 4_000;

/// Why there is no certificate.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CoverError {
    /// Not positive somewhere, exactly.
    #[error("{what} is not positive on the whole square: it is {} at (u, v) = ({}, {})", if *zero { "0" } else { "negative" }, at[0], at[1])]
    NotPositive {
        /// Of what.
        what: &'static str,
        /// Where.
        at: Box<[BigRational; 2]>,
        /// Whether it is 0 there.
        zero: bool,
    },
    /// Positive wherever it was looked at, but not shown to be so everywhere.
    #[error("{what} is not shown to be positive on the whole square{}", why_not(near.as_deref()))]
    NotShown {
        /// Of what.
        what: &'static str,
        /// Where it comes too near to 0 to tell; nowhere if the boxes became too many.
        near: Option<Box<[BigRational; 2]>>,
    },
    /// A limit of the checker.
    #[error("the checker, which judges every certificate, has limits: {0}")]
    Limit(Limit),
    /// Interrupted.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
    /// The checker refused.
    #[error("{0}")]
    Refused(CheckError),
}

/// The certificate that this net, the only patch of the statement, covers the polygon between its corners.
///
/// # Errors
/// [`CoverError`]
pub fn cover(statement: &Statement, net: &[Vec<Point>], control: &Control) -> Result<Proof, CoverError> {
    let (m, n) = (net.len() - 1, net[0].len() - 1);
    let weights: Vec<FieldElement> = net.iter().flatten().map(|[.., weight]| weight.clone()).collect();
    let denominator = positive("the denominator W", (m, n), weights, control)?;

    let column = |j: usize| net.iter().map(|row| row[j].clone()).collect::<Vec<_>>();
    let curves = [net[0].clone(), net[m].clone(), column(0), column(n)];
    let points: Vec<bool> = curves.iter().map(|curve| is_point(curve)).collect();
    let mut edges = [EdgeTree::Point, EdgeTree::Point, EdgeTree::Point, EdgeTree::Point];
    for (number, curve) in curves.iter().enumerate().filter(|(number, _)| !points[*number]) {
        let (a, b) = (&curve[0], &curve[curve.len() - 1]);
        let middle: Vector = std::array::from_fn(|k| &(&a[k] * &b[3]) + &(&b[k] * &a[3]));
        let along: Vec<FieldElement> = curve.iter().map(|point| dot(&middle, &vector(point))).collect();
        let bidegree = if number < 2 { (0, n) } else { (m, 0) };
        let tree =
            positive("an edge's side of its arc", bidegree, along, control).map_err(|why| match why {
                // The form knows the place along the edge only.
                CoverError::NotPositive { what, mut at, zero } => {
                    at[number / 2] = BigRational::from_integer((number % 2).into());
                    CoverError::NotPositive { what, at, zero }
                }
                CoverError::NotShown { what, near: Some(mut near) } => {
                    near[number / 2] = BigRational::from_integer((number % 2).into());
                    CoverError::NotShown { what, near: Some(near) }
                }
                other => other,
            })?;
        edges[number] = EdgeTree::Arc(tree);
    }

    let (mut bidegree, mut values) = jacobian(net, control)?;
    if let Some(edge) = points.iter().position(|point| *point) {
        (bidegree, values) = without_factor(edge, bidegree, values);
    }
    let inward = values[0].sign() == crate::algebra::Sign::Negative;
    if inward {
        values = values.iter().map(|value| -value).collect();
    }
    let regular = positive("the Jacobian determinant", bidegree, values, control)?;
    let argument = Argument::Cover(Cover { values: vec![], denominator, edges, inward, regular });
    Ok(Proof::of(statement, argument, control)?)
}

impl From<NoProof> for CoverError {
    fn from(why: NoProof) -> Self {
        match why {
            NoProof::Interrupted(why) => CoverError::Interrupted(why),
            NoProof::Limit(limit) => CoverError::Limit(limit),
            NoProof::Refused(error) => CoverError::Refused(error),
        }
    }
}

fn positive(
    what: &'static str,
    bidegree: (usize, usize),
    values: Vec<FieldElement>,
    control: &Control,
) -> Result<Tree, CoverError> {
    positive_tree(bidegree, values, BOXES, control).map_err(|why| match why {
        NoTree::Interrupted(why) => CoverError::Interrupted(why),
        NoTree::TooMany => CoverError::NotShown { what, near: None },
        NoTree::Near(near) => CoverError::NotShown { what, near: Some(near) },
        NoTree::Fails { at, zero } => CoverError::NotPositive { what, at, zero },
    })
}

fn why_not(near: Option<&[BigRational; 2]>) -> String {
    match near {
        Some(near) => format!(": it comes too near to 0 around {}", around(near)),
        None => format!(" by {BOXES} boxes"),
    }
}

fn vector([x, y, z, _]: &Point) -> Vector {
    [x.clone(), y.clone(), z.clone()]
}

/// Whether all points have one direction.
fn is_point(curve: &[Point]) -> bool {
    let [a, b, c] = vector(&curve[0]);
    curve.iter().all(|[x, y, z, _]| {
        [(&b, z, &c, y), (&c, x, &a, z), (&a, y, &b, x)].iter().all(|(p, q, r, s)| *p * *q == *r * *s)
    })
}

/// det[P, P_u, P_v]/(mn), of bidegree (3m−2, 3n−2): its Bernstein coefficients.
///
/// P is bilinear in Q₀₀, Q₁₀, Q₀₁, Q₁₁, forms of bidegree (m−1, n−1) (one step of de Casteljau in each direction), and its
/// derivatives are m and n times those of the bilinear patch with these corners. For such a patch the determinant is bilinear
/// too, and at each corner it is that of three of the points.
fn jacobian(
    net: &[Vec<Point>],
    control: &Control,
) -> Result<((usize, usize), Vec<FieldElement>), Interrupted> {
    let (m, n) = (net.len() as u32 - 1, net[0].len() as u32 - 1);
    let field = net[0][0][0].field();
    let corner = |a: usize, b: usize| -> [BernsteinForm; 3] {
        std::array::from_fn(|k| {
            BernsteinForm::from_bernstein(field, (m - 1, n - 1), |i, j| {
                Polynomial::constant(net[i + a][j + b][k].clone())
            })
        })
    };
    let [low, right, left, high] = [corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)];
    let minus = BernsteinForm::constant(field.integer(-1));
    let times = |x: &BernsteinForm, y: &BernsteinForm| x.multiply_within(y, control);
    let product = |[a, b, c]: &[BernsteinForm; 3], [p, q, r]: &[BernsteinForm; 3], s: &[BernsteinForm; 3]| {
        let minor = |x: &BernsteinForm, y: &BernsteinForm, z: &BernsteinForm, w: &BernsteinForm| {
            Ok::<_, Interrupted>(times(x, w)?.add(&times(&minus, &times(y, z)?)?))
        };
        let [x, y, z] = s;
        let first = times(a, &minor(q, r, y, z)?)?;
        let second = times(b, &minor(r, p, z, x)?)?;
        Ok::<_, Interrupted>(first.add(&second).add(&times(c, &minor(p, q, x, y)?)?))
    };
    let at = |a: usize, b: usize| {
        BernsteinForm::from_bernstein(field, (1, 1), |i, j| {
            Polynomial::constant(field.integer(i64::from((i, j) == (a, b))))
        })
    };
    let mut sum = times(&at(0, 0), &product(&low, &right, &left)?)?;
    for (corner, points) in
        [((1, 0), [&low, &right, &high]), ((0, 1), [&low, &high, &left]), ((1, 1), [&high, &left, &right])]
    {
        let [a, b, c] = points;
        sum = sum.add(&times(&at(corner.0, corner.1), &product(a, b, c)?)?);
    }
    let (p, q) = sum.bidegree();
    Ok(((p as usize, q as usize), sum.constants()))
}

/// A form that vanishes on the edge u = 0, u = 1, v = 0 or v = 1, divided by the distance from it.
fn without_factor(
    edge: usize,
    (m, n): (usize, usize),
    values: Vec<FieldElement>,
) -> ((usize, usize), Vec<FieldElement>) {
    let (in_u, at_end) = (edge < 2, edge % 2 == 1);
    let bidegree = if in_u { (m - 1, n) } else { (m, n - 1) };
    let degree = if in_u { m } else { n };
    let field = values[0].field();
    let mut rest = Vec::new();
    for i in 0..=bidegree.0 {
        for j in 0..=bidegree.1 {
            let k = if in_u { i } else { j };
            // (1−u)·Bₖᴰ⁻¹ = (D−k)/D·Bₖᴰ and u·Bₖᴰ⁻¹ = (k+1)/D·Bₖ₊₁ᴰ.
            let share = if at_end { degree - k } else { k + 1 };
            let (i, j) = if at_end {
                (i, j)
            } else if in_u {
                (i + 1, j)
            } else {
                (i, j + 1)
            };
            let factor = field.rational(Integer::from(degree as u32), Integer::from(share as u32));
            rest.push(&values[i * (n + 1) + j] * &factor);
        }
    }
    (bidegree, rest)
}
