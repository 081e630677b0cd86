//! NAME or FILE: a built-in statement or one of the user's.

use std::path::{Path, PathBuf};

use super::check::read_limited;
use super::outcome::Failure;
use crate::catalogue;
use crate::control::Control;
use crate::exact::Work;
use crate::formats::net::statement_from_json;
use crate::statement::Statement;

/// Bytes of a file that may be JSON: what is written for a statement may have its proof beside it.
pub(super) const JSON_BYTES: u64 = 16 << 20;

/// A statement with where it came from.
pub(super) struct Source {
    /// The built-in name, or that of the file.
    pub name: String,
    /// The text of the statement file.
    pub text: String,
    /// The statement.
    pub statement: Statement,
    /// Whether it is a built-in cap.
    pub cap: bool,
}

impl Source {
    /// Finds a built-in statement, or reads a file.
    pub(super) fn find(name_or_file: &Path) -> Result<Source, Failure> {
        Source::find_within(name_or_file, &Control::default())
    }

    /// The same, where reading may be stopped.
    pub(super) fn find_within(name_or_file: &Path, control: &Control) -> Result<Source, Failure> {
        if let Some(entry) = name_or_file.to_str().and_then(catalogue::find) {
            let text = entry.statement();
            let statement =
                Statement::read(&text).map_err(|error| Failure(format!("{}:{error}", entry.name)))?;
            return Ok(Source { name: entry.name.to_owned(), text, statement, cap: entry.is_cap() });
        }
        let family = name_or_file.to_str().filter(|_| !name_or_file.exists());
        if let Some((name, cap)) = family.and_then(|name| Some((name, catalogue::cap(name)?))) {
            let text = cap.map_err(Failure)?.statement();
            let statement = Statement::read(&text).map_err(|error| Failure(format!("{name}:{error}")))?;
            return Ok(Source { name: name.to_owned(), text, statement, cap: true });
        }
        if !name_or_file.exists() {
            let names: Vec<&str> = catalogue::ENTRIES.iter().map(|entry| entry.name).collect();
            return Err(Failure(format!(
                "`{}` is neither a file nor a built-in statement\nbuilt-in: {}; and all {}",
                name_or_file.display(),
                names.join(", "),
                catalogue::FAMILY
            )));
        }
        let bytes = read_limited(name_or_file, JSON_BYTES)?;
        if let Some(json) = as_json(&bytes) {
            return Source::from_json(name_or_file, json);
        }
        let statement = Statement::read_bytes(&bytes, &mut control.work())
            .map_err(|error| Failure(format!("{}:{error}", name_or_file.display())))?;
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let name = name_of(name_or_file);
        Ok(Source { name, text, statement, cap: false })
    }

    /// The net of a JSON document, or the statement it is about.
    pub(super) fn from_json(file: &Path, json: &str) -> Result<Source, Failure> {
        let text =
            statement_from_json(json).map_err(|error| Failure(format!("{}: {error}", file.display())))?;
        let statement = Statement::read_bytes(text.as_bytes(), &mut Work::full())
            .map_err(|error| Failure(format!("{}: {}", file.display(), error.fault)))?;
        Ok(Source { name: name_of(file), text, statement, cap: false })
    }

    /// The same statement over a larger field: its text with these radicands.
    pub(super) fn with_radicands(&self, radicands: &[u32]) -> Result<Source, Failure> {
        let failure = |error: &dyn std::fmt::Display| Failure(format!("{}: {error}", self.name));
        let document = toml::de::DeTable::parse(&self.text).map_err(|error| failure(&error))?;
        let list = format!("{radicands:?}");
        let mut text = self.text.clone();
        match document.get_ref().get("radicands") {
            Some(present) => text.replace_range(present.span(), &list),
            None => text.insert_str(0, &format!("radicands = {list}\n")),
        }
        let statement = Statement::read(&text).map_err(|error| failure(&error))?;
        Ok(Source { name: self.name.clone(), text, statement, cap: self.cap })
    }

    /// Where the proof goes unless the user says otherwise.
    pub(super) fn default_directory(&self) -> PathBuf {
        Path::new("proofs").join(&self.name)
    }
}

/// The text of a file that is JSON and no TOML: its first character tells.
fn as_json(bytes: &[u8]) -> Option<&str> {
    let text = std::str::from_utf8(bytes).ok()?;
    text.trim_start_matches('\u{feff}').trim_start().starts_with('{').then_some(text)
}

/// The file's name without its ending; for `NAME/statement.toml`, as this program writes it, the folder's.
fn name_of(file: &Path) -> String {
    let stem = file.file_stem().filter(|stem| *stem != "statement");
    let folder = file.parent().and_then(Path::file_name);
    stem.or(folder).map_or("statement".into(), |name| name.to_string_lossy().into_owned())
}
