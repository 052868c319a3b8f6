//! The work meter: limits the number of steps of a computation, counted per thread without a clock.

use std::cell::Cell;
use std::sync::atomic::{AtomicBool, Ordering};
use thiserror::Error;

/// How much work a computation may do, in steps of about ten nanoseconds.
///
/// Steps are counted instead of timed: the same input takes the same number of steps on every machine, so a computation either
/// succeeds on every machine or is refused on every machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget(u64);

impl Budget {
    /// The budget of every public call of the engine if the caller has not opened a budget with [`within`].
    pub const DEFAULT: Self = Self(3 * STEPS_PER_SECOND);

    /// A budget of this many steps.
    pub const fn steps(steps: u64) -> Self {
        Self(steps)
    }

    /// The number of steps that a current machine takes in about this many seconds; at least one step.
    ///
    /// ```
    /// use sneddon_num::work::Budget;
    /// assert_eq!(Budget::seconds(2.0), Budget::steps(200_000_000));
    /// ```
    pub fn seconds(seconds: f64) -> Self {
        // The cast saturates: a float that is too large becomes the largest number of steps, NaN becomes 0.
        Self(((seconds * STEPS_PER_SECOND as f64) as u64).max(1))
    }

    /// The number of steps.
    pub const fn count(self) -> u64 {
        self.0
    }
}

/// Steps that take about one second.
const STEPS_PER_SECOND: u64 = 100_000_000;

/// The budget was exhausted, so the computation was stopped without a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("the work limit of {steps} steps was reached; simplify the profile, use fewer points or raise the budget")]
pub struct Exhausted {
    /// The budget in steps.
    pub steps: u64,
}

/// The remaining steps of this thread; a limit of `NONE` means that no budget is open.
struct Meter {
    /// The number of steps left plus one; 0 if more was spent than the budget has.
    left: Cell<u64>,
    limit: Cell<u64>,
    /// The steps of [`prepared`] work in the open [`share`]; `None` outside a share.
    kept: Cell<Option<u64>>,
    /// Set by another thread to end the work.
    stop: Cell<Option<&'static AtomicBool>>,
    /// Set by another thread to end what runs under [`until_deadline`].
    deadline: Cell<Option<&'static AtomicBool>>,
}

const NONE: u64 = u64::MAX;

thread_local! {
    static METER: Meter = const {
        Meter {
            left: Cell::new(NONE),
            limit: Cell::new(NONE),
            kept: Cell::new(None),
            stop: Cell::new(None),
            deadline: Cell::new(None),
        }
    };
}

/// Runs `work` with at most `budget` steps; if a budget is already open, it applies instead.
///
/// # Errors
/// [`Exhausted`] if the budget was exhausted, whatever `work` returned; otherwise the error of `work`.
///
/// ```
/// use sneddon_num::work::{Budget, Exhausted, spend, within};
/// let sum = within(Budget::steps(10), || { spend(4); Ok::<_, Exhausted>(1 + 1) });
/// assert_eq!(sum, Ok(2));
/// let sum = within(Budget::steps(10), || { spend(11); Ok::<_, Exhausted>(1 + 1) });
/// assert_eq!(sum, Err(Exhausted { steps: 10 }));
/// ```
pub fn within<T, E: From<Exhausted>>(budget: Budget, work: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
    let opened = METER.with(|meter| meter.limit.get() == NONE).then(|| Restored::open(budget.0, None));
    let result = work();
    let outcome = check();
    drop(opened);
    outcome?;
    result
}

/// Runs one public call with the default budget, unless the caller has opened a budget.
///
/// # Errors
/// As [`within`].
pub fn bounded<T, E: From<Exhausted>>(work: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
    within(Budget::DEFAULT, work)
}

/// Runs an optional part of the work with at most `steps` of the remaining steps; `None` if they do not suffice.
///
/// The steps of the part also count towards the open budget. Those of [`prepared`] work count towards it alone, so that it does not
/// depend on earlier calls whether the steps suffice.
///
/// ```
/// use sneddon_num::work::{Budget, Exhausted, left, prepared, share, spend, within};
/// let rest = within(Budget::steps(100), || {
///     assert_eq!(share(10, || { prepared(|| spend(40)); spend(9) }), Some(()));
///     Ok::<_, Exhausted>(left())
/// });
/// assert_eq!(rest, Ok(51));
/// ```
pub fn share<T>(steps: u64, work: impl FnOnce() -> T) -> Option<T> {
    if is_exhausted() {
        return None;
    }
    // The default budget applies if none is open.
    let most = if left() > NONE / 2 { Budget::DEFAULT.0 } else { left() };
    let restored = Restored::open(steps.min(most), Some(0));
    let result = work();
    let (rest, whole) = (left(), !is_exhausted());
    let kept = METER.with(|meter| meter.kept.get()).unwrap_or(0);
    drop(restored);
    let spent = steps.min(most).saturating_sub(rest);
    // Overdrawing the whole remainder exhausts the outer budget as well.
    spend(if whole || steps < most { spent } else { spent.saturating_add(1) });
    keep(kept);
    (whole && !is_exhausted()).then_some(result)
}

