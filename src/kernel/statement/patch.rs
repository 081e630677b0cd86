//! The part of a statement file that describes a patch: convention, bidegree, surface, net.

use super::document::{Document, Value, array, integer, string};
use super::error::StatementFault;
use super::expression::{Scope, check_digits, evaluate};
use super::source::Located;
use super::{HomogeneousPoint, Patch};
use crate::exact::{Monomial, Polynomial, Work, limits};

/// The surface of a statement that names none: the unit sphere.
pub const UNIT_SPHERE: &str = "X^2 + Y^2 + Z^2 - W^2";

/// How the four numbers of a control point are meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Convention {
    /// x, y, z and the weight w: the homogeneous point is (wx, wy, wz, w).
    Cartesian,
    /// X, Y, Z, W as they are.
    Homogeneous,
}

impl Convention {
    const BOTH: &'static str =
        "\"cartesian\" (point x, y, z and weight w) or \"homogeneous\" (premultiplied wx, wy, wz, w)";

    /// The convention a word stands for.
    pub fn read(word: &str) -> Option<Self> {
        match word {
            "cartesian" => Some(Convention::Cartesian),
            "homogeneous" => Some(Convention::Homogeneous),
            _ => None,
        }
    }

    /// The word for it.
    pub fn word(self) -> &'static str {
        match self {
            Convention::Cartesian => "cartesian",
            Convention::Homogeneous => "homogeneous",
        }
    }

    /// The other one.
    #[must_use]
    pub fn other(self) -> Self {
        match self {
            Convention::Cartesian => Convention::Homogeneous,
            Convention::Homogeneous => Convention::Cartesian,
        }
    }

    /// The names of the four numbers.
    pub fn names(self) -> [&'static str; 4] {
        match self {
            Convention::Cartesian => ["x", "y", "z", "w"],
            Convention::Homogeneous => ["X", "Y", "Z", "W"],
        }
    }

    fn entries(self) -> &'static str {
        match self {
            Convention::Cartesian => "4: x, y, z and the weight w",
            Convention::Homogeneous => "4: wx, wy, wz, w",
        }
    }
}

pub(super) fn read_patch<'a>(
    document: &Document<'a>,
    scope: &Scope<'_>,
    surface_scope: &Scope<'_>,
    work: &mut Work,
) -> Result<Patch, Located> {
    let net_value =
        document.required("net", "the rows of control points (or `polynomials` for a bare system)")?;
    let value = document.required("convention", Convention::BOTH)?;
    let word = string(value, Convention::BOTH)?;
    let convention = Convention::read(word).ok_or_else(|| {
        let shown = word.chars().take(limits::NAME).collect::<String>().escape_debug().to_string();
        (StatementFault::Convention(shown), value.span())
    })?;
    let bidegree = read_bidegree(document)?;
    let surface = match document.optional("surface") {
        Some(value) => {
            let surface = document.expression(value, surface_scope, work)?;
            check_surface(&surface).map_err(|fault| (fault, value.span()))?;
            surface
        }
        None => evaluate(UNIT_SPHERE, surface_scope, work)?,
    };

    let rows = array(net_value, "a list of rows")?;
    let (expected_rows, expected_columns) =
        (u64::from(bidegree.0).saturating_add(1), u64::from(bidegree.1).saturating_add(1));
    if !matches(rows.len(), expected_rows) {
        return Err((StatementFault::Rows { expected: expected_rows, found: rows.len() }, net_value.span()));
    }
    let mut net = Vec::with_capacity(rows.len());
    for (row, row_value) in rows.iter().enumerate() {
        let points = array(row_value, "a row of control points")?;
        if !matches(points.len(), expected_columns) {
            let fault = StatementFault::Columns { row, expected: expected_columns, found: points.len() };
            return Err((fault, row_value.span()));
        }
        let read = |point: &Value<'a>| read_point(document, point, convention, scope, work);
        net.push(points.iter().map(read).collect::<Result<Vec<_>, _>>()?);
    }
    let no_denominator = net.iter().flatten().all(|[.., weight]: &HomogeneousPoint| weight.is_zero());
    if no_denominator {
        return Err((StatementFault::NoDenominator, net_value.span()));
    }
    Ok(Patch { bidegree, surface, net })
}

fn matches(found: usize, expected: u64) -> bool {
    u64::try_from(found) == Ok(expected)
}

fn read_bidegree(document: &Document<'_>) -> Result<(u32, u32), Located> {
    let value = document.required("bidegree", "[m, n], the degrees in u and v")?;
    match array(value, "[m, n]")? {
        [m, n] => Ok((
            integer(m, "the degree in u", 1, limits::BIDEGREE)?,
            integer(n, "the degree in v", 1, limits::BIDEGREE)?,
        )),
        _ => Err((
            StatementFault::WrongType { expected: "[m, n]", found: "a list of another length" },
            value.span(),
        )),
    }
}

fn check_surface(surface: &Polynomial) -> Result<(), StatementFault> {
    let degree = surface.degree();
    if degree == 0 {
        return Err(StatementFault::NoSurface);
    }
    if degree > limits::SURFACE_DEGREE {
        let found = degree.to_string();
        return Err(StatementFault::Range {
            what: "the degree of the surface",
            at_least: 1,
            at_most: limits::SURFACE_DEGREE,
            found,
        });
    }
    let mut degrees = surface.terms().map(|(monomial, _)| Monomial::degree(monomial));
    match degrees.find(|&other| other != degree) {
        Some(other) => Err(StatementFault::NotHomogeneous { degree, other }),
        None => Ok(()),
    }
}

fn read_point<'a>(
    document: &Document<'a>,
    value: &Value<'a>,
    convention: Convention,
    scope: &Scope<'_>,
    work: &mut Work,
) -> Result<HomogeneousPoint, Located> {
    let [x, y, z, w] = array(value, "a control point [x, y, z, w]")? else {
        let found = array(value, "a control point")?.len();
        return Err((StatementFault::Entries { expected: convention.entries(), found }, value.span()));
    };
    let weight = document.expression(w, scope, work)?;
    let mut coordinate = |entry: &Value<'a>| {
        let plain = document.expression(entry, scope, work)?;
        match convention {
            Convention::Homogeneous => Ok(plain),
            Convention::Cartesian => {
                let product = plain.multiply(&weight, scope.field, work);
                let checked = product.and_then(|product| check_digits(&product).map(|()| product));
                checked.map_err(|limit| (limit.into(), entry.span()))
            }
        }
    };
    Ok([coordinate(x)?, coordinate(y)?, coordinate(z)?, weight])
}
