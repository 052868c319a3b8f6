//! A progress bar on stderr for work of more than a second; none where stderr is no terminal.

use indicatif::{ProgressBar, ProgressStyle};
use std::cell::{Cell, OnceCell};
use std::io::{IsTerminal, stderr, stdout};
use std::time::{Duration, Instant};

/// Steps done of a number that is known.
pub(super) struct Progress {
    total: u64,
    done: Cell<u64>,
    started: Instant,
    bar: OnceCell<ProgressBar>,
    shown: bool,
}

/// Shorter work needs no bar.
const PATIENCE: Duration = Duration::from_secs(1);
/// Steps between two looks at the clock.
const LOOK: u64 = 16;

impl Progress {
    /// No step is done yet; `to_terminal` where the answer itself may go to the terminal, and the bar would disturb it.
    pub(super) fn new(total: u64, to_terminal: bool) -> Self {
        let shown = stderr().is_terminal() && !(to_terminal && stdout().is_terminal());
        Self { total, done: Cell::new(0), started: Instant::now(), bar: OnceCell::new(), shown }
    }

    /// One step more.
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
