//! Bernstein forms, control nets and the condition that a patch lies on a surface.

mod arc;
mod bernstein;
mod image;
mod surface_condition;

pub use arc::RationalArc;
pub use bernstein::{BernsteinForm, binomial, value_at};
pub use image::{Image, image};
pub use surface_condition::{surface_condition, surface_condition_within};
