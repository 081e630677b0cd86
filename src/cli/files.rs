//! Statement and certificate on disk.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use super::check::examine;
use super::outcome::Failure;
use super::source::Source;
use crate::exact::Work;
use crate::report::Files;
use crate::statement::Statement;

/// Writes a statement and its certificate, and lets the independent checker judge the bytes that are on disk.
pub(super) fn write_and_check(
    source: &Source,
    directory: Option<&Path>,
    certificate: &str,
    name: &str,
) -> Result<Files, Failure> {
    let directory = match directory {
        Some(directory) => directory.to_path_buf(),
        None => vacant(source.default_directory(), &source.statement)?,
    };
    write_pair(&directory, &source.text, certificate, name)
}

/// Writes a statement and a certificate into a directory that holds no other statement, and lets the checker judge them.
pub(super) fn write_pair(
    directory: &Path,
    statement: &str,
    certificate: &str,
    name: &str,
) -> Result<Files, Failure> {
    fs::create_dir_all(directory)
        .map_err(|error| Failure(format!("{}: cannot be created: {error}", directory.display())))?;
    let files = Files { statement: directory.join("statement.toml"), certificate: directory.join(name) };
    write_atomically(&files.statement, statement.as_bytes())?;
    write_atomically(&files.certificate, certificate.as_bytes())?;
    match examine(&files.statement, &files.certificate)? {
        Ok(_) => Ok(files),
        Err(rejection) => Err(Failure(format!("the checker refuses the files just written: {rejection}"))),
    }
}

/// The name of the file for bounds, which are many for one statement: the hash that seals it, shortened, is in it.
pub(super) fn sealed_name(kind: &str, certificate: &str) -> String {
    let hash = certificate.trim_end().rsplit(' ').next().unwrap_or_default();
    format!("{kind}-{}.txt", hash.get(..8).unwrap_or(hash))
}

/// A directory that the user has not named must not hold the proof of something else.
pub(super) fn vacant(directory: PathBuf, statement: &Statement) -> Result<PathBuf, Failure> {
    let present = directory.join("statement.toml");
    let other =
        fs::read(&present).ok().and_then(|bytes| Statement::read_bytes(&bytes, &mut Work::full()).ok());
    match other {
        Some(other) if other.hash() != statement.hash() => {
            Err(Failure(format!("{} holds another statement; name a directory with -o", present.display())))
        }
        _ => Ok(directory),
    }
}

/// To a temporary file beside the target, then renamed: whoever looks sees the old file or the new one.
pub(super) fn write_atomically(target: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let cannot = |error: std::io::Error| Failure(format!("{}: cannot be written: {error}", target.display()));
    // What a link points to is replaced, not the link; a device or a directory is not replaced at all.
    if fs::metadata(target).is_ok_and(|present| !present.is_file()) {
        return Err(Failure(format!("{}: cannot be written: it is not a regular file", target.display())));
    }
    let resolved = fs::canonicalize(target).unwrap_or_else(|_| target.to_path_buf());
    let target = resolved.as_path();
    let directory = target.parent().filter(|parent| !parent.as_os_str().is_empty());
    let mut builder = tempfile::Builder::new();
    builder.prefix(".prove-cap-").suffix(".tmp");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o644));
    let mut file = builder.tempfile_in(directory.unwrap_or(Path::new("."))).map_err(cannot)?;
    file.write_all(bytes).and_then(|()| file.as_file().sync_all()).map_err(cannot)?;
    file.persist(target).map(|_| ()).map_err(|error| cannot(error.error))
}
