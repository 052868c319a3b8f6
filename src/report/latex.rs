//! Derivations as a LaTeX fragment: one equation per quantity, conditions as comments.

use super::Derivation;
use crate::print;
use crate::transform::{Check, Verdict};
use std::io::{self, Write};

/// Writes a fragment that compiles inside a document with the package amsmath.
///
/// # Errors
/// As the writer.
pub fn derivation(record: &Derivation<'_>, out: &mut dyn Write) -> io::Result<()> {
    let mut lines = vec![format!("  f(r) &= {}", print::latex(record.formula()))];
    for entry in record.entries() {
        if let Some(derived) = entry.derived {
            lines.push(format!("  {} &= {}", entry.left, print::latex(&derived.formula)));
        }
    }
    if let Some(shift) = record.shift() {
        writeln!(out, "% f(0) = {} is subtracted, so that f starts at 0", print::text_expr(shift))?;
    }
    for condition in &record.relations.conditions {
        writeln!(out, "% condition: {condition}")?;
    }
    for note in record.notes() {
        writeln!(out, "% {note}")?;
    }
    match &record.check {
        Ok(Check { verdict: Verdict::NotCompared, why, .. }) => {
            writeln!(out, "% check against quadrature: not compared: {}", why.unwrap_or_default())?;
        }
        Ok(check) => {
            let verdict = if check.passed() { "passed" } else { "FAILED" };
            writeln!(
                out,
                "% check against quadrature: {} points, largest relative difference {:e}, {verdict}",
                check.points, check.max_relative_difference
            )?;
        }
        Err(reason) => writeln!(out, "% check against quadrature: not compared: {reason}")?,
    }
    writeln!(out, "\\begin{{align*}}\n{}\n\\end{{align*}}", lines.join(" \\\\\n"))
}
