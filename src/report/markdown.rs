//! Markdown: the catalogue of exact solutions as a document.

use super::Statement;
use crate::print;
use std::io::{self, Write};

/// Writes the catalogue: a table of contents, then every rule with its formulas, domain and sources.
///
/// # Errors
/// As the writer.
pub fn rules(statements: &[Statement], out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "# Exact solutions\n")?;
    writeln!(out, "This document is written by `sneddon rules --format markdown`; a test holds it to the program.\n")?;
    writeln!(out, "Every rule answers one family of terms of $f'$; a profile's solution is the sum of its terms' solutions.")?;
    writeln!(out, "Parameters are positive, $E$ is the effective modulus $E^\\ast$, and $F$ and $p$ belong to a smooth edge.")?;
    writeln!(
        out,
        "Where no pressure is stated, it stays an integral over the closed $g$, for the reasons in [pressures.md](pressures.md)."
    )?;
    writeln!(
        out,
        "Each formula is an example of its family: the rule also covers products with powers of $r$, other parameters and, where it says so, segments.\n"
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
