//! The budget of a command: steps of work that the library counts, and a clock as the last guard.

use super::failure::warn;
use super::{Failure, Outcome, input};
use crate::num::Budget;
use crate::num::work;
use crate::report::Unchecked;
use crate::transform::{Check, TransformError, Verdict};
use std::io::Write;
use std::process;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

/// The budget of every command that computes.
#[derive(clap::Args)]
pub(super) struct BudgetArguments {
    /// About how many seconds of processor time the work may take [default: 3, and more for long lists, grids and files].
    #[arg(long, value_name = "SECONDS", allow_hyphen_values = true)]
    budget: Option<String>,
}

/// The seconds where none are given.
const USUAL: f64 = 3.0;
/// The longest budget in seconds.
pub(super) const LONGEST: f64 = 86_400.0;
/// The clock stops the program after this many times the seconds that the steps should take …
const PATIENCE: f64 = if cfg!(debug_assertions) { 40.0 } else { 10.0 };
/// … and looks this often.
const LOOK: Duration = Duration::from_millis(50);
/// A command that did not finish its work.
const INCOMPLETE: i32 = 1;

/// Milliseconds of processor time after which the clock ends the program.
static LIMIT: AtomicU64 = AtomicU64::new(0);

impl BudgetArguments {
    /// Runs a command within its budget.
    ///
    /// # Errors
    /// [`Failure`] as the command, for a budget that is no number of seconds, and where the budget is used up.
    pub(super) fn run(&self, command: impl FnOnce() -> Result<Outcome, Failure>) -> Result<Outcome, Failure> {
        let seconds = self.budget.as_deref().map(seconds).transpose()?.unwrap_or(USUAL);
        watch(seconds);
        work::within(Budget::seconds(seconds), command)
    }
}

/// Reads a number of seconds.
///
/// # Errors
/// [`Failure`] for what is not positive or longer than a day.
pub(super) fn seconds(text: &str) -> Result<f64, Failure> {
    let seconds = input::positive("--budget", text)?;
    if seconds <= LONGEST {
        return Ok(seconds);
    }
    let help = format!("seconds up to {LONGEST} would be accepted");
    Err(Failure::new(format!("--budget {} is too long", text.trim())).help(help).at("--budget", text, 0..text.len()))
}

/// Allows more work for an input of many parts: lists of points, rows of a scene, cells of a grid, bytes of a file.
pub(super) fn allow(parts: u64, steps_per_part: u64) {
    let steps = parts.saturating_mul(steps_per_part);
    work::allow(steps);
    let more = steps as f64 / Budget::seconds(1.0).count() as f64;
    LIMIT.fetch_add((1000.0 * PATIENCE * more) as u64, Ordering::Relaxed);
}

/// Runs a part that the answer can do without, with half of what is left of the budget.
pub(super) fn part<T>(run: impl FnOnce() -> Result<T, TransformError>) -> Result<T, Unchecked> {
    work::share(work::left() / 2, run).map_or(Err(Unchecked::Cut), |done| done.map_err(Unchecked::from))
}

/// The outcome of a command, given the check of the formulas it has written.
pub(super) fn judged(check: &Result<Check, Unchecked>) -> Outcome {
    if let Some(why) = Unchecked::why(check) {
        warn(why);
        return Outcome::Failed;
    }
    if check.as_ref().is_ok_and(|own| own.verdict == Verdict::Failed) {
        warn("the check against quadrature failed");
        return Outcome::Failed;
    }
    Outcome::Done
}

/// Starts the clock that ends the program if the count of steps has missed something.
///
/// It never changes an answer: it says that there is none.
pub(super) fn watch(seconds: f64) {
    LIMIT.store((1000.0 * PATIENCE * seconds) as u64, Ordering::Relaxed);
    let watch = || {
        loop {
            std::thread::sleep(LOOK);
            let limit = LIMIT.load(Ordering::Relaxed);
            if spent() > limit as f64 {
                let seconds = limit as f64 / 1000.0;
                // Nothing can be said where even the message cannot be written.
                let _ = writeln!(
                    std::io::stderr(),
                    "error: stopped by the clock after {seconds:.1} s of processor time\nhelp: a larger --budget SECONDS, or a simpler profile, would be accepted"
                );
                super::file::remove_unfinished();
                process::exit(INCOMPLETE);
            }
        }
    };
    // Without a thread there is no last guard; the count of steps remains.
    let _ = std::thread::Builder::new().name("clock".to_owned()).spawn(watch);
}

/// Milliseconds of processor time of this process.
#[cfg(unix)]
fn spent() -> f64 {
    use rustix::time::{ClockId, clock_gettime};
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 * 1e3 + time.tv_nsec as f64 * 1e-6
}

/// Milliseconds since the first look.
#[cfg(not(unix))]
fn spent() -> f64 {
    use std::sync::OnceLock;
    use std::time::Instant;
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed().as_secs_f64() * 1e3
}
