//! A file with fields under one load: pressures away from the apex, kinks and the rim, displacements, and the force from the pressures.

use super::exact::{Exact, Pressures};
use super::loads::{BLIND_ROW, HEADROOM, Tolerances, decided, single};
use super::mirrored::Mirrored;
use super::norms::{GOLDEN, Norms, Outlier, Sample};
use super::peak::{CUT, Peak};
use super::record::{Beyond, Column, Excluded, Plot, significant};
use super::region::{Region, excused};
use super::rim::Expected;
use super::shells::Shells;
use super::{FileReport, Suspicion, ValidationError};
use crate::contact::{Boundary, State};
use crate::scene::Scene;
use crate::validate::diagnosis::displacement::Displacements;
use crate::validate::file::column::Kind;
use crate::validate::file::lattice::Offset;
use crate::validate::file::layout::Averaging;
use crate::validate::file::pixel::Pixel;
use crate::validate::file::survey::{Cell, Places, Survey};
use crate::validate::file::table::Table;
use crate::validate::file::units;
use std::f64::consts::PI;

/// A point with its pressure, and coordinates if the file has them, in computing units and positive in compression.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) r: f64,
    pub(super) p: f64,
}

impl Spot {
    /// Returns the same pressure at another point.
    pub(super) fn at(&self, (x, y): (f64, f64)) -> Self {
        Self { x, y, r: if y.is_nan() { x.abs() } else { x.hypot(y) }, ..*self }
    }
}

/// A file with fields compared with the exact solution.
pub(super) struct Compared {
    pub(super) report: FileReport,
    /// Evenly sampled points.
    pub(super) spots: Vec<Spot>,
    /// Distance, data and exact pressure of the compared points, evenly sampled.
    pub(super) errors: Vec<(f64, f64, f64)>,
    /// The displacements of evenly sampled rows.
    pub(super) displacements: Displacements,
    /// The distance between compared points and the apex, kinks and rim.
    pub(super) margin: f64,
    /// The distance between the edge of the contact and the nearest kink.
    pub(super) room: f64,
    /// A single point with an error, or clipped pressures.
    pub(super) single: Option<Suspicion>,
}

/// Number of pixels between compared points and singular points.
pub(super) const MARGIN: f64 = 4.0;
/// Near the edge, the tolerance is the change of the exact pressure over this many pixels, on the side where it changes more, times
/// 1 + `AT_EDGE`.
const EDGE: f64 = 1.5;
const AT_EDGE: f64 = 0.1;
/// The largest pressure outside of a smooth edge, relative to the mean pressure, in addition to that `EDGE` pixels further inside.
const OUTSIDE: f64 = 0.02;
/// The tolerance of displacements around a rim, relative to the tolerance of the force.
const RIM_OUTSIDE: f64 = 2.0;
/// Maximum fraction by which a pressure at a rim may be smaller than the exact pressure `EDGE` pixels further inside.
const AT_RIM: f64 = 0.5;
/// Pressures below this fraction of the mean pressure are rounding errors.
const ROUNDING: f64 = 1e-6;
/// A force this close to the exact force, relative to the tolerance, is taken to have been imposed.
const CONTROLLED: f64 = 0.1;
/// Number of rows computed together.
const BLOCK: usize = 4096;
/// Number of points kept for plots, the diagnosis, and the order.
const KEPT: usize = 400;
const KEPT_ERRORS: usize = 4000;
/// Number of displacements compared.
const DISPLACEMENTS: u64 = 4000;

/// Returns radii whose mean pressure approximates the mean over a cell: two in the cell, or the point itself.
pub(super) fn places(r: f64, cell: Option<Cell>, out: &mut Vec<f64>) {
    match cell {
        None => out.push(r),
        Some(cell) => out.extend(cell.radii(r)),
    }
}

