//! What `audit` takes.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::limits::Limits;
use crate::commands::{Failure, FileKind};
use crate::formats::net::Convention;

#[derive(Debug, Args)]
pub(in crate::cli) struct AuditOptions {
    /// A listing of formulas (.tex, .txt, .toml), or a control net (a statement without unknowns, by name or .toml;
    /// .json; .m) [default: the paper's Eq. 11].
    #[arg(value_name = "NAME|FILE")]
    pub(in crate::cli) file: Option<PathBuf>,
    /// What a listing is held against: a built-in statement (see `list`) or a statement file.
    #[arg(long, value_name = "NAME|FILE")]
    pub(in crate::cli) statement: Option<PathBuf>,
    /// How the file is to be read, where its ending does not tell.
    #[arg(long = "as", value_enum, value_name = "KIND")]
    pub(in crate::cli) kind: Option<KindName>,
    /// What a name of the listing means in the statement, as in w_{11}=w; may be repeated.
    #[arg(long = "name", value_name = "NAME=EXPRESSION")]
    pub(in crate::cli) names: Vec<String>,
    /// Which coefficient a label names, as in a_{14}=4,2; may be repeated.
    #[arg(long = "label", value_name = "LABEL=I,J")]
    pub(in crate::cli) labels: Vec<String>,
    /// How the points of a net are given; needed for .m files, which do not say.
    #[arg(long, value_enum)]
    pub(in crate::cli) convention: Option<ConventionName>,
    /// The surface that a net is held against [default: what the file says, or the unit sphere].
    #[arg(long, value_name = "POLYNOMIAL")]
    pub(in crate::cli) surface: Option<String>,
    #[command(flatten)]
    pub(in crate::cli) limits: Limits,
}

impl AuditOptions {
    /// What is for nets only is not given.
    pub(in crate::cli) fn fit_a_listing(&self) -> Result<(), Failure> {
        match self.convention.is_some() || self.surface.is_some() {
            true => {
                Err(Failure::new("--convention and --surface are for nets; this is a listing of formulas"))
            }
            false => Ok(()),
        }
    }

    /// What is for listings only is not given.
    pub(in crate::cli) fn fit_a_net(&self) -> Result<(), Failure> {
        match self.statement.is_some() || !self.names.is_empty() || !self.labels.is_empty() {
            true => Err(Failure::new(
                "--statement, --name and --label are for listings of formulas; this is a net",
            )),
            false => Ok(()),
        }
    }
}

/// What a file to be audited is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum KindName {
    /// Formulas in LaTeX.
    Latex,
    /// Formulas in plain text.
    Plain,
    /// A listing or a net in TOML.
    Toml,
    /// A net in JSON.
    Json,
    /// A net in MATLAB's notation.
    Matlab,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum ConventionName {
    /// x, y, z and the weight w.
    Cartesian,
    /// X, Y, Z, W, premultiplied.
    Homogeneous,
}

impl From<KindName> for FileKind {
    fn from(name: KindName) -> Self {
        match name {
            KindName::Latex => FileKind::Latex,
            KindName::Plain => FileKind::Plain,
            KindName::Toml => FileKind::Toml,
            KindName::Json => FileKind::Json,
            KindName::Matlab => FileKind::Matlab,
        }
    }
}

impl From<ConventionName> for Convention {
    fn from(name: ConventionName) -> Self {
        match name {
            ConventionName::Cartesian => Convention::Cartesian,
            ConventionName::Homogeneous => Convention::Homogeneous,
        }
    }
}
