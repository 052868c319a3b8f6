//! A study as one JSON document.

use super::super::json::{Typeset, write};
use super::Tradeoff;
use serde::Serialize;
use std::collections::BTreeMap;
use std::io::{self, Write};

/// Writes the complete study.
///
/// # Errors
/// Returns the errors of the writer.
pub fn tradeoff(record: &Tradeoff<'_>, out: &mut dyn Write) -> io::Result<()> {
    #[derive(Serialize)]
    struct Document<'a> {
        profile: Typeset,
        parameters: BTreeMap<&'a str, f64>,
        quantity: &'static str,
        coordinate: &'static str,
        effective_modulus: f64,
        radius: Option<f64>,
        reference: Reference,
        clock: &'static str,
        points: Vec<Point>,
        rows: Vec<Entry<'a>>,
        skipped: Vec<Missing<'a>>,
        advice: Vec<Pick<'a>>,
        sentences: Vec<String>,
        #[serde(skip_serializing_if = "Option::is_none")]
        complete: Option<bool>,
        #[serde(skip_serializing_if = "Option::is_none")]
        why: Option<String>,
    }
    #[derive(Serialize)]
    struct Reference {
        source: String,
        relative_error: f64,
    }
    #[derive(Serialize)]
    struct Point {
        at: f64,
        value: f64,
        reference: &'static str,
    }
    #[derive(Serialize)]
    struct Entry<'a> {
        method: &'static str,
        setting: &'a str,
        true_relative_error: f64,
        at_most: bool,
        median_relative_error: f64,
        stated_relative_error: Option<f64>,
        honest: Option<bool>,
        ns_per_point: f64,
        ns_low: f64,
        ns_high: f64,
        set_up_ns: f64,
        evaluations: f64,
        front: bool,
    }
    #[derive(Serialize)]
    struct Missing<'a> {
        method: &'static str,
        setting: Option<&'a str>,
        why: &'a str,
    }
    #[derive(Serialize)]
    struct Pick<'a> {
        wanted: f64,
        method: Option<&'static str>,
        setting: Option<&'a str>,
        ns_per_point: Option<f64>,
        #[serde(skip_serializing_if = "Option::is_none")]
        why: Option<&'static str>,
        few_points: Option<Few<'a>>,
    }
    #[derive(Serialize)]
    struct Few<'a> {
        method: &'static str,
        setting: &'a str,
        below: f64,
    }
    let study = record.study;
    let problem = &study.problem;
    let factor = problem.factor();
    let document = Document {
        profile: Typeset::of(record.profile),
        parameters: record.parameters.iter().map(|(name, value)| (name.as_str(), *value)).collect(),
        quantity: problem.quantity.key(),
        coordinate: problem.quantity.coordinate(),
        effective_modulus: 1.0,
        radius: problem.radius,
        reference: Reference { source: record.reference(), relative_error: record.reference_error() },
        clock: study.clock,
        points: problem
            .points
            .iter()
            .zip(&study.truths)
            .map(|(at, truth)| Point { at: *at, value: factor * truth.value.value.hi, reference: truth.source })
            .collect(),
        rows: record
            .rows()
            .map(|row| Entry {
                method: row.method,
                setting: &row.setting,
                true_relative_error: row.error,
                at_most: row.at_most,
                median_relative_error: row.median_error,
                stated_relative_error: row.claimed,
                honest: row.honest,
                ns_per_point: row.time.median,
                ns_low: row.time.low,
                ns_high: row.time.high,
                set_up_ns: row.set_up,
                evaluations: row.evaluations,
                front: row.front,
            })
            .collect(),
        skipped: study.skipped.iter().map(|own| Missing { method: own.method, setting: own.setting.as_deref(), why: &own.why }).collect(),
        advice: study
            .advice
            .iter()
            .map(|own| {
                let pick = own.pick.and_then(|index| study.rows.get(index));
                let few = own.few.and_then(|(index, below)| study.rows.get(index).map(|row| (row, below)));
                Pick {
                    wanted: own.wanted,
                    method: pick.map(|row| row.method),
                    setting: pick.map(|row| row.setting.as_str()),
                    ns_per_point: pick.map(|row| row.time.median),
                    why: pick.is_none().then_some("no measured method is accurate enough"),
                    few_points: few.map(|(row, below)| Few { method: row.method, setting: &row.setting, below }),
                }
            })
            .collect(),
        sentences: record.sentences(),
        complete: record.cut().map(|_| false),
        why: record.cut(),
    };
    write("tradeoff", &document, out)
}
