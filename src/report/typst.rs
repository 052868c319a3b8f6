//! Derivations as Typst markup: one equation per quantity, conditions and sources as text.

use super::{Derivation, text};
use crate::print;
use std::io::{self, Write};

/// Writes markup that compiles as a document or inside one.
///
/// # Errors
/// As the writer.
pub fn derivation(record: &Derivation<'_>, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "$ f(r) = {} $", print::typst(record.formula()))?;
    if let Some(shift) = record.shift() {
        writeln!(out, "The value $f(0) = {}$ is subtracted, so that $f$ starts at 0.", print::typst(&shift.clone().into()))?;
    }
    for entry in record.entries() {
        if let Some(derived) = entry.derived {
            writeln!(out, "$ {} = {} $", entry.left, print::typst(&derived.formula))?;
            let mut sources = Vec::new();
            text::sources(derived, &mut sources)?;
            writeln!(out, "#{:?}", String::from_utf8_lossy(&sources).trim())?;
        }
    }
    let mut line = |label: &str, text: &str| writeln!(out, "- {label}: #{text:?}");
    record.relations.conditions.iter().try_for_each(|condition| line("Condition", condition))?;
    record.notes().iter().try_for_each(|note| line("Note", note))?;
    let mut outcome = Vec::new();
    text::outcome(&record.check, &mut outcome)?;
    line("Check against quadrature", String::from_utf8_lossy(&outcome).trim())
}
