//! Records as plain text, made to be read in a terminal.

use super::{Compared, Evaluation, Unchecked};
use crate::contact::Measured;
use crate::num::{Bound, Estimate};
use crate::print;
use crate::transform::{Check, Reading, Rule, Verdict};
use std::io::{self, Write};

/// Writes the numbers of one quantity as a table.
///
/// # Errors
/// As the writer.
pub fn evaluation(record: &Evaluation<'_>, out: &mut dyn Write) -> io::Result<()> {
    let (symbol, argument) = symbols(record.quantity);
    writeln!(out, "{symbol}{argument} of f(r) = {}", print::text(record.profile))?;
    let units = &record.units;
    let of_parameters = units.parameters.iter().map(String::as_str).chain(std::iter::repeat(""));
    let named = record.parameters.iter().zip(of_parameters);
    let mut given: Vec<String> = named.map(|((name, value), unit)| format!("{name} = {}", with_unit(*value, unit))).collect();
    // Without a modulus that has a unit, forces are counted in it.
    if units.modulus != "E*" {
        given.push(format!("E* = {}", with_unit(record.effective_modulus, &units.modulus)));
    }
    given.extend(record.radius.map(|a| format!("a = {}", with_unit(a, &units.at))));
    given.extend(record.depth.map(|d| format!("d = {} (rim)", with_unit(d, &units.at))));
    writeln!(out, "with {}", given.join(", "))?;
    if let Some(shift) = &record.shift {
        let (exact, value) = (print::text_expr(&shift.expr), number(shift.value));
        let value = match shift.value {
            0.0 => format!("{exact}, which is below the range of doubles,"),
            _ if exact == value => value,
            _ => format!("{exact} = {value}"),
        };
        writeln!(out, "f(0) = {} is subtracted, so that f starts at 0", with_unit_name(value, &units.at))?;
    }
    writeln!(out)?;
    let titled = |name: &str, unit: &str| if unit.is_empty() { name.to_owned() } else { format!("{name} [{unit}]") };
    let (coordinate, quantity) = (titled(record.coordinate, &units.at), titled(symbol, &units.value));
    let header = [coordinate.as_str(), quantity.as_str(), "error", "method"];
    table(&header, || record.at.iter().zip(&record.readings).map(row), out)?;
    let asked = record.ways.iter().flatten();
    record.at.iter().zip(&record.readings).zip(asked).try_for_each(|((at, reading), asked)| {
        write!(out, "\nWays to {} at {} = {}", symbols(record.quantity).0, record.coordinate, with_unit(*at, &units.at))?;
        match reading {
            // A depth, radius or force is computed from numbers of this way, so its value is not in the row of the way.
            Ok(own) if asked.first().is_some_and(|first| first.way == "auto") => writeln!(out, "; the answer is auto, by {}:", own.way())?,
            Ok(own) => writeln!(out, "; the answer comes from {}:", own.way())?,
            Err(reason) => return writeln!(out, ": none, {}", reason.text()),
        }
        let rows = || {
            asked.iter().map(|own| match &own.found {
                Ok(found) => {
                    let numbers = [number(found.value), error(found), found.bound.name().to_owned()];
                    let [value, error, bound] = numbers;
                    [own.way.to_owned(), value, error, bound, own.steps.to_string(), String::new()]
                }
                Err(why) => {
                    let none = || "-".to_owned();
                    [own.way.to_owned(), none(), none(), none(), own.steps.to_string(), why.clone()]
                }
            })
        };
        table(&["way", quantity.as_str(), "error", "bound", "steps", "why not"], rows, out)
    })
}

/// The symbol of a quantity and its argument in parentheses: the key `F_of_d` is F(d), while `g` has no argument in its key.
fn symbols(key: &str) -> (&str, String) {
    key.split_once("_of_").map_or((key, String::new()), |(symbol, argument)| (symbol, format!("({argument})")))
}

/// Writes the same numbers as comma-separated values; where there is no number the field is empty.
///
/// # Errors
/// As the writer.
pub fn evaluation_as_csv(record: &Evaluation<'_>, out: &mut dyn Write) -> io::Result<()> {
    let titled = |name: &str, unit: &str| if unit.is_empty() { name.to_owned() } else { format!("{name}_{unit}") };
    let header = [titled(record.coordinate, &record.units.at), titled(record.quantity, &record.units.value)];
    writeln!(out, "{},{},error,method,bound", header[0], header[1])?;
    record.at.iter().zip(&record.readings).try_for_each(|(at, reading)| match reading {
        Ok(Reading { estimate, method }) => {
            writeln!(out, "{at:?},{:?},{:?},{method},{}", estimate.value, estimate.error, estimate.bound.name())
        }
        Err(_) => writeln!(out, "{at:?},,,,"),
    })
}

