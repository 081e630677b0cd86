//! POLYGON or `--corners`: a spherical polygon by name or by its exact corners.

use clap::Args;

use crate::commands::{Failure, Shape};

#[derive(Debug, Args)]
pub(in crate::cli) struct PolygonOptions {
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

impl PolygonOptions {
    pub(in crate::cli) fn shape(&self) -> Result<Shape, Failure> {
        match &self.corners {
            Some(corners) => Shape::with_corners(corners, &self.radicands),
            None => Shape::named(self.polygon.as_deref().unwrap_or("cube")),
        }
    }
}
