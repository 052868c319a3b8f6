//! The result of `invert`, and its JSON output.

use super::Unchecked;
use super::json::{Check, Completion, Readings, StatedFormula, Step, Typeset, write};
use super::record::rounding;
use super::text::{row, table};
use crate::contact::{self, Measured, Reason};
use crate::expr::{Bindings, Condition, Expr, Formula};
use crate::print::{self, Notation, Presentation, Prose};
use crate::transform::{self, Derived, TransformError};
use serde::Serialize;
use std::io::{self, Write};

/// A profile found from an equivalent profile, or from a pressure.
pub struct Inversion<'a> {
    /// The pressure, with its depth and force.
    pub pressure: Option<Wanted<'a>>,
    /// g(x), with the given parameter values.
    pub equivalent: &'a Formula,
    /// f(r).
    pub profile: Derived,
    /// f(0) = g(0).
    pub at_axis: &'a Expr,
    /// The conditions.
    pub conditions: Vec<Condition>,
    /// The result of the check, or the reason why it was not possible.
    pub check: Result<transform::Check, Unchecked>,
    /// The radii at which f was requested.
    pub at: Vec<f64>,
    /// f at these radii, or the reason why it has no value there.
    pub readings: Vec<Measured>,
}

/// A pressure.
pub struct Wanted<'a> {
    /// p(r).
    pub pressure: &'a Expr,
    /// d.
    pub depth: &'a Expr,
    /// F.
    pub force: &'a Expr,
}

impl Inversion<'_> {
    /// Returns the reason why the result is incomplete; `None` if it is complete.
    pub fn why(&self) -> Option<&'static str> {
        let is_cut = || self.readings.iter().any(|own| matches!(own, Err(Reason::Unfinished)));
        Unchecked::why(&self.check).or_else(|| is_cut().then(|| Reason::Unfinished.text()))
    }

    /// Returns notes about the formulas.
    pub(super) fn notes(&self, presentation: &Presentation) -> Vec<Prose> {
        let zero = if self.at_axis.is_zero() { "" } else { "; it shifts the shape and does not affect the contact" };
        let mut notes = vec![
            Prose::read("$f(0)$ = $g(0)$ = ").formula(self.at_axis.clone()).then(zero),
            Prose::read("the formulas hold for $x$ >= 0 and $r$ >= 0; both functions are even"),
        ];
        if self.pressure.is_some() {
            notes.push(Prose::read(
                "$E$ is the effective modulus E*, $a$ the contact radius; $f$ holds for $r$ < $a$; for $r$ > $a$ the shape must not touch the surface",
            ));
        }
        notes.extend(rounding(presentation));
        notes.iter().map(|own| own.presented(presentation)).collect()
    }
}

/// Returns the message of an error of `transform::invert` in terms of g(x), or `None` if the error does not concern g itself.
///
/// `read` parses an expression in r.
pub fn refusal(error: &TransformError, read: impl Fn(&str) -> Option<Formula>) -> Option<String> {
    let over_x = |text: &str| {
        let named = read(text).map(|formula| print::text(&formula.substitute(&Bindings::one("r", Expr::symbol("x")))));
        named.unwrap_or_else(|| text.to_owned())
    };
    Some(match error {
        TransformError::SingularAtAxis { detail } => {
            let detail = over_x(detail);
            format!("g has no finite value at x = 0 ({detail}); expected a function such as C*x^n with n > 0")
        }
        TransformError::UnknownAtAxis { detail } => {
            format!(
                "the limit of g at x = 0 is not known ({}); expected a form with a value there, such as C*x^n with n > 0",
                over_x(detail)
            )
        }
        TransformError::NotReal { detail } => {
            format!("g is not a real number near x = 0 ({}); check the signs under roots and logarithms", over_x(detail))
        }
        TransformError::Jump { at, jump } => {
            format!("g jumps by {jump} at x = {at}; expected pieces with equal values at their breakpoints")
        }
        TransformError::OutOfDomain { .. } | TransformError::Overflow { .. } | TransformError::Evaluation(_) => return None,
        other => other.to_string().replace("the profile", "g"),
    })
}

/// Writes f at the requested radii as a table.
///
/// # Errors
/// Returns the errors of the writer.
pub fn readings(record: &Inversion<'_>, out: &mut dyn Write) -> io::Result<()> {
    if record.at.is_empty() {
        return Ok(());
    }
    writeln!(out)?;
    table(&["r", "f", "error", "method"], || record.at.iter().zip(&record.readings).map(row), out)
}

/// Writes one JSON document.
///
/// # Errors
/// Returns the errors of the writer.
pub fn json(record: &Inversion<'_>, steps: Option<&[contact::Step]>, presentation: &Presentation, out: &mut dyn Write) -> io::Result<()> {
    #[derive(Serialize)]
    struct Document<'a> {
        #[serde(skip_serializing_if = "Option::is_none")]
        p: Option<Typeset>,
        #[serde(skip_serializing_if = "Option::is_none")]
        d: Option<Typeset>,
        #[serde(rename = "F", skip_serializing_if = "Option::is_none")]
        force: Option<Typeset>,
        #[serde(flatten)]
        complete: Completion,
        g: Typeset,
        f: StatedFormula<'a>,
        at_axis: Typeset,
        conditions: Vec<String>,
        notes: Vec<String>,
        check: Check<'a>,
        #[serde(skip_serializing_if = "Option::is_none")]
        digits: Option<u32>,
        #[serde(skip_serializing_if = "Option::is_none")]
        steps: Option<Vec<Step<'a>>>,
        #[serde(skip_serializing_if = "Option::is_none")]
        points: Option<Readings<'a>>,
    }
    let typeset = |expr: &Expr| Typeset::of(&presentation.formula(&expr.clone().into()));
    let wanted = record.pressure.as_ref();
    let document = Document {
        p: wanted.map(|own| typeset(own.pressure)),
        d: wanted.map(|own| typeset(own.depth)),
        force: wanted.map(|own| typeset(own.force)),
        complete: Completion(record.why()),
        g: Typeset::of(&presentation.formula(record.equivalent)),
        f: StatedFormula::presented(&record.profile, presentation),
        at_axis: typeset(record.at_axis),
        conditions: record.conditions.iter().map(|own| print::text_condition(&presentation.condition(own))).collect(),
        notes: record.notes(presentation).iter().map(|own| own.written(Notation::Text)).collect(),
        check: Check::of(&record.check),
        digits: presentation.digits,
        steps: steps.map(|list| list.iter().map(|own| Step::of(own, presentation)).collect()),
        points: (!record.at.is_empty()).then_some(Readings { at: &record.at, readings: &record.readings }),
    };
    write("invert", &document, out)
}
