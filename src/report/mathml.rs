//! Derivations as an HTML fragment with MathML.

use super::{Derivation, text};
use crate::print;
use std::io::{self, Write};

/// Writes an `article` element that a page can hold; it needs no style sheet and no script.
///
/// # Errors
/// As the writer.
pub fn derivation(record: &Derivation<'_>, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "<article>\n{}", print::mathml_equation("f(r)", record.formula()))?;
    if let Some(shift) = record.shift() {
        let shift = print::mathml_equation("f(0)", &shift.clone().into());
        writeln!(out, "<p>So that f starts at 0, its value at the axis is subtracted:</p>\n{shift}")?;
    }
    for entry in record.entries() {
        if let Some(derived) = entry.derived {
            writeln!(out, "{}", print::mathml_equation(entry.left, &derived.formula))?;
            let mut sources = Vec::new();
            text::sources(derived, &mut sources)?;
            writeln!(out, "<p>{}</p>", print::escaped(String::from_utf8_lossy(&sources).trim()))?;
        }
    }
    writeln!(out, "<ul>")?;
    let mut item = |text: &str| writeln!(out, "<li>{}</li>", print::escaped(text));
    record.relations.conditions.iter().try_for_each(|condition| item(condition))?;
    record.notes().iter().try_for_each(|note| item(note))?;
    let mut outcome = Vec::new();
    text::outcome(&record.check, &mut outcome)?;
    item(&format!("Check against quadrature: {}", String::from_utf8_lossy(&outcome).trim()))?;
    writeln!(out, "</ul>\n</article>")
}
