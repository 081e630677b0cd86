//! The cap over one face of the inscribed cube: the paper's Appendix A, derived; and a patch that covers it exactly.

mod cube_face;
mod spinor;

pub use cube_face::{CubeFace, GreatCircleArc, Vector, dot};
pub use spinor::exact_cap;
