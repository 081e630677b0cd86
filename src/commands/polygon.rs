//! Spherical polygons, by name or by their exact corners.

use super::Failure;
use crate::algebra::{FieldElement, MultiquadraticField, polynomial_from_exact};
use crate::exact::Radicands;
use crate::formats::listing::read_constant;
use crate::geometry::{NamedPolygon, POLYGONS, Polygon, Vector};

/// Names of tilings whose corners lie in no field this program has, and why.
const FIVEFOLD: [&str; 2] = ["rhombic-triacontahedron", "deltoidal-hexecontahedron"];

/// A polygon with its name.
#[derive(Debug, Clone)]
pub struct Shape {
    /// The name.
    pub name: String,
    /// The polygon.
    pub polygon: Polygon,
    /// Where it is from, if it has a tiling.
    pub named: Option<&'static NamedPolygon>,
}

impl Shape {
    /// A built-in polygon.
    ///
    /// # Errors
    /// Where there is none of this name, or none over a field of square roots.
    pub fn named(name: &str) -> Result<Shape, Failure> {
        if FIVEFOLD.contains(&name) {
            return Err(Failure::new(format!(
                "`{name}` has corners on the 5-fold axes of the icosahedron: the triple product of three of them, \
                 √(2(5 + √5))/5, is the same in every position, and no field of square roots of rationals contains it"
            )));
        }
        let Some(named) = NamedPolygon::find(name) else {
            let names: Vec<&str> = POLYGONS.iter().map(|polygon| polygon.name).collect();
            return Err(Failure::new(format!(
                "`{name}` is not the name of a polygon\nbuilt-in: {}; any other by --corners",
                names.join(", ")
            )));
        };
        Ok(Shape { name: name.to_owned(), polygon: named.polygon(), named: Some(named) })
    }

    /// The polygon with these corners on the unit sphere, `x,y,z; x,y,z; …`, over the field with these radicands.
    ///
    /// # Errors
    /// Where they cannot be read, or are not the corners of a polygon.
    pub fn with_corners(text: &str, radicands: &[u32]) -> Result<Shape, Failure> {
        let mut radicands = radicands.to_vec();
        radicands.sort_unstable();
        let trusted =
            Radicands::new(radicands.clone()).map_err(|error| Failure::about("--radicands", error))?;
        let field = MultiquadraticField::new(&radicands);
        let mut corners: Vec<Vector> = Vec::new();
        for (number, point) in (1..).zip(text.split(';')) {
            let entries: Vec<&str> = bare(point.trim()).split(',').collect();
            let [x, y, z] = entries[..] else {
                return Err(Failure::new(format!(
                    "--corners: corner {number} has {} coordinates, expected x,y,z",
                    entries.len()
                )));
            };
            let entry = |text: &str| {
                number_of(text.trim(), field, &trusted)
                    .map_err(|fault| fault.after(&format!("--corners: corner {number}: ")))
            };
            corners.push([entry(x)?, entry(y)?, entry(z)?]);
        }
        let polygon = Polygon::new(corners).map_err(|error| Failure::about("--corners", error))?;
        Ok(Shape { name: "polygon".to_owned(), polygon, named: None })
    }

    /// An exact number of its field, as people write it.
    ///
    /// # Errors
    /// Where it cannot be read.
    pub fn number(&self, text: &str) -> Result<FieldElement, Failure> {
        let field = self.polygon.field();
        let trusted = Radicands::new(field.radicands().to_vec()).map_err(Failure::of)?;
        number_of(text, field, &trusted)
    }
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
fn number_of(text: &str, field: MultiquadraticField, trusted: &Radicands) -> Result<FieldElement, Failure> {
    // The place is that of one line, which is shown.
    let read = read_constant(text, trusted).map_err(|error| {
        let message = error.to_string();
        let place = |c: char| c.is_ascii_digit() || c == ':' || c == ' ';
        Failure::new(message.trim_start_matches(place))
    })?;
    polynomial_from_exact(field, &read)
        .as_constant()
        .ok_or_else(|| Failure::new(format!("`{text}` is not a number")))
}
