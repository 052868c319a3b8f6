//! Runs a validation: surveys the files, determines the pixels, compares, judges, and searches for a fault.

use super::diagnosis::{self, Evidence, Unfinished};
use super::exact::Exact;
use super::order::Level;
use super::record::significant;
use super::region::Region;
use super::verdict::{Verdict, verdict};
use super::{FileReport, Suspicion, Validation, ValidationError, field, loads};
use crate::contact::{Boundary, Load, State};
use crate::scene::{Change, Control, Dimension, Scene, Walls, scene_for_data};
use crate::validate::diagnosis::placing::placings;
use crate::validate::diagnosis::score::GridProperties;
use crate::validate::file::column::Kind;
use crate::validate::file::data::{Data, Source};
use crate::validate::file::layout::Layout;
use crate::validate::file::pixel::{Pixel, contradiction, pixels};
use crate::validate::file::row::Row;
use crate::validate::file::survey::{Content, Survey};
use crate::validate::file::units::DataUnits;
use std::collections::BTreeSet;

/// The input of a validation.
pub struct Request<'a> {
    /// The text of the scene file.
    pub text: &'a str,
    /// The scene of this text, with the points of its tip if it has one.
    pub scene: &'a Scene,
    /// The data.
    pub sources: &'a [Source<'a>],
    /// Relative error to accept, instead of the discretization error.
    pub tolerance: Option<f64>,
    /// Number of pixels along a side of the box, per file.
    pub grid: &'a [f64],
    /// User-defined layout of the files.
    pub layout: &'a Layout,
}

