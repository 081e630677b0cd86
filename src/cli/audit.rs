//! `prove-cap audit [FILE]`: a printed listing, or a printed net, against the truth.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::arguments::{Format, to_json};
use super::check::read_limited;
use super::control::{Limits, under_control};
use super::outcome::{Failure, Outcome};
use super::source::{JSON_BYTES, Source};
use crate::audit::net::{Convention, NetAudit, PrintedNet, from_json, from_matlab};
use crate::audit::{Audit, AuditError, PAPER};
use crate::commands::Verdict;
use crate::control::Control;
use crate::exact::Ring;
use crate::listing::{LISTING_BYTES, Listing, Notation, decode, in_statement_language, is_expansion, is_net};
use crate::report::stopped::stopped_by;
use crate::report::{audit_data, describe_audit, describe_net, latex, net_data};
use crate::statement::COORDINATES;

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
    kind: Option<FileKind>,
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
enum FileKind {
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

/// What was read.
enum Printed {
    /// With the statement that is in the same file, if so.
    Listing(Box<Listing>, Option<Box<Source>>),
    Net(PrintedNet),
}

pub(super) fn run(options: &AuditOptions, format: Format) -> Result<Outcome, Failure> {
    let name = place(options);
    under_control(&options.limits, (&name, format), |control| carried_out(options, format, control))
}

fn carried_out(options: &AuditOptions, format: Format, control: &Control) -> Result<Outcome, Failure> {
    let printed = match &options.file {
        None => Printed::Listing(Box::new(Listing::from_toml(PAPER).map_err(Failure::of)?), None),
        Some(file) => read(file, options)?,
    };
    match printed {
        Printed::Listing(listing, source) => {
            audit_listing(*listing, source.map(|source| *source), options, (format, control))
        }
        Printed::Net(net) => audit_net(net, options, (format, control)),
    }
}

fn place(options: &AuditOptions) -> String {
    options.file.as_deref().map_or_else(|| "the paper's listing".into(), |file| file.display().to_string())
}

/// An audit that was interrupted, or that the checker cannot follow, has no verdict; any other error is one.
fn stopped(options: &AuditOptions, error: AuditError, format: Format) -> Result<Outcome, Failure> {
    let (reason, why) = match error {
        AuditError::Interrupted(why) => (format!("the audit was stopped: {why}"), Some(stopped_by(why.why))),
        error @ AuditError::TooLarge(_) => (format!("{}: {error}", place(options)), None),
        other => return Err(failure(options, &other)),
    };
    let text = match format {
        Format::Json => to_json(
            &serde_json::json!({ "verdict": "UNDECIDED", "name": place(options), "reason": reason, "stopped": why }),
        )?,
        Format::Text | Format::Latex => format!("UNDECIDED  {reason}\n"),
    };
    Ok(Outcome { text, verdict: Verdict::Undecided })
}

fn failure(options: &AuditOptions, error: &AuditError) -> Failure {
    let space = if matches!(error, AuditError::Listing(_)) { "" } else { " " };
    Failure(format!("{}:{space}{error}", place(options)))
}

fn audit_listing(
    mut listing: Listing,
    own: Option<Source>,
    options: &AuditOptions,
    (format, control): (Format, &Control),
) -> Result<Outcome, Failure> {
    if options.convention.is_some() || options.surface.is_some() {
        return Err(Failure(
            "--convention and --surface are for nets; this is a listing of formulas".to_owned(),
        ));
    }
    for mapping in &options.names {
        listing.map_name(mapping).map_err(|error| Failure(format!("--name: {error}")))?;
    }
    for mapping in &options.labels {
        listing.map_label(mapping).map_err(|error| Failure(format!("--label: {error}")))?;
    }
    let named = options.statement.clone().or_else(|| {
        let name = listing.statement.as_deref()?;
        // A file is meant from where the listing is.
        let beside = options.file.as_deref().and_then(Path::parent).map(|folder| folder.join(name));
        Some(beside.filter(|path| path.is_file()).unwrap_or_else(|| PathBuf::from(name)))
    });
    let source = match (named, own) {
        (Some(named), _) => Source::find_within(&named, control)?,
        (None, Some(own)) => own,
        (None, None) => {
            return Err(Failure(
                "what is the listing to be held against? name a statement with --statement (see `list`)"
                    .to_owned(),
            ));
        }
    };
    let audit = match Audit::of(&listing, &source.statement, control) {
        Ok(audit) => audit,
        Err(error) => return stopped(options, error, format),
    };
    let text = match format {
        Format::Text => describe_audit(&listing, &source.name, &source.statement, &audit),
        Format::Json => to_json(&audit_data(&listing, &source.name, &source.statement, &audit))?,
        Format::Latex => latex::audit(&listing, &source.name, &source.statement, &audit),
    };
    Ok(Outcome { text, verdict: audit.verdict().into() })
}

fn audit_net(
    mut net: PrintedNet,
    options: &AuditOptions,
    (format, control): (Format, &Control),
) -> Result<Outcome, Failure> {
    if options.statement.is_some() || !options.names.is_empty() || !options.labels.is_empty() {
        return Err(Failure(
            "--statement, --name and --label are for listings of formulas; this is a net".to_owned(),
        ));
    }
    if let Some(surface) = &options.surface {
        let ring = Ring { field: net.field.clone(), variables: COORDINATES.map(String::from).to_vec() };
        let surface = in_statement_language(surface, &ring);
        let surface = surface.map_err(|error| Failure(format!("--surface: {}", error.fault)))?;
        net.surface = Some(surface.into_owned());
    }
    let audit = match NetAudit::of(&net, control) {
        Ok(audit) => audit,
        Err(error) => return stopped(options, error, format),
    };
    let text = match format {
        Format::Text => describe_net(&net, &audit).map_err(Failure::of)?,
        Format::Json => to_json(&net_data(&net, &audit))?,
        Format::Latex => return Err(Failure("--format latex is for listings of formulas".to_owned())),
    };
    Ok(Outcome { text, verdict: if audit.agrees { Verdict::Agrees } else { Verdict::Differs } })
}

fn read(file: &Path, options: &AuditOptions) -> Result<Printed, Failure> {
    let stated = options.convention.map(|name| match name {
        ConventionName::Cartesian => Convention::Cartesian,
        ConventionName::Homogeneous => Convention::Homogeneous,
    });
    if !file.exists() {
        let source = Source::find(file)?;
        return net_of(&source, options, stated);
    }
    let ending = file.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    let kind = options.kind.or(match ending {
        "tex" | "latex" => Some(FileKind::Latex),
        "txt" => Some(FileKind::Plain),
        "toml" => Some(FileKind::Toml),
        "json" => Some(FileKind::Json),
        "m" => Some(FileKind::Matlab),
        _ => None,
    });
    let Some(kind) = kind else {
        return Err(Failure(format!(
            "{}: a listing or a net, in which notation? say so with --as, or by the ending .tex, .txt, .toml, .json or .m",
            file.display()
        )));
    };
    let in_file = |error: &dyn std::fmt::Display| Failure(format!("{}:{error}", file.display()));
    let at_most = if kind == FileKind::Json { JSON_BYTES } else { LISTING_BYTES };
    let bytes = read_limited(file, at_most)?;
    let text = decode(&bytes, at_most).map_err(|error| in_file(&error))?;
    let title = file.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let listing = match kind {
        FileKind::Latex => Listing::from_formulas(&title, text, Notation::Latex),
        FileKind::Plain => Listing::from_formulas(&title, text, Notation::Plain),
        FileKind::Toml if is_net(text) => return net_of(&Source::find(file)?, options, stated),
        FileKind::Toml => Listing::from_toml(text),
        FileKind::Json if is_expansion(text) => {
            let listing = Listing::from_json(text).map_err(|error| in_file(&error))?;
            let own = Source::from_json(file, text)?;
            return Ok(Printed::Listing(Box::new(listing), Some(Box::new(own))));
        }
        FileKind::Json => {
            let net = from_json(text).map_err(|error| failure(options, &error))?;
            let convention = stated.unwrap_or(net.convention);
            return Ok(Printed::Net(PrintedNet { convention, ..net }));
        }
        FileKind::Matlab => {
            let Some(convention) = stated else {
                return Err(Failure(format!(
                    "{}: are the points premultiplied by their weights? MATLAB files do not say: add \
                     --convention homogeneous (premultiplied) or --convention cartesian",
                    file.display()
                )));
            };
            let net = from_matlab(text, &title, convention).map_err(|error| failure(options, &error))?;
            return Ok(Printed::Net(net));
        }
    };
    listing.map(|listing| Printed::Listing(Box::new(listing), None)).map_err(|error| in_file(&error))
}

/// The net of a statement; it says itself which convention it follows.
fn net_of(source: &Source, options: &AuditOptions, stated: Option<Convention>) -> Result<Printed, Failure> {
    if stated.is_some() {
        return Err(Failure("a statement says itself which convention it follows".to_owned()));
    }
    let convention = crate::listing::convention_word(&source.text).and_then(|word| Convention::read(&word));
    let convention = convention.unwrap_or(Convention::Homogeneous);
    PrintedNet::from_statement(&source.statement, convention)
        .map(Printed::Net)
        .map_err(|error| failure(options, &error))
}
