//! A statement with where it came from: built in, or the text of a file.

use std::path::Path;

use super::Failure;
use crate::catalogue;
use crate::control::Control;
use crate::exact::Work;
use crate::formats::net::statement_from_json;
use crate::statement::Statement;

/// A statement with where it came from.
#[derive(Debug, Clone)]
pub struct Source {
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
    /// A built-in statement, or one of a family.
    ///
    /// # Errors
    /// Where nothing has this name.
    pub fn named(name: &str) -> Result<Source, Failure> {
        let (text, cap) = match (catalogue::find(name), catalogue::cap(name)) {
            (Some(entry), _) => (entry.statement(), entry.is_cap()),
            (None, Some(cap)) => (cap.map_err(Failure::new)?.statement(), true),
            (None, None) => {
                let names: Vec<&str> = catalogue::ENTRIES.iter().map(|entry| entry.name).collect();
                return Err(Failure::new(format!(
                    "`{name}` is neither a file nor a built-in statement\nbuilt-in: {}; and all {}",
                    names.join(", "),
                    catalogue::FAMILY
                )));
            }
        };
        let statement = Statement::read(&text).map_err(|error| Failure::at(name, &error))?;
        Ok(Source { name: name.to_owned(), text, statement, cap })
    }

    /// The bytes of a file: a statement in TOML, or a document of this program in JSON.
    ///
    /// # Errors
    /// Where they cannot be read.
    pub fn read(file: &Path, bytes: &[u8], control: &Control) -> Result<Source, Failure> {
        if let Some(json) = as_json(bytes) {
            return Source::from_json(file, json);
        }
        let statement = Statement::read_bytes(bytes, &mut control.work())
            .map_err(|error| Failure::at(file.display(), &error))?;
        let text = String::from_utf8_lossy(bytes).into_owned();
        Ok(Source { name: name_of(file), text, statement, cap: false })
    }

    /// The net of a JSON document, or the statement it is about.
    ///
    /// # Errors
    /// Where it has none.
    pub fn from_json(file: &Path, json: &str) -> Result<Source, Failure> {
        let text = statement_from_json(json).map_err(|error| Failure::in_file(file, error))?;
        let statement = Statement::read_bytes(text.as_bytes(), &mut Work::full())
            .map_err(|error| Failure::in_file(file, error.fault))?;
        Ok(Source { name: name_of(file), text, statement, cap: false })
    }

    /// The same statement over a larger field: its text with these radicands.
    ///
    /// # Errors
    /// Where that is no statement.
    pub fn with_radicands(&self, radicands: &[u32]) -> Result<Source, Failure> {
        let document =
            toml::de::DeTable::parse(&self.text).map_err(|error| Failure::about(&self.name, error))?;
        let list = format!("{radicands:?}");
        let mut text = self.text.clone();
        match document.get_ref().get("radicands") {
            Some(present) => text.replace_range(present.span(), &list),
            None => text.insert_str(0, &format!("radicands = {list}\n")),
        }
        let statement = Statement::read(&text).map_err(|error| Failure::about(&self.name, error))?;
        Ok(Source { name: self.name.clone(), text, statement, cap: self.cap })
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
