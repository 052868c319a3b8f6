//! What `invert` found, and how it is written: text, LaTeX and JSON.

use super::json::{Check, Quantity, Readings, Typeset, write};
use super::text::{error, number, outcome, sources, table};
use crate::expr::{Expr, Formula};
use crate::print;
use crate::transform::{self, Derived, Reading, Verdict};
use serde::Serialize;
use std::io::{self, Write};

/// A profile found from an equivalent profile, or from a pressure.
pub struct Inversion<'a> {
    /// The wanted pressure, with the depth and the force that belong to it.
    pub pressure: Option<Wanted<'a>>,
    /// g(x), with set parameters in place.
    pub equivalent: &'a Formula,
    /// f(r).
    pub profile: Derived,
    /// f(0) = g(0).
    pub at_axis: &'a Expr,
    /// Conditions as text.
    pub conditions: Vec<String>,
    /// The outcome of the check, or why it could not be made.
    pub check: Result<transform::Check, String>,
    /// The radii at which f was asked for.
    pub at: Vec<f64>,
    /// f there.
    pub readings: Vec<Reading>,
}

/// A wanted pressure.
pub struct Wanted<'a> {
    /// p(r).
    pub pressure: &'a Expr,
    /// d.
    pub depth: &'a Expr,
    /// F.
    pub force: &'a Expr,
}

impl Inversion<'_> {
    /// True where the check found a difference.
    pub fn failed(&self) -> bool {
        self.check.as_ref().is_ok_and(|check| check.verdict == Verdict::Failed)
    }

    /// What a reader of the formulas must know.
    fn notes(&self) -> Vec<String> {
        let zero = if self.at_axis.is_zero() { "" } else { "; it shifts the shape and is not seen by a contact" };
        let mut notes = vec![
            format!("f(0) = g(0) = {}{zero}", print::text_expr(self.at_axis)),
            "the formulas hold for x >= 0 and r >= 0; both functions are even".to_owned(),
        ];
        if self.pressure.is_some() {
            notes.push(
                "E is the effective modulus E*, a the contact radius; f holds for r < a, outside anything below the surface".to_owned(),
            );
        }
        notes
    }
}

/// Writes it to be read in a terminal.
///
/// # Errors
/// As the writer.
pub fn text(record: &Inversion<'_>, out: &mut dyn Write) -> io::Result<()> {
    if let Some(wanted) = &record.pressure {
        writeln!(out, "p(r) = {}\n", print::text_expr(wanted.pressure))?;
        writeln!(out, "d = {}", print::text_expr(wanted.depth))?;
        writeln!(out, "F = {}\n", print::text_expr(wanted.force))?;
    }
    writeln!(out, "g(x) = {}\n", print::text(record.equivalent))?;
    writeln!(out, "f(r) = {}", print::text(&record.profile.formula))?;
    sources(&record.profile, out)?;
    if !record.conditions.is_empty() {
        writeln!(out, "\nConditions")?;
        record.conditions.iter().try_for_each(|condition| writeln!(out, "  {condition}"))?;
    }
    writeln!(out, "\nNotes")?;
    record.notes().iter().try_for_each(|note| writeln!(out, "  {note}"))?;
    writeln!(out, "\nCheck against quadrature of g as typed")?;
    outcome(&record.check, out)?;
    if record.at.is_empty() {
        return Ok(());
    }
    writeln!(out)?;
    let rows = || {
        record
            .at
            .iter()
            .zip(&record.readings)
            .map(|(at, reading)| [number(*at), number(reading.estimate.value), error(&reading.estimate), reading.method.to_owned()])
    };
    table(&["r", "f", "error", "method"], rows, out)
}

/// Writes a LaTeX fragment that compiles with the package amsmath.
///
/// # Errors
/// As the writer.
pub fn latex(record: &Inversion<'_>, out: &mut dyn Write) -> io::Result<()> {
    let mut lines = Vec::new();
    if let Some(wanted) = &record.pressure {
        let named = [("p(r)", wanted.pressure), ("d", wanted.depth), ("F", wanted.force)];
        lines.extend(named.map(|(left, expr)| format!("  {left} &= {}", print::latex(&Formula::Closed(expr.clone())))));
    }
    lines.push(format!("  g(x) &= {}", print::latex(record.equivalent)));
    lines.push(format!("  f(r) &= {}", print::latex(&record.profile.formula)));
    record.conditions.iter().try_for_each(|condition| writeln!(out, "% condition: {condition}"))?;
    record.notes().iter().try_for_each(|note| writeln!(out, "% {note}"))?;
    writeln!(out, "\\begin{{align*}}\n{}\n\\end{{align*}}", lines.join(" \\\\\n"))
}

/// Writes one JSON document.
///
/// # Errors
/// As the writer.
pub fn json(record: &Inversion<'_>, out: &mut dyn Write) -> io::Result<()> {
    #[derive(Serialize)]
    struct Document<'a> {
        #[serde(skip_serializing_if = "Option::is_none")]
        p: Option<Typeset>,
        #[serde(skip_serializing_if = "Option::is_none")]
        d: Option<Typeset>,
        #[serde(rename = "F", skip_serializing_if = "Option::is_none")]
        force: Option<Typeset>,
        g: Typeset,
        f: Quantity<'a>,
        at_axis: Typeset,
        conditions: &'a [String],
        notes: Vec<String>,
        check: Check<'a>,
        #[serde(skip_serializing_if = "Option::is_none")]
        points: Option<Readings<'a>>,
    }
    let wanted = record.pressure.as_ref();
    let document = Document {
        p: wanted.map(|own| Typeset::of_expr(own.pressure)),
        d: wanted.map(|own| Typeset::of_expr(own.depth)),
        force: wanted.map(|own| Typeset::of_expr(own.force)),
        g: Typeset::of(record.equivalent),
        f: Quantity::of(&record.profile),
        at_axis: Typeset::of_expr(record.at_axis),
        conditions: &record.conditions,
        notes: record.notes(),
        check: Check::of(&record.check),
        points: (!record.at.is_empty()).then_some(Readings { at: &record.at, readings: &record.readings }),
    };
    write("invert", &document, out)
}
