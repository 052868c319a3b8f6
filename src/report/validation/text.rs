//! A validation as text.

use crate::validate::{Column, FileReport, Validation};
use std::io::{self, Write};

/// Writes the verdict, the reason, the suspected fault, and one table per file.
///
/// # Errors
/// Returns the errors of the writer.
pub fn text(own: &Validation, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "{}: {}", if own.passed { "passed" } else { "failed" }, own.reason)?;
    if let Some(suspicion) = &own.suspicion {
        writeln!(out, "suspicion: {} ({})", suspicion.text, suspicion.fall())?;
    }
    for (name, order) in own.orders.iter().flatten() {
        let span = match (order.low, order.high) {
            (Some(low), Some(high)) => format!(", {low:.2} to {high:.2}"),
            _ => String::new(),
        };
        writeln!(out, "order of {name}: {:.2}{span} from {} files", order.value, order.files)?;
    }
    for file in &own.files {
        let grid = file.grid.map_or(String::new(), |own| format!(", grid {own}"));
        let pixel = file.pixel.map_or(String::new(), |own| format!(", h/a = {own:.4}"));
        let rows = if file.rows == 1 { "row" } else { "rows" };
        writeln!(out, "\n{}: {} {rows}{grid}{pixel}", file.name, file.rows)?;
        writeln!(
            out,
            "  {:8} {:>10} {:>10} {:>10} {:>15} {:>11} {:>7}  verdict",
            "column",
            "L1",
            "L2",
            "max",
            worst_at(file),
            "tolerance",
            "rows"
        )?;
        for column in &file.columns {
            let tolerance = match (column.pixels, column.tolerance) {
                (Some(_), _) => "0.5 pixels".to_owned(),
                (None, Some(own)) => format!("{own:.3e}"),
                (None, None) => "-".to_owned(),
            };
            writeln!(
                out,
                "  {:8} {:>10} {:>10} {:>10} {:>15.5e} {tolerance:>11} {:>7}  {}",
                column.name,
                norm(column.l1),
                norm(column.l2),
                norm(column.max),
                column.worst_at,
                column.rows,
                word(column)
            )?;
            if let Some(left) = column.excluded {
                writeln!(
                    out,
                    "  {:8} {:>10} {:>10.3e} {:>10.3e} {:>15} {:>11} {:>7}  near apex, kink or edge, listed separately",
                    "", "", left.l2, left.max, "", "-", left.rows
                )?;
            }
        }
        for note in &file.notes {
            writeln!(out, "  note: {note}")?;
        }
    }
    own.notes.iter().map(String::as_str).chain(own.cut_short).try_for_each(|note| writeln!(out, "note: {note}"))
}

/// Returns the title of the column with the coordinates of the largest errors, such as `worst at r / um`.
fn worst_at(file: &FileReport) -> String {
    file.plots.first().map_or_else(|| "worst at".to_owned(), |own| format!("worst at {}", own.across))
}

/// Returns an error relative to exact values, or "-" where all of them are 0.
fn norm(error: f64) -> String {
    if error == f64::MAX { "-".to_owned() } else { format!("{error:.3e}") }
}

fn word(column: &Column) -> String {
    let pixels = column.pixels.map_or(String::new(), |own| format!(" ({own:.2} pixels)"));
    match column.passed {
        Some(true) => format!("within{pixels}"),
        Some(false) => format!("beyond{pixels}"),
        None => "reported".to_owned(),
    }
}