/// Runs work with a separate count of steps; returns its result, its steps, and whether they sufficed.
pub fn apart<T>(steps: u64, work: impl FnOnce() -> T) -> (T, u64, bool) {
    let restored = Restored::open(steps, None);
    let begin = left();
    let result = work();
    let (rest, whole) = (left(), !is_exhausted());
    drop(restored);
    (result, begin.saturating_sub(rest), whole)
}

/// Runs work that ends as if its budget were exhausted once another thread sets `stop`.
///
/// Results that are computed for later use, by [`unbroken`] or [`uncounted`], are finished first.
///
/// ```
/// use sneddon_num::work::{Budget, Exhausted, spend, stoppable, within};
/// use std::sync::atomic::{AtomicBool, Ordering};
/// static STOP: AtomicBool = AtomicBool::new(false);
/// let work = || within(Budget::steps(10), || { spend(4); Ok::<_, Exhausted>(1 + 1) });
/// assert_eq!(stoppable(&STOP, work), Ok(2));
/// STOP.store(true, Ordering::Relaxed);
/// assert!(stoppable(&STOP, work).is_err());
/// ```
pub fn stoppable<T>(stop: impl Into<Option<&'static AtomicBool>>, work: impl FnOnce() -> T) -> T {
    let before = METER.with(|meter| meter.stop.replace(stop.into()));
    let result = work();
    METER.with(|meter| meter.stop.set(before));
    result
}

/// Runs work whose parts, run by [`until_deadline`], end as if their budget were exhausted once another thread sets `passed`.
///
/// What is not such a part runs to its end, so that the work can still return the parts that were finished.
///
/// ```
/// use sneddon_num::work::{share, until_deadline, with_deadline};
/// use std::sync::atomic::{AtomicBool, Ordering};
/// static PASSED: AtomicBool = AtomicBool::new(false);
/// let squares = with_deadline(&PASSED, || {
///     let square = |n: u64| {
///         PASSED.store(n == 3, Ordering::Relaxed);
///         n * n
///     };
///     (1..=4).map(|n| until_deadline(|| share(10, || square(n)))).collect::<Vec<_>>()
/// });
/// assert_eq!(squares, [Some(1), Some(4), None, None]);
/// ```
pub fn with_deadline<T>(passed: &'static AtomicBool, work: impl FnOnce() -> T) -> T {
    let before = METER.with(|meter| meter.deadline.replace(Some(passed)));
    let result = work();
    METER.with(|meter| meter.deadline.set(before));
    result
}

/// Runs a part of the work that the caller can do without; see [`with_deadline`].
pub fn until_deadline<T>(work: impl FnOnce() -> T) -> T {
    let ends = METER.with(|meter| meter.deadline.get().or(meter.stop.get()));
    stoppable(ends, work)
}

/// Runs a part of the work that the caller can do without, with half of the remaining steps; see [`share`] and [`with_deadline`].
pub fn part<T>(work: impl FnOnce() -> T) -> Option<T> {
    until_deadline(|| share(left() / 2, work))
}

/// The steps of the open budget that are kept for writing the answer: a sixteenth of those that are left at the first question.
///
/// ```
/// use sneddon_num::work::{Budget, Exhausted, Reserve, left, spend, within};
/// let rest = within(Budget::steps(160), || {
///     let reserve = Reserve::default();
///     assert_eq!((0..100).filter(|_| reserve.part(|| spend(1_000)).is_some()).count(), 0);
///     assert_eq!(reserve.part(|| 7), Some(7));
///     Ok::<_, Exhausted>(left())
/// });
/// assert!(rest.is_ok_and(|rest| rest >= 10));
/// ```
#[derive(Debug)]
pub struct Reserve(Cell<u64>);

impl Default for Reserve {
    fn default() -> Self {
        Self(Cell::new(NONE))
    }
}

impl Reserve {
    /// Returns the steps that are left beyond the reserve.
    pub fn beyond(&self) -> u64 {
        let left = left();
        // A smaller budget was opened.
        if left < self.0.get() {
            self.0.set(left / FOR_THE_ANSWER);
        }
        left - self.0.get()
    }

    /// Runs one of several parts of the work with half of the steps beyond the reserve; see [`part`].
    pub fn part<T>(&self, work: impl FnOnce() -> T) -> Option<T> {
        let most = self.beyond() / 2;
        until_deadline(|| share(most, work))
    }
}

/// Divisor of the budget that gives the reserve.
const FOR_THE_ANSWER: u64 = 16;

/// Returns the flag that ends the work of this thread, to be passed to [`stoppable`] on threads that share the work.
pub fn stop_flag() -> Option<&'static AtomicBool> {
    METER.with(|meter| meter.stop.get())
}

/// Runs work whose result is kept for later budgets as well: it is counted, but never cut short.
pub fn unbroken<T>(work: impl FnOnce() -> T) -> T {
    let (result, spent, _) = apart(NONE, || finished(work));
    spend(spent);
    result
}

/// As [`unbroken`], for small work that the first of several calls does for all of them: it does not count towards a [`share`].
pub fn prepared<T>(work: impl FnOnce() -> T) -> T {
    let (result, spent, _) = apart(NONE, || finished(work));
    keep(spent);
    result
}

