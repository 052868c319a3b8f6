//! Markdown: the catalogue of exact solutions as a document.

use super::Statement;
use crate::print;
use std::io::{self, Write};

/// Writes the catalogue: a table of contents, then every rule with its formulas, domain and sources.
///
/// # Errors
/// Returns the errors of the writer.
pub fn rules(statements: &[Statement], out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "# Exact solutions\n")?;
    writeln!(out, "This document is written by `sneddon rules --format markdown`; a test checks that it is up to date.\n")?;
    writeln!(out, "Each rule solves one family of terms of $f'$; the solution of a profile is the sum of the solutions of its terms.")?;
    writeln!(out, "Parameters are positive, $E$ is the effective modulus $E^\\ast$, and $F$ and $p$ belong to a smooth edge.")?;
    writeln!(
        out,
        "If no pressure is stated, it remains an integral over the closed form of $g$; [pressures.md](pressures.md) explains why."
    )?;
    writeln!(
        out,
        "The formula of a family is an example: the rule also solves terms with other parameters, with additional powers of $r$ and, if stated, on segments.\n"
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
    let mut lines = vec![("f(r)", &statement.pattern), ("g(x)", &statement.equivalent), ("F(a)", &statement.force)];
    lines.extend(statement.pressure.as_ref().map(|pressure| ("p(r)", pressure)));
    let lines: Vec<String> = lines.into_iter().map(|(left, formula)| format!("{left} &= {}", print::latex(formula))).collect();
    writeln!(out, "{}\n\\end{{aligned}}\n```\n", lines.join(" \\\\\n"))?;
    writeln!(out, "- As typed: `{}`", rule.pattern)?;
    writeln!(out, "- Where: {}", rule.guard)?;
    if let Some(general) = rule.specializes {
        writeln!(out, "- A special form of [{general}](#{general})")?;
    }
    writeln!(out, "- Source: {}", rule.reference.join("; "))
}
