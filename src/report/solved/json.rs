//! A solved scene as JSON, written row by row without storing the rows; the verdict is at the end.

use crate::contact::Finding;
use crate::report::json::Completion;
use crate::report::solved::tip_json;
use crate::report::solved::tip_json::TipEntry;
use crate::report::solved::{Verdict, assumptions, edge, words};
use crate::scene::{Dimension, Point, Row, Run};
use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::io::{self, Write};

/// Writes the result of a scene; with `formally`, the values of invalid rows are included.
///
/// # Errors
/// Returns the errors of the writer.
pub fn solved(run: &Run<'_>, formally: bool, out: &mut dyn Write) -> io::Result<Verdict> {
    let verdict = RefCell::new(Verdict::default());
    #[derive(Serialize)]
    struct Document<'a, 'r> {
        units: Option<UnitNames<'a>>,
        effective_modulus: f64,
        #[serde(skip_serializing_if = "Option::is_none")]
        tip: Option<TipEntry<'a>>,
        rows: Rows<'a, 'r>,
        curves: Curves<'a, 'r>,
        validity: Validity<'a, 'r>,
        #[serde(flatten)]
        completion: CompletionOf<'a, 'r>,
    }
    #[derive(Serialize)]
    struct UnitNames<'a> {
        length: &'a str,
        force: &'a str,
        pressure: &'a str,
    }
    let scene = run.scene();
    let units = scene.system.names().map(|own| UnitNames { length: &own.length, force: &own.force, pressure: &own.pressure });
    let document = Document {
        units,
        effective_modulus: scene.effective_modulus * scene.system.out(Dimension::PRESSURE),
        tip: tip_json::entry(run),
        rows: Rows { run, formally, verdict: &verdict },
        curves: Curves { run, formally },
        validity: Validity { run, verdict: &verdict },
        completion: CompletionOf(run),
    };
    crate::report::json::write("solve", &document, out)?;
    Ok(verdict.into_inner())
}

/// Whether the rows, curves and fields, which were already written, are complete.
pub(in crate::report) struct CompletionOf<'a, 'r>(pub(in crate::report) &'a Run<'r>);

impl Serialize for CompletionOf<'_, '_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Completion(self.0.cut_short()).serialize(serializer)
    }
}

struct Rows<'a, 'r> {
    run: &'a Run<'r>,
    formally: bool,
    verdict: &'a RefCell<Verdict>,
}

impl Serialize for Rows<'_, '_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let rows = (0..self.run.scene().loads.len()).filter_map(|index| Some((index, self.run.row(index)?)));
        serializer.collect_seq(rows.map(|(index, row)| {
            self.verdict.borrow_mut().take(&row);
            RowEntry { run: self.run, row, index, formally: self.formally }
        }))
    }
}

struct RowEntry<'a, 'r> {
    run: &'a Run<'r>,
    row: Row,
    index: usize,
    formally: bool,
}

impl Serialize for RowEntry<'_, '_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (row, scene) = (&self.row, self.run.scene());
        let mut map = serializer.serialize_map(None)?;
        let shown = self.formally || row.is_valid();
        let control = scene.control.datum();
        let mut why = None;
        for (datum, value) in &row.values {
            // An invalid row still contains its load, which identifies it.
            let own = match value {
                _ if *datum == control && !scene.counts_from_touch() => Some(row.load),
                Ok(value) if shown => Some(*value),
                Ok(_) => None,
                Err(reason) => {
                    why.get_or_insert_with(|| format!("{}: {reason}", datum.key()));
                    None
                }
            };
            map.serialize_entry(datum.key(), &own)?;
        }
        if scene.counts_from_touch() {
            map.serialize_entry("d_first_touch", &row.load)?;
        } else if let Some(depth) = row.depth_from_touch {
            map.serialize_entry("d_first_touch", &Some(depth).filter(|_| shown))?;
        }
        if shown {
            let known = self.run.estimates(self.index, row);
            let known = || known.iter().filter_map(|(datum, own)| Some((datum.key(), (*own)?)));
            map.serialize_entry("error_estimates", &known().map(|(name, own)| (name, own.error)).collect::<BTreeMap<_, _>>())?;
            map.serialize_entry("bounds", &known().map(|(name, own)| (name, own.bound.name())).collect::<BTreeMap<_, _>>())?;
        }
        let state = row.indented.state.filter(|_| shown);
        if let Some(changes) = self.run.row_model_errors(self.index, state.as_ref()) {
            let changes: BTreeMap<&str, Option<f64>> = changes.into_iter().map(|(datum, own)| (datum.key(), own)).collect();
            map.serialize_entry("model_error", &changes)?;
        }
        map.serialize_entry("edge", &row.indented.state.filter(|_| shown).map(|state| edge(state.boundary)))?;
        map.serialize_entry("valid", &row.validity())?;
        map.serialize_entry("verdict", &row.validity().map(|own| words(own, row.indented.radii)))?;
        if let Some(radii) = row.indented.radii {
            map.serialize_entry("radii", &radii)?;
        }
        if let Some(own) = &row.regime {
            map.serialize_entry("regime", &RegimeEntry { shape: own.simple.name(), force_error: own.force_error, message: None })?;
        }
        if let Some(why) = row.why().or(why.as_deref()) {
            map.serialize_entry("why", why)?;
        }
        let findings: Vec<FindingEntry<'_>> = row.indented.findings.iter().map(|own| FindingEntry::of(own, None, self.run)).collect();
        map.serialize_entry("findings", &findings)?;
        map.end()
    }
}

