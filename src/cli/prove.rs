//! `prove-cap prove [NAME|FILE]`: prove a statement, write statement and certificate, check what was written.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use super::arguments::{Format, to_json};
use super::check::examine;
use super::control::{Limits, under_control};
use super::outcome::{Failure, Outcome, Status};
use super::source::Source;
use crate::exact::Work;
use crate::prove::{Attempt, prove};
use crate::report::{Files, describe, json};
use crate::statement::Statement;

pub(super) fn run(
    name_or_file: &Path,
    directory: Option<&Path>,
    limits: &Limits,
    format: Format,
) -> Result<Outcome, Failure> {
    let source = Source::find(name_or_file)?;
    let attempt = under_control(limits, |control| prove(&source.statement, control))?;
    let attempt = attempt.map_err(Failure::of)?;
    let directory = match directory {
        Some(directory) => directory.to_path_buf(),
        None => vacant(source.default_directory(), &source.statement)?,
    };
    let files = match &attempt {
        Attempt::Proved { certificate, .. } => {
            Some(write_and_check(&directory, &source.text, &certificate.write(&source.statement.ring()))?)
        }
        Attempt::Undecided(_) => None,
    };
    let text = match format {
        Format::Text | Format::Latex => {
            describe(&source.name, &source.statement, source.cap, &attempt, files.as_ref())
                .map_err(Failure::of)?
        }
        Format::Json => {
            let data = json::attempt(&source.name, &source.statement, &attempt, files.as_ref())
                .map_err(Failure::of)?;
            to_json(&data)?
        }
    };
    let status = if files.is_some() { Status::Established } else { Status::Undecided };
    Ok(Outcome { text, status })
}

/// A directory that the user has not named must not hold the proof of something else.
fn vacant(directory: PathBuf, statement: &Statement) -> Result<PathBuf, Failure> {
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

/// Writes both files and lets the independent checker judge the bytes that are on disk.
fn write_and_check(directory: &Path, statement: &str, certificate: &str) -> Result<Files, Failure> {
    fs::create_dir_all(directory)
        .map_err(|error| Failure(format!("{}: cannot be created: {error}", directory.display())))?;
    let files =
        Files { statement: directory.join("statement.toml"), certificate: directory.join("certificate.txt") };
    write_atomically(directory, &files.statement, statement)?;
    write_atomically(directory, &files.certificate, certificate)?;
    match examine(&files.statement, &files.certificate)? {
        Ok(_) => Ok(files),
        Err(rejection) => Err(Failure(format!("the checker refuses the files just written: {rejection}"))),
    }
}

/// To a temporary file beside the target, then renamed: whoever looks sees the old file or the new one.
fn write_atomically(directory: &Path, target: &PathBuf, text: &str) -> Result<(), Failure> {
    let cannot = |error: std::io::Error| Failure(format!("{}: cannot be written: {error}", target.display()));
    let mut builder = tempfile::Builder::new();
    builder.prefix(".prove-cap-").suffix(".tmp");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o644));
    let mut file = builder.tempfile_in(directory).map_err(cannot)?;
    file.write_all(text.as_bytes()).and_then(|()| file.as_file().sync_all()).map_err(cannot)?;
    file.persist(target).map(|_| ()).map_err(|error| cannot(error.error))
}
