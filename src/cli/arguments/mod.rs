//! The command line: what can be typed. What is done is in the files beside this folder.

use std::path::PathBuf;

use clap::{Parser, Subcommand};

use super::outcome::Format;
use crate::commands::Verdict;

mod approximate;
mod audit;
mod bound;
mod construct;
mod degrees;
mod expand;
mod export;
mod limits;
mod plot;
mod polygon;
mod prove;
mod table;
mod values;

pub(super) use approximate::ApproximateOptions;
pub(super) use audit::AuditOptions;
pub(super) use bound::BoundOptions;
pub(super) use construct::ConstructOptions;
pub(super) use degrees::DegreesOptions;
pub(super) use expand::ExpandOptions;
pub(super) use export::ExportOptions;
pub(super) use limits::Limits;
pub(super) use plot::PlotOptions;
pub(super) use prove::ProveOptions;
pub(super) use table::TableOptions;
pub(super) use values::values;

/// Can this rational Bézier patch lie exactly on that surface, for any values of its unknowns?
///
/// Answers PROVED (impossible, with a certificate), EXACT (with a control net) or UNDECIDED. Without a command it
/// proves the paper's theorem, cap-2x2: no biquadratic rational patch with the paper's edges, and its centre on the axis,
/// represents the spherical cap over one face of the inscribed cube.
#[derive(Debug, Parser)]
#[command(version, max_term_width = 110, args_conflicts_with_subcommands = true)]
#[command(
    after_help = Verdict::summary()
)]
pub(super) struct CommandLine {
    #[command(subcommand)]
    pub(super) command: Option<Command>,
    #[command(flatten)]
    pub(super) options: ProveOptions,
    /// How results are printed.
    #[arg(long, value_enum, default_value_t = Format::Text, global = true)]
    pub(super) format: Format,
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Prove a statement, write its certificate and check it.
    Prove {
        /// A built-in statement (see `list`) or a statement file [default: cap-2x2].
        #[arg(value_name = "NAME|FILE")]
        source: Option<PathBuf>,
        #[command(flatten)]
        options: ProveOptions,
    },
    /// Replay a certificate against a statement with the independent checker.
    Check {
        /// The statement file.
        statement: PathBuf,
        /// The certificate file.
        certificate: PathBuf,
    },
    /// Print the canonical text of a statement, whose SHA-256 certificates name.
    Canonical {
        /// The statement file.
        statement: PathBuf,
    },
    /// Print the coefficients of the condition that the patch lies on the surface.
    Expand(ExpandOptions),
    /// Hold a printed coefficient listing, or a printed control net, against the truth.
    Audit(AuditOptions),
    /// Enclose the radius (of another surface F/Wᵉ) over the whole patch, with a proof, at given values of the unknowns.
    Bound(BoundOptions),
    /// Search for the best values of the unknowns, and enclose the radius there, with a proof.
    Approximate(ApproximateOptions),
    /// The best patches found of the cap, degree by degree, with proved errors, and how six of them fit together.
    Table(TableOptions),
    /// Construct a patch that covers a spherical polygon exactly, and verify it.
    Construct(ConstructOptions),
    /// Which bidegrees cover a spherical polygon exactly, with proofs.
    Degrees(DegreesOptions),
    /// Write the proof in another language: for Coq, for a computer-algebra system.
    Export(ExportOptions),
    /// List the built-in statements.
    List,
}