/// Reads the file again and compares it with the exact solution.
pub(super) fn compare(
    survey: &Survey<'_>,
    scene: &Scene,
    exact: &Exact<'_>,
    state: &State,
    pixel: Pixel,
    judge: Tolerances,
) -> Result<Compared, ValidationError> {
    let (a, room) = (state.radius, exact.room(state));
    let declared = scene.data.as_ref();
    let cell = survey.cell(pixel.pixel);
    let sign = if declared.is_some_and(|own| own.tension) { -1.0 } else { 1.0 };
    // Without a known pixel, the spacing of the points is used.
    let margin = MARGIN * pixel.pixel.unwrap_or_else(|| spacing(survey, a));
    let formula = exact.formula();
    let pressures = Pressures::new(exact, formula.as_ref(), state, survey.rows);
    let region = Region::new(a, margin, &pressures.sharp);
    let contact = exact.contact(state);
    let mut own = Sums::new(state, (margin, room), survey, pixel);
    let mut table = Table::open(&survey.data)?;
    let (at_p, at_u) = (survey.index(Kind::Pressure), survey.index(Kind::Displacement));
    let locations = survey.places();
    let value =
        |values: &[f64], index: Option<usize>| index.and_then(|own| values.get(own).zip(survey.factors.get(own))).map(|(v, f)| v * f);
    let every = survey.rows.div_ceil(DISPLACEMENTS).max(1);
    // Steps by the golden ratio sample all rows and columns of a lattice evenly.
    let is_drawn = |index: u64| (index.wrapping_mul(GOLDEN) >> 32).is_multiple_of(every);
    let (mut values, mut index, mut ended) = (Vec::new(), 0u64, false);
    let free_constant = at_u.and_then(|own| survey.columns.get(own)).is_some_and(|own| own.free_constant);
    let mut displacements = Displacements::new(free_constant);
    let shape = exact.shape();
    let mut shapes = [Kind::Profile, Kind::Equivalent].map(|kind| (kind, survey.index(kind), Norms::new(false)));
    let (mut block, mut wanted, mut found) = (Vec::with_capacity(BLOCK), Vec::new(), Vec::new());
    while !ended {
        block.clear();
        while block.len() < BLOCK {
            if table.next(&mut values)?.is_none() {
                ended = true;
                break;
            }
            let spot = spot(&values, survey, locations, value(&values, at_p).map_or(f64::NAN, |p| sign * p));
            if let (Some(u), true) = (value(&values, at_u), is_drawn(index))
                && let Ok(reading) = contact.displacement(spot.r, a)
            {
                displacements.push(survey.shown(Kind::Distance, spot.r), u, reading.estimate.value);
            }
            for (kind, column, norms) in shapes.iter_mut().filter(|_| is_drawn(index)) {
                let exact = if *kind == Kind::Profile { shape.profile(spot.r) } else { shape.depth(spot.r) };
                if let (Some(own), Ok(exact)) = (value(&values, *column), exact) {
                    norms.add(
                        survey.shown(Kind::Distance, spot.r),
                        0.0,
                        own,
                        exact.estimate.value,
                        judge.allowed(pixel.pixel, state, room),
                    );
                }
            }
            index += 1;
            if at_p.is_some() {
                block.push(spot);
            }
        }
        wanted.clear();
        block.iter().for_each(|spot| places(spot.r, cell, &mut wanted));
        pressures.at(&wanted, &mut found);
        wanted.clear();
        let each = if cell.is_some() { 2 } else { 1 };
        for (spot, exact) in block.iter().zip(found.chunks(each)) {
            let exact = exact.iter().sum::<f64>() / each as f64;
            own.add(spot, exact, &region, judge, pixel);
        }
        if let (Some(h), None) = (pixel.pixel, judge.demanded) {
            let near: Vec<&Spot> = block.iter().filter(|spot| region.meets_edge(spot.r)).collect();
            near.iter().for_each(|spot| wanted.extend([(spot.r - EDGE * h).max(0.0), spot.r, spot.r + EDGE * h]));
            pressures.at(&wanted, &mut found);
            near.iter().zip(found.chunks(3)).for_each(|(spot, exact)| own.add_at_edge(spot, exact));
        }
    }
    for unequal in own.mirrored.unequal(own.mean, HEADROOM * judge.demanded.unwrap_or(0.0)) {
        own.compared.suspect(unequal.own, unequal.difference, unequal.limit);
    }
    let mut report = own.report(survey, scene, exact, pixel, judge);
    if own.mirrored.repeated() > 0 {
        report.notes.push(format!("{} points are in the data more than once", own.mirrored.repeated()));
    }
    if at_u.is_some() {
        // Around a rim the displacement changes as fast as the pressure inside, so its error is larger than the error of the force.
        let allowed = judge.allowed(pixel.pixel, state, room) * if state.boundary == Boundary::Rim { RIM_OUTSIDE } else { 1.0 };
        report.columns.push(decided("u", &displacements.norms(allowed), true));
        if every > 1 {
            report.notes.push(format!("u is compared in {} of {} rows, sampled evenly", displacements.len(), survey.rows));
        }
        if free_constant {
            let constant = survey.shown(Kind::Displacement, displacements.constant());
            let unit = units::shown("u", &survey.unit(Kind::Displacement, scene));
            report.notes.push(format!("u is compared up to a constant, which is {constant:.6e} in the data ({unit})"));
        }
    }
    for (kind, _, norms) in shapes.iter().filter(|own| own.1.is_some()) {
        report.columns.push(decided(kind.symbol(), norms, true));
    }
    if at_p.is_some() {
        let text = match (cell, survey.averaging) {
            (Some(Cell::Square { .. }), _) => "pressures are treated as means over pixels",
            (Some(Cell::Ring { .. }), _) => "pressures are treated as means over rings",
            (None, Some(Averaging::OverSquares | Averaging::OverRings)) => {
                "the pixel is not known, so pressures are treated as values at points"
            }
            (None, _) => "pressures are treated as values at points",
        };
        report.notes.push(text.to_owned());
    }
    let shown = |p: f64| sign * survey.shown(Kind::Pressure, p);
    // If the norms fail as well, a wrong axis or another fault may explain the data, and the diagnosis decides.
    let holds = own.compared.l2() <= own.compared.allowed();
    let top = |p: f64| significant(shown(p), &survey.unit(Kind::Pressure, scene));
    let cut_off = own.peak.suspicion(top, own.compared.l2()).filter(|_| holds);
    let single = cut_off.or_else(|| {
        let unit = |kind: Kind| survey.unit(kind, scene);
        let place = |r: f64| format!("r = {} {}", survey.shown(survey.distance(), r), unit(survey.distance()));
        single(&own.compared, shown, ("p", &unit(Kind::Pressure)), place)
    });
    Ok(Compared { report, spots: own.spots.items, errors: own.errors.items, displacements, margin, room, single })
}

