//! A study as a Markdown table, for the document with the measurements.

use super::super::text::short;
use super::{Tradeoff, duration};
use std::io::{self, Write};

/// Writes the table and the recommendations, one sentence per line.
///
/// # Errors
/// Returns the errors of the writer.
pub fn tradeoff(record: &Tradeoff<'_>, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "| | method | setting | true error | stated | per point | middle half | set-up | evaluations |")?;
    writeln!(out, "|---|---|---|---|---|---|---|---|---|")?;
    for row in record.rows() {
        let error = if row.at_most { format!("≤ {}", short(row.error)) } else { short(row.error) };
        writeln!(
            out,
            "| {} | {} | {} | {error} | {} | {} | {} – {} | {} | {} |",
            if row.front { "★" } else { "" },
            row.method,
            row.setting,
            row.claimed.map_or("–".to_owned(), short),
            duration(row.time.median),
            duration(row.time.low),
            duration(row.time.high),
            duration(row.set_up),
            if row.evaluations == 0.0 { "–".to_owned() } else { format!("{:.0}", row.evaluations) },
        )?;
    }
    writeln!(out)?;
    for own in record.study.skipped.iter().filter(|own| own.setting.is_none()) {
        writeln!(out, "Without {}: {}.", own.method, own.why.replace('|', "\\|"))?;
    }
    record.sentences().iter().try_for_each(|sentence| writeln!(out, "{sentence}"))
}
