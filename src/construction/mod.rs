//! Exact patches of spherical polygons, found, and verified by the checker; and which bidegrees have one.

mod cover;
mod degree;
mod search;
mod system;
mod tiling;

pub use cover::{CoverError, cover};
pub use degree::{Cell, Phase, classify, triple_products};
pub use search::{Construction, How, Refusal, centre_of, construct, elevated};
pub use system::{closing_argument, closing_statement, closing_values};
pub use tiling::{Seam, Tiled, tile};
