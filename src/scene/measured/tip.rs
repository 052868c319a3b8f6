//! A measured tip: its profile, a second profile for the model error, and notes.

use super::columns::{Sheet, sheet};
use super::fit::{self, Fit};
use super::header::Column;
use super::keys::{Apex, Join, Measured, Smoothing};
use super::note::Note;
use super::points::{Points, extended, note_falls, note_steps, ordered};
use super::scan::{Scan, folded};
use crate::contact::ContactError;
use crate::expr::Expr;
use crate::scene::file::dimensioned::to_f64;
use crate::scene::{Dimension, SceneError, System, Unit};
use crate::transform::{Interpolation, Penalty, Profile, TableProfile};
use std::sync::Arc;

/// A measured tip in the computing units of its scene.
#[derive(Clone)]
pub struct MeasuredTip {
    profile: Arc<TableProfile>,
    second: Arc<TableProfile>,
    points: Points,
    rows: usize,
    rounded: bool,
    joined: [&'static str; 2],
    scan: Option<Scan>,
    notes: Vec<Note>,
}

impl std::fmt::Debug for MeasuredTip {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(out, "MeasuredTip({} points, {})", self.points.len(), self.joined[0])
    }
}

impl Measured {
    /// Creates a tip from the text of its file, as returned by [`super::decoded`]; positions in errors are bytes of that text.
    ///
    /// # Errors
    /// [`SceneError`] for a file without a valid profile.
    pub fn tip(&self, (text, foreign): &(String, bool), system: &System) -> Result<MeasuredTip, SceneError> {
        let own = sheet(text, self.line_scan)?;
        let scales = self.scales(&own, system)?;
        let mut notes = Vec::new();
        if *foreign {
            notes.push(Note::new("tip_encoding", "the file is not UTF-8 and was read as Latin-1".to_owned(), None));
        }
        if own.decimal_comma {
            notes.push(Note::new("tip_decimal_comma", "decimal commas were read as decimal points".to_owned(), None));
        }
        let mut points = ordered(&own, scales, self.line_scan, system, &mut notes)?;
        if self.invert {
            points.iter_mut().for_each(|point| point.1 = -point.1);
        }
        let header = own.radius.place.clone();
        let mut scan = None;
        if self.line_scan {
            let (folded, found) = folded(&points, system, &mut notes).map_err(|error| error.at(header.clone()))?;
            (points, scan) = (folded, Some(found));
        }
        note_falls(&points, self.join == Join::MonotoneCubic, system, &mut notes);
        if self.join == Join::MonotoneCubic {
            note_steps(&points, &mut notes);
        }
        let measured = points.clone();
        let rounded = match self.apex {
            Apex::Rounded => true,
            Apex::Pointed => false,
            Apex::Auto => !is_pointed(&points),
        };
        extended(&mut points, rounded, system, &mut notes);
        let number = self.penalty_number(system)?;
        let table = |points: &[(f64, f64)], how: Interpolation| {
            let (r, z): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
            Profile::from_points(&r, &z, how).map_err(|error| SceneError::from(ContactError::from(error)).at(header.clone()))
        };
        let (profile, second, joined) = match &self.join {
            Join::MonotoneCubic => {
                let own = if rounded { Interpolation::EvenMonotoneCubic } else { Interpolation::MonotoneCubic };
                // Two interpolants through the same points share their leading error; with half of the points it is sixteen times as large.
                let (fewer, other) = (every_other(&points), spline(rounded, Penalty::Weight(0.0)));
                let name =
                    if fewer.len() < points.len() { "natural cubic spline through every other point" } else { "natural cubic spline" };
                (table(&points, own)?, table(&fewer, other)?, ["monotone-cubic", name])
            }
            Join::SmoothingSpline(smoothing) => {
                let value = number.unwrap_or(0.0);
                let (own, other) = match smoothing {
                    Smoothing::CrossValidation => (Penalty::CrossValidation, Penalty::CrossValidation),
                    Smoothing::Noise(_) => (Penalty::Noise(value), Penalty::Noise(value)),
                    Smoothing::Weight(_) => (Penalty::Weight(value), Penalty::Weight(0.5 * value)),
                };
                let fewer = every_other(&points);
                let names = ["smoothing-spline", "smoothing spline of every other point"];
                (table(&points, spline(rounded, own))?, table(&fewer, spline(rounded, other))?, names)
            }
        };
        let rows = own.rows.len();
        Ok(MeasuredTip { profile: Arc::new(profile), second: Arc::new(second), points: measured, rows, rounded, joined, scan, notes })
    }

    /// Returns the factors that convert both columns to computing units.
    fn scales(&self, sheet: &Sheet, system: &System) -> Result<[f64; 2], SceneError> {
        let scale = |column: &Column, named: &Option<Unit>| -> Result<f64, SceneError> {
            let unit = column.unit.as_ref().or(named.as_ref()).or(self.length_unit.as_ref());
            let factor = match (unit, system.has_units()) {
                (Some(unit), true) => system.own(unit.factor().clone(), Dimension::LENGTH),
                (None, false) => Expr::one(),
                (None, true) => {
                    let message = format!("the column {} has no unit, but other numbers of the scene have one", column.name);
                    let help = format!("expected {}_um in the header, or length_unit = \"um\" in [profile]", column.name);
                    return Err(SceneError::unit(message).help(help).at(column.place.clone()));
                }
                // Numbers without a unit in a scene are in the output units.
                (Some(unit), false) => match system.names().and_then(|names| Unit::parse(&names.length).ok()) {
                    Some(bare) => unit.factor() / bare.factor(),
                    None => {
                        let message = format!("the column {} has a unit, but the numbers of the scene have none", column.name);
                        let help = "expected units in the scene, such as depth = \"50 nm\", or columns without units";
                        return Err(SceneError::unit(message).help(help).at(column.place.clone()));
                    }
                },
            };
            to_f64(&factor).map_err(|error| error.at(column.place.clone()))
        };
        let [r, z] = &self.units;
        Ok([scale(&sheet.radius, r)?, scale(&sheet.height, z)?])
    }
}