/// Compares a solver's data with the exact solution of a scene.
///
/// Files with d, F and a contain one load per row; files with r (or x, y) and p or u contain points under the single load of the scene,
/// or under every load in their column d.
///
/// # Errors
/// [`ValidationError`] if a file or the scene cannot be read.
pub fn validate(request: &Request<'_>) -> Result<Validation, ValidationError> {
    let scene = request.scene;
    let mut units = DataUnits::default();
    let mut surveys = Vec::new();
    for source in request.sources {
        for data in Data::of(source, request.layout, scene)? {
            surveys.push(Survey::new(data, scene, &mut units)?);
        }
    }
    let names: Vec<String> = surveys.iter().flat_map(|own| own.names.iter().cloned()).collect();
    if let Some(error) = request.layout.without_column(&names) {
        return Err(error);
    }
    let work = Work { request, scene, judge: judge(request, scene) };
    let length = |own: f64| significant(own * scene.system.out(Dimension::LENGTH), &scene.system.unit_name(Dimension::LENGTH));
    let mut parts = Vec::new();
    for (content, mut own) in groups(&mut surveys) {
        let pixels = pixels(&mut own, content, scene.data.as_ref(), request.grid, &length)?;
        let contradiction = contradiction(&pixels, &length);
        let mut files: Vec<(&Survey<'_>, Pixel)> = own.into_iter().map(|own| &*own).zip(pixels).collect();
        files.sort_by(|one, other| other.1.relative.total_cmp(&one.1.relative));
        let part = if content == Content::Loads { work.loads(&files)? } else { work.field(&files)? };
        parts.push(part.against(contradiction, content == Content::Loads));
    }
    let mut notes: Vec<String> = units.note.into_iter().collect();
    if scene.data.as_ref().is_some_and(|own| own.walls == Walls::Periodic) {
        notes.push("the box is declared as periodic, but the exact solution does not include periodic images".to_owned());
    }
    let uses_radii = |own: &Survey<'_>| own.data.arrays.as_ref().is_some_and(|arrays| arrays.radii);
    if request.layout.radii && !surveys.iter().any(uses_radii) {
        notes.push("the given radii are not used, since the data contain coordinates".to_owned());
    }
    let mut found = together(parts, request.sources.len(), notes);
    let unread: BTreeSet<&str> = surveys.iter().flat_map(|survey| survey.unread.iter().map(String::as_str)).collect();
    if !unread.is_empty() {
        let names: Vec<&str> = unread.into_iter().collect();
        found.reason = format!("{}; ignored columns: {}", found.reason, names.join(", "));
    }
    Ok(found)
}

/// Groups files with loads, and files with fields by their load; the files of one group are several resolutions.
fn groups<'a, 's>(surveys: &'a mut [Survey<'s>]) -> Vec<(Content, Vec<&'a mut Survey<'s>>)> {
    let mut groups: Vec<(Content, Vec<&mut Survey<'s>>)> = Vec::new();
    let near = |one: Option<f64>, other: Option<f64>| match (one, other) {
        (Some(one), Some(other)) => (one - other).abs() <= 1e-6 * one.abs().max(other.abs()),
        _ => one.is_none() && other.is_none(),
    };
    for own in surveys {
        let same = |group: &&mut (Content, Vec<&mut Survey<'s>>)| {
            group.0 == own.content && group.1.first().is_some_and(|first| near(first.load_value(), own.load_value()))
        };
        match groups.iter_mut().find(same) {
            Some(group) => group.1.push(own),
            None => groups.push((own.content, vec![own])),
        }
    }
    groups.sort_by_key(|group| group.0 == Content::Field);
    groups
}

fn judge(request: &Request<'_>, scene: &Scene) -> loads::Tolerances {
    loads::Tolerances { demanded: request.tolerance, solver: scene.data.as_ref().map_or(0.0, |own| own.tolerance) }
}

/// The result for the files of one kind.
struct Part {
    /// The load of the fields, if the files have several loads.
    load: Option<String>,
    verdict: Verdict,
    suspicion: Result<Option<Suspicion>, Unfinished>,
    files: Vec<FileReport>,
    /// Warnings about the exact solution.
    warnings: Vec<String>,
}

impl Part {
    /// Returns the verdict on one of several loads at which the contact radius is 0, so that p and u must be 0.
    fn apart(load: String, files: &[(&Survey<'_>, Pixel)], scene: &Scene, warnings: Vec<String>) -> Self {
        let size = |survey: &Survey<'_>, kind: Kind, scale: f64| survey.largest(kind).filter(|own| *own > NOTHING * scale);
        let wrong = files.iter().find_map(|(survey, _)| {
            let reach = survey.largest(Kind::Distance).or(survey.largest(Kind::X)).unwrap_or(1.0);
            let p = size(survey, Kind::Pressure, scene.effective_modulus).map(|_| "p");
            p.or(size(survey, Kind::Displacement, reach).map(|_| "u"))
        });
        let reason = match wrong {
            Some(name) => format!("{name} is not 0 although the bodies do not touch"),
            None => "nothing was judged: the bodies do not touch".to_owned(),
        };
        let verdict = Verdict { passed: false, judged: wrong.is_some(), reason, advice: None, order: None, grows: false };
        let files = files.iter().map(|(survey, pixel)| survey.report(scene, pixel.grid)).collect();
        Self { load: Some(load), verdict, suspicion: Ok(None), files, warnings }
    }

    /// Fails if the points of the data contradict the declaration.
    fn against(mut self, contradiction: Option<Suspicion>, of_radii: bool) -> Self {
        if let Some(found) = contradiction {
            if self.verdict.passed {
                self.verdict.reason = "the declared box and grid do not fit the data".to_owned();
            }
            (self.verdict.passed, self.verdict.judged) = (false, true);
            // Coordinates from a corner often miss a pixel as well, and the axis is the larger fault. Contact radii that do not fit the
            // box may be the consequence of another fault, such as swapped columns.
            let is_larger = |own: &Suspicion| of_radii || matches!(own.id, "origin-corner" | "fftshift");
            if !matches!(&self.suspicion, Ok(Some(own)) if is_larger(own)) {
                self.suspicion = Ok(Some(found));
            }
        }
        self
    }

    /// Returns the reason, with advice if no fault explains the data.
    fn reason(&self) -> String {
        let own = match self.verdict.advice.filter(|_| matches!(self.suspicion, Ok(None))) {
            Some(advice) => format!("{}; {advice}", self.verdict.reason),
            None => self.verdict.reason.clone(),
        };
        self.load.as_ref().map_or_else(|| own.clone(), |load| format!("{load}: {own}"))
    }
}

/// Pressures below this fraction of E*, and displacements below this fraction of the largest radius, are treated as 0.
const NOTHING: f64 = 1e-6;
/// What is said where the budget does not suffice for the search for a fault.
const SEARCH_CUT: &str = "the search for the fault was stopped at the work limit";
/// Maximum number of reasons in one sentence.
const MOST_REASONS: usize = 2;

/// Combines the results of all kinds.
fn together(parts: Vec<Part>, count: usize, notes: Vec<String>) -> Validation {
    // A load without comparable points, such as the first load of a ramp from 0, is ignored if other loads can be compared.
    let passed = parts.iter().any(|own| own.verdict.passed) && parts.iter().all(|own| own.verdict.passed || !own.verdict.judged);
    let mut telling: Vec<String> =
        parts.iter().filter(|own| own.verdict.judged && own.verdict.passed == passed).map(Part::reason).collect();
    let more = telling.len().saturating_sub(MOST_REASONS);
    if more > 0 {
        telling.truncate(MOST_REASONS);
        let (loads, end) = (if more == 1 { "load" } else { "loads" }, if passed { "passed" } else { "failed" });
        telling.push(format!("{more} more {loads} {end}"));
    }
    let unjudged: Vec<String> = parts.iter().filter(|own| !own.verdict.judged).map(Part::reason).collect();
    telling.extend(unjudged.into_iter().take(MOST_REASONS));
    let suspicions: Vec<&Suspicion> = parts.iter().filter_map(|own| own.suspicion.as_ref().ok()?.as_ref()).collect();
    let agreed = suspicions.first().filter(|first| suspicions.iter().all(|own| own.id == first.id));
    let orders: Vec<_> = parts.iter().filter_map(|own| own.verdict.order).collect();
    Validation {
        passed,
        reason: telling.join("; "),
        suspicion: agreed.map(|own| (*own).clone()),
        cut_short: parts.iter().any(|own| own.suspicion.is_err()).then_some(SEARCH_CUT),
        columns: parts.iter().filter_map(|own| own.files.last()).flat_map(|own| own.columns.clone()).collect(),
        warnings: parts.iter().flat_map(|own| own.warnings.iter().cloned()).collect::<BTreeSet<_>>().into_iter().collect(),
        orders: (count > parts.len() && !orders.is_empty()).then_some(orders),
        files: parts.into_iter().flat_map(|own| own.files).collect(),
        notes,
    }
}

struct Work<'w> {
    request: &'w Request<'w>,
    scene: &'w Scene,
    judge: loads::Tolerances,
}

impl Work<'_> {
    fn declared_force(&self) -> bool {
        self.scene.data.as_ref().is_some_and(|own| own.control == Some(Control::Force))
    }

    fn loads(&self, files: &[(&Survey<'_>, Pixel)]) -> Result<Part, ValidationError> {
        let largest = |kind: Kind| files.iter().filter_map(|(own, _)| own.largest(kind)).fold(0.0, f64::max);
        let by_force = files.iter().all(|(own, _)| loads::control(own, self.scene.data.as_ref()) == Control::Force);
        let load = if by_force { Load::Force(largest(Kind::Force)) } else { Load::Depth(largest(Kind::Depth)) };
        let solution = self.scene.solution()?;
        let exact = Exact::new(self.scene, &solution, load)?;
        let mut all = Vec::new();
        for (survey, pixel) in files {
            all.push(loads::compare(survey, self.scene, &exact, *pixel, self.judge)?);
        }
        let errors: Vec<&[(f64, f64)]> = all.iter().map(|own| own.errors.as_slice()).collect();
        let relative: Vec<f64> = files.iter().map(|(_, pixel)| pixel.relative).collect();
        let levels = paired(&errors, &relative);
        let Some(finest) = all.last() else {
            return Err(ValidationError::request("no data files", "expected at least one data file"));
        };
        let has_rim = exact.state(load).is_some_and(|own| own.boundary == Boundary::Rim);
        let last = files.last().map(|own| own.0);
        let control = if by_force { Kind::Force } else { Kind::Depth };
        let place = |at: f64| last.map_or(String::new(), |own| own.place(control, at, self.scene));
        let verdict = verdict(finest.column, &finest.report.columns, &levels, (self.judge.solver, has_rim), finest.unmatched, &place);
        let suspicion = if verdict.passed {
            Ok(None)
        } else if let Some(own) = finest
            .single
            .clone()
            .or_else(|| finest.scaled.clone())
            .or_else(|| reversed(&verdict, &all.iter().map(|own| &own.report).collect::<Vec<_>>()))
        {
            Ok(Some(own))
        } else {
            let pixel = files.last().and_then(|own| own.1.pixel);
            let margin = finest.rows.iter().map(|row| row.radius).fold(0.0, f64::max);
            let reach = exact.state(load).map_or(margin, |own| own.radius);
            let gauge =
                GridProperties { pixel, margin: reach, cell: None, solver: self.judge.solver, demanded: finest.tolerance, by_force };
            let factors = files.last().map_or(Row { depth: 1.0, force: 1.0, radius: 1.0 }, |own| own.0.row_factors());
            let evidence = Evidence::Loads {
                rows: finest.rows.clone(),
                factors,
                columns: files.last().map_or_else(Vec::new, |own| own.0.labels(self.scene)),
            };
            diagnosis::diagnose(self.request.text, self.scene, &evidence, &gauge)
        };
        Ok(Part { load: None, verdict, suspicion, files: all.into_iter().map(|own| own.report).collect(), warnings: solution.warnings() })
    }

    fn field(&self, files: &[(&Survey<'_>, Pixel)]) -> Result<Part, ValidationError> {
        let known = files.first().and_then(|(survey, _)| survey.load());
        let (solution, load) = (self.scene.solution()?, known.map_or_else(|| self.single_load(), Ok)?);
        let exact = Exact::new(self.scene, &solution, load)?;
        let found = exact.state(load);
        let Some(state) = found.filter(|own| own.radius > 0.0) else {
            if let (Some(_), Some(load)) = (found, files.first().and_then(|(survey, _)| survey.load_name(self.scene))) {
                return Ok(Part::apart(load, files, self.scene, solution.warnings()));
            }
            return Err(ValidationError::request(
                "the load of the scene produces no contact, so exact pressures are undefined",
                "expected a load with a valid contact",
            ));
        };
        let mut all = Vec::new();
        for (survey, pixel) in files {
            all.push(field::compare(survey, self.scene, &exact, &state, *pixel, self.judge)?);
        }
        let Some(finest) = all.last() else {
            return Err(ValidationError::request("no data files", "expected at least one data file"));
        };
        // Orders are computed in one region, determined by the coarsest file.
        let margin = all.iter().map(|own| own.margin).fold(0.0, f64::max);
        let region = Region::new(state.radius, margin, &exact.sharp(state.radius));
        let relative = files.iter().map(|(_, pixel)| pixel.relative);
        let levels: Vec<Level> = all.iter().zip(relative).map(|(own, pixel)| level(pixel, within(&own.errors, &region))).collect();
        let column = finest.report.columns.first().map_or("p", |own| own.name);
        let levels = if column == "p" { levels } else { Vec::new() };
        let last = files.last().map(|own| own.0);
        let unit = last.map_or(String::new(), |own| own.unit(own.distance(), self.scene));
        let place = |at: f64| format!("r = {at} {unit}").trim_end().to_owned();
        let judged = (self.judge.solver, state.boundary == Boundary::Rim);
        let verdict = verdict(column, &finest.report.columns, &levels, judged, 0, &place);
        let reversed = reversed(&verdict, &all.iter().map(|own| &own.report).collect::<Vec<_>>());
        let suspicion = match finest.single.clone().or(reversed) {
            _ if verdict.passed => Ok(None),
            Some(own) => Ok(Some(own)),
            None => files.last().map_or(Ok(None), |(survey, pixel)| self.suspicion(finest, survey, *pixel, &state)),
        };
        let load = files.first().and_then(|(survey, _)| survey.load_name(self.scene));
        Ok(Part { load, verdict, suspicion, files: all.into_iter().map(|own| own.report).collect(), warnings: solution.warnings() })
    }

    fn suspicion(
        &self,
        finest: &field::Compared,
        survey: &Survey<'_>,
        pixel: Pixel,
        state: &State,
    ) -> Result<Option<Suspicion>, Unfinished> {
        let fails = |name: &str| finest.report.columns.iter().any(|own| own.name == name && own.passed == Some(false));
        if fails("u") && !fails("p") && !fails("F_from_p") {
            return Ok(self.suspicion_of_displacements(finest, survey, pixel, state));
        }
        let declared = self.scene.data.as_ref();
        let held = match (declared.and_then(|own| own.control), self.scene.control) {
            (Some(Control::Force), _) | (None, Control::Force) => vec![Control::Force],
            (Some(_), _) | (None, Control::Depth) => vec![Control::Depth],
            (None, Control::ContactRadius) => vec![Control::Depth, Control::Force, Control::ContactRadius],
        };
        let cell = survey.cell(pixel.pixel);
        let (solver, by_force) = (self.judge.solver, self.declared_force());
        let gauge = GridProperties { pixel: pixel.pixel, margin: finest.margin, cell, solver, demanded: None, by_force };
        let evidence = Evidence::Field {
            spots: finest.spots.clone(),
            state: *state,
            held,
            side: pixel.side.or_else(|| survey.filled_square()),
            placings: placings(&survey.extent, pixel.pixel, pixel.side),
            factors: survey.place_factors(),
            columns: survey.labels(self.scene),
        };
        diagnosis::diagnose(self.request.text, self.scene, &evidence, &gauge)
    }

    fn suspicion_of_displacements(&self, finest: &field::Compared, survey: &Survey<'_>, pixel: Pixel, state: &State) -> Option<Suspicion> {
        let young =
            scene_for_data(self.request.text, &Change::NoPoisson).ok().map(|own| own.effective_modulus / self.scene.effective_modulus);
        let unit = survey.unit(Kind::Displacement, self.scene);
        let length = |own: f64| format!("{:.4e} {unit}", survey.shown(Kind::Displacement, own)).trim_end().to_owned();
        finest.displacements.suspicion(
            self.judge.allowed(pixel.pixel, state, finest.room),
            young.filter(|own| (own - 1.0).abs() > 1e-6),
            &length,
        )
    }

    fn single_load(&self) -> Result<Load, ValidationError> {
        let help = "expected one load, such as depth = \"0.4 um\" in [load]";
        match (self.scene.loads.len(), self.scene.loads.get(0)) {
            (1, Some(value)) => Ok(self.scene.control.load(value)),
            (0, _) => Err(ValidationError::request("fields require a load, but the scene has none", help)),
            (count, _) => Err(ValidationError::request(format!("fields require a single load, but the scene has {count} loads"), help)),
        }
    }
}

/// Returns the wrong order of the files as a fault if the errors increase with refinement, and the file declared as the coarsest
/// is within the tolerance of the finest. A factor that cancels the error of the coarsest grid makes errors grow too, but towards a limit.
fn reversed(verdict: &Verdict, files: &[&FileReport]) -> Option<Suspicion> {
    let (name, _) = verdict.order.filter(|_| verdict.grows)?;
    let error = |file: &FileReport| file.columns.iter().find(|own| own.name == name).map(|own| (own.l2, own.tolerance));
    let (first, last) = (error(files.first()?)?, error(files.last()?)?);
    let errors: Vec<f64> = files.iter().filter_map(|file| error(file)).map(|own| own.0).collect();
    let levels_off = matches!(errors.as_slice(), [one, two, .., three, four] if four - three < two - one)
        || matches!(errors.as_slice(), [one, two, three] if three - two < two - one);
    let fits = first.0 <= last.1.unwrap_or(f64::MAX) && !levels_off;
    let text = format!("files in the wrong order: the errors of {name} decrease with refinement if the order of the files is reversed");
    fits.then_some(Suspicion { id: "file-order", text, before: last.0, after: first.0 })
}

/// Returns the relative L2 error within a region, and the error of the amplitude.
fn within(errors: &[(f64, f64, f64)], region: &Region) -> Option<(f64, f64)> {
    let (mut error, mut exact, mut along) = (0.0, 0.0, 0.0);
    for (_, p, own) in errors.iter().filter(|own| region.holds(own.0)) {
        error += (p - own) * (p - own);
        exact += own * own;
        along += (p - own) * own;
    }
    (exact > 0.0).then(|| ((error / exact).sqrt(), along / exact))
}

fn level(pixel: f64, found: Option<(f64, f64)>) -> Level {
    Level { pixel, errors: vec![found.map(|own| own.0)], signed: vec![found.map(|own| own.1)] }
}

/// Returns the errors of every file at the loads of the finest file; the load steps of the files may differ slightly.
fn paired(files: &[&[(f64, f64)]], pixels: &[f64]) -> Vec<Level> {
    const NEAR: f64 = 0.02;
    let Some(finest) = files.last() else { return Vec::new() };
    let nearest = |file: &[(f64, f64)], load: f64| {
        let own = file.iter().min_by(|one, other| (one.0 - load).abs().total_cmp(&(other.0 - load).abs()))?;
        ((own.0 - load).abs() <= NEAR * load.abs()).then_some(own.1)
    };
    let level = |(file, pixel): (&&[(f64, f64)], &f64)| {
        let errors: Vec<Option<f64>> = finest.iter().map(|(load, _)| nearest(file, *load)).collect();
        Level { pixel: *pixel, signed: errors.clone(), errors }
    };
    files.iter().zip(pixels).map(level).collect()
}
