//! Bernstein forms, control nets and the condition that a patch lies on a surface.

mod arc;
mod bernstein;
mod image;
mod surface_condition;

pub use arc::RationalArc;
pub use bernstein::{BernsteinForm, binomial, value_at};
pub use image::{Image, image};
pub use surface_condition::{surface_condition, surface_condition_within};

/// In which basis a form is expanded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Basis {
    /// uʳ(1−u)^(M−r)·vˢ(1−v)^(N−s): the coefficients `c[r,s]` of certificates.
    Bernstein,
    /// uⁱvʲ: the coefficients `a[i,j]`; a1, …, a16 of the paper (Eq. 10, 11) are those with i, j = 1, …, 4, row by row.
    Monomial,
}
