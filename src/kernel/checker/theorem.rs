//! What a completed check establishes, as a value that nothing else can make.

use std::fmt;

use num_rational::BigRational;

use crate::certificate::{Quantity, Units, spell_decimal};
use crate::exact::Polynomial;
use crate::statement::{HomogeneousPoint, Statement, Subject};

/// A proved claim about a statement. Only a completed replay constructs one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Theorem {
    statement: Statement,
    claim: Claim,
}

/// What was proved.
#[allow(clippy::large_enum_variant, reason = "one or two are alive at a time")]
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Claim {
    /// The equations and assumptions of the statement have no common zero over any field containing K.
    Impossible {
        /// Steps replayed.
        steps: usize,
        /// Terms of all multipliers.
        multiplier_terms: usize,
    },
    /// At these values the patch lies on the surface.
    Exact {
        /// The value of each unknown, a constant of K.
        values: Vec<Polynomial>,
        /// The control net at these values: rows i = 0..m along u, points j = 0..n along v.
        net: Vec<Vec<HomogeneousPoint>>,
        /// Whether every weight is positive, so that the patch is defined on the whole closed square.
        weights_positive: bool,
    },
    /// These values solve the system.
    Solution {
        /// The value of each unknown, a constant of K.
        values: Vec<Polynomial>,
    },
    /// At these values W > 0 on the whole square, and the quantity lies between the bounds, each the best decimal of its length.
    Bounds {
        /// The value of each unknown, a constant of K.
        values: Vec<Polynomial>,
        /// What is bounded.
        quantity: Quantity,
        /// Decimal places.
        places: u32,
        /// The bounds, in units of the last place.
        between: [Units; 2],
        /// Points (u, v) where they are approached to within a unit.
        at: [[BigRational; 2]; 2],
        /// Boxes of all subdivisions.
        boxes: usize,
    },
    /// At these values the patch lies on the unit sphere, W > 0 on the whole square, and the square is mapped one to one
    /// and regularly onto the convex spherical polygon between its corners.
    Cover {
        /// The value of each unknown, a constant of K.
        values: Vec<Polynomial>,
        /// The points (x, y, z) at (u, v) = (0,0), (1,0), (1,1), (0,1).
        corners: Vec<[Polynomial; 3]>,
        /// Whether the normal ∂/∂u × ∂/∂v points to the centre of the sphere.
        inward: bool,
        /// The edge that is a single point, so that the polygon is a triangle.
        point: Option<&'static str>,
        /// Boxes of all subdivisions.
        boxes: usize,
    },
    /// At no real values is W > 0 on the whole square and the quantity strictly between the bounds.
    Unreachable {
        /// What is bounded.
        quantity: Quantity,
        /// Decimal places.
        places: u32,
        /// The bounds, in units of the last place.
        between: [Units; 2],
        /// Boxes that were excluded.
        boxes: usize,
    },
}

impl Theorem {
    pub(super) fn established(statement: &Statement, claim: Claim) -> Self {
        Theorem { statement: statement.clone(), claim }
    }

    /// The statement.
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    /// The claim.
    pub fn claim(&self) -> &Claim {
        &self.claim
    }

