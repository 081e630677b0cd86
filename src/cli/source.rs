//! NAME or FILE: a built-in statement or one of the user's.

use std::path::{Path, PathBuf};

use super::files::read_limited;
use crate::catalogue;
use crate::commands::{Failure, JSON_BYTES, Source};
use crate::control::Control;

/// Finds a built-in statement, or reads a file.
pub(super) fn find(name_or_file: &Path, control: &Control) -> Result<Source, Failure> {
    let built_in = name_or_file.to_str().and_then(catalogue::find).is_some();
    if built_in || !name_or_file.exists() {
        return Source::named(&name_or_file.display().to_string());
    }
    Source::read(name_or_file, &read_limited(name_or_file, JSON_BYTES)?, control)
}

/// What a file calls a statement: a file is meant from where the first one is.
pub(super) fn beside(file: Option<&Path>, name: &str) -> PathBuf {
    let path = file.and_then(Path::parent).map(|folder| folder.join(name));
    path.filter(|path| path.is_file()).unwrap_or_else(|| PathBuf::from(name))
}

/// Where the proof goes unless the user says otherwise.
pub(super) fn default_directory(source: &Source) -> PathBuf {
    Path::new("proofs").join(&source.name)
}
