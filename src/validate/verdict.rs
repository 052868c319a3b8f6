//! The verdict on the files of one kind: the finest file must be within its tolerance, and the errors must not be proven to persist under refinement.

use super::order::{Level, Order, limit_error, order};
use super::record::{Beyond, Column};

/// The verdict on files of one kind.
pub(super) struct Verdict {
    pub(super) passed: bool,
    /// False if no column can be compared; such a file passes only together with others.
    pub(super) judged: bool,
    pub(super) reason: String,
    /// Advice if no fault explains the data.
    pub(super) advice: Option<&'static str>,
    /// The decisive column, with its order if it is determined.
    pub(super) order: Option<(&'static str, Order)>,
    /// True if the errors are proven to increase under refinement.
    pub(super) grows: bool,
}

/// Errors below this value are due to printed digits.
const PRINTED: f64 = 1e-8;
/// An error whose order is proven to be below this value does not decrease under refinement.
const LEAST_ORDER: f64 = 0.25;
/// If the errors of every file are below this fraction of the tolerance, they are noise.
const NOTHING_LEFT: f64 = 0.05;
/// The same for a rim, where the error varies unevenly with the pixel.
const STEPS_OF_A_RIM: f64 = 0.6;
/// A coarse grid cannot explain an error larger than this multiple of the tolerance, which is proportional to the error.
const COARSE: f64 = 20.0;
/// An order with a wider interval is not determined.
const WIDEST: f64 = 2.0;
/// The error on an infinitely fine grid must be proven to exceed this fraction of the tolerance of the finest file.
const LEFT: f64 = 0.5;

/// The convergence of several files.
enum Convergence {
    /// There is only one file.
    One,
    /// The order is proven to be positive.
    Shrinks(Order),
    /// The errors of every file are far below the tolerance.
    Settled,
    /// Nothing is proven.
    Undetermined,
    /// The order is proven to be about 0 or negative.
    Stays(Order),
    /// The interval of the error on an infinitely fine grid contains neither 0 nor small values.
    Left(f64, f64),
}

impl Convergence {
    fn of(levels: &[Level], tolerance: Option<f64>, noise: f64, has_rim: bool) -> Self {
        if levels.len() < 2 {
            return Self::One;
        }
        let found = order(levels, noise);
        let share = if has_rim { STEPS_OF_A_RIM } else { NOTHING_LEFT };
        let small = tolerance.map_or(0.0, |own| share * own).max(10.0 * PRINTED.max(noise));
        if vanishing(levels, small) {
            return found.filter(shrinks).map_or(Self::Settled, Self::Shrinks);
        }
        let left = limit_error(levels).zip(tolerance).filter(|((low, high), own)| *low > LEFT * own || *high < -LEFT * own);
        match (found, left) {
            (Some(own), _) if own.high.is_some_and(|high| high < LEAST_ORDER) => Self::Stays(own),
            (_, Some(((low, high), _))) => Self::Left(low, high),
            (Some(own), _) if shrinks(&own) => Self::Shrinks(own),
            _ => Self::Undetermined,
        }
    }

    fn fails(&self) -> bool {
        matches!(self, Self::Stays(_) | Self::Left(..))
    }