    /// `impossible`, `exact`, `solution`, `bounds`, `unreachable` or `cover`.
    pub fn kind(&self) -> &'static str {
        match self.claim {
            Claim::Impossible { .. } => "impossible",
            Claim::Exact { .. } => "exact",
            Claim::Solution { .. } => "solution",
            Claim::Bounds { .. } => "bounds",
            Claim::Unreachable { .. } => "unreachable",
            Claim::Cover { .. } => "cover",
        }
    }

    /// What was proved, as sentences.
    pub fn sentence(&self) -> String {
        let field = self.statement.field();
        let ring = self.statement.ring();
        let assumed: Vec<String> = self
            .statement
            .nonzero()
            .iter()
            .map(|polynomial| format!("{} ≠ 0", ring.spell(polynomial)))
            .collect();
        let assuming =
            if assumed.is_empty() { String::new() } else { format!(" with {}", assumed.join(", ")) };
        match (self.statement.subject(), &self.claim) {
            (Subject::Patch(patch), Claim::Impossible { .. }) => {
                let degree = patch.surface.degree();
                let (m, n) = patch.bidegree;
                let count = count_coefficients(m.saturating_mul(degree), n.saturating_mul(degree));
                let surface = self.statement.coordinate_ring().spell(&patch.surface);
                let patch = format!("this rational Bézier patch of bidegree ({m},{n})");
                let fails = match self.statement.unknowns() {
                    [] => format!("{patch} does not lie").replacen("this", "This", 1),
                    [one] => format!("For no value of {one}{assuming}, real or complex, does {patch} lie"),
                    many => {
                        let many = many.join(", ");
                        format!("For no values of {many}{assuming}, real or complex, does {patch} lie")
                    }
                };
                format!(
                    "{fails} on the surface {surface} = 0: its {count} coefficients c[r,s] have no common zero \
                     over any field containing {field}{assuming}."
                )
            }
            (Subject::System(polynomials), Claim::Impossible { .. }) => format!(
                "The system of {} polynomial{} has no zero{assuming} over any field containing {field}.",
                polynomials.len(),
                if polynomials.len() == 1 { "" } else { "s" }
            ),
            (_, Claim::Exact { values, weights_positive, .. }) => {
                let at = if values.is_empty() { "As it stands" } else { "At the stated values" };
                let defined = if *weights_positive {
                    "Every weight is positive, so the patch is defined on the whole square."
                } else {
                    "Not every weight is positive; that the denominator vanishes nowhere on the square is not claimed."
                };
                format!(
                    "{at} every point of the patch whose denominator is not zero lies on the surface. {defined}"
                )
            }
            (_, Claim::Solution { .. }) => {
                format!("The stated values in {field} solve the system{assuming}.")
            }
            (_, Claim::Bounds { quantity, places, between: [low, high], at, .. }) => {
                let [low, high] = [low, high].map(|bound| spell_decimal(bound, *places));
                let [at_low, at_high] = at.each_ref().map(|[u, v]| format!("({u}, {v})"));
                format!(
                    "At the stated values the denominator W is positive on the whole square, and there \
                     {low} ≤ {} ≤ {high}. Both bounds are the best with {places} decimals: the quantity comes within one unit of \
                     the last place at (u, v) = {at_low} and {at_high}.",
                    name_of(*quantity)
                )
            }
            (_, Claim::Cover { values, point, .. }) => {
                let at = if values.is_empty() { "As it stands" } else { "At the stated values" };
                let (polygon, regular) = match point {
                    None => ("quadrilateral", String::new()),
                    Some(edge) => ("triangle", format!(", but for the edge {edge}, which is a single point")),
                };
                format!(
                    "{at} the patch lies on the unit sphere, its denominator W is positive on the whole square, and it maps \
                     the square one to one and regularly onto the convex spherical {polygon} between its corners, whose \
                     sides are the shorter arcs of great circles{regular}."
                )
            }
            (_, Claim::Unreachable { quantity, places, between: [low, high], .. }) => {
                let [low, high] = [low, high].map(|bound| spell_decimal(bound, *places));
                format!(
                    "For no real values of {} is the denominator W positive on the whole square and {low} < {} < {high} \
                     everywhere on it.",
                    self.statement.unknowns().join(", "),
                    name_of(*quantity)
                )
            }
        }
    }
}

fn name_of(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Radius => "√(x² + y² + z²)",
        Quantity::Ratio => "F/W^e",
    }
}

fn count_coefficients(r: u32, s: u32) -> u64 {
    u64::from(r).saturating_add(1).saturating_mul(u64::from(s).saturating_add(1))
}

impl fmt::Display for Theorem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.sentence())
    }
}
