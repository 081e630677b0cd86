//! `prove-cap audit [FILE]`: a printed listing, or a printed net, against the truth.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::control::{Limits, under_control};
use super::files::read_limited;
use super::outcome::{Ended, Format, Outcome};
use super::source::find;
use crate::audit::net::Convention;
use crate::commands::{self, Failure, FileKind, Printed, Source};
use crate::control::Control;
use crate::listing::Listing;

#[derive(Debug, Args)]
pub(super) struct AuditOptions {
    /// A listing of formulas (.tex, .txt, .toml), or a control net (a statement without unknowns, by name or .toml;
    /// .json; .m) [default: the paper's Eq. 11].
    #[arg(value_name = "NAME|FILE")]
    file: Option<PathBuf>,
    /// What a listing is held against: a built-in statement (see `list`) or a statement file.
    #[arg(long, value_name = "NAME|FILE")]
    statement: Option<PathBuf>,
    /// How the file is to be read, where its ending does not tell.
    #[arg(long = "as", value_enum, value_name = "KIND")]
    kind: Option<KindName>,
    /// What a name of the listing means in the statement, as in w_{11}=w; may be repeated.
    #[arg(long = "name", value_name = "NAME=EXPRESSION")]
    names: Vec<String>,
    /// Which coefficient a label names, as in a_{14}=4,2; may be repeated.
    #[arg(long = "label", value_name = "LABEL=I,J")]
    labels: Vec<String>,
    /// How the points of a net are given; needed for .m files, which do not say.
    #[arg(long, value_enum)]
    convention: Option<ConventionName>,
    /// The surface that a net is held against [default: what the file says, or the unit sphere].
    #[arg(long, value_name = "POLYNOMIAL")]
    surface: Option<String>,
    #[command(flatten)]
    limits: Limits,
}

/// What a file to be audited is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum KindName {
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
enum ConventionName {
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

pub(super) fn run(options: &AuditOptions, format: Format) -> Result<Outcome, Failure> {
    let place = options.file.as_deref().map(|file| file.display().to_string());
    let place = place.unwrap_or_else(|| "the paper's listing".to_owned());
    under_control(&options.limits, (&place, format), |control| match options.printed(control)? {
        Printed::Listing(listing, own) => {
            let (listing, source) = options.against(*listing, own, control)?;
            let audited = commands::audit_listing(&place, listing, source, control)?;
            Ok(Outcome::of(&audited, format)?)
        }
        Printed::Net(net) => {
            let surface = options.surface()?;
            let audited = commands::audit_net(&place, net, surface, control)?;
            Ok(Outcome::of(&audited, format)?)
        }
    })
}

impl AuditOptions {
    /// What is to be audited.
    fn printed(&self, control: &Control) -> Result<Printed, Failure> {
        let Some(file) = &self.file else { return Printed::paper() };
        let stated = self.convention.map(|name| match name {
            ConventionName::Cartesian => Convention::Cartesian,
            ConventionName::Homogeneous => Convention::Homogeneous,
        });
        if !file.exists() {
            return Printed::net_of(&file.display().to_string(), &find(file, control)?, stated);
        }
        let kind = self.kind.map_or_else(|| FileKind::of(file), |kind| Ok(kind.into()))?;
        Printed::read(file, kind, &read_limited(file, kind.bytes())?, stated, control)
    }

    /// The listing with the names and labels that were given for it, and the statement that it is held against.
    fn against(
        &self,
        mut listing: Listing,
        own: Option<Box<Source>>,
        control: &Control,
    ) -> Result<(Listing, Source), Ended> {
        if self.convention.is_some() || self.surface.is_some() {
            let fault = "--convention and --surface are for nets; this is a listing of formulas";
            return Err(Failure::new(fault).into());
        }
        for mapping in &self.names {
            listing.map_name(mapping).map_err(|error| Failure::about("--name", error))?;
        }
        for mapping in &self.labels {
            listing.map_label(mapping).map_err(|error| Failure::about("--label", error))?;
        }
        let named = self.statement.clone().or_else(|| {
            let name = listing.statement.as_deref()?;
            // A file is meant from where the listing is.
            let beside = self.file.as_deref().and_then(Path::parent).map(|folder| folder.join(name));
            Some(beside.filter(|path| path.is_file()).unwrap_or_else(|| PathBuf::from(name)))
        });
        let unnamed = || {
            Failure::new(
                "what is the listing to be held against? name a statement with --statement (see `list`)",
            )
        };
        let source = match named {
            Some(named) => find(&named, control)?,
            None => *own.ok_or_else(unnamed)?,
        };
        Ok((listing, source))
    }

    /// The surface that a net is held against, if it is not its own.
    fn surface(&self) -> Result<Option<&str>, Failure> {
        if self.statement.is_some() || !self.names.is_empty() || !self.labels.is_empty() {
            let fault = "--statement, --name and --label are for listings of formulas; this is a net";
            return Err(Failure::new(fault));
        }
        Ok(self.surface.as_deref())
    }
}
