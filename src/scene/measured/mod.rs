//! Measured tips: points from a file are turned into a profile, and all corrections are recorded.

pub(super) mod columns;
mod fit;
pub(super) mod header;
mod keys;
mod note;
mod points;
mod scan;
mod tip;

pub use columns::decoded;
pub use fit::{Fit, FitParameter};
pub(super) use keys::KEYS;
pub use keys::{Apex, Join, Measured, Smoothing};
pub use note::Note;
pub use scan::Scan;
pub use tip::MeasuredTip;

/// Maximum size of a file of points, in bytes.
pub const LONGEST_TIP: usize = 1 << 26;

/// Formats a length with six digits and its unit.
fn shown(system: &super::System, length: f64) -> String {
    let unit = system.unit_name(super::Dimension::LENGTH);
    let number = six_digits(length * system.out(super::Dimension::LENGTH));
    if unit.is_empty() { number } else { format!("{number} {unit}") }
}

/// Rounds to six significant digits.
fn six_digits(value: f64) -> String {
    format!("{value:.5e}").parse::<f64>().map_or_else(|_| String::new(), |rounded| format!("{rounded:?}"))
}