fn spot(values: &[f64], survey: &Survey<'_>, places: Places, p: f64) -> Spot {
    let number = |index: Option<usize>| index.and_then(|own| values.get(own).zip(survey.factors.get(own))).map_or(f64::NAN, |(v, f)| v * f);
    let (x, y) = (number(places.x) - places.axis, if places.y.is_some() { number(places.y) - places.axis } else { 0.0 });
    let r = if places.r.is_some() { number(places.r) } else { x.hypot(y) };
    Spot { x, y, r: r.abs(), p }
}

/// Estimates the spacing of neighbouring points if they do not form a lattice.
fn spacing(survey: &Survey<'_>, a: f64) -> f64 {
    let reach = [Kind::Distance, Kind::X].into_iter().find_map(|kind| survey.largest(kind)).unwrap_or(a);
    (reach / survey.rows as f64).max(1e-6 * a).min(0.05 * a)
}

/// The sums over all rows.
struct Sums {
    compared: Norms,
    left_out: Norms,
    peak: Peak,
    mirrored: Mirrored,
    infinite: u64,
    spots: Sample<Spot>,
    errors: Sample<(f64, f64, f64)>,
    /// Forces from the data and from the exact pressures by the same rule, if the lattice is complete.
    force: Shells,
    /// True if the pressures are means over pixels, whose sum is the exact force.
    means: bool,
    /// True if the scene or the file declares them as values at points.
    values: bool,
    state: State,
    /// The mean pressure.
    mean: f64,
    rim: bool,
    /// The distance between the edge of the contact and the nearest kink.
    room: f64,
    /// The pixel; 0 if it is unknown.
    pixel: f64,
}

