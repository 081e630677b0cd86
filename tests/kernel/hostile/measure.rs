//! What a check allocates, beside what it pays.

use std::sync::{Mutex, MutexGuard, PoisonError};

use cap::Cap;
use peak_alloc::PeakAlloc;
use prove_cap_kernel::checker::{CheckError, Theorem, check_within};
use prove_cap_kernel::exact::Work;

/// Counts all that is ever allocated, and the most that is at any one time.
#[global_allocator]
static ALLOCATED: Cap<PeakAlloc> = Cap::new(PEAK, usize::MAX);
static PEAK: PeakAlloc = PeakAlloc;

/// The counts are those of the whole process.
static ALONE: Mutex<()> = Mutex::new(());

/// What a check came to and what it took.
pub(crate) struct Measured {
    pub(crate) result: Result<Theorem, CheckError>,
    /// Units of work.
    pub(crate) units: u64,
    /// Bytes, as the meter counts them.
    pub(crate) held: u64,
    /// Bytes at any one time, as the allocator does.
    pub(crate) peak: u64,
    /// Bytes allocated in all.
    pub(crate) allocated: u64,
}

/// Nothing else is allocated while this is held: every test takes it.
pub(crate) fn alone() -> MutexGuard<'static, ()> {
    ALONE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Checks and prints, within so many units.
pub(crate) fn measured(statement: &[u8], certificate: &[u8], units: u64) -> Measured {
    let mut work = Work::full().at_most(units);
    let before = PEAK.current_usage();
    let allocated = ALLOCATED.total_allocated();
    PEAK.reset_peak_usage();
    let result = check_within(statement, certificate, &mut work);
    // What is printed belongs to it.
    match &result {
        Ok(theorem) => drop((theorem.sentence(), theorem.details())),
        Err(error) => drop(error.to_string()),
    }
    Measured {
        result,
        units: work.spent(),
        held: work.most_held(),
        peak: (PEAK.peak_usage() - before) as u64,
        allocated: (ALLOCATED.total_allocated() - allocated) as u64,
    }
}
