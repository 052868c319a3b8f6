//! The measured tip of a solved scene: how it was read, similar named shapes, and the error due to the interpolation.

use crate::contact::{Finding, Severity};
use crate::scene::{Dimension, Fit, MeasuredTip, Quantity, Run};
use std::io::{self, Write};

/// Returns the word for the slope at the axis.
pub(in crate::report) fn apex(tip: &MeasuredTip) -> &'static str {
    if tip.is_rounded() { "rounded" } else { "pointed" }
}

/// Converts a parameter to output units; C of C·rⁿ is a length to the power 1 − n.
pub(in crate::report) fn in_answers(fit: &Fit, name: &str, value: f64, run: &Run<'_>) -> f64 {
    let length = run.scene().system.out(Dimension::LENGTH);
    match (name, fit.parameters.iter().find(|own| own.name == "n")) {
        ("C", Some(n)) => value * length.powf(1.0 - n.value),
        _ => fit.parameters.iter().find(|own| own.name == name).map_or(value, |own| value * run.scene().system.out(own.dimension)),
    }
}

/// Returns the corrections of the points, as findings without a row.
pub(in crate::report) fn findings(run: &Run<'_>) -> Vec<Finding> {
    let length = run.scene().system.out(Dimension::LENGTH);
    let notes = run.scene().tip.iter().flat_map(|tip| tip.notes());
    let warning = |rule, message: &str, at: Option<f64>| Finding { rule, severity: Severity::Warning, message: message.to_owned(), at };
    notes.map(|own| warning(own.rule, &own.message, own.at.map(|at| at * length))).collect()
}

/// Writes how the tip was read, and the named shapes that fit it.
pub(in crate::report) fn introduction(run: &Run<'_>, out: &mut dyn Write) -> io::Result<()> {
    let (Some(tip), Some(measured)) = (&run.scene().tip, &run.scene().measured) else { return Ok(()) };
    let (length, unit) = (run.scene().system.out(Dimension::LENGTH), run.scene().system.unit_name(Dimension::LENGTH));
    let shown = |value: f64| format!("{} {unit}", short(value)).trim_end().to_owned();
    let joined = tip.joined()[0];
    let end = shown(tip.last_radius() * length);
    writeln!(
        out,
        "tip: {} points of {} up to r = {end}, interpolated by a {joined}, {} at the axis",
        tip.points().len(),
        measured.file(),
        apex(tip)
    )?;
    for fit in tip.fits() {
        let own = |name: &'static str, value: f64| -> String {
            match name {
                "theta" => format!("theta = {} deg", short(value.to_degrees())),
                "n" => format!("n = {}", short(value)),
                "C" if unit.is_empty() => format!("C = {}", short(in_answers(&fit, name, value, run))),
                "C" => format!("C = {} {unit}^(1-n)", short(in_answers(&fit, name, value, run))),
                _ => format!("{name} = {}", shown(value * length)),
            }
        };
        let parameters: Vec<String> = fit.parameters.iter().map(|parameter| own(parameter.name, parameter.value)).collect();
        let rms = shown(fit.rms * length);
        writeln!(out, "  {:<12} {:<64} deviation {rms} (root mean square)", fit.shape, parameters.join(", "))?;
    }
    Ok(())
}

/// Formats a number with four digits.
fn short(value: f64) -> String {
    format!("{value:.3e}").parse::<f64>().map_or_else(|_| String::new(), |rounded| format!("{rounded:?}"))
}

/// The largest relative changes of rows with the second interpolation.
#[derive(Default)]
pub(in crate::report) struct Changes(Vec<(Quantity, f64)>);

impl Changes {
    /// Adds a row.
    pub(in crate::report) fn take(&mut self, errors: Option<Vec<(Quantity, Option<f64>)>>, value: impl Fn(Quantity) -> Option<f64>) {
        for (datum, error) in errors.into_iter().flatten() {
            let (Some(error), Some(value)) = (error, value(datum)) else { continue };
            let own = if value == 0.0 { 0.0 } else { (error / value).abs() };
            match self.0.iter_mut().find(|(known, _)| *known == datum) {
                Some((_, most)) => *most = most.max(own),
                None => self.0.push((datum, own)),
            }
        }
    }

    /// Writes the largest changes.
    pub(in crate::report) fn write(&self, run: &Run<'_>, out: &mut dyn Write) -> io::Result<()> {
        let Some(tip) = &run.scene().tip else { return Ok(()) };
        let control = run.scene().control.datum();
        let list: Vec<String> =
            self.0.iter().filter(|(datum, _)| *datum != control).map(|(datum, most)| format!("{} {most:.1e}", datum.key())).collect();
        if list.is_empty() {
            return Ok(());
        }
        writeln!(out, "model error: with a {} instead, the largest relative changes are {}", tip.joined()[1], list.join(", "))
    }
}
