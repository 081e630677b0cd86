//! What was found: each answer is a page, which is a document for people (printed by `text` and `latex`; another printer is
//! one more file) and data.

mod attempt;
mod audit;
mod audit_data;
pub mod bounds;
mod construction;
mod degrees;
mod expansion;
mod headline;
pub mod json;
pub mod latex;
mod mathematics;
mod net;
mod page;
pub mod pages;
mod refutation;
pub mod rounding;
mod setting;
mod solution;
mod text;
pub mod stopped;
mod undecided;

pub use attempt::Files;
pub use headline::{surface_equation, surface_phrase};
pub use mathematics::Notation;
pub use page::{Page, json, latex, text};
