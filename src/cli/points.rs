//! Lists of points: parses numbers, linear ranges and logarithmic ranges, and warns of points without a value.

use super::Failure;
use super::failure::warn;
use super::units::CallUnits;
use crate::contact::{Measured, Reason};
use crate::scene::{Dimension, Loads, Steps};

/// Maximum number of points.
const MOST_POINTS: usize = 1_000_000;

const ACCEPTED: &str = "expected numbers with commas between them, such as 0.1,0.5, a range start:stop:count, or log:start:stop:count";

/// Parses a list of points; each must be a finite number of this dimension, at least 0.
pub fn read(list: &str, units: &CallUnits, dimension: Dimension) -> Result<Vec<f64>, Failure> {
    if list.trim().is_empty() {
        return Err(Failure::new("--at is empty").help(ACCEPTED));
    }
    let mut points = Vec::new();
    let mut start = 0;
    for item in list.split(',') {
        let bad = |message: String| Failure::new(message).help(ACCEPTED).at("--at", list, start..start + item.len());
        let number = |text: &str| units.number("--at", text, dimension);
        let range = |ends: [&str; 2], count, logarithmic| {
            let [first, last] = [units.end("--at", ends[0], dimension)?, units.end("--at", ends[1], dimension)?];
            if logarithmic && (first.value() <= 0.0 || last.value() <= 0.0) {
                return Err(bad("both ends of a logarithmic range must be positive".to_owned()));
            }
            Ok(Loads::Range(Steps::new(first, last, count, logarithmic)))
        };
        let parts: Vec<&str> = item.split(':').collect();
        match parts.as_slice() {
            [blank] if blank.trim().is_empty() => return Err(bad("a number is missing".to_owned())),
            [only] if only.contains(';') || numbers_apart(only) => return Err(bad(format!("{} is not one number", only.trim()))),
            [only] => points.push(number(only)?),
            [first, last, count] => points.extend(range([first, last], counted(count, points.len()).map_err(bad)?, false)?.iter()),
            ["log", first, last, count] => {
                points.extend(range([first, last], counted(count, points.len()).map_err(bad)?, true)?.iter());
            }
            _ => return Err(bad(format!("{item} is neither a number nor a range"))),
        }
        if let Some(negative) = points.iter().find(|point| **point < 0.0) {
            return Err(bad(format!("the point {negative} is negative")));
        }
        start += item.len() + 1;
    }
    Ok(points)
}

/// Returns true if a text has several numbers with white space between them.
fn numbers_apart(text: &str) -> bool {
    text.split_whitespace().filter(|own| own.starts_with(|first: char| first.is_ascii_digit() || first == '.')).count() > 1
}

/// Parses the number of points in a range; `already` is the number of points before it.
fn counted(text: &str, already: usize) -> Result<usize, String> {
    let count: usize =
        text.trim().parse().map_err(|_| format!("{text} is not a number of points; expected a whole number from 1 to {MOST_POINTS}"))?;
    match count {
        0 => Err("a range of 0 points is empty".to_owned()),
        count if count.saturating_add(already) > MOST_POINTS => Err(format!("{count} points are too many; the limit is {MOST_POINTS}")),
        count => Ok(count),
    }
}

/// Warns of points that have no value, except where the value is infinite in theory.
pub(super) fn warn_of_missing_values(readings: &[Measured]) {
    let missing =
        || readings.iter().filter_map(|own| own.as_ref().err()).filter(|own| matches!(own, Reason::Refused(_) | Reason::Unfinished));
    if let Some(first) = missing().next() {
        warn(&format!("{} of {} points have no value: {}", missing().count(), readings.len(), first.text()));
    }
}
