//! POLYGON or `--corners`: a spherical polygon by name or by its exact corners.

use clap::Args;

use super::outcome::Failure;
use crate::algebra::{FieldElement, MultiquadraticField, polynomial_from_exact};
use crate::exact::Radicands;
use crate::formats::listing::read_constant;
use crate::geometry::{NamedPolygon, POLYGONS, Polygon, Vector};

/// Names of tilings whose corners lie in no field this program has, and why.
const FIVEFOLD: [&str; 2] = ["rhombic-triacontahedron", "deltoidal-hexecontahedron"];

#[derive(Debug, Args)]
pub(super) struct PolygonOptions {
    /// cube, rhombic-dodecahedron, deltoidal-icositetrahedron or octant [default: cube].
    #[arg(value_name = "POLYGON", conflicts_with = "corners")]
    polygon: Option<String>,
    /// The corners on the unit sphere, in the order of the boundary: "x,y,z; x,y,z; …", exactly, like sqrt(3)/3; four of them, or
    /// three for a triangle.
    #[arg(long, value_name = "POINTS", allow_hyphen_values = true)]
    corners: Option<String>,
    /// The primes whose square roots are in the field of --corners; more of them allow nicer nets.
    #[arg(long, value_name = "PRIMES", default_value = "2,3", value_delimiter = ',', requires = "corners")]
    radicands: Vec<u32>,
}

/// A polygon with its name.
pub(super) struct Shape {
    pub(super) name: String,
    pub(super) polygon: Polygon,
    /// Where it is from, if it has a tiling.
    pub(super) named: Option<&'static NamedPolygon>,
}

impl Shape {
    pub(super) fn find(options: &PolygonOptions) -> Result<Shape, Failure> {
        if let Some(corners) = &options.corners {
            let polygon = read(corners, &options.radicands)?;
            return Ok(Shape { name: "polygon".to_owned(), polygon, named: None });
        }
        let name = options.polygon.as_deref().unwrap_or("cube");
        if FIVEFOLD.contains(&name) {
            return Err(Failure(format!(
                "`{name}` has corners on the 5-fold axes of the icosahedron: the triple product of three of them, \
                 √(2(5 + √5))/5, is the same in every position, and no field of square roots of rationals contains it"
            )));
        }
        let Some(named) = NamedPolygon::find(name) else {
            let names: Vec<&str> = POLYGONS.iter().map(|polygon| polygon.name).collect();
            return Err(Failure(format!(
                "`{name}` is not the name of a polygon\nbuilt-in: {}; any other by --corners",
                names.join(", ")
            )));
        };
        Ok(Shape { name: name.to_owned(), polygon: named.polygon(), named: Some(named) })
    }
}

fn read(text: &str, radicands: &[u32]) -> Result<Polygon, Failure> {
    let mut radicands = radicands.to_vec();
    radicands.sort_unstable();
    let trusted =
        Radicands::new(radicands.clone()).map_err(|error| Failure(format!("--radicands: {error}")))?;
    let field = MultiquadraticField::new(&radicands);
    let mut corners: Vec<Vector> = Vec::new();
    for (number, point) in (1..).zip(text.split(';')) {
        let entries: Vec<&str> = bare(point.trim()).split(',').collect();
        let [x, y, z] = entries[..] else {
            return Err(Failure(format!(
                "--corners: corner {number} has {} coordinates, expected x,y,z",
                entries.len()
            )));
        };
        let mut corner = Vec::with_capacity(3);
        for entry in [x, y, z] {
            corner.push(
                number_of(entry.trim(), field, &trusted)
                    .map_err(|Failure(fault)| Failure(format!("--corners: corner {number}: {fault}")))?,
            );
        }
        corners.push(corner.try_into().expect("three coordinates"));
    }
    Polygon::new(corners).map_err(|error| Failure(format!("--corners: {error}")))
}

/// A corner without the brackets it is printed in, `(x, y, z)`.
fn bare(point: &str) -> &str {
    let Some(inside) = point.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')) else { return point };
    // In (x+1)/2, y, (z) the first bracket is closed before the end.
    let depths = inside.chars().scan(0i32, |depth, c| {
        *depth += i32::from(c == '(') - i32::from(c == ')');
        Some(*depth)
    });
    if depths.min().is_some_and(|least| least < 0) { point } else { inside }
}

/// An exact number of the field.
pub(super) fn number_of(
    text: &str,
    field: MultiquadraticField,
    trusted: &Radicands,
) -> Result<FieldElement, Failure> {
    // The place is that of one line, which is shown.
    let read = read_constant(text, trusted).map_err(|error| {
        let message = error.to_string();
        let place = |c: char| c.is_ascii_digit() || c == ':' || c == ' ';
        Failure(message.trim_start_matches(place).to_owned())
    })?;
    polynomial_from_exact(field, &read)
        .as_constant()
        .ok_or_else(|| Failure(format!("`{text}` is not a number")))
}