fn spline(rounded: bool, penalty: Penalty) -> Interpolation {
    if rounded { Interpolation::EvenSmoothingSpline(penalty) } else { Interpolation::SmoothingSpline(penalty) }
}

/// Returns every other point and the last one, so that the profile keeps its end. A short list is returned unchanged.
fn every_other(points: &[(f64, f64)]) -> Points {
    if points.len() < 7 {
        return points.to_vec();
    }
    let mut fewer: Points = points.iter().step_by(2).copied().collect();
    if let Some(last) = points.last().filter(|_| points.len().is_multiple_of(2)) {
        fewer.push(*last);
    }
    fewer
}

/// Returns true if the tip is pointed rather than rounded at the axis, judged by the polynomial through the first five points and,
/// to exclude noise, by a parabola through the first eighth of all points.
fn is_pointed(points: &[(f64, f64)]) -> bool {
    let first = |count: usize| points.get(..count.min(points.len())).unwrap_or_default();
    let (few, more) = (first(5), first((points.len() / 8).max(8)));
    let rise = |list: &[(f64, f64)]| match list {
        [one, other, ..] => (other.1 - one.1) / (other.0 - one.0),
        _ => 0.0,
    };
    let ends = |list: &[(f64, f64)]| match (list.first(), list.last()) {
        (Some(one), Some(other)) if other.0 > one.0 => (other.1 - one.1) / (other.0 - one.0),
        _ => 0.0,
    };
    // Slopes are positive in the direction of the first points.
    let chord = ends(more);
    let (slope, doubt) = slope_of_parabola(more);
    let sign = chord.signum();
    sign * slope_of_polynomial(few) > 0.5 * rise(few).abs() && sign * slope > (0.5 * chord.abs()).max(3.0 * doubt)
}

/// Returns the slope at the axis of the polynomial through a few points.
fn slope_of_polynomial(points: &[(f64, f64)]) -> f64 {
    let base = points.first().map_or(0.0, |own| own.1);
    let weight = |j: usize, own: f64| -> f64 {
        let others = || points.iter().enumerate().filter(move |(i, _)| *i != j);
        let product = |i: usize| -> f64 { others().filter(|(k, _)| *k != i).map(|(_, (r, _))| -r / (own - r)).product() };
        others().map(|(i, (r, _))| product(i) / (own - r)).sum()
    };
    points.iter().enumerate().map(|(j, (r, z))| (z - base) * weight(j, *r)).sum()
}

/// Returns the slope at the axis of the least-squares parabola, and its standard error.
fn slope_of_parabola(points: &[(f64, f64)]) -> (f64, f64) {
    let count = points.len() as f64;
    let mean = |value: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(value).sum::<f64>() / count;
    let (middle, height) = (mean(&|own| own.0), mean(&|own| own.1));
    let spread = mean(&|own| (own.0 - middle).powi(2));
    if points.len() < 4 || spread <= 0.0 {
        return (0.0, f64::INFINITY);
    }
    // Orthogonal polynomials in t = r − mean: 1, t, t² − c t − spread.
    let c = mean(&|own| (own.0 - middle).powi(3)) / spread;
    let second = |own: &(f64, f64)| (own.0 - middle).powi(2) - c * (own.0 - middle) - spread;
    let norm = mean(&|own| second(own).powi(2));
    let one = mean(&|own| (own.0 - middle) * (own.1 - height)) / spread;
    let two = mean(&|own| second(own) * (own.1 - height)) / norm;
    let rest = mean(&|own| (own.1 - height - one * (own.0 - middle) - two * second(own)).powi(2)) / (count - 3.0);
    let lever = -2.0 * middle - c;
    (one + two * lever, (rest * (1.0 / spread + lever * lever / norm)).sqrt())
}

impl MeasuredTip {
    /// Returns the profile.
    pub fn profile(&self) -> &Arc<TableProfile> {
        &self.profile
    }

    /// Returns the profile through every other point with another interpolation; the difference between the two is the model error.
    pub fn second(&self) -> &Arc<TableProfile> {
        &self.second
    }

    /// Returns the names of the interpolations of both profiles.
    pub fn joined(&self) -> [&'static str; 2] {
        self.joined
    }

    /// Returns the number of rows in the file.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Returns the radius and the height of every remaining point.
    pub fn points(&self) -> &[(f64, f64)] {
        &self.points
    }

    /// Returns true if f′(0) = 0.
    pub fn is_rounded(&self) -> bool {
        self.rounded
    }

    /// Returns the last radius, at which the profile ends.
    pub fn last_radius(&self) -> f64 {
        self.points.last().map_or(0.0, |own| own.0)
    }

    /// Returns the result of centring a line scan.
    pub fn scan(&self) -> Option<Scan> {
        self.scan
    }

    /// Returns the notes about corrections and properties of the points.
    pub fn notes(&self) -> &[Note] {
        &self.notes
    }

    /// Returns the named shapes fitted by least squares, the best first; computed on demand.
    pub fn fits(&self) -> Vec<Fit> {
        fit::fits(&self.points)
    }
}