fn keep(steps: u64) {
    METER.with(|meter| match meter.kept.get() {
        Some(kept) => meter.kept.set(Some(kept.saturating_add(steps))),
        None => spend(steps),
    });
}

/// Runs work that is done once for the whole process, without counting it towards any budget.
pub fn uncounted<T>(work: impl FnOnce() -> T) -> T {
    apart(NONE, || finished(work)).0
}

/// Runs work to its end even under [`stoppable`], for a result that is cached beyond the call.
pub fn finished<T>(work: impl FnOnce() -> T) -> T {
    let stop = METER.with(|meter| meter.stop.take());
    let result = work();
    METER.with(|meter| meter.stop.set(stop));
    result
}

/// Adds steps to an open budget that is not used up, for a task that grows with its input.
pub fn allow(steps: u64) {
    METER.with(|meter| {
        if meter.limit.get() != NONE && !is_exhausted() {
            meter.left.set(meter.left.get().saturating_add(steps).min(NONE - 1));
            meter.limit.set(meter.limit.get().saturating_add(steps).min(NONE - 1));
        }
    });
}

/// Counts steps.
///
/// This never fails, so that constructors can call it; long computations must call [`check`] or [`is_exhausted`].
#[inline]
pub fn spend(steps: u64) {
    METER.with(|meter| meter.left.set(meter.left.get().saturating_sub(steps)));
}

/// Returns the remaining steps; close to `u64::MAX` if no budget is open.
pub fn left() -> u64 {
    METER.with(|meter| meter.left.get().saturating_sub(1))
}

/// Returns true if the open budget is overspent or the work was stopped; results computed after this are discarded.
#[inline]
pub fn is_exhausted() -> bool {
    METER.with(|meter| meter.left.get() == 0) || is_stopped()
}

/// Returns true once another thread has ended the work, as in [`stoppable`].
#[inline]
pub fn is_stopped() -> bool {
    METER.with(|meter| meter.stop.get().is_some_and(|stop| stop.load(Ordering::Relaxed)))
}

/// Returns an error if the work must end.
///
/// # Errors
/// [`Exhausted`] if the open budget is overspent or the work was stopped.
#[inline]
pub fn check() -> Result<(), Exhausted> {
    if is_exhausted() { Err(exhausted()) } else { Ok(()) }
}

/// The error that says how large the open budget was.
pub fn exhausted() -> Exhausted {
    Exhausted { steps: METER.with(|meter| meter.limit.get()) }
}

/// Puts the meter back as it was, also where the work panics.
struct Restored {
    left: u64,
    limit: u64,
    kept: Option<u64>,
}

impl Restored {
    fn open(steps: u64, kept: Option<u64>) -> Self {
        METER.with(|meter| Self {
            left: meter.left.replace(steps.saturating_add(1)),
            limit: meter.limit.replace(steps),
            kept: meter.kept.replace(kept),
        })
    }
}

impl Drop for Restored {
    fn drop(&mut self) {
        METER.with(|meter| {
            meter.left.set(self.left);
            meter.limit.set(self.limit);
            meter.kept.set(self.kept);
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_inner_budget_joins_the_outer_one() {
        let outcome: Result<(), Exhausted> = within(Budget::steps(100), || {
            within(Budget::steps(1000), || {
                spend(200);
                Ok::<_, Exhausted>(())
            })
        });
        assert_eq!(outcome, Err(Exhausted { steps: 100 }));
        assert!(!is_exhausted());
    }

    #[test]
    fn a_share_that_is_used_up_leaves_the_rest() {
        let outcome = within(Budget::steps(100), || {
            assert_eq!(share(30, || spend(40)), None);
            assert_eq!(left(), 70);
            assert_eq!(share(30, || spend(20)), Some(()));
            assert_eq!(left(), 50);
            assert_eq!(share(500, || spend(60)), None);
            Ok::<_, Exhausted>(())
        });
        assert_eq!(outcome, Err(Exhausted { steps: 100 }));
    }

    #[test]
    fn allowance_grows_an_open_budget_only() {
        allow(5);
        assert!(left() > NONE / 2);
        let outcome = within(Budget::steps(10), || {
            allow(5);
            spend(12);
            Ok::<_, Exhausted>(left())
        });
        assert_eq!(outcome, Ok(3));
    }

    #[test]
    fn a_panic_closes_the_budget() {
        let caught = std::panic::catch_unwind(|| {
            let _: Result<(), Exhausted> = within(Budget::steps(10), || panic!("stop"));
        });
        assert!(caught.is_err());
        assert!(left() > NONE / 2);
    }

    #[test]
    fn a_budget_may_be_spent_to_the_last_step() {
        let spent = |steps| {
            within(Budget::steps(10), || {
                spend(steps);
                Ok::<_, Exhausted>(())
            })
        };
        assert_eq!((spent(10), spent(11)), (Ok(()), Err(Exhausted { steps: 10 })));
        assert_eq!(apart(10, || spend(10)), ((), 10, true));
        assert_eq!(apart(10, || spend(11)), ((), 10, false));
    }
}
