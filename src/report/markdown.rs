//! Markdown: a derivation, and the catalogue of exact solutions as a document.

use super::{Derivation, Statement, text};
use crate::print;
use std::io::{self, Write};

/// Writes a derivation, every formula as a block of mathematics with its sources below it.
///
/// # Errors
/// As the writer.
pub fn derivation(record: &Derivation<'_>, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "```math\nf(r) = {}\n```", print::latex(record.formula()))?;
    if let Some(shift) = record.shift() {
        writeln!(out, "\nThe value $f(0) = {}$ is subtracted, so that $f$ starts at 0.", print::latex_expr(shift))?;
    }
    for entry in record.entries() {
        match entry.derived {
            None => writeln!(out, "\n${}$: no explicit form", entry.left)?,
            Some(derived) => {
                writeln!(out, "\n```math\n{} = {}\n```\n", entry.left, print::latex(&derived.formula))?;
                let mut sources = Vec::new();
                text::sources(derived, &mut sources)?;
                writeln!(out, "{}", String::from_utf8_lossy(&sources).trim())?;
            }
        }
    }
    writeln!(out, "\nConditions:\n")?;
    record.relations.conditions.iter().try_for_each(|condition| writeln!(out, "- {condition}"))?;
    writeln!(out, "\nNotes:\n")?;
    record.notes().iter().try_for_each(|note| writeln!(out, "- {note}"))?;
    write!(out, "\nCheck against quadrature of f as typed:")?;
    text::outcome(&record.check, out)
}

/// Writes the catalogue: a table of contents, then every rule with its formulas, domain and sources.
///
/// # Errors
/// As the writer.
pub fn rules(statements: &[Statement], out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "# Exact solutions\n")?;
    writeln!(out, "This document is written by `sneddon rules --format markdown`; a test holds it to the program.\n")?;
    writeln!(out, "Every rule answers one family of terms of $f'$; a profile's solution is the sum of its terms' solutions.")?;
    writeln!(out, "Parameters are positive, $E$ is the effective modulus $E^\\ast$, and $F$ and $p$ belong to a smooth edge.")?;
    writeln!(out, "Where no pressure is stated, it stays an integral over the closed $g$.")?;
    writeln!(
        out,
        "The formula of a family is an example of it: powers of $r$ in front of it, other parameters and, where it says so, segments are answered too.\n"
    )?;
    writeln!(out, "| rule | solves | $f(r)$ |\n|---|---|---|")?;
    for statement in statements {
        let rule = statement.rule;
        let formula = print::latex(&statement.pattern).replace('|', "\\vert ");
        writeln!(out, "| [{}](#{}) | {} | ${formula}$ |", rule.id, rule.id, rule.title)?;
    }
    for statement in statements {
        section(statement, out)?;
    }
    Ok(())
}

fn section(statement: &Statement, out: &mut dyn Write) -> io::Result<()> {
    let rule = statement.rule;
    writeln!(out, "\n## {}\n\n{}.\n\n```math\n\\begin{{aligned}}", rule.id, rule.title)?;
    let mut lines = vec![("f(r)", &statement.pattern), ("g(x)", &statement.slope), ("F(a)", &statement.force)];
    lines.extend(statement.pressure.as_ref().map(|pressure| ("p(r)", pressure)));
    let lines: Vec<String> = lines.into_iter().map(|(left, formula)| format!("{left} &= {}", print::latex(formula))).collect();
    writeln!(out, "{}\n\\end{{aligned}}\n```\n", lines.join(" \\\\\n"))?;
    writeln!(out, "- As typed: `{}`", rule.pattern)?;
    writeln!(out, "- Where: {}", rule.guard)?;
    if let Some(general) = rule.specializes {
        writeln!(out, "- A nicer form of [{general}](#{general})")?;
    }
    writeln!(out, "- Source: {}", rule.reference.join("; "))
}
