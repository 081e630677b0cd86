//! Stopping and watching long work.

use std::fmt;
use std::sync::atomic::{AtomicU8, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Instant;

use crate::exact::Work;

/// Why work stopped before its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Why {
    /// The time allowed is over.
    Time,
    /// The user asked.
    Interrupt,
    /// The memory allowed is used up.
    Memory,
}

impl Why {
    const ALL: [Why; 3] = [Why::Time, Why::Interrupt, Why::Memory];
}

impl fmt::Display for Why {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Why::Time => "the time allowed is over",
            Why::Interrupt => "interrupted",
            Why::Memory => "the memory allowed is used up",
        })
    }
}

/// Work that stopped before its end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Interrupted {
    /// Why.
    pub why: Why,
    /// What had been going on, in words.
    pub reached: Option<String>,
}

impl fmt::Display for Interrupted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.why.fmt(f)
    }
}

impl std::error::Error for Interrupted {}

type Watch = dyn Fn() -> Option<Why> + Send + Sync;
type Observer = dyn Fn(&dyn fmt::Display) + Send + Sync;

/// The strings by which long work is held. Clones hold the same work: what stops one stops all, for good.
///
/// Whoever works asks [`check`](Control::check) again and again, in parallel loops too. There is no clock and no meter
/// in here, only a question that is put at each check: tests put another one, which counts.
#[derive(Clone, Default)]
pub struct Control {
    watch: Option<Arc<Watch>>,
    observer: Option<Arc<Observer>>,
    state: Arc<State>,
}

impl fmt::Debug for Control {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Control(stopped: {:?})", self.stopped())
    }
}

#[derive(Default)]
struct State {
    /// 0, or one more than the position of the reason in [`Why::ALL`].
    stopped: AtomicU8,
    reached: Mutex<Option<String>>,
}

impl Control {
    /// Asks, at each check, whether there is a reason to stop.
    pub fn watched(watch: impl Fn() -> Option<Why> + Send + Sync + 'static) -> Self {
        Control { watch: Some(Arc::new(watch)), ..Control::default() }
    }

    /// Stops at this time.
    pub fn until(deadline: Instant) -> Self {
        Control::watched(move || (Instant::now() >= deadline).then_some(Why::Time))
    }

    /// Tells an observer, too, what is going on.
    #[must_use]
    pub fn observed(self, observer: impl Fn(&dyn fmt::Display) + Send + Sync + 'static) -> Self {
        Control { observer: Some(Arc::new(observer)), ..self }
    }

    /// Stops the work at its next check, from any thread. The first reason counts.
    pub fn stop(&self, why: Why) {
        let number = (1..).zip(Why::ALL).find_map(|(number, other)| (other == why).then_some(number));
        let _ =
            self.state.stopped.compare_exchange(0, number.unwrap_or(1), Ordering::Relaxed, Ordering::Relaxed);
    }

    /// Whether to go on.
    ///
    /// # Errors
    /// Once there is a reason to stop, each time.
    pub fn check(&self) -> Result<(), Interrupted> {
        if self.stopped().is_none()
            && let Some(why) = self.watch.as_ref().and_then(|watch| watch())
        {
            self.stop(why);
        }
        match self.stopped() {
            Some(why) => Err(Interrupted { why, reached: self.reached() }),
            None => Ok(()),
        }
    }

    /// Tells what is going on; a stop carries the last that was told.
    pub fn observe(&self, progress: &dyn fmt::Display) {
        if let Ok(mut reached) = self.state.reached.lock() {
            *reached = Some(progress.to_string());
        }
        if let Some(observer) = &self.observer {
            observer(progress);
        }
    }

    /// Asks once for so many units of work, in loops whose rounds are too short to ask in each.
    pub fn every(&self, units: usize) -> Pace<'_> {
        Pace { control: self, units, left: units }
    }

    /// A full allowance of trusted work that ends where this work is stopped; see
    /// [`unless_stopped`](Control::unless_stopped).
    pub fn work(&self) -> Work {
        let control = self.clone();
        Work::until(move || control.check().is_err())
    }

    /// What is to be said of an error: that the work was stopped, if it was, which may be why there is one.
    pub fn unless_stopped<E: From<Interrupted>>(&self, error: E) -> E {
        self.check().map_or_else(E::from, |()| error)
    }

    fn stopped(&self) -> Option<Why> {
        let number = self.state.stopped.load(Ordering::Relaxed);
        Why::ALL.get(usize::from(number).checked_sub(1)?).copied()
    }

    fn reached(&self) -> Option<String> {
        self.state.reached.lock().ok().and_then(|reached| reached.clone())
    }
}

/// Asks a [`Control`] once for so many units of work.
pub struct Pace<'a> {
    control: &'a Control,
    units: usize,
    left: usize,
}

impl Pace<'_> {
    /// Counts units of work that were done, or are about to be.
    ///
    /// # Errors
    /// [`Control::check`]
    pub fn count(&mut self, done: usize) -> Result<(), Interrupted> {
        match self.left.checked_sub(done) {
            Some(left) => {
                self.left = left;
                Ok(())
            }
            None => {
                self.left = self.units;
                self.control.check()
            }
        }
    }
}
