//! A progress bar on stderr for work that takes more than a second; it is omitted if stderr is not a terminal.

use indicatif::{ProgressBar, ProgressStyle};
use std::cell::{Cell, OnceCell};
use std::io::{IsTerminal, stderr, stdout};
use std::time::{Duration, Instant};

/// Counts finished steps out of a known total.
pub(super) struct Progress {
    total: u64,
    done: Cell<u64>,
    started: Instant,
    bar: OnceCell<ProgressBar>,
    shown: bool,
}

/// No bar is shown for shorter work.
const PATIENCE: Duration = Duration::from_secs(1);
/// Number of steps between two readings of the clock.
const LOOK: u64 = 16;

impl Progress {
    /// Starts at zero steps. Pass `to_terminal` if the output may go to the terminal, since a bar would disturb it.
    pub(super) fn new(total: u64, to_terminal: bool) -> Self {
        let shown = stderr().is_terminal() && !(to_terminal && stdout().is_terminal());
        Self { total, done: Cell::new(0), started: Instant::now(), bar: OnceCell::new(), shown }
    }

    /// Counts one more step.
    pub(super) fn step(&self) {
        let done = self.done.get() + 1;
        self.done.set(done);
        if !self.shown || !done.is_multiple_of(LOOK) || (self.bar.get().is_none() && self.started.elapsed() < PATIENCE) {
            return;
        }
        let bar = self.bar.get_or_init(|| {
            let style = ProgressStyle::with_template("{wide_bar} {pos}/{len}, {eta} left").unwrap_or_else(|_| ProgressStyle::default_bar());
            ProgressBar::new(self.total).with_style(style)
        });
        bar.set_position(done);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = self.bar.get() {
            bar.finish_and_clear();
        }
    }
}
