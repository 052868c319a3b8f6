//! A file with loads, compared row by row: force and contact radius at the depth of the data, or depth and radius at the force of the data.

use super::exact::{Exact, States};
use super::neighbours::Neighbours;
use super::norms::{Norms, Outlier, Sample};
use super::record::{Column, Plot, significant};
use super::rim::Expected;
use super::{FileReport, Suspicion, ValidationError};
use crate::contact::{Boundary, Load, State};
use crate::scene::{Control, Declared, Scene};
use crate::validate::file::column::Kind;
use crate::validate::file::pixel::Pixel;
use crate::validate::file::row::Row;
use crate::validate::file::survey::Survey;
use crate::validate::file::table::Table;
use crate::validate::file::units;

/// A file with loads compared with the exact solution.
pub(super) struct Compared {
    pub(super) report: FileReport,
    /// Evenly sampled rows.
    pub(super) rows: Vec<Row>,
    /// Load and relative error of the decisive column, for the order.
    pub(super) errors: Vec<(f64, f64)>,
    /// The decisive column: F, d or a.
    pub(super) column: &'static str,
    /// Number of rows without a contact.
    pub(super) unmatched: u64,
    /// A single row with an error.
    pub(super) single: Option<Suspicion>,
    /// The factor of one column among d, F and a, if only this column fails.
    pub(super) scaled: Option<Suspicion>,
    /// The tolerance inferred from the contact radii if the grid is unknown.
    pub(super) tolerance: Option<f64>,
}

/// Criteria for errors.
#[derive(Clone, Copy)]
pub(super) struct Tolerances {
    /// The tolerance requested by the user.
    pub(super) demanded: Option<f64>,
    /// The tolerance of the solver.
    pub(super) solver: f64,
}

/// The tolerance for an unknown grid, and for a punch with a rim, whose error is of first order.
pub(super) const BLIND: f64 = 1e-2;
const BLIND_RIM: f64 = 2e-2;
/// Contact radii with an unknown grid fail only above this relative error.
pub(super) const BLIND_RADIUS: f64 = 0.15;
/// Tolerance of a single load, relative to its discretization error.
pub(super) const HEADROOM: f64 = 4.0;
/// Tolerance of a single load for an unknown grid.
pub(super) const BLIND_ROW: f64 = 0.5;
/// Minimum error for which a row of F or d, or of a, is considered an outlier among its neighbours.
const CLEAR: f64 = 2e-3;
const CLEAR_RADIUS: f64 = 2e-2;
/// Minimum number of pixels along a contact radius for which the radius is compared.
const FEWEST_PIXELS: f64 = 2.0;
/// Tolerances relative to the tolerance of F: of U, which is the integral of F, and of k, which solvers compute from differences of F.
const WORK: f64 = 2.0;
const SLOPE: f64 = 0.05;
/// Number of rows kept for orders, plots and the diagnosis.
const KEPT: usize = 256;

impl Tolerances {
    /// The maximum relative error of a single load, independent of its weight in the norm.
    ///
    /// The errors of single loads scatter around the discretization error, which requires some headroom.
    /// If the pixel is unknown, only an error that no resolved contact has is significant.
    pub(super) fn limit(&self, pixel: Option<f64>, state: &State, room: f64) -> f64 {
        let grid = Self { demanded: None, ..*self }.allowed(pixel, state, room);
        match pixel {
            Some(_) => (HEADROOM * grid).max(HEADROOM * self.demanded.unwrap_or(0.0)),
            None => BLIND_ROW.max(HEADROOM * self.demanded.unwrap_or(0.0)),
        }
    }

    /// Returns the relative discretization error at a contact radius whose nearest kink is at the distance `room` from the edge.
    pub(super) fn allowed(&self, pixel: Option<f64>, state: &State, room: f64) -> f64 {
        let blind = if state.boundary == Boundary::Rim { BLIND_RIM } else { BLIND };
        let Some(pixel) = pixel else { return self.demanded.unwrap_or(blind + self.solver) };
        // A grid cannot resolve a contact smaller than one pixel.
        let share = if state.radius > pixel { pixel / state.radius } else { 1.0 };
        // The resolution of a ring between a kink and the edge is determined by its width.
        let narrow = (state.radius / room.max(share * state.radius)).max(1.0);
        let grid = if state.boundary == Boundary::Rim { 0.25 * share } else { 0.25 * share * share * narrow };
        self.demanded.unwrap_or(grid + self.solver)
    }
}

