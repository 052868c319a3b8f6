//! Records as JSON: one document, numbers as the shortest decimals that read back, and null with a reason for a missing value.

use super::{Compared, Derivation, Evaluation, Unchecked};
use crate::contact::{self, Measured, Reason, WayResult};
use crate::expr::{Expr, Formula};
use crate::print::{self, Notation, Presentation, Prose};
use crate::transform::{self, Derived, Reading, Rule, Verdict};
use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};
use serde_json::Value;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io::{self, Write};

/// Returns an empty map for a complete result, else the reason why it is incomplete.
pub(super) struct Completion(pub(super) Option<&'static str>);

impl Serialize for Completion {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        if let Some(why) = self.0 {
            map.serialize_entry("complete", &false)?;
            map.serialize_entry("why", why)?;
        }
        map.end()
    }
}

/// Writes the derived formulas, with the steps if requested.
///
/// # Errors
/// Returns the errors of the writer.
pub fn derivation(record: &Derivation<'_>, steps: Option<&[contact::Step]>, out: &mut dyn Write) -> io::Result<()> {
    #[derive(Serialize)]
    struct Document<'a> {
        #[serde(flatten)]
        complete: Completion,
        profile: Typeset,
        shift: Option<Typeset>,
        conditions: Vec<String>,
        #[serde(flatten)]
        entries: Entries<'a>,
        notes: Vec<String>,
        check: Check<'a>,
        #[serde(skip_serializing_if = "Option::is_none")]
        digits: Option<u32>,
        #[serde(skip_serializing_if = "Option::is_none")]
        steps: Option<Vec<Step<'a>>>,
    }
    let in_text = |list: Vec<Prose>| list.iter().map(|own| own.written(Notation::Text)).collect();
    let entries = record.entries();
    let document = Document {
        complete: Completion(Unchecked::why(&record.check)),
        profile: Typeset::of(&record.presentation.formula(record.formula())),
        shift: record.shift().map(|shift| Typeset::of(&record.presentation.formula(&shift.clone().into()))),
        conditions: in_text(record.conditions()),
        entries: Entries(&entries, record.presentation),
        notes: in_text(record.notes(&entries)),
        check: Check::of(&record.check),
        digits: record.presentation.digits,
        steps: steps.map(|list| list.iter().map(|own| Step::of(own, record.presentation)).collect()),
    };
    write("derive", &document, out)
}

/// Writes the values of one quantity.
///
/// # Errors
/// Returns the errors of the writer.
pub fn evaluation(record: &Evaluation<'_>, out: &mut dyn Write) -> io::Result<()> {
    #[derive(Serialize)]
    struct Document<'a> {
        quantity: &'static str,
        method: &'static str,
        coordinate: &'static str,
        profile: Typeset,
        parameters: BTreeMap<&'a str, f64>,
        effective_modulus: f64,
        radius: Option<f64>,
        depth: Option<f64>,
        shift: Option<Shift>,
        #[serde(skip_serializing_if = "Option::is_none")]
        units: Option<UnitNames<'a>>,
        points: Points<'a>,
        #[serde(flatten)]
        completion: Completion,
    }
    #[derive(Serialize)]
    struct UnitNames<'a> {
        at: &'a str,
        value: &'a str,
        effective_modulus: &'a str,
        parameters: BTreeMap<&'a str, &'a str>,
    }
    #[derive(Serialize)]
    struct Shift {
        #[serde(flatten)]
        formula: Typeset,
        value: f64,
    }
    let names = record.parameters.iter().map(|(name, _)| name.as_str());
    let document = Document {
        quantity: record.quantity,
        method: record.method(),
        coordinate: record.coordinate,
        profile: Typeset::of(record.profile),
        parameters: record.parameters.iter().map(|(name, value)| (name.as_str(), *value)).collect(),
        effective_modulus: record.effective_modulus,
        radius: record.radius,
        depth: record.depth,
        shift: record.shift.as_ref().map(|shift| Shift { formula: Typeset::of_expr(&shift.expr), value: shift.value }),
        units: (!record.units.at.is_empty() || !record.units.modulus.is_empty()).then(|| UnitNames {
            at: &record.units.at,
            value: &record.units.value,
            effective_modulus: &record.units.modulus,
            parameters: names.zip(record.units.parameters.iter().map(String::as_str)).collect(),
        }),
        points: Points(record),
        completion: Completion(record.is_cut().then(|| Reason::Unfinished.text())),
    };
    write("eval", &document, out)
}

/// Writes the comparisons, one key per quantity.
///
/// # Errors
/// Returns the errors of the writer.
pub fn comparison(record: &Compared<'_>, out: &mut dyn Write) -> io::Result<()> {
    write("compare", record, out)
}

