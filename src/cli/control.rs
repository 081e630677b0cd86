//! Long work: Ctrl-C, the clock, and progress on a terminal.

use std::io::{IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use super::outcome::Failure;
use crate::elimination::{Control, Progress};

static CANCELLED: AtomicBool = AtomicBool::new(false);

/// Does the work under a control that listens to Ctrl-C and the clock, and shows progress where that is seen.
pub(super) fn under_control<T>(
    timeout: Option<Duration>,
    work: impl FnOnce(&Control<'_>) -> T,
) -> Result<T, Failure> {
    ctrlc::set_handler(|| CANCELLED.store(true, Ordering::Relaxed)).map_err(Failure::of)?;
    let show = |progress: &Progress| {
        // One line, overwritten: there is no use for it in a file.
        let _ = write!(std::io::stderr().lock(), "\r\x1b[K{progress}");
    };
    let terminal = std::io::stderr().is_terminal();
    let result = work(&Control {
        deadline: timeout.and_then(|timeout| Instant::now().checked_add(timeout)),
        cancelled: Some(&CANCELLED),
        observer: if terminal { Some(&show) } else { None },
    });
    if terminal {
        let _ = write!(std::io::stderr().lock(), "\r\x1b[K");
    }
    Ok(result)
}
