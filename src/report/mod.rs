//! What was found, as text for people and as data.

mod attempt;
mod audit;
mod audit_data;
pub mod bounds;
pub mod construction;
mod degrees;
mod expansion;
mod headline;
pub mod json;
pub mod latex;
mod mathematics;
mod net;
mod refutation;
pub mod rounding;
mod setting;
mod solution;
pub mod stopped;
mod undecided;

pub use attempt::{Files, describe};
pub use audit::describe_audit;
pub use audit_data::audit as audit_data;
pub use degrees::{Backing, degrees_data, degrees_text, explain};
pub use expansion::describe_expansion;
pub use headline::{surface_equation, surface_phrase};
pub use mathematics::Notation;
pub use net::{describe_net, net_data};
