//! The cap of the inscribed cube, the paper's Appendix A, derived; spherical polygons; and spinors, which make exact patches of them.

mod complex;
mod cube_face;
mod exact_patch;
mod polygon;
mod spinor;
mod tiling;

pub use complex::Complex;
pub use cube_face::{CubeFace, GreatCircleArc, Vector, dot};
pub use exact_patch::{Moduli, Split, biquartic, quadrilateral, triangle, without_phase};
pub use polygon::{Polygon, PolygonError, determinant};
pub use spinor::{Point, Spinor, SpinorForm};
pub use tiling::{NamedPolygon, POLYGONS};