/// Writes the catalogue of rules.
///
/// # Errors
/// Returns the errors of the writer.
pub fn rules(rules: &[&Rule], out: &mut dyn Write) -> io::Result<()> {
    #[derive(Serialize)]
    struct Entry {
        id: &'static str,
        name: &'static str,
        title: &'static str,
        pattern: &'static str,
        parameters: Vec<Interval>,
        result: Results,
        guard: &'static str,
        source: &'static [&'static str],
        specializes: Option<&'static str>,
    }
    #[derive(Serialize)]
    struct Interval {
        name: &'static str,
        lowest: f64,
        highest: f64,
    }
    #[derive(Serialize)]
    struct Results {
        g: &'static str,
        #[serde(rename = "F")]
        force: &'static str,
        p: Option<&'static str>,
    }
    let entries: Vec<Entry> = rules
        .iter()
        .map(|rule| Entry {
            id: rule.id,
            name: rule.id,
            title: rule.title,
            pattern: rule.pattern,
            parameters: rule.parameters.iter().map(|p| Interval { name: p.name, lowest: p.lowest, highest: p.highest }).collect(),
            result: Results { g: rule.equivalent, force: rule.force, p: rule.pressure },
            guard: rule.guard,
            source: rule.reference,
            specializes: rule.specializes,
        })
        .collect();
    #[derive(Serialize)]
    struct Document {
        rules: Vec<Entry>,
    }
    write("rules", &Document { rules: entries }, out)
}

/// Writes the document of a command on one line, beginning with the version of its schema.
///
/// The schemas are in `docs/schemas`; the version increases if a key changes its meaning or is removed.
pub(super) fn write(command: &'static str, document: &impl Serialize, mut out: &mut dyn Write) -> io::Result<()> {
    #[derive(Serialize)]
    struct Versioned<'a, D> {
        schema: String,
        #[serde(flatten)]
        document: &'a D,
    }
    serde_json::to_writer(&mut out, &Versioned { schema: format!("sneddon/{command}/1"), document })?;
    writeln!(out)
}

/// Writes a document without a result, with the reason.
///
/// # Errors
/// Returns the errors of the writer.
pub fn unfinished(command: &'static str, why: &str, out: &mut dyn Write) -> io::Result<()> {
    write(command, &BTreeMap::from([("complete", Value::from(false)), ("why", Value::from(why))]), out)
}

/// JSON has neither NaN nor infinities.
fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

/// Returns a formula in both notations.
#[derive(Serialize)]
pub(super) struct Typeset {
    text: String,
    latex: String,
}

impl Typeset {
    pub(super) fn of(formula: &Formula) -> Self {
        Self { text: print::text(formula), latex: print::latex(formula) }
    }

    pub(super) fn of_expr(expr: &Expr) -> Self {
        Self::of(&Formula::Closed(expr.clone()))
    }
}

/// Returns the derived quantities by key.
struct Entries<'a>(&'a [super::Entry<'a>], &'a Presentation);

impl<'a> Serialize for Entries<'a> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let stated = |entry: &'a super::Entry<'a>| (entry.key, entry.derived.as_deref().map(|own| StatedFormula::presented(own, self.1)));
        serializer.collect_map(self.0.iter().map(stated))
    }
}

/// Returns a formula with its status, rules and sources.
#[derive(Serialize)]
pub(super) struct StatedFormula<'a> {
    #[serde(flatten)]
    formula: Typeset,
    status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    compared: Option<bool>,
    rules: &'a [&'static str],
    reference: &'a [&'static str],
}

impl<'a> StatedFormula<'a> {
    pub(super) fn presented(derived: &'a Derived, presentation: &Presentation) -> Self {
        let formula = Typeset::of(&presentation.formula(&derived.formula));
        Self { formula, status: derived.status.name(), compared: derived.compared, rules: &derived.rules, reference: &derived.reference }
    }
}

/// Returns a step of a derivation.
#[derive(Serialize)]
pub(super) struct Step<'a> {
    title: &'a str,
    left: Option<Typeset>,
    right: Option<Typeset>,
    reason: String,
    reference: &'a [&'static str],
    steps: Vec<Self>,
}

impl<'a> Step<'a> {
    pub(super) fn of(step: &'a contact::Step, presentation: &Presentation) -> Self {
        let left = step.left.as_ref().map(|left| presentation.name(left));
        Self {
            title: &step.title,
            left: left.map(|left| Typeset { text: Notation::Text.name(&left), latex: Notation::Latex.name(&left) }),
            right: step.right.as_ref().map(|right| Typeset::of(&presentation.formula(right))),
            reason: step.reason.presented(presentation).written(Notation::Text),
            reference: &step.reference,
            steps: step.steps.iter().map(|own| Self::of(own, presentation)).collect(),
        }
    }
}