/// Writes the comparisons as a table.
///
/// # Errors
/// As the writer.
pub fn comparison(record: &Compared<'_>, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "closed forms against quadrature, f(r) = {}\n", print::text(record.profile))?;
    let header = ["quantity", "points", "largest relative difference", "at", "verdict"];
    let rows = || {
        record.comparisons.quantities.iter().map(|own| {
            [
                own.quantity.to_owned(),
                own.points.to_string(),
                own.max_relative_difference.map_or("-".to_owned(), short),
                own.at.map_or("-".to_owned(), number),
                own.why.as_ref().map_or(word(own.verdict).to_owned(), |why| format!("{}: {why}", word(own.verdict))),
            ]
        })
    };
    table(&header, rows, out)?;
    record.why().map_or(Ok(()), |why| writeln!(out, "\nnot complete: {why}"))
}

/// Writes the catalogue of rules.
///
/// # Errors
/// As the writer.
pub fn rules(rules: &[&Rule], out: &mut dyn Write) -> io::Result<()> {
    for (index, rule) in rules.iter().enumerate() {
        if index > 0 {
            writeln!(out)?;
        }
        writeln!(out, "{}: {}", rule.id, rule.title)?;
        writeln!(out, "  f(r) = {}", rule.pattern)?;
        writeln!(out, "  g(x) = {}", rule.equivalent)?;
        writeln!(out, "  F(a) = {}", rule.force)?;
        writeln!(out, "  p(r) = {}", rule.pressure.unwrap_or("(left as an integral)"))?;
        writeln!(out, "  where  {}", rule.guard)?;
        if let Some(general) = rule.specializes {
            writeln!(out, "  a nicer form of {general}")?;
        }
        writeln!(out, "  source {}", rule.reference.join("; "))?;
    }
    Ok(())
}

/// How a check ended.
pub(super) fn outcome(check: &Result<Check, Unchecked>) -> String {
    match check {
        Ok(check) => {
            let word = word(check.verdict);
            match (check.verdict, check.why) {
                (Verdict::NotCompared, why) => format!("{word}: {}", why.unwrap_or_default()),
                _ => format!("{} points, largest relative difference {}: {word}", check.points, short(check.max_relative_difference)),
            }
        }
        Err(reason) => format!("not compared: {reason}"),
    }
}

/// A verdict as it is shown, a failure in capitals.
fn word(verdict: Verdict) -> &'static str {
    if verdict == Verdict::Failed { "FAILED" } else { verdict.name() }
}

/// Two digits of an error or a difference.
pub(super) fn short(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("{value:.1e}") }
}

/// The error of an estimate, with a tilde where it is not proven.
pub(super) fn error(estimate: &Estimate) -> String {
    marked(short(estimate.error), estimate.bound)
}

/// An error as it is shown, with a tilde where it is not proven.
pub(super) fn marked(error: String, bound: Bound) -> String {
    match bound {
        Bound::Proven => error,
        Bound::Estimated => format!("~{error}"),
    }
}

/// Returns the row of a point: its coordinate, and the value with its error and method or the reason why there is none.
pub(super) fn row((at, reading): (&f64, &Measured)) -> [String; 4] {
    match reading {
        Ok(own) => [number(*at), number(own.estimate.value), error(&own.estimate), own.method.to_owned()],
        Err(reason) => [number(*at), "-".to_owned(), "-".to_owned(), reason.text().to_owned()],
    }
}

/// Writes rows under a header, every column as wide as its widest entry.
pub(super) fn table<const N: usize, I: Iterator<Item = [String; N]>>(
    header: &[&str; N],
    rows: impl Fn() -> I,
    out: &mut dyn Write,
) -> io::Result<()> {
    let mut widths = header.map(|title| title.chars().count());
    for row in rows() {
        for (width, cell) in widths.iter_mut().zip(&row) {
            *width = (*width).max(cell.chars().count());
        }
    }
    let mut line = |cells: &[String; N]| {
        let padded: Vec<String> = cells.iter().zip(widths).map(|(cell, width)| format!("{cell:<width$}")).collect();
        writeln!(out, "{}", padded.join("  ").trim_end())
    };
    line(&header.map(str::to_owned))?;
    rows().try_for_each(|row| line(&row))
}

fn with_unit(value: f64, unit: &str) -> String {
    with_unit_name(number(value), unit)
}

fn with_unit_name(value: String, unit: &str) -> String {
    if unit.is_empty() { value } else { format!("{value} {unit}") }
}

/// The shortest decimal that reads back to the same number, whole numbers without a point.
pub(super) fn number(value: f64) -> String {
    let text = format!("{value:?}");
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}
