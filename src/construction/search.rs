//! The search for an exact patch with positive weights that covers its polygon regularly.

use itertools::{Itertools, iproduct};

use super::cover::{CoverError, cover};
use super::degree::{Cell, Phase, classify};
use crate::algebra::{FieldElement, Integer, Sign};
use crate::bezier::RationalArc;
use crate::catalogue::{net_statement, normalised};
use crate::certificate::Argument;
use crate::checker::CheckError;
use crate::control::{Control, Interrupted};
use crate::exact::Limit;
use crate::geometry::{
    Moduli, Point, Polygon, SpinorForm, Split, Vector, biquartic, quadrilateral, triangle, without_phase,
};
use crate::proof::{NoProof, Proof};
use crate::statement::Statement;

/// An exact patch.
#[derive(Debug)]
pub struct Construction {
    /// Premultiplied control points, m + 1 rows of n + 1; weight 1 at u = v = 0.
    pub net: Vec<Vec<Point>>,
    /// The polygon, its corners at (u,v) = (0,0), (1,0), (1,1), (0,1); a triangle's second one is the edge u = 1.
    pub placed: Polygon,
    /// How it was made.
    pub how: How,
    /// The statement file that the net lies on the unit sphere.
    pub text: String,
    /// The statement.
    pub statement: Statement,
    /// That it lies on the sphere.
    pub exact: Proof,
    /// That it covers the polygon, or why that is not shown.
    pub cover: Result<Proof, CoverError>,
}

/// The construction that an exact patch comes from, before its degrees were raised.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum How {
    /// A spinor of bidegree (2,1), or (1,2): the image has bidegree (4,2), or (2,4).
    Linear {
        /// What was chosen.
        moduli: Moduli,
        /// Whether u and v are exchanged.
        transposed: bool,
        /// How many choices were tried before.
        tried: usize,
    },
    /// A bilinear spinor: the image has bidegree (2,2).
    Bilinear,
    /// A spinor of bidegree (2,2) with the symmetry of the square, and the number that is free at its centre.
    Biquartic(FieldElement),
}

/// Why there is no patch.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Refusal {
    /// There is none.
    #[error("no exact patch")]
    Impossible(Cell),
    /// A number at the centre of a patch that has none.
    #[error(
        "--centre is for bidegrees from (4,4) on and a quadrilateral about the axis (0, 0, 1) with the symmetry of the square"
    )]
    NoCentre,
    /// No choice of what is free made a net.
    #[error("none of the constructions that were tried makes a net")]
    NoneFound,
    /// The net, or what is to be checked about it, is beyond the limits of the checker.
    #[error("the checker, which judges every certificate, has limits: {0}")]
    Limit(Limit),
    /// Interrupted.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
    /// The checker refused: a defect of this program.
    #[error("the independent checker refused the net: {0}")]
    Refused(CheckError),
}

impl From<NoProof> for Refusal {
    fn from(why: NoProof) -> Self {
        match why {
            NoProof::Interrupted(why) => Refusal::Interrupted(why),
            NoProof::Limit(limit) => Refusal::Limit(limit),
            NoProof::Refused(error) => Refusal::Refused(error),
        }
    }
}

impl From<CheckError> for Refusal {
    fn from(error: CheckError) -> Self {
        match error.limit() {
            Some(limit) => Refusal::Limit(*limit),
            None => Refusal::Refused(error),
        }
    }
}

/// An exact patch of this bidegree for a polygon: the first of the family that covers it, or if none is found to, the first.
///
/// `centre` is the free number of the symmetric biquartic patch.
///
/// # Errors
/// [`Refusal`]
pub fn construct(
    polygon: &Polygon,
    title: &str,
    bidegree: (u32, u32),
    centre: Option<&FieldElement>,
    control: &Control,
) -> Result<Construction, Refusal> {
    let cell = classify(Phase::of(polygon), bidegree);
    let base = match cell {
        Cell::Exact(base) => base,
        Cell::LongerWay => (2, 2),
        Cell::NoSurface | Cell::NoClosure => return Err(Refusal::Impossible(cell)),
    };
    let one = polygon.field().one();
    if bidegree.0 >= 4
        && bidegree.1 >= 4
        && is_square(polygon)
        && let Some(form) = biquartic(polygon, centre.unwrap_or(&one))
    {
        let how = How::Biquartic(centre.unwrap_or(&one).clone());
        return finish(title, bidegree, (form.image(), polygon.clone(), how), control);
    }
    if centre.is_some() {
        return Err(Refusal::NoCentre);
    }
    let (mut first, mut limit) = (None, None);
    for (tried, (scales, split, rotation)) in
        iproduct!(scales(polygon), [Split::Even, Split::Low, Split::High], [0usize, 1]).enumerate()
    {
        control.check()?;
        let moduli = Moduli { rotation: 0, split, scales };
        let Some(made) = candidate(polygon, base, moduli, rotation == 1, tried) else { continue };
        let last = matches!(made.2, How::Bilinear) && !polygon.is_triangle();
        let positive = made.0.iter().flatten().all(|[.., weight]| weight.sign() == Sign::Positive);
        if positive || first.is_none() {
            match finish(title, bidegree, made, control) {
                Ok(made) if made.cover.is_ok() || last => return Ok(made),
                Ok(made) => first = first.or(Some(made)),
                // Another net may be shorter.
                Err(Refusal::Limit(reached)) => limit = limit.or(Some(reached)),
                Err(refusal) => return Err(refusal),
            }
        }
        // A corner that is not convex leaves no hope: at it the Jacobian determinant is negative or zero.
        if !polygon.is_convex() && !polygon.reversed().is_convex() {
            break;
        }
    }
    first.ok_or_else(|| limit.map_or(Refusal::NoneFound, Refusal::Limit))
}

