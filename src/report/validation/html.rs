//! A validation as one self-contained page: verdict, tables, and plots of data, exact curve and error.

use super::plot;
use crate::report::sheet::SHEET;
use crate::validate::{Column, Validation};
use std::fmt::Write;

/// Returns the page.
///
/// # Errors
/// Returns a sentence if a plot cannot be drawn.
pub fn html(own: &Validation) -> Result<String, String> {
    let mut page = String::new();
    let word = if own.passed { "passed" } else { "failed" };
    // Writing to a string cannot fail.
    let _ = write!(
        page,
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Validation {word}</title><meta name=\"viewport\" content=\"width=device-width\"><style>{SHEET}</style></head><body>\n\
         <h1 class=\"{word}\">Validation {word}</h1>\n<p>{}</p>\n",
        escaped(&own.reason)
    );
    if let Some(suspicion) = &own.suspicion {
        let _ = writeln!(page, "<p><strong>Suspicion:</strong> {} ({}).</p>", escaped(&suspicion.text), suspicion.fall());
    }
    for (name, order) in own.orders.iter().flatten() {
        let span = order.low.zip(order.high).map_or(String::new(), |(low, high)| format!(", {low:.2} to {high:.2}"));
        let _ = writeln!(page, "<p>Order of {name}: {:.2}{span}, from {} files.</p>", order.value, order.files);
    }
    for file in &own.files {
        let _ = writeln!(page, "<h2>{}</h2>", escaped(&file.name));
        let grid = file.grid.map_or(String::new(), |own| format!(", grid {own}"));
        let pixel = file.pixel.map_or(String::new(), |own| format!(", h/a = {own:.4}"));
        let _ = writeln!(page, "<p>{} rows{grid}{pixel}.</p>", file.rows);
        page.push_str("<table><tr><th>column</th><th>L1</th><th>L2</th><th>max</th><th>worst at</th><th>tolerance</th><th>rows</th><th>verdict</th></tr>\n");
        file.columns.iter().for_each(|column| row(column, &mut page));
        page.push_str("</table>\n");
        for note in &file.notes {
            let _ = writeln!(page, "<p>{}.</p>", escaped(note));
        }
        for drawn in &file.plots {
            let [values, errors] = plot::svg(drawn)?;
            let _ = writeln!(page, "<figure>{values}{errors}</figure>");
        }
    }
    for note in own.notes.iter().map(String::as_str).chain(own.cut_short) {
        let _ = writeln!(page, "<p>{}.</p>", escaped(note));
    }
    page.push_str("</body></html>\n");
    Ok(page)
}

fn row(column: &Column, page: &mut String) {
    let tolerance = match (column.pixels, column.tolerance) {
        (Some(pixels), _) => format!("0.5 pixels (found {pixels:.2})"),
        (None, Some(own)) => format!("{own:.3e}"),
        (None, None) => "&ndash;".to_owned(),
    };
    let word = match column.passed {
        Some(true) => "within",
        Some(false) => "beyond",
        None => "reported",
    };
    let _ = writeln!(
        page,
        "<tr><td>{}</td><td>{:.3e}</td><td>{:.3e}</td><td>{:.3e}</td><td>{:.5e}</td><td>{tolerance}</td><td>{}</td><td>{word}</td></tr>",
        column.name, column.l1, column.l2, column.max, column.worst_at, column.rows
    );
    if let Some(left) = column.excluded {
        let _ = writeln!(
            page,
            "<tr><td>next to apex, kink or edge</td><td></td><td>{:.3e}</td><td>{:.3e}</td><td></td><td></td><td>{}</td><td>apart</td></tr>",
            left.l2, left.max, left.rows
        );
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