#[derive(Serialize)]
struct RegimeEntry {
    shape: &'static str,
    force_error: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    message: Option<String>,
}

#[derive(Serialize)]
struct FindingEntry<'a> {
    rule: &'static str,
    severity: &'static str,
    message: &'a str,
    at: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rows: Option<u64>,
}

impl<'a> FindingEntry<'a> {
    fn of(finding: &'a Finding, rows: Option<u64>, run: &Run<'_>) -> Self {
        let Finding { rule, severity, message, at } = finding;
        let at = at.map(|at| at * run.scene().system.out(Dimension::LENGTH)).filter(|at| at.is_finite());
        Self { rule, severity: severity.name(), message, at, rows }
    }
}

struct Curves<'a, 'r> {
    run: &'a Run<'r>,
    formally: bool,
}

impl Serialize for Curves<'_, '_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let scene = self.run.scene();
        let shapes = scene.outputs.curves.iter().filter(|own| !own.needs_radius()).map(|curve| (*curve, None));
        let loaded = (0..scene.loads.len()).flat_map(|index| {
            let wanted = scene.outputs.curves.iter().filter(|own| own.needs_radius());
            wanted.map(move |curve| (*curve, Some(index)))
        });
        serializer.collect_seq(shapes.chain(loaded).map(|(curve, index)| {
            let state = index.and_then(|index| self.run.state(index, self.formally));
            CurveEntry {
                d: state.zip(index).map(|(state, index)| self.run.shown_depth(index, &state)),
                row: index,
                quantity: curve.key(),
                points: Points { run: self.run, curve, state, second: index.and_then(|index| self.run.second_state(index)) },
            }
        }))
    }
}

#[derive(Serialize)]
struct CurveEntry<'a, 'r> {
    d: Option<f64>,
    row: Option<usize>,
    quantity: &'static str,
    points: Points<'a, 'r>,
}

struct Points<'a, 'r> {
    run: &'a Run<'r>,
    curve: crate::contact::Quantity,
    state: Option<crate::contact::State>,
    /// Returns the state with the second interpolation of a measured tip.
    second: Option<crate::contact::State>,
}

impl Serialize for Points<'_, '_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Entry {
            at: f64,
            value: Option<f64>,
            error_estimate: Option<f64>,
            #[serde(skip_serializing_if = "Option::is_none")]
            bound: Option<&'static str>,
            #[serde(skip_serializing_if = "Option::is_none")]
            model_error: Option<Option<f64>>,
            #[serde(skip_serializing_if = "Option::is_none")]
            why: Option<&'static str>,
        }
        serializer.collect_seq(self.run.curve(self.curve, self.state).into_iter().map(|(at, Point { at: shown, value, bound })| {
            let model_error = self
                .run
                .scene()
                .tip
                .as_ref()
                .map(|_| self.run.point_model_error(self.curve, self.state.as_ref().zip(self.second.as_ref()), at));
            match value {
                Ok((value, error)) => {
                    Entry { at: shown, value: Some(value), error_estimate: Some(error), bound: Some(bound.name()), model_error, why: None }
                }
                Err(why) => Entry { at: shown, value: None, error_estimate: None, bound: None, model_error, why: Some(why) },
            }
        }))
    }
}

struct Validity<'a, 'r> {
    run: &'a Run<'r>,
    verdict: &'a RefCell<Verdict>,
}

impl Serialize for Validity<'_, '_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut verdict = self.verdict.borrow_mut();
        verdict.close(self.run);
        let list = verdict.findings().iter();
        // The radius of a finding about the whole profile is already in output units.
        let findings: Vec<FindingEntry<'_>> = list
            .map(|(own, rows)| FindingEntry {
                at: own.at.filter(|_| *rows == 0).or(FindingEntry::of(own, None, self.run).at),
                ..FindingEntry::of(own, Some(*rows), self.run)
            })
            .collect();
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("valid", &verdict.validity())?;
        map.serialize_entry("verdict", &verdict.validity().map(|own| words(own, verdict.radii())))?;
        if let Some(radii) = verdict.radii() {
            map.serialize_entry("radii", &radii)?;
        }
        map.serialize_entry("assumptions", assumptions(self.run.scene()))?;
        if let Some(own) = verdict.regime() {
            let message = Some(own.sentence(&self.run.scene().system));
            map.serialize_entry("regime", &RegimeEntry { shape: own.simple.name(), force_error: own.force_error, message })?;
        }
        map.serialize_entry("findings", &findings)?;
        map.end()
    }
}
