//! `prove-cap audit [FILE]`: a printed listing, or a printed net, against the truth.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::arguments::{Format, to_json};
use super::check::read_limited;
use super::outcome::{Failure, Outcome, Status};
use super::source::Source;
use crate::audit::{Audit, PAPER};
use crate::elimination::Control;
use crate::listing::{LISTING_BYTES, Listing, Notation, decode};
use crate::report::{audit_data, describe_audit, latex};

#[derive(Debug, Args)]
pub(super) struct AuditOptions {
    /// A listing (.toml, .tex or plain text) or a control net (a statement without unknowns, .json or .m)
    /// [default: the paper's Eq. 11].
    file: Option<PathBuf>,
    /// What to hold it against: a built-in statement (see `list`) or a statement file.
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
}

/// What a file to be audited is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum FileKind {
    /// Formulas in LaTeX.
    Latex,
    /// Formulas in plain text.
    Plain,
    /// A listing file.
    Listing,
}

pub(super) fn run(options: &AuditOptions, format: Format) -> Result<Outcome, Failure> {
    let mut listing = match &options.file {
        None => Listing::from_toml(PAPER).map_err(Failure::of)?,
        Some(file) => read(file, options.kind)?,
    };
    for mapping in &options.names {
        listing.map_name(mapping).map_err(|error| Failure(format!("--name {mapping}: {error}")))?;
    }
    for mapping in &options.labels {
        listing.map_label(mapping).map_err(|error| Failure(format!("--label {mapping}: {error}")))?;
    }
    let named = options.statement.clone().or_else(|| {
        let name = listing.statement.as_deref()?;
        // A file is meant from where the listing is.
        let beside = options.file.as_deref().and_then(Path::parent).map(|folder| folder.join(name));
        Some(beside.filter(|path| path.is_file()).unwrap_or_else(|| PathBuf::from(name)))
    });
    let Some(named) = named else {
        return Err(Failure(
            "what is the listing to be held against? name a statement with --statement (see `list`)".to_owned(),
        ));
    };
    let source = Source::find(&named)?;
    let place = options.file.as_deref().map_or_else(|| "the paper's listing".into(), |f| f.display().to_string());
    let audit = Audit::of(&listing, &source.statement, &Control::default())
        .map_err(|error| Failure(format!("{place}:{error}")))?;
    let text = match format {
        Format::Text => describe_audit(&listing, &source.name, &source.statement, &audit),
        Format::Json => to_json(&audit_data(&listing, &source.name, &source.statement, &audit))?,
        Format::Latex => latex::audit(&listing, &source.name, &source.statement, &audit),
    };
    let status = if audit.agrees() { Status::Established } else { Status::Wrong };
    Ok(Outcome { text, status })
}

fn read(file: &Path, kind: Option<FileKind>) -> Result<Listing, Failure> {
    let kind = kind.or_else(|| match file.extension()?.to_str()? {
        "tex" | "latex" => Some(FileKind::Latex),
        "txt" => Some(FileKind::Plain),
        "toml" => Some(FileKind::Listing),
        _ => None,
    });
    let Some(kind) = kind else {
        return Err(Failure(format!(
            "{}: LaTeX, plain text or a listing file? say so with --as, or by the ending .tex, .txt or .toml",
            file.display()
        )));
    };
    let bytes = read_limited(file, LISTING_BYTES)?;
    let title = file.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let listing = decode(&bytes).and_then(|text| match kind {
        FileKind::Latex => Listing::from_formulas(&title, text, Notation::Latex),
        FileKind::Plain => Listing::from_formulas(&title, text, Notation::Plain),
        FileKind::Listing => Listing::from_toml(text),
    });
    listing.map_err(|error| Failure(format!("{}:{error}", file.display())))
}