/// A net, the polygon as it lies in it, and how it was made.
type Made = (Vec<Vec<Point>>, Polygon, How);

/// One member of the family; `other_pair`: the phase is carried by the other pair of edges, and u and v exchanged.
fn candidate(
    polygon: &Polygon,
    base: (u32, u32),
    moduli: Moduli,
    other_pair: bool,
    tried: usize,
) -> Option<Made> {
    if base == (2, 2) {
        let moduli = Moduli { rotation: usize::from(other_pair), ..moduli };
        let form = match polygon.is_triangle() {
            true => triangle(polygon, &moduli)?,
            false => without_phase(polygon, &moduli)?.0,
        };
        return Some((form.image(), polygon.rotated(moduli.rotation), How::Bilinear));
    }
    // (2,4): the corners the other way round from the first, and u and v exchanged at the end.
    let transposed = base == (2, 4);
    let rotation = usize::from(other_pair);
    let (around, moduli) = match transposed {
        true => {
            let scales = [0, 3, 2, 1].map(|k| moduli.scales[k].clone()).to_vec();
            (polygon.reversed().rotated(3), Moduli { rotation, scales, ..moduli })
        }
        false => (polygon.clone(), Moduli { rotation, ..moduli }),
    };
    let form = quadrilateral(&around, &moduli)?;
    let (form, placed) = match transposed {
        true => (exchanged(&form), polygon.rotated(3 * rotation)),
        false => (form, polygon.rotated(rotation)),
    };
    Some((form.image(), placed, How::Linear { moduli, transposed, tried }))
}

fn exchanged(SpinorForm(rows): &SpinorForm) -> SpinorForm {
    SpinorForm((0..rows[0].len()).map(|j| rows.iter().map(|row| row[j].clone()).collect()).collect())
}

/// All scales 1; then some corners with another one.
fn scales(polygon: &Polygon) -> Vec<Vec<FieldElement>> {
    let field = polygon.field();
    let count = polygon.corners().len();
    let one = field.one();
    let patterns =
        (1u32..1 << count).filter(|pattern| pattern.trailing_zeros() == 0 || pattern.count_ones() == 1);
    let others = iproduct!([(3i64, 4i64), (4, 3), (1, 2), (2, 1)], patterns).map(|((p, q), pattern)| {
        let scale = field.rational(Integer::from(p), Integer::from(q));
        (0..count).map(|k| if pattern >> k & 1 == 1 { scale.clone() } else { one.clone() }).collect()
    });
    [vec![one.clone(); count]].into_iter().chain(others).collect()
}

/// Whether a quarter turn about the axis (0, 0, 1) takes each corner to the next.
fn is_square(polygon: &Polygon) -> bool {
    let pairs = polygon.corners().iter().circular_tuple_windows();
    polygon.corners().len() == 4 && pairs.clone().all(|([x, y, z], [p, q, r])| *p == -y && q == x && r == z)
        || pairs.clone().all(|([x, y, z], [p, q, r])| p == y && *q == -x && r == z)
}

fn finish(
    title: &str,
    bidegree: (u32, u32),
    (net, placed, how): Made,
    control: &Control,
) -> Result<Construction, Refusal> {
    let net = elevated(&normalised(&net), bidegree);
    let remark = "An exact patch: the generalised stereographic image of a spinor whose edges run along great circles.";
    let (m, n) = bidegree;
    let text = net_statement(&format!("{title}, bidegree ({m},{n}), exact"), remark, &net);
    let statement = Statement::read(&text).map_err(CheckError::from)?;
    let exact = Proof::of(&statement, Argument::Exact(vec![]), control)?;
    let cover = match cover(&statement, &net, control) {
        Err(CoverError::Interrupted(why)) => return Err(Refusal::Interrupted(why)),
        other => other,
    };
    Ok(Construction { net, placed, how, text, statement, exact, cover })
}

/// The number at the centre with which a net of bidegree (4,4) is the symmetric patch of the polygon between its corners.
pub fn centre_of(net: &[Vec<Point>]) -> Option<FieldElement> {
    if (net.len(), net[0].len()) != (5, 5) {
        return None;
    }
    let corner = |i: usize, j: usize| -> Option<Vector> {
        let [x, y, z, w] = &net[i][j];
        let inverse = w.inverse()?;
        Some([x, y, z].map(|coordinate| coordinate * &inverse))
    };
    let corners = vec![corner(0, 0)?, corner(4, 0)?, corner(4, 4)?, corner(0, 4)?];
    let polygon = Polygon::new(corners).ok().filter(is_square)?;
    let member = |centre: &FieldElement| Some(normalised(&biquartic(&polygon, centre)?.image()));
    let field = polygon.field();
    let net = normalised(net);
    // The weight at (1,1) depends on it linearly.
    let [at_zero, at_one] = [member(&field.zero())?, member(&field.one())?].map(|net| net[1][1][3].clone());
    let centre = &(&net[1][1][3] - &at_zero) * &(&at_one - &at_zero).inverse()?;
    (member(&centre)? == net).then_some(centre)
}

/// The same patch with higher degrees.
pub fn elevated(net: &[Vec<Point>], (m, n): (u32, u32)) -> Vec<Vec<Point>> {
    let raise = |points: Vec<Point>, degree: u32| RationalArc { points }.elevated_to(degree).points;
    let columns =
        (0..net[0].len()).map(|j| raise(net.iter().map(|row| row[j].clone()).collect(), m)).collect_vec();
    (0..=m as usize).map(|i| raise(columns.iter().map(|column| column[i].clone()).collect(), n)).collect()
}
