//! The measured tip of a solved scene as JSON.

use crate::report::solved::tip::{apex, in_answers};
use crate::scene::{Dimension, Run};
use serde::Serialize;
use std::collections::BTreeMap;

/// The tip in JSON; lengths are in output units.
#[derive(Serialize)]
pub(in crate::report) struct TipEntry<'a> {
    file: &'a str,
    rows: usize,
    points: usize,
    last_radius: f64,
    interpolation: &'static str,
    compared_with: &'static str,
    apex: &'static str,
    line_scan: Option<ScanEntry>,
    repairs: Vec<RepairEntry<'a>>,
    best_fit: Option<&'static str>,
    fits: Vec<FitEntry>,
}

#[derive(Serialize)]
struct ScanEntry {
    apex_offset: f64,
    tilt: f64,
    asymmetry_rms: f64,
}

#[derive(Serialize)]
struct RepairEntry<'a> {
    rule: &'static str,
    message: &'a str,
}

#[derive(Serialize)]
struct FitEntry {
    shape: &'static str,
    parameters: BTreeMap<&'static str, f64>,
    rms_deviation: f64,
    largest_deviation: f64,
}

/// Returns the tip of a scene, if it has one.
pub(in crate::report) fn entry<'a>(run: &Run<'a>) -> Option<TipEntry<'a>> {
    let (tip, length) = (run.scene().tip.as_ref()?, run.scene().system.out(Dimension::LENGTH));
    let fits = tip.fits();
    let [interpolation, compared_with] = tip.joined();
    Some(TipEntry {
        file: run.scene().measured.as_ref().map_or("", |own| own.file()),
        rows: tip.rows(),
        points: tip.points().len(),
        last_radius: tip.last_radius() * length,
        interpolation,
        compared_with,
        apex: apex(tip),
        line_scan: tip.scan().map(|own| ScanEntry {
            apex_offset: own.apex_offset * length,
            tilt: own.tilt,
            asymmetry_rms: own.asymmetry * length,
        }),
        repairs: tip.notes().iter().map(|own| RepairEntry { rule: own.rule, message: &own.message }).collect(),
        best_fit: fits.first().map(|own| own.shape),
        fits: fits
            .iter()
            .map(|fit| FitEntry {
                shape: fit.shape,
                parameters: fit.parameters.iter().map(|own| (own.name, in_answers(fit, own.name, own.value, run))).collect(),
                rms_deviation: fit.rms * length,
                largest_deviation: fit.largest * length,
            })
            .collect(),
    })
}
