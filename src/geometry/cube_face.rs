//! From the unit sphere and its inscribed cube to the control points of the four edges.
//!
//! Equation numbers are those of the paper (Provatidis, "How accurately can spherical caps be represented by
//! rational quadratic polynomials?").

use crate::algebra::{FieldElement, Integer, MultiquadraticField};
use crate::bezier::RationalArc;

/// A point or vector (x, y, z).
pub type Vector = [FieldElement; 3];

/// The arc of a great circle of the unit sphere between two of its points, as a rational quadratic.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GreatCircleArc {
    /// A.
    pub start: Vector,
    /// B.
    pub end: Vector,
    /// M = (A + B)/2, the middle of the chord.
    pub middle_of_chord: Vector,
    /// The intersection of the tangents at A and B.
    pub tangents_meet: Vector,
    /// cos(α/2), α the angle of the arc: the weight of that point if both ends have weight 1.
    pub weight: FieldElement,
}

/// The face z > 0 of the cube inscribed in the unit sphere.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CubeFace {
    /// a, the side of the cube (1).
    pub side: FieldElement,
    /// `corners[i][j]`: i along u (y increasing), j along v (x increasing), so that A = `corners[0][0]` and
    /// B = `corners[0][1]` as in (3).
    pub corners: [[Vector; 2]; 2],
}

impl GreatCircleArc {
    /// The arc from A to B, two points of the unit sphere that are not antipodal.
    ///
    /// The tangents at A and B meet on the line OM, in the point P with P·A = P·B = 1.
    /// `None` where |OM| is not in the field.
    pub fn between(start: &Vector, end: &Vector) -> Option<Self> {
        let field = start[0].field();
        let half = field.rational(Integer::one(), Integer::from(2i64));
        let middle: Vector = std::array::from_fn(|k| &(&start[k] + &end[k]) * &half);
        let scale = dot(&middle, start).inverse()?;
        let tangents_meet: Vector = std::array::from_fn(|k| &middle[k] * &scale);
        let weight = dot(&middle, &middle).square_root()?;
        Some(GreatCircleArc {
            start: start.clone(),
            end: end.clone(),
            middle_of_chord: middle,
            tangents_meet,
            weight,
        })
    }

    /// The control points A, P, B with weights 1, cos(α/2), 1, premultiplied.
    pub fn to_curve(&self) -> RationalArc {
        let one = self.weight.field().one();
        let point = |p: &Vector, w: &FieldElement| [&p[0] * w, &p[1] * w, &p[2] * w, w.clone()];
        RationalArc {
            points: vec![
                point(&self.start, &one),
                point(&self.tangents_meet, &self.weight),
                point(&self.end, &one),
            ],
        }
    }
}

impl CubeFace {
    /// Derives the face. R = 1.
    ///
    /// M, the middle of an edge of the cube, has |OM|² = a²/2 and |MB| = a/2, so a²/2 + a²/4 = R²,
    /// whence a = 2R/√3 (1).
    pub fn derive(field: MultiquadraticField) -> Option<Self> {
        let fraction = |n: i64, d: i64| field.rational(Integer::from(n), Integer::from(d));
        let sum = &fraction(1, 2) + &fraction(1, 4);
        let side = sum.inverse()?.square_root()?;
        let plus = &side * &fraction(1, 2);
        let minus = -&plus;
        let corner = |y: &FieldElement, x: &FieldElement| [x.clone(), y.clone(), plus.clone()];
        let corners =
            [[corner(&minus, &minus), corner(&minus, &plus)], [corner(&plus, &minus), corner(&plus, &plus)]];
        Some(CubeFace { side, corners })
    }

    /// The edge u = 0 or 1, from v = 0 to v = 1.
    pub fn edge_along_v(&self, u: usize) -> Option<GreatCircleArc> {
        GreatCircleArc::between(&self.corners[u][0], &self.corners[u][1])
    }

    /// The edge v = 0 or 1, from u = 0 to u = 1.
    pub fn edge_along_u(&self, v: usize) -> Option<GreatCircleArc> {
        GreatCircleArc::between(&self.corners[0][v], &self.corners[1][v])
    }
}

/// The scalar product.
pub fn dot(a: &Vector, b: &Vector) -> FieldElement {
    let [x, y, z] = std::array::from_fn(|k| &a[k] * &b[k]);
    &(&x + &y) + &z
}
