//! The verdict on the files of one kind: the finest within its tolerance, and errors that shrink with the pixel.

use super::order::{Level, Order, order};
use super::record::{Beyond, Column};

/// What one kind of file says.
pub(super) struct Verdict {
    pub(super) passed: bool,
    pub(super) reason: String,
    /// The column that decides, with its order.
    pub(super) order: Option<(&'static str, Order)>,
}

/// Errors below this are those of printed digits.
const PRINTED: f64 = 1e-8;

/// An error that is independent of the pixel has an order near 0, however well that is known.
const LEAST_ORDER: f64 = 0.25;
/// Errors of this share of the tolerance in every file are noise that no refinement needs to cure.
const NOTHING_LEFT: f64 = 0.05;

/// Judges the columns of the finest file, and the levels of all of them.
pub(super) fn verdict(column: &'static str, finest: &[Column], levels: &[Level], solver: f64, unmatched: u64) -> Verdict {
    let found = if levels.len() > 1 { order(levels, PRINTED.max(solver)) } else { None };
    let failed: Vec<&Column> = finest.iter().filter(|own| own.passed == Some(false)).collect();
    let converges = match found {
        None => levels.len() < 2 || vanishing(levels, 10.0 * PRINTED.max(solver)),
        Some(own) => own.low.unwrap_or(own.value) > 0.0 && own.value > LEAST_ORDER,
    };
    let tolerance = finest.iter().find(|own| own.name == column).and_then(|own| own.tolerance);
    let settled = found.is_some() && !converges && vanishing(levels, tolerance.map_or(0.0, |own| NOTHING_LEFT * own));
    let converges = converges || settled;
    let none_judged = finest.iter().all(|own| own.passed.is_none());
    let passed = failed.is_empty() && converges && unmatched == 0 && !none_judged;
    let reason = if unmatched > 0 {
        format!("no valid contact belongs to {unmatched} of the loads")
    } else if none_judged {
        nothing_judged(column)
    } else {
        match (settled, failed.first()) {
            (true, None) => {
                let part = (1.0 / NOTHING_LEFT).round();
                format!("the errors of {column} are below the tolerance by {part} and more in every file: no order is left to see")
            }
            (_, failed) => sentence(column, finest, failed.copied(), found, levels.len(), converges),
        }
    };
    Verdict { passed, reason, order: found.map(|own| (column, own)) }
}

/// Why no column has a verdict.
fn nothing_judged(column: &str) -> String {
    let why = match column {
        "a" => "the file has contact radii only, which need the pixel: [data] box and grid give it",
        "p" => "no compared place lies inside the contact, because all of them are within 4 pixels of its edge, a kink or the apex",
        _ => "no row has an exact value to compare with",
    };
    format!("nothing was judged: {why}")
}

/// True where even the coarsest errors are no larger than this.
fn vanishing(levels: &[Level], most: f64) -> bool {
    levels.iter().all(|level| level.errors.iter().flatten().all(|e| e.abs() <= most))
}

fn sentence(column: &str, finest: &[Column], failed: Option<&Column>, found: Option<Order>, files: usize, converges: bool) -> String {
    let order = found.map(|own| match (own.low, own.high) {
        (Some(low), Some(high)) => format!("order {:.2} ({low:.2} to {high:.2})", own.value),
        _ => format!("order {:.2}", own.value),
    });
    let floor = found.and_then(|own| own.floor).map_or(String::new(), |own| format!("; below {own:.1e} refinement has no effect"));
    let size = |own: &Column| match (own.pixels, own.tolerance) {
        (Some(pixels), Some(tolerance)) => format!("contact radii are {pixels:.2} pixels off, more than {tolerance}"),
        (None, Some(tolerance)) => {
            format!("the error of {} is {:.3e} in L2, more than the {tolerance:.3e} that is accepted", own.name, own.l2)
        }
        _ => format!("the error of {} is {:.3e} in L2", own.name, own.l2),
    };
    if let Some((name, row)) = finest.iter().find_map(|own| Some((own.name, own.beyond.filter(|_| own.passed == Some(false))?))) {
        let Beyond { at, error, limit } = row;
        return format!("the error of {name} is {error:.3e} at the load {at}, more than the {limit:.3e} that a single row may have");
    }
    match (failed, order, converges) {
        (None, Some(order), true) => {
            let own = finest.iter().find(|own| own.name == column);
            let error = own.map_or(String::new(), |own| {
                format!(" and the finest file is within its tolerance ({:.3e} of {:.3e})", own.l2, own.tolerance.unwrap_or(f64::MAX))
            });
            format!("the errors of {column} shrink with the pixel, {order},{error}{floor}").replace(", and", " and")
        }
        (None, None, true) => {
            let judged = finest.iter().filter_map(|own| Some((own.name, own.l2, own.tolerance?)));
            match judged.clone().find(|own| own.0 == column).or(judged.clone().next()) {
                Some((name, error, tolerance)) => {
                    format!("every column is within its tolerance ({name}: {error:.3e} of {tolerance:.3e})")
                }
                None => nothing_judged(column),
            }
        }
        (None, order, false) => {
            let order = order.unwrap_or_else(|| "no order".to_owned());
            format!("the errors of {column} do not shrink with the pixel ({order}): refinement does not cure them")
        }
        (Some(own), Some(order), true) => {
            format!("{}; the errors of {column} shrink with the pixel, {order}{floor}: a finer grid would help", size(own))
        }
        (Some(own), Some(order), false) => {
            format!("{}, and the errors of {column} do not shrink with the pixel ({order}): refinement does not cure them", size(own))
        }
        (Some(own), None, _) if files > 1 => format!("{}, whatever the grid", size(own)),
        (Some(own), None, _) if files == 0 => size(own),
        (Some(own), None, _) => format!("{}; one file cannot tell a coarse grid from a wrong model", size(own)),
    }
}
