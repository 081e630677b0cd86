//! Statement and certificate on disk.

use std::fs::{self, File, TryLockError};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Duration;

use prove_cap_kernel::command::{self, examine_within};

use super::outcome::Ended;
use super::source::default_directory;
use crate::commands::{Failure, Source, Undecided};
use crate::control::{Control, Interrupted};
use crate::exact::Work;
use crate::report::Files;
use crate::report::pages::Unchecked;
use crate::statement::Statement;

/// How often it is looked whether another run is done with a directory.
const LOOK: Duration = Duration::from_millis(5);

/// Reads a file, but not more than one byte beyond its limit.
pub(super) fn read_limited(file: &Path, limit: u64) -> Result<Vec<u8>, Failure> {
    command::read_limited(file, limit).map_err(|failure| Failure::from(failure).of_file(file))
}

/// Writes a statement and its certificate, and lets the independent checker judge the bytes that are on disk.
pub(super) fn write_and_check(
    source: &Source,
    directory: Option<&Path>,
    (certificate, name): (&str, &str),
    control: &Control,
) -> Result<Files, Ended> {
    let directory = match directory {
        Some(directory) => directory.to_path_buf(),
        None => vacant(default_directory(source), &source.statement)?,
    };
    write_pair(&directory, (&source.name, &source.text), (certificate, name), control)
}

/// Writes a statement and a certificate into a directory that holds no other statement, and lets the checker judge them.
///
/// Runs that write into one directory do so one after another, so that no pair is mixed: the last one's files remain.
/// The statement first: whoever looks in between sees the new statement beside an old certificate, which names another
/// statement and is refused for that.
pub(super) fn write_pair(
    directory: &Path,
    (name, statement): (&str, &str),
    (certificate, file): (&str, &str),
    control: &Control,
) -> Result<Files, Ended> {
    fs::create_dir_all(directory)
        .map_err(|error| Failure::in_file(directory, format!("cannot be created: {error}")))?;
    let files = Files { statement: directory.join("statement.toml"), certificate: directory.join(file) };
    let _alone = alone_in(directory, control).map_err(|why| Undecided::stopped(name, why))?;
    write_atomically(&files.statement, statement.as_bytes())?;
    write_atomically(&files.certificate, certificate.as_bytes())?;
    match examine_within(&files.statement, &files.certificate, &mut control.work()) {
        Ok(Ok(_)) => Ok(files),
        Ok(Err(rejection)) => {
            Err(Failure::new(format!("the checker refuses the files just written: {rejection}")).into())
        }
        Err(failure) => Err(match control.check() {
            Ok(()) => Failure::from(failure).into(),
            Err(why) => Ended::Unchecked(Box::new(Unchecked { name: name.to_owned(), why, files })),
        }),
    }
}

/// Waits until no other run writes into the directory. Where the system cannot lock one, nothing is waited for.
fn alone_in(directory: &Path, control: &Control) -> Result<Option<File>, Interrupted> {
    let Ok(opened) = File::open(directory) else { return Ok(None) };
    loop {
        match opened.try_lock() {
            Err(TryLockError::WouldBlock) => control.check()?,
            Ok(()) | Err(TryLockError::Error(_)) => return Ok(Some(opened)),
        }
        std::thread::sleep(LOOK);
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
            let fault = "holds another statement; name a directory with -o";
            Err(Failure::new(format!("{} {fault}", present.display())))
        }
        _ => Ok(directory),
    }
}

/// To a temporary file beside the target, then renamed: whoever looks sees the old file or the new one.
pub(super) fn write_atomically(target: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let cannot = |error: std::io::Error| Failure::in_file(target, format!("cannot be written: {error}"));
    // What a link points to is replaced, not the link; a device or a directory is not replaced at all.
    if fs::metadata(target).is_ok_and(|present| !present.is_file()) {
        return Err(Failure::in_file(target, "cannot be written: it is not a regular file"));
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