impl Sums {
    fn new(state: &State, (margin, room): (f64, f64), survey: &Survey<'_>, pixel: Pixel) -> Self {
        let mean = state.force / (PI * state.radius * state.radius);
        Self {
            compared: Norms::new(false),
            left_out: Norms::new(false),
            peak: Peak::default(),
            mirrored: Mirrored::new(survey.lattice.filter(|own| own.offset != Offset::Line).map(|own| own.pixel)),
            infinite: 0,
            spots: Sample::new(KEPT),
            errors: Sample::new(KEPT_ERRORS),
            room,
            pixel: pixel.pixel.unwrap_or(0.0),
            force: Shells::new(survey, state.radius + pixel.pixel.unwrap_or(margin), pixel, ROUNDING * mean),
            means: matches!(survey.cell(pixel.pixel), Some(Cell::Square { .. })),
            values: survey.averaging == Some(Averaging::Values),
            state: *state,
            mean,
            rim: state.boundary == Boundary::Rim,
        }
    }

    fn add(&mut self, spot: &Spot, exact: f64, region: &Region, judge: Tolerances, pixel: Pixel) {
        self.spots.push(*spot);
        // Within a pixel of a kink, the value at a point is not the mean over the pixel; exclude both from the force.
        let in_force = if !self.means && region.is_near_inner(spot.r, self.pixel) { f64::NAN } else { exact };
        self.force.add((spot.r, spot.p), in_force, self.means);
        if exact.is_nan() {
            self.infinite += 1;
            return;
        }
        self.mirrored.add(spot.x, spot.y, Outlier { at: spot.r, data: spot.p, exact, allowed: 0.0 });
        self.peak.add(spot.r, spot.p, exact);
        let holds = region.holds(spot.r);
        if holds || region.lies_between(spot.r, pixel.pixel) {
            let grid = excused(spot.r, region, pixel.pixel, self.rim) + judge.solver;
            let allowed = judge.demanded.unwrap_or(grid);
            let limit = if pixel.pixel.is_some() { HEADROOM * grid } else { BLIND_ROW };
            let own = Outlier { at: spot.r, data: spot.p, exact, allowed };
            self.compared.limit(own, limit.max(HEADROOM * judge.demanded.unwrap_or(0.0)));
            if holds {
                self.compared.add(spot.r, 0.0, spot.p, exact, allowed);
                self.errors.push((spot.r, spot.p, exact));
            }
        }
        if !holds {
            self.left_out.add(spot.r, 0.0, spot.p, exact, 0.0);
        }
    }

    /// Adds a point near the edge, with the exact pressures a few pixels further inside, at the point, and as far outside.
    fn add_at_edge(&mut self, spot: &Spot, exact: &[f64]) {
        let [inner, exact, outer] = *exact else { return };
        let far = (inner - exact).abs().max((exact - outer).abs());
        if self.rim {
            // The exact pressure is infinite at a rim, so only a lower limit applies; pixels that the rim cuts are not judged.
            let lost = Outlier { at: spot.r, data: spot.p, exact: inner, allowed: AT_RIM };
            if inner.is_finite() && spot.p < inner && spot.r + 0.75 * self.pixel <= self.state.radius {
                self.compared.limit(lost, AT_RIM);
            }
        } else if far.is_finite() && exact > 0.0 {
            let limit = (1.0 + AT_EDGE) * far / exact;
            self.compared.limit(Outlier { at: spot.r, data: spot.p, exact, allowed: limit }, limit);
        } else if inner.is_finite() && self.state.radius <= spot.r {
            // A pixel that the edge cuts may have what the contact has further inside.
            let limit = OUTSIDE + (1.0 + AT_EDGE) * inner / self.mean;
            self.compared.limit_relative_to(self.mean, Outlier { at: spot.r, data: spot.p, exact, allowed: limit }, limit);
        }
    }

