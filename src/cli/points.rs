//! The list of points: numbers, linear ranges and logarithmic ones.

use super::Failure;
use super::units::Units;

/// The largest number of points.
const MOST: usize = 1_000_000;

const ACCEPTED: &str = "numbers such as 0.1,0.5, a range start:stop:count, or log:start:stop:count would be accepted";

/// Reads LIST; every point is a finite length that is not negative.
pub fn read(list: &str, units: &Units) -> Result<Vec<f64>, Failure> {
    if list.trim().is_empty() {
        return Err(Failure::new("--at is empty").help(ACCEPTED));
    }
    let mut points = Vec::new();
    let mut start = 0;
    for item in list.split(',') {
        let bad = |message: String| Failure::new(message).help(ACCEPTED).at("--at", list, start..start + item.len());
        let number = |text: &str| units.length("--at", text);
        let parts: Vec<&str> = item.split(':').collect();
        match parts.as_slice() {
            [blank] if blank.trim().is_empty() => return Err(bad("a number is missing".to_owned())),
            [only] => points.push(number(only)?),
            [first, last, count] => {
                let (first, last, count) = (number(first)?, number(last)?, counted(count, points.len()).map_err(bad)?);
                range(count, |t| first + t * (last - first), first, last, &mut points);
            }
            ["log", first, last, count] => {
                let (first, last, count) = (number(first)?, number(last)?, counted(count, points.len()).map_err(bad)?);
                if first <= 0.0 || last <= 0.0 {
                    return Err(bad("a logarithmic range starts and stops above 0".to_owned()));
                }
                let (low, high) = (first.ln(), last.ln());
                range(count, |t| (low + t * (high - low)).exp(), first, last, &mut points);
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

/// The number of points of a range, with as many as there are already.
fn counted(text: &str, already: usize) -> Result<usize, String> {
    let count: usize =
        text.trim().parse().map_err(|_| format!("{text} is no count of points; a whole number from 1 to {MOST} would be one"))?;
    match count {
        0 => Err("a range of 0 points is empty".to_owned()),
        count if count.saturating_add(already) > MOST => Err(format!("{count} points are too many; the limit is {MOST}")),
        count => Ok(count),
    }
}

/// `count` points; the first and the last one exactly as they were typed.
fn range(count: usize, at: impl Fn(f64) -> f64, first: f64, last: f64, points: &mut Vec<f64>) {
    points.extend((0..count).map(|index| match index {
        0 => first,
        index if index + 1 == count => last,
        index => at(index as f64 / (count - 1) as f64),
    }));
}