    /// Returns true if the errors are proven to increase under refinement.
    fn grows(&self) -> bool {
        matches!(self, Self::Stays(own) if own.high.is_some_and(|high| high < -LEAST_ORDER))
    }
}

fn is_narrow(own: &Order) -> bool {
    own.low.zip(own.high).is_none_or(|(low, high)| high - low <= WIDEST)
}

fn shrinks(own: &Order) -> bool {
    own.low.unwrap_or(own.value) > 0.0 && own.value > LEAST_ORDER && is_narrow(own)
}

/// Returns `true` if every error, on every grid, is at most `most` in magnitude.
fn vanishing(levels: &[Level], most: f64) -> bool {
    levels.iter().all(|level| level.errors.iter().flatten().all(|e| e.abs() <= most))
}

/// Judges the columns of the finest file, and the levels of all files; `unmatched` loads have no contact, and `place` names a load or a
/// radius of the data.
pub(super) fn verdict(
    column: &'static str,
    finest: &[Column],
    levels: &[Level],
    (solver, has_rim): (f64, bool),
    unmatched: u64,
    place: &dyn Fn(f64) -> String,
) -> Verdict {
    let failed: Vec<&Column> = finest.iter().filter(|own| own.passed == Some(false)).collect();
    let decisive = finest.iter().find(|own| own.name == column);
    // The tolerance of contact radii is in pixels, so their relative errors have no tolerance.
    let tolerance = decisive.filter(|own| own.pixels.is_none()).and_then(|own| own.tolerance);
    let convergence = Convergence::of(levels, tolerance, PRINTED.max(solver), has_rim);
    let none_judged = finest.iter().all(|own| own.passed.is_none());
    let passed = failed.is_empty() && !convergence.fails() && unmatched == 0 && !none_judged;
    let (reason, advice) = if unmatched > 0 {
        (format!("no valid contact exists for {unmatched} of the loads"), None)
    } else if none_judged {
        (nothing_judged(column), None)
    } else if let Some(first) = failed.iter().find(|own| own.beyond.is_some()).or(failed.first()) {
        failure(column, first, &convergence, place)
    } else {
        (sentence(column, finest, &convergence), None)
    };
    let found = if levels.len() > 1 { order(levels, PRINTED.max(solver)).filter(is_narrow) } else { None };
    Verdict {
        passed,
        judged: !none_judged || unmatched > 0 || convergence.fails(),
        reason,
        advice,
        order: found.map(|own| (column, own)),
        grows: convergence.grows(),
    }
}

/// Returns the reason if no column can be judged.
fn nothing_judged(column: &str) -> String {
    let why = match column {
        "a" => "contact radii alone require the pixel (set box and grid in [data]) or a tolerance",
        "p" => "no compared point is inside the contact, because all of them are within 4 pixels of its edge, a kink or the apex",
        _ => "every exact value is 0, as without a load",
    };
    format!("nothing was judged: {why}")
}

fn order_text(own: &Order) -> String {
    match (own.low, own.high) {
        (Some(low), Some(high)) => format!("order {:.2} ({low:.2} to {high:.2})", own.value),
        _ => format!("order {:.2}", own.value),
    }
}

/// Returns the reason if the finest file exceeds its tolerance, and advice.
fn failure(column: &str, failed: &Column, convergence: &Convergence, place: &dyn Fn(f64) -> String) -> (String, Option<&'static str>) {
    let hidden = failed.tolerance.is_some_and(|own| failed.l2 <= own);
    if let Some(Beyond { at, error, limit }) = failed.beyond.filter(|_| hidden) {
        let name = failed.name;
        if name == "F_from_p" {
            let reason =
                format!("the error of {name} is {error:.3e}, above the limit of {limit:.3e} for the area of the pixels in contact");
            return (reason, None);
        }
        let one = if matches!(name, "p" | "u") { "point" } else { "row" };
        return (format!("the error of {name} is {error:.3e} at {}, above the limit of {limit:.3e} for a single {one}", place(at)), None);
    }
    let size = match (failed.pixels, failed.tolerance) {
        (Some(pixels), Some(tolerance)) => format!("contact radii have an error of {pixels:.2} pixels, above the tolerance of {tolerance}"),
        // Every load of the exact solution is 0 there.
        _ if failed.max == f64::MAX => {
            format!("{} is not 0 at {}, where its exact value is 0", failed.name, place(failed.worst_at))
        }
        (_, tolerance) => {
            let accepted = tolerance.unwrap_or_default();
            format!("the L2 error of {} is {:.3e}, above the tolerance of {accepted:.3e}", failed.name, failed.l2)
        }
    };
    match convergence {
        Convergence::One => {
            let is_near = failed.tolerance.is_none_or(|own| failed.l2 <= COARSE * own);
            (size, is_near.then_some("one file is not enough to distinguish a coarse grid from a wrong model"))
        }
        Convergence::Shrinks(own) if failed.name == column => {
            let advice = own.floor.is_none().then_some("refine the grid");
            (format!("{size}; the errors of {column} decrease with the pixel, {}", order_text(own)), advice)
        }
        Convergence::Shrinks(_) | Convergence::Settled => (size, None),
        Convergence::Undetermined => (format!("{size}; order not determined"), None),
        Convergence::Stays(_) | Convergence::Left(..) => (format!("{size}, and {}", stays(column, convergence)), None),
    }
}

/// Returns the reason if the errors do not vanish under refinement.
fn stays(column: &str, convergence: &Convergence) -> String {
    match convergence {
        Convergence::Left(low, high) => format!(
            "the errors of {column} tend to {:.3e} ({low:.3e} to {high:.3e}) instead of 0 as the pixel decreases, so refinement does not help",
            0.5 * (low + high)
        ),
        Convergence::Stays(own) => {
            format!("the errors of {column} do not decrease with the pixel ({}), so refinement does not help", order_text(own))
        }
        _ => String::new(),
    }
}

/// Returns the sentence if every column is within its tolerance.
fn sentence(column: &str, finest: &[Column], convergence: &Convergence) -> String {
    let judged = finest.iter().filter_map(|own| Some((own, own.tolerance?)));
    let shown = judged.clone().find(|own| own.0.name == column).or(judged.clone().next());
    let shown = shown.map_or(String::new(), |(own, tolerance)| match own.pixels {
        Some(pixels) => format!(" (error of {}: {pixels:.2} pixels, tolerance {tolerance} pixels)", own.name),
        None => format!(" (L2 error of {}: {:.3e}, tolerance {tolerance:.3e})", own.name, own.l2),
    });
    let names = |list: &mut dyn Iterator<Item = &Column>| list.map(|own| own.name).collect::<Vec<_>>().join(", ");
    let reported = names(&mut finest.iter().filter(|own| own.passed.is_none()));
    match convergence {
        Convergence::One => {
            let within = names(&mut judged.map(|own| own.0));
            let rest = if reported.is_empty() { String::new() } else { format!("; not judged: {reported}") };
            format!("within the tolerance: {within}{shown}{rest}")
        }
        Convergence::Shrinks(own) => {
            let floor = own.floor.map_or(String::new(), |own| format!("; below {own:.1e} refinement has no effect"));
            let order = order_text(own);
            format!("the errors of {column} decrease with the pixel, {order}, and the finest file is within its tolerance{shown}{floor}")
        }
        Convergence::Settled => {
            format!("the errors of {column} are within the tolerance in every file, and too small to determine an order{shown}")
        }
        Convergence::Undetermined => format!("the finest file is within its tolerance{shown}; order not determined"),
        Convergence::Stays(_) | Convergence::Left(..) => stays(column, convergence),
    }
}
