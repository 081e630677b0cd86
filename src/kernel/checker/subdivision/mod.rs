//! Arguments by subdivision: boxes on each of which the coefficients of a form have one sign.

pub(super) mod bounds;
pub(super) mod cover;
mod form;
mod scene;
pub(super) mod unreachable;
