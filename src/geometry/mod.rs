//! The cap over one face of the inscribed cube: the paper's Appendix A, derived.

mod cube_face;

pub use cube_face::{CubeFace, GreatCircleArc, Vector, dot};
