//! The budget of a command: a deterministic step limit counted by the library, and a clock as a safeguard.

use super::failure::warn;
use super::{Failure, Outcome, input};
use crate::num::Budget;
use crate::num::work;
use crate::report::Unchecked;
use crate::transform::{Check, TransformError, Verdict};
use std::io::Write;
use std::process;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::Duration;

/// The budget option shared by all commands that compute.
#[derive(clap::Args)]
pub(super) struct BudgetArguments {
    /// Limits the work to about this many seconds of processor time [default: 3, more for long lists, grids, files and generated code].
    #[arg(long, value_name = "SECONDS", allow_hyphen_values = true)]
    budget: Option<String>,
}

/// Default budget in seconds.
const USUAL: f64 = 3.0;
/// Largest budget in seconds.
pub(super) const LONGEST: f64 = 86_400.0;
/// The clock ends unfinished parts of the answer, such as points and rows, once this multiple of the budget is spent.
const PATIENCE: f64 = if cfg!(debug_assertions) { 40.0 } else { 10.0 };
/// The clock allows at least this many milliseconds: the tables that a process reads once count towards no budget.
const LEAST: u64 = 2_000;
/// After that, writing what is finished may take this fraction of the time so far, and at least a second, before the program stops.
const GRACE: f64 = 0.25;
/// Interval between two checks of the clock.
const LOOK: Duration = Duration::from_millis(50);
/// Exit code of a command that did not finish.
const INCOMPLETE: i32 = 1;

/// Processor time that the clock allows, in milliseconds.
static LIMIT: AtomicU64 = AtomicU64::new(0);
/// Set by a budget on the command line, which does not grow with the input.
static IS_GIVEN: AtomicBool = AtomicBool::new(false);
/// Set by the clock once that time is spent.
static PASSED: AtomicBool = AtomicBool::new(false);

impl BudgetArguments {
    /// Runs a command within its budget.
    ///
    /// # Errors
    /// Returns the error of the command, and an error if the budget is not a valid number of seconds or is exhausted.
    pub(super) fn run(&self, command: impl FnOnce() -> Result<Outcome, Failure>) -> Result<Outcome, Failure> {
        let given = self.budget.as_deref().map(seconds).transpose()?;
        IS_GIVEN.store(given.is_some(), Ordering::Relaxed);
        let seconds = given.unwrap_or(USUAL);
        watch(seconds);
        work::with_deadline(&PASSED, || work::within(Budget::seconds(seconds), command))
    }
}

/// Parses a budget in seconds.
///
/// # Errors
/// Returns an error unless the number is positive and at most one day.
pub(super) fn seconds(text: &str) -> Result<f64, Failure> {
    let seconds = input::positive("--budget", text)?;
    if seconds <= LONGEST {
        return Ok(seconds);
    }
    let help = format!("expected at most {LONGEST} seconds");
    Err(Failure::new(format!("--budget {} is too long", text.trim())).help(help).at("--budget", text, 0..text.len()))
}

/// Raises the default step limit for an input with many parts, such as points, rows of a scene, cells of a grid or bytes of a file.
pub(super) fn allow(parts: u64, steps_per_part: u64) {
    if IS_GIVEN.load(Ordering::Relaxed) {
        return;
    }
    let steps = parts.saturating_mul(steps_per_part);
    work::allow(steps);
    let more = steps as f64 / Budget::seconds(1.0).count() as f64;
    LIMIT.fetch_add((1000.0 * PATIENCE * more) as u64, Ordering::Relaxed);
}

/// Runs an optional part of a command with half of the remaining budget.
pub(super) fn part<T>(run: impl FnOnce() -> Result<T, TransformError>) -> Result<T, Unchecked> {
    work::part(run).map_or(Err(Unchecked::Cut), |done| done.map_err(Unchecked::from))
}

/// Returns the outcome of a command from the check of the formulas it has written.
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

/// Starts the clock that ends the work if the step limit fails to do so.
///
/// It never changes a value: it ends the parts of an answer that the command can leave out, and the program if that does not help.
pub(super) fn watch(seconds: f64) {
    LIMIT.store(((1000.0 * PATIENCE * seconds) as u64).max(LEAST), Ordering::Relaxed);
    let watch = || {
        loop {
            std::thread::sleep(LOOK);
            let limit = LIMIT.load(Ordering::Relaxed) as f64;
            let spent = spent();
            if spent > limit && !PASSED.swap(true, Ordering::Relaxed) {
                // An error while writing to stderr cannot be reported.
                let _ = writeln!(
                    std::io::stderr(),
                    "warning: this takes more than {:.1} s of processor time: points and rows that are not finished are left out",
                    spent / 1e3
                );
            }
            if spent > limit + (GRACE * limit).max(1000.0) {
                let _ = writeln!(
                    std::io::stderr(),
                    "error: stopped after {:.1} s of processor time\nhelp: raise the limit with --budget SECONDS, or simplify the profile",
                    spent / 1e3
                );
                super::file::remove_unfinished();
                process::exit(INCOMPLETE);
            }
        }
    };
    // Without this thread only the step limit applies.
    let _ = std::thread::Builder::new().name("clock".to_owned()).spawn(watch);
}

/// Returns the processor time of this process in milliseconds.
#[cfg(unix)]
fn spent() -> f64 {
    use rustix::time::{ClockId, clock_gettime};
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 * 1e3 + time.tv_nsec as f64 * 1e-6
}

/// Returns the milliseconds since the first call.
#[cfg(not(unix))]
fn spent() -> f64 {
    use std::sync::OnceLock;
    use std::time::Instant;
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed().as_secs_f64() * 1e3
}
