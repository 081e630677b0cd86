//! What a completed check establishes, as a value that nothing else can make.

use std::fmt;

use num_rational::BigRational;

use super::wording;
use crate::certificate::{Quantity, Units, spell_decimal};
use crate::exact::Polynomial;
use crate::statement::{HomogeneousPoint, Patch, Statement, Subject};

/// A proved claim about a statement. Only a completed replay constructs one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Theorem {
    statement: Statement,
    claim: Claim,
}

/// What was proved.
#[allow(clippy::large_enum_variant, reason = "one or two are alive at a time")]
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
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
    /// and regularly onto the convex spherical polygon between its corners, but for an edge that is a point.
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

    /// What was proved, as sentences. `docs/trust.md` says which check makes each of them true.
    pub fn sentence(&self) -> String {
        let statement = &self.statement;
        match (statement.subject(), &self.claim) {
            (Subject::Patch(patch), Claim::Impossible { .. }) => patch_impossible(statement, patch),
            (Subject::System(polynomials), Claim::Impossible { .. }) => {
                system_impossible(statement, polynomials.len())
            }
            (Subject::Patch(patch), Claim::Exact { weights_positive, .. }) => {
                exact(statement, patch, *weights_positive)
            }
            // There is no other patch; nothing else is exact.
            (Subject::System(_), Claim::Exact { .. }) | (_, Claim::Solution { .. }) => solution(statement),
            (_, Claim::Bounds { quantity, places, between, at, .. }) => {
                bounds(statement, *quantity, *places, between, at)
            }
            (_, Claim::Cover { point, .. }) => cover(statement, *point),
            (_, Claim::Unreachable { quantity, places, between, .. }) => {
                unreachable(statement, *quantity, *places, between)
            }
        }
    }
}

fn patch_impossible(statement: &Statement, patch: &Patch) -> String {
    let degree = patch.surface.degree();
    let (m, n) = patch.bidegree;
    let count = count_coefficients(m.saturating_mul(degree), n.saturating_mul(degree));
    let surface = wording::surface(statement, patch);
    let with = with_assumptions(statement);
    let patch = format!("rational Bézier patch of bidegree ({m},{n})");
    let values = match statement.unknowns() {
        [] => {
            return format!(
                "This {patch} does not lie on {surface}: its {count} coefficients c[r,s] are not all zero."
            );
        }
        [one] => format!("For no value of {one}"),
        many => format!("For no values of {}", many.join(", ")),
    };
    format!(
        "{values}{with}, real or complex, does this {patch} lie on {surface}: its {count} coefficients c[r,s] have \
         no common zero over any field containing {}{with}.",
        statement.field()
    )
}

fn system_impossible(statement: &Statement, polynomials: usize) -> String {
    if statement.unknowns().is_empty() {
        return "The polynomials of the system, all constants, are not all zero.".to_owned();
    }
    format!(
        "The system of {polynomials} polynomial{} has no zero{} over any field containing {}.",
        if polynomials == 1 { "" } else { "s" },
        with_assumptions(statement),
        statement.field()
    )
}

fn exact(statement: &Statement, patch: &Patch, weights_positive: bool) -> String {
    let defined = if weights_positive {
        "Every weight is positive, so the patch is defined on the whole square."
    } else {
        "Not every weight is positive; that the denominator vanishes nowhere on the square is not claimed."
    };
    format!(
        "{}{} every point of the patch whose denominator is not zero lies on {}. {defined}",
        wording::at_values(statement),
        where_assumptions(statement),
        wording::surface(statement, patch)
    )
}

fn solution(statement: &Statement) -> String {
    if statement.unknowns().is_empty() {
        return "Every polynomial of the system is zero.".to_owned();
    }
    let also =
        wording::assumptions(statement).map_or_else(String::new, |assumed| format!(", with {assumed}"));
    format!("The stated values in {} solve the system{also}.", statement.field())
}

fn bounds(
    statement: &Statement,
    quantity: Quantity,
    places: u32,
    between: &[Units; 2],
    at: &[[BigRational; 2]; 2],
) -> String {
    let [low, high] = between.each_ref().map(|bound| decimal(bound, places));
    let [at_low, at_high] = at.each_ref().map(|[u, v]| format!("({u}, {v})"));
    let unchecked = wording::assumptions(statement)
        .map_or_else(String::new, |assumed| format!(" That {assumed} at these values is not checked."));
    format!(
        "{} the denominator W is positive on the whole square, and there {low} ≤ {} ≤ {high}{}. Both bounds are \
         the best with {places} decimals: the quantity comes within one unit of the last place at (u, v) = {at_low} and \
         {at_high}.{unchecked}",
        wording::at_values(statement),
        name_of(statement, quantity),
        meaning_of(statement, quantity)
    )
}

fn cover(statement: &Statement, point: Option<&str>) -> String {
    let image = match point {
        None => {
            "it maps the square one to one and regularly onto the convex spherical quadrilateral between its \
                 corners, whose sides are the shorter arcs of great circles"
                .to_owned()
        }
        Some(edge) => format!(
            "it maps the square onto the convex spherical triangle between its corners, whose sides are the shorter \
             arcs of great circles: the edge {} to one corner, and all else one to one and regularly onto the rest",
            edge.replace('=', " = ")
        ),
    };
    format!(
        "{}{} the patch lies on the unit sphere, its denominator W is positive on the whole square, and {image}.",
        wording::at_values(statement),
        where_assumptions(statement)
    )
}

fn unreachable(statement: &Statement, quantity: Quantity, places: u32, between: &[Units; 2]) -> String {
    let [low, high] = between.each_ref().map(|bound| decimal(bound, places));
    // No assumption is made use of.
    let whether = wording::assumptions(statement)
        .map_or_else(String::new, |assumed| format!(", whether {assumed} or not,"));
    let values = match statement.unknowns() {
        [] => "It is not so that".to_owned(),
        [one] => format!("For no real value of {one}{whether} is"),
        many => format!("For no real values of {}{whether} is", many.join(", ")),
    };
    let is = if statement.unknowns().is_empty() { " is" } else { "" };
    format!(
        "{values} the denominator W{is} positive on the whole square and {low} < {} < {high} everywhere on it{}.",
        name_of(statement, quantity),
        meaning_of(statement, quantity)
    )
}

/// ` with d ≠ 0`, or nothing.
fn with_assumptions(statement: &Statement) -> String {
    wording::assumptions(statement).map_or_else(String::new, |assumed| format!(" with {assumed}"))
}

/// `, where d ≠ 0,`, or nothing.
fn where_assumptions(statement: &Statement) -> String {
    wording::assumptions(statement).map_or_else(String::new, |assumed| format!(", where {assumed},"))
}

fn decimal(units: &Units, places: u32) -> String {
    wording::mathematics(&spell_decimal(units, places))
}

fn name_of(statement: &Statement, quantity: Quantity) -> String {
    match (quantity, statement.subject()) {
        (Quantity::Ratio, Subject::Patch(patch)) => {
            format!("F/W{}", wording::exponent(patch.surface.degree()))
        }
        _ => "√(x² + y² + z²)".to_owned(),
    }
}

/// What F is; nothing for a radius.
fn meaning_of(statement: &Statement, quantity: Quantity) -> String {
    match (quantity, statement.subject()) {
        (Quantity::Ratio, Subject::Patch(patch)) => {
            format!(", for F = {}", wording::written(&statement.coordinate_ring(), &patch.surface))
        }
        _ => String::new(),
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
