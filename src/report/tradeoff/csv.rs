//! A study as comma-separated values, one line per method and setting.

use super::Tradeoff;
use std::io::{self, Write};

/// The columns.
pub const COLUMNS: [&str; 13] = [
    "method",
    "setting",
    "true_relative_error",
    "at_most",
    "median_relative_error",
    "stated_relative_error",
    "honest",
    "ns_per_point",
    "ns_low",
    "ns_high",
    "set_up_ns",
    "evaluations",
    "front",
];

/// Writes the rows; the error cells are empty for a method without error estimate.
///
/// # Errors
/// Returns the errors of the writer.
pub fn tradeoff(record: &Tradeoff<'_>, out: &mut dyn Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(out);
    writer.write_record(COLUMNS)?;
    for row in record.rows() {
        let number = |value: f64| format!("{value:?}");
        writer.write_record([
            row.method.to_owned(),
            row.setting.clone(),
            number(row.error),
            row.at_most.to_string(),
            number(row.median_error),
            row.claimed.map(number).unwrap_or_default(),
            row.honest.map(|own| own.to_string()).unwrap_or_default(),
            number(row.time.median),
            number(row.time.low),
            number(row.time.high),
            number(row.set_up),
            number(row.evaluations),
            row.front.to_string(),
        ])?;
    }
    writer.flush()
}
