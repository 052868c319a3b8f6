//! Measured tips: points from a file become a profile, with everything that was done to them on the way.

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

/// The longest file of points, in bytes.
pub const LONGEST_TIP: usize = 1 << 26;

/// A length with six digits and its unit, for sentences.
fn shown(system: &super::System, length: f64) -> String {
    let unit = system.unit_name(super::Dimension::LENGTH);
    let number = six_digits(length * system.out(super::Dimension::LENGTH));
    if unit.is_empty() { number } else { format!("{number} {unit}") }
}

/// The shortest decimal of the number rounded to six digits.
fn six_digits(value: f64) -> String {
    format!("{value:.5e}").parse::<f64>().map_or_else(|_| String::new(), |rounded| format!("{rounded:?}"))
}