/// The columns of a row.
pub(super) fn row(survey: &Survey<'_>, declared: Option<&Declared>, values: &[f64]) -> Row {
    let value =
        |kind: Kind| survey.index(kind).and_then(|own| values.get(own).zip(survey.factors.get(own))).map_or(f64::NAN, |(v, f)| v * f);
    let sign = if declared.is_some_and(|own| own.tension) { -1.0 } else { 1.0 };
    Row { depth: value(Kind::Depth), force: sign * value(Kind::Force), radius: value(Kind::ContactRadius) }
}

/// The quantity controlled by the solver, if the columns contain it.
pub(super) fn control(survey: &Survey<'_>, declared: Option<&Declared>) -> Control {
    let (depth, force) = (survey.index(Kind::Depth).is_some(), survey.index(Kind::Force).is_some());
    match declared.and_then(|own| own.control) {
        Some(Control::Force) if force => Control::Force,
        _ if depth => Control::Depth,
        _ => Control::Force,
    }
}

/// Reads the file again and compares it with the exact solution.
pub(super) fn compare(
    survey: &Survey<'_>,
    scene: &Scene,
    exact: &Exact<'_>,
    pixel: Pixel,
    judge: Tolerances,
) -> Result<Compared, ValidationError> {
    let declared = scene.data.as_ref();
    let control = control(survey, declared);
    let mut table = Table::open(&survey.data)?;
    let (mut force, mut depth, mut radius) = (Norms::new(true), Norms::new(true), Norms::new(true));
    let (mut kept, mut errors, mut drawn) = (Sample::new(KEPT), Sample::new(KEPT), Sample::new(KEPT));
    let (mut values, mut unmatched, mut has_rim) = (Vec::new(), 0, false);
    let (mut rows, mut radii) = (Neighbours::new(2, CLEAR + HEADROOM * judge.solver), Neighbours::new(1, CLEAR_RADIUS));
    let mut others = [Kind::Energy, Kind::Stiffness].map(|kind| (kind, survey.index(kind), Norms::new(true)));
    let control_kind = if control == Control::Depth { Kind::Depth } else { Kind::Force };
    let load_of: fn(f64) -> Load = if control == Control::Depth { Load::Depth } else { Load::Force };
    let mut states = States::new(exact, judge.demanded);
    while table.next(&mut values)?.is_some() {
        let row = row(survey, declared, &values);
        kept.push(row);
        let load = if control == Control::Depth { row.depth } else { row.force };
        let Some(state) = states.at(load_of(load)) else {
            unmatched += 1;
            continue;
        };
        has_rim |= state.boundary == Boundary::Rim;
        let room = exact.room(&state);
        let (at, allowed) = (survey.shown(control_kind, load), judge.allowed(pixel.pixel, &state, room));
        let limit = judge.limit(pixel.pixel, &state, room);
        let mut deciding = None;
        if control == Control::Depth && !row.force.is_nan() {
            force.add(at, load, row.force, state.force, allowed);
            force.limit(Outlier { at, data: row.force, exact: state.force, allowed }, limit);
            deciding = Some((row.force, state.force));
        }
        if control == Control::Force && !row.depth.is_nan() {
            depth.add(at, load, row.depth, exact.depth(&state), allowed);
            depth.limit(Outlier { at, data: row.depth, exact: exact.depth(&state), allowed }, limit);
            deciding = Some((row.depth, exact.depth(&state)));
            // The same error expressed as an error of the force, for comparison with other runs; it is not judged.
            if let Some(own) = states.at(Load::Depth(row.depth)) {
                force.add(at, load, row.force, own.force, allowed);
            }
        }
        if let (Some(pixel), None) = (pixel.pixel, judge.demanded)
            && state.boundary == Boundary::Rim
            && let Some(own) = if control == Control::Depth { Some(state) } else { states.at(Load::Depth(row.depth)) }
            && let Some(expected) = Expected::missed(exact, &own, (row.force, row.radius), pixel)
        {
            if control == Control::Depth {
                let (own, limit) = expected.of_force(at, row.force);
                force.limit(own, limit);
            } else {
                let (own, limit) = expected.of_depth(at, (row.force, row.depth));
                depth.limit(own, limit);
            }
        }
        // The radius of a contact of a few pixels is uncertain by half a pixel.
        if !row.radius.is_nan() && pixel.pixel.is_none_or(|h| state.radius >= FEWEST_PIXELS * h) {
            radius.add(at, load, row.radius, state.radius, allowed);
            radii.push(Outlier { at, data: row.radius, exact: state.radius, allowed }, state.radius);
        }
        for (kind, column, norms) in &mut others {
            let Some(data) = column.and_then(|own| Some(values.get(own)? * survey.factors.get(own)?)) else { continue };
            let (exact, allowed) = if *kind == Kind::Energy {
                (exact.energy(&state), WORK * allowed)
            } else {
                (exact.stiffness(&state), judge.demanded.unwrap_or(SLOPE))
            };
            if let Some(exact) = exact {
                norms.add(at, load, data, exact, allowed);
                norms.limit(Outlier { at, data, exact, allowed }, limit.max(HEADROOM * allowed));
            }
        }
        if let Some((data, exact)) = deciding {
            rows.push(Outlier { at, data, exact, allowed }, state.radius);
        }
        let decided = deciding.unwrap_or((row.radius, state.radius));
        if decided.1 != 0.0 {
            errors.push((load, decided.0 / decided.1 - 1.0));
        }
        drawn.push((at, decided.0, decided.1));
    }
    let mut tolerance = None;
    let deciding = if control == Control::Depth { &mut force } else { &mut depth };
    if let Some((own, limit)) = rows.worst() {
        deciding.limit(own, limit.max(judge.demanded.unwrap_or(0.0)));
    }
    if judge.demanded.is_none() && pixel.pixel.is_none() {
        if let Some((own, limit)) = radii.worst() {
            radius.limit(own, limit);
        }
        // For a punch with a rim the contact radius equals the radius of the punch and contains no information about the solver.
        tolerance = seen_by_radii(&radius).filter(|_| !has_rim);
        deciding.tighten(tolerance.map_or(1.0, |own| own / BLIND));
    }
    let mut report = survey.report(scene, pixel.grid);
    if let Some(tolerance) = tolerance {
        report.notes.push(format!(
            "the grid is unknown; since the contact radii are accurate to {:.1e}, the tolerance is {tolerance:.1e}",
            radius.max()
        ));
    }
    let (has_force, has_depth) = (survey.index(Kind::Force).is_some(), survey.index(Kind::Depth).is_some());
    let column = match control {
        Control::Depth if has_force => "F",
        Control::Depth => "a",
        _ if has_depth => "d",
        _ => "a",
    };
    if has_force && has_depth {
        report.columns.push(decided("F", &force, control == Control::Depth));
    }
    if control != Control::Depth && has_depth {
        report.columns.push(decided("d", &depth, true));
    }
    if survey.index(Kind::ContactRadius).is_some() {
        // Other columns judge the file where there are any.
        report.columns.push(counted(&radius, pixel.pixel, column == "a" && judge.demanded.is_some()));
    }
    report.columns.extend(others.iter().filter(|own| own.1.is_some()).map(|(kind, _, norms)| decided(kind.symbol(), norms, true)));
    let largest = kept.items.iter().map(|row: &Row| if control == Control::Depth { row.depth } else { row.force }).fold(0.0, f64::max);
    let state = exact.state(load_of(largest));
    report.pixel = pixel.pixel.zip(state.map(|own| own.radius)).map(|(h, a)| h / a);
    let kind = match column {
        "F" => Kind::Force,
        "d" => Kind::Depth,
        _ => Kind::ContactRadius,
    };
    let unit = |kind: Kind| units::shown(kind.symbol(), &survey.unit(kind, scene));
    let points = drawn.items.iter().map(|(x, data, own)| (*x, survey.shown(kind, *data), survey.shown(kind, *own))).collect();
    report.plots.push(Plot { title: unit(kind), across: unit(control_kind), points });
    if unmatched > 0 {
        report.notes.push(format!("no valid contact exists for {unmatched} of {} loads", survey.rows));
    }
    let deciding = if column == "d" { &depth } else { &force };
    let kinds = (kind, control_kind);
    let single = if column == "a" {
        None
    } else {
        {
            let own = (column, survey.unit(kinds.0, scene));
            single(deciding, |own| survey.shown(kinds.0, own), (own.0, &own.1), |at| survey.place(kinds.1, at, scene))
        }
    };
    let scaled = others.iter().find_map(|(kind, _, norms)| scaled(&report.columns, *kind, norms));
    Ok(Compared { report, rows: kept.items, errors: errors.items, column, unmatched, single, scaled, tolerance })
}

