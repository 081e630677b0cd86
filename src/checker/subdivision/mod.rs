//! Arguments by subdivision: boxes on each of which the coefficients of a form have one sign.

pub(super) mod bounds;
mod form;
pub(super) mod unreachable;