    fn report(&mut self, survey: &Survey<'_>, scene: &Scene, exact: &Exact<'_>, pixel: Pixel, judge: Tolerances) -> FileReport {
        let at = |r: f64| survey.shown(if survey.index(Kind::Distance).is_some() { Kind::Distance } else { Kind::X }, r);
        let mut columns = Vec::new();
        let mut notes = survey.notes.clone();
        if survey.index(Kind::Pressure).is_some() {
            // Near kinks and rims the tolerances are too wide to detect clipped pressures.
            if let Some(own) = self.peak.cut_off() {
                self.compared.limit(own, CUT.max(HEADROOM * judge.demanded.unwrap_or(0.0)));
            }
            let mut column = decided("p", &self.compared, true);
            column.worst_at = at(column.worst_at);
            column.beyond = column.beyond.map(|own| Beyond { at: at(own.at), ..own });
            column.at_largest_load = column.l2;
            let rows = self.left_out.rows + self.infinite;
            column.excluded =
                (rows > 0).then(|| Excluded { rows, infinite: self.infinite, l2: self.left_out.l2(), max: self.left_out.max() });
            columns.push(column);
            match self.force.total() {
                Some((data, sum, radius)) => columns.push(self.integrated(exact, (data, sum, radius), pixel, judge)),
                None => notes.push(
                    "the force of the pressures is not judged, since it needs the pressures at all points of a lattice, each once"
                        .to_owned(),
                ),
            }
        }
        let unit = |kind: Kind| units::shown(kind.symbol(), &survey.unit(kind, scene));
        let across = unit(if survey.index(Kind::Distance).is_some() { Kind::Distance } else { Kind::X });
        let points = self.errors.items.iter().step_by(self.errors.items.len() / KEPT + 1);
        let points = points.map(|(r, p, exact)| (at(*r), survey.shown(Kind::Pressure, *p), survey.shown(Kind::Pressure, *exact))).collect();
        FileReport {
            name: survey.name(scene),
            grid: pixel.grid,
            pixel: pixel.pixel.map(|h| h / self.state.radius),
            rows: survey.rows,
            columns,
            notes,
            plots: vec![Plot { title: unit(Kind::Pressure), across, points }],
        }
    }

    fn integrated(&self, exact: &Exact<'_>, (data, sum, radius): (f64, f64, f64), pixel: Pixel, judge: Tolerances) -> Column {
        // Pixels cut by the edge of a smooth contact, where p vanishes as a square root: O((h/a)^(3/2)).
        let narrow = (self.state.radius / self.room).sqrt();
        let grid = pixel.pixel.map_or(super::loads::BLIND, |h| 0.5 * (h / self.state.radius).powf(1.5) * narrow);
        let force = if self.means { self.state.force } else { sum };
        let allowed = judge.demanded.unwrap_or(0.0).max(grid + judge.solver);
        let mut norms = Norms::new(true);
        norms.add(0.0, 0.0, data, force, allowed);
        // This does not apply to the exact force of a solver under force control, nor to the sum of exact values at points.
        let known = [self.state.force, sum].into_iter().any(|own| (data / own - 1.0).abs() <= CONTROLLED * allowed);
        let missed = pixel.pixel.filter(|_| !self.values && !known && judge.demanded.is_none());
        let missed = missed.and_then(|h| Expected::missed(exact, &self.state, (data, radius), h));
        if let Some(expected) = &missed {
            let (own, limit) = expected.of_force(radius, data);
            norms.limit(own, limit);
        }
        // Otherwise a sum of values under a rim is reported, but not judged.
        decided("F_from_p", &norms, self.means || !self.rim || missed.is_some())
    }
}