/// Returns the tolerance for an unknown grid if there is a column of radii: errors of forces and depths are at most ten times larger.
fn seen_by_radii(radius: &Norms) -> Option<f64> {
    const FEWEST: u64 = 5;
    const FORCES: f64 = 10.0;
    const LEAST: f64 = 1e-3;
    let own = (FORCES * radius.max()).max(LEAST);
    (radius.rows >= FEWEST && own < BLIND).then_some(own)
}

/// Finds the factor of a column if all other columns are within their tolerance.
fn scaled(columns: &[Column], kind: Kind, norms: &Norms) -> Option<Suspicion> {
    let mut failed = columns.iter().filter(|own| own.passed == Some(false));
    let first = failed.next().filter(|own| own.name == kind.symbol() && failed.next().is_none())?;
    let (factor, after) = norms.scaled();
    let text = format!("another scale: {} is {factor:.4} times the exact value, while F and a are correct", first.name);
    (after <= first.tolerance?).then_some(Suspicion { id: "scale", text, before: norms.l2(), after })
}

/// Finds a single row with an error if all other rows are within their tolerance.
pub(super) fn single(
    norms: &Norms,
    shown: impl Fn(f64) -> f64,
    (name, unit): (&str, &str),
    place: impl Fn(f64) -> String,
) -> Option<Suspicion> {
    let (own, after) = norms.single().filter(|_| norms.l2() > norms.allowed() || norms.beyond().is_some())?;
    let with_unit = |value: f64| format!("{value} {unit}").trim_end().to_owned();
    let text = format!(
        "one row has an error: {name} = {} at {}, but the exact value is {}",
        with_unit(shown(own.data)),
        place(own.at).trim_end(),
        significant(shown(own.exact), unit)
    );
    Some(Suspicion { id: "single-row", text, before: norms.l2(), after })
}