/// Returns the result of a check.
#[derive(Serialize)]
pub(super) struct Check<'a> {
    points: u32,
    max_relative_difference: Option<f64>,
    /// Returns null if nothing was compared.
    passed: Option<bool>,
    verdict: &'static str,
    why: Option<Cow<'a, str>>,
}

impl<'a> Check<'a> {
    pub(super) fn of(outcome: &'a Result<transform::Check, Unchecked>) -> Self {
        match outcome {
            Ok(check) => {
                let max_relative_difference = finite(check.max_relative_difference);
                Self {
                    points: check.points,
                    max_relative_difference,
                    passed: check.verdict.passed(),
                    verdict: check.verdict.name(),
                    why: check.why.map(Cow::Borrowed),
                }
            }
            Err(reason) => Self {
                points: 0,
                max_relative_difference: None,
                passed: None,
                verdict: Verdict::NotCompared.name(),
                why: Some(reason.to_string().into()),
            },
        }
    }
}

/// Returns readings of a quantity that is never infinite.
pub(super) struct Readings<'a> {
    pub(super) at: &'a [f64],
    pub(super) readings: &'a [Measured],
}

impl Serialize for Readings<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.at.iter().zip(self.readings).map(|(at, reading)| Point::new(*at, reading)))
    }
}

/// Serializes the readings one by one, since there may be many.
struct Points<'a>(&'a Evaluation<'a>);

impl Serialize for Points<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Evaluation { at, readings, ways, .. } = self.0;
        let own = |place: usize| ways.as_ref().map(|ways| ways.get(place).into_iter().flatten().map(Way::of).collect());
        let points = at.iter().zip(readings).enumerate();
        serializer.collect_seq(points.map(|(place, (at, reading))| Point { ways: own(place), ..Point::new(*at, reading) }))
    }
}

#[derive(Serialize)]
struct Point<'a> {
    at: f64,
    value: Option<f64>,
    error_estimate: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    bound: Option<&'static str>,
    method: Option<&'static str>,
    way: Option<&'static str>,
    evaluations: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    why: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ways: Option<Vec<Way<'a>>>,
}

/// Returns the result of one method.
#[derive(Serialize)]
struct Way<'a> {
    id: &'static str,
    value: Option<f64>,
    error_estimate: Option<f64>,
    bound: Option<&'static str>,
    steps: u64,
    why: Option<&'a str>,
}

impl<'a> Way<'a> {
    fn of(asked: &'a WayResult) -> Self {
        let (found, why) = match &asked.found {
            Ok(found) => (Some(found), None),
            Err(why) => (None, Some(why.as_str())),
        };
        let (value, error_estimate) = (found.and_then(|own| finite(own.value)), found.and_then(|own| finite(own.error)));
        Self { id: asked.way, value, error_estimate, bound: found.map(|own| own.bound.name()), steps: asked.steps, why }
    }
}

impl<'a> Point<'a> {
    fn new(at: f64, reading: &'a Measured) -> Self {
        match reading {
            Ok(reading) => Self::of(at, reading),
            Err(reason) => {
                let why = Some(reason.text());
                Self { at, value: None, error_estimate: None, bound: None, method: None, way: None, evaluations: 0, why, ways: None }
            }
        }
    }

    fn of(at: f64, reading: &Reading) -> Self {
        let (value, error_estimate) = (finite(reading.estimate.value), finite(reading.estimate.error));
        let why = match (value, error_estimate) {
            (None, _) => Some("no finite value was found"),
            (_, None) => Some("no error bound is available"),
            _ => None,
        };
        let bound = error_estimate.map(|_| reading.estimate.bound.name());
        let (method, way, evaluations) = (Some(reading.method), Some(reading.way()), reading.estimate.evaluations);
        Self { at, value, error_estimate, bound, method, way, evaluations, why, ways: None }
    }
}

impl Serialize for Compared<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Entry<'a> {
            max_relative_difference: Option<f64>,
            at: Option<f64>,
            points: u32,
            /// Returns null if nothing was compared.
            passed: Option<bool>,
            verdict: &'static str,
            #[serde(skip_serializing_if = "Option::is_none")]
            why: Option<&'a str>,
        }
        let mut map = serializer.serialize_map(None)?;
        if let Some(why) = self.why() {
            map.serialize_entry("complete", &false)?;
            map.serialize_entry("why", why)?;
        }
        for own in &self.comparisons.quantities {
            let entry = Entry {
                max_relative_difference: own.max_relative_difference.and_then(finite),
                at: own.at,
                points: own.points,
                passed: own.verdict.passed(),
                verdict: own.verdict.name(),
                why: own.why.as_deref(),
            };
            map.serialize_entry(own.quantity, &entry)?;
        }
        map.end()
    }
}
