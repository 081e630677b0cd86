//! Bernstein forms, control nets and the condition that a patch lies on a surface.

mod arc;
mod bernstein;
mod subdivision;
mod surface_condition;

pub use arc::RationalArc;
pub use bernstein::{BernsteinForm, binomial};
pub use subdivision::{SignOnSquare, sign_on_square, value_at};
pub use surface_condition::surface_condition;