/// A column with its norms.
pub(super) fn decided(name: &'static str, norms: &Norms, decides: bool) -> Column {
    let tolerance = (decides && norms.decisive()).then(|| norms.allowed());
    Column {
        name,
        l1: norms.l1(),
        l2: norms.l2(),
        max: norms.max(),
        worst_at: norms.worst_at,
        bias: norms.bias(),
        rows: norms.rows,
        at_largest_load: norms.at_largest_load(),
        tolerance,
        passed: tolerance.map(|own| norms.l2() <= own && norms.beyond().is_none()),
        beyond: norms.beyond(),
        pixels: None,
        excluded: None,
    }
}

/// Contact radii have a tolerance of half a pixel if it is known, else that of the request if they decide; they are never corrected.
fn counted(norms: &Norms, pixel: Option<f64>, decides: bool) -> Column {
    let column = decided("a", norms, decides && pixel.is_none());
    match pixel {
        Some(pixel) => {
            let pixels = norms.farthest / pixel;
            // Radii may be printed with few digits: compare half a pixel up to rounding.
            Column { pixels: Some(pixels), tolerance: Some(0.5), passed: Some(pixels <= 0.5 * (1.0 + 1e-6)), ..column }
        }
        None if !decides && (column.l2 > BLIND_RADIUS || column.beyond.is_some()) => {
            Column { tolerance: Some(BLIND_RADIUS), passed: Some(false), ..column }
        }
        None => column,
    }
}
