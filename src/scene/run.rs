//! Solves a scene row by row and curve by curve; everything is computed on demand and nothing is stored.

use super::regime::{Regime, SAME_SHAPE, Simple};
use super::{Control, DepthFrom, Dimension, Loads, MeasuredTip, Quantity, Row, Scene, SceneError, Work};
use crate::contact::{
    Absence, Boundary, Contact, ContactError, Estimates, Expanded, Finding, Indentation, Indented, Kind, Load, Loaded, Naming, Part,
    Reason, Setup, Severity, State, each_point, in_unit, step_of,
};
use crate::num::{Bound, Bounded, Estimate, work};
use crate::scene::file::dimensioned::to_f64;
use crate::transform::{PressureCurve, Quantities, Reading, Solution, Superposition, TableProfile, TransformError};
use std::cell::{Cell, OnceCell, RefCell};
use std::sync::Arc;

/// A scene with its transform, ready to solve.
pub struct Run<'a> {
    scene: &'a Scene,
    pub(super) indentation: Indentation<'a>,
    /// The same contact with the second interpolation of a measured tip.
    pub(super) second: Option<Indentation<'a>>,
    work: Cell<Work>,
    /// True if the work budget was exhausted in a row or a point.
    cut: Cell<bool>,
    reserve: work::Reserve,
    watch: Option<Box<dyn Fn() + 'a>>,
    /// The last state whose points were computed, and its errors.
    pub(super) doubt: Cell<Option<(State, Option<Estimates>)>>,
    tip: OnceCell<Option<Simple>>,
    /// Number of pressures that are expected in all.
    many: Cell<usize>,
    /// Whether they cost too much one by one, once that is known.
    expensive: Cell<Option<bool>>,
    /// The last state whose pressures were computed, and one expansion for all of them.
    expansion: RefCell<Option<(State, Option<Arc<PressureCurve<'static>>>)>>,
}

/// The message when the work budget is exhausted.
const UNFINISHED: &str = "stopped at the work limit";

/// A value of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The coordinate, in output units.
    pub at: f64,
    /// Value and error in output units, or the reason for a missing value.
    pub value: Result<(f64, f64), &'static str>,
    /// Whether the error is proven or estimated.
    pub bound: Bound,
}

impl<'a> Run<'a> {
    /// Prepares the contact; no load is solved yet.
    ///
    /// # Errors
    /// [`SceneError`] if the profile cannot be evaluated or needs a rim, or if a force or contact radius is not allowed.
    pub fn new(scene: &'a Scene, solution: &'a Solution) -> Result<Self, SceneError> {
        let Scene { rim, effective_modulus, tolerance, method, .. } = *scene;
        let (smallest, largest) = scene.loads.extremes().unwrap_or((0.0, 0.0));
        let largest = scene.control.load(largest);
        if scene.measured.is_some() && scene.tip.is_none() {
            return Err(scene.placed(SceneError::missing("the points of the tip were not read").help("call Scene::with_points first")));
        }
        if let (Some(c), Some(tip)) = (rim, &scene.tip)
            && c > tip.last_radius()
        {
            let length =
                |own: f64| format!("{:?} {}", own * scene.system.out(Dimension::LENGTH), scene.system.unit_name(Dimension::LENGTH));
            let message = format!("radius = {} is beyond the last point of the tip", length(c).trim_end());
            let help = format!("expected a radius of at most {}", length(tip.last_radius()).trim_end());
            return Err(scene.placed(SceneError::value(message).help(help)));
        }
        let setup = Setup { effective_modulus, rim, tolerance, method };
        let others = |tip: Option<&Arc<TableProfile>>| tip.map(|own| Part::new(Arc::clone(own))).into_iter().collect();
        let tip = scene.tip.as_ref();
        let bodies = scene.parts().map_err(|error| scene.placed(error.into()))?;
        let indentation = Indentation::between(&bodies, Some(solution), others(tip.map(MeasuredTip::profile)), setup, largest);
        let indentation = indentation.map_err(|error| scene.placed(tip.map_or_else(|| late(&error, scene), |_| of_tip(&error))))?;
        let named = |dimension| (scene.system.out(dimension), scene.system.unit_name(dimension));
        let indentation = indentation.naming(Naming { length: named(Dimension::LENGTH), force: named(Dimension::FORCE) });
        let second = tip.and_then(|own| Indentation::between(&bodies, Some(solution), others(Some(own.second())), setup, largest).ok());
        let own = Self {
            scene,
            indentation,
            second,
            work: Cell::default(),
            cut: Cell::default(),
            reserve: work::Reserve::default(),
            watch: None,
            doubt: Cell::default(),
            tip: OnceCell::new(),
            many: Cell::new(scene.outputs.at.len().saturating_mul(scene.loads.len())),
            expensive: Cell::default(),
            expansion: RefCell::default(),
        };
        // Report invalid input before any output is written.
        for load in [scene.control.load(smallest), largest] {
            if !matches!(load, Load::Depth(_)) && !scene.loads.is_empty() {
                own.refuse(load)?;
            }
        }
        Ok(own)
    }

    /// Returns an error for a load that is not allowed; it is an input error, not an invalid row.
    fn refuse(&self, load: Load) -> Result<(), SceneError> {
        match load {
            Load::Depth(_) => Ok(()),
            Load::Force(force) if force < 0.0 => {
                Err(SceneError::value(format!("the force {force:?} is negative: adhesion is not supported"))
                    .help("expected forces of at least 0"))
            }
            Load::Radius(radius) if radius < 0.0 => {
                Err(SceneError::value(format!("the contact radius {radius:?} is negative")).help("expected radii of at least 0"))
            }
            _ => Ok(()),
        }
    }

    /// Returns the scene.
    pub fn scene(&self) -> &'a Scene {
        self.scene
    }

    /// Returns the number of evaluations so far.
    pub fn work(&self) -> Work {
        self.work.get()
    }

    /// Returns the reason if the output is incomplete so far, because the work budget was exhausted in a row or a point.
    pub fn cut_short(&self) -> Option<&'static str> {
        self.cut.get().then_some(UNFINISHED)
    }

    /// Calls a function after every row and every point.
    #[must_use]
    pub fn watched(self, watch: impl Fn() + 'a) -> Self {
        Self { watch: Some(Box::new(watch)), ..self }
    }

    /// Omits the searches for the radius at which an overlap or a tension begins, for callers that need only the verdict of each row.
    #[must_use]
    pub fn without_details(self) -> Self {
        Self { indentation: self.indentation.without_details(), ..self }
    }

    /// Returns the number of calls of that function if all rows and curves are computed.
    pub fn steps(&self) -> u64 {
        let per_load = |own: &Quantity| if own.needs_radius() { self.grid(*own).len() as u64 + 1 } else { 0 };
        let once = |own: &Quantity| if own.needs_radius() { 0 } else { self.grid(*own).len() as u64 };
        let curves = &self.scene.outputs.curves;
        self.scene.loads.len() as u64 * (1 + curves.iter().map(per_load).sum::<u64>()) + curves.iter().map(once).sum::<u64>()
    }

    pub(super) fn told(&self) {
        if let Some(watch) = &self.watch {
            watch();
        }
    }

    fn count(&self, add: impl FnOnce(&mut Work)) {
        let mut asked = self.work.get();
        add(&mut asked);
        self.work.set(asked);
    }

    /// Returns the radii where f′ jumps, in output units, and the jumps.
    pub fn kinks(&self) -> Vec<(f64, f64)> {
        self.indentation.kinks().map(|(at, jump)| (at * self.scene.system.out(Dimension::LENGTH), jump)).collect()
    }

    /// Returns the contact of a state.
    pub(super) fn contact(&self, state: &State) -> Contact<'a, Superposition<'a>> {
        self.indentation.contact(state)
    }

    pub(super) fn load(&self, index: usize) -> Option<(f64, Load)> {
        let value = self.scene.loads.get(index)?;
        let load = match (self.scene.control.load(value), self.scene.depth_from) {
            (Load::Depth(depth), DepthFrom::FirstTouch) => Load::Depth(depth + self.indentation.first_touch()),
            (load, _) => load,
        };
        Some((value, load))
    }

    /// Runs one part of a row with half of the remaining budget, so that a hard row leaves work for the following rows and for writing.
    fn part<T>(&self, work: impl FnOnce() -> T) -> Option<T> {
        let found = self.reserve.part(work);
        self.cut.set(self.cut.get() || found.is_none());
        found
    }

    fn solved(&self, index: usize) -> Option<(f64, Indented)> {
        let (value, load) = self.load(index)?;
        self.count(|asked| asked.loads += 1);
        let solved = self.part(|| self.indentation.solve(load).unwrap_or_else(|error| not_computable(&error)));
        let mut indented = solved.unwrap_or_else(unfinished);
        self.told();
        let within = |last: f64| matches!(load, Load::Radius(own) if own <= last) || self.scene.rim.is_some();
        if let (Some(end), Some(tip)) = (self.tip_ends_at(), self.scene.tip.as_ref().filter(|tip| !within(tip.last_radius()))) {
            let unit = self.scene.system.unit_name(Dimension::LENGTH);
            for finding in indented.findings.iter_mut().filter(|own| own.rule == "unreachable") {
                let message = format!("no contact exists for this load within the measured tip, whose last point is at r = {end:?} {unit}");
                finding.message = message.trim_end().to_owned();
                finding.at = Some(tip.last_radius());
            }
        }
        Some((value, indented))
    }

    /// Returns the row of a load; `None` if the index is out of range.
    pub fn row(&self, index: usize) -> Option<Row> {
        let (load, mut indented) = self.solved(index)?;
        let system = &self.scene.system;
        let mut values = Vec::with_capacity(self.scene.outputs.data.len());
        let mut computed = Vec::new();
        for datum in &self.scene.outputs.data {
            let own = match indented.state {
                None => Err("no contact exists for this load"),
                Some(state) => match self.part(|| self.datum(*datum, &state, &mut computed)) {
                    Some(Ok(own)) => own.map(|own| own * system.out(datum.dimension())),
                    Some(Err(error)) => {
                        // The other numbers of the load are not affected.
                        let message = format!("{}: {error}", datum.key());
                        indented.findings.push(Finding { rule: NOT_COMPUTABLE, severity: Severity::Warning, message, at: None });
                        Err("it cannot be computed")
                    }
                    None => Err(UNFINISHED),
                },
            };
            let pressed = indented.state.is_some_and(|state| state.boundary != Boundary::Apart && state.depth > 0.0);
            values.push((*datum, own.and_then(|own| representable(own, pressed))));
        }
        let touch = self.indentation.first_touch();
        let length = system.out(Dimension::LENGTH);
        let depth_from_touch = indented.state.filter(|_| touch != 0.0).map(|state| (state.depth - touch) * length);
        let regime = indented.state.as_ref().filter(|_| indented.is_valid()).and_then(|state| self.part(|| self.regime(state))?);
        Some(Row { load: self.shown_load(index, load), indented, depth_from_touch, values, computed, regime })
    }

    /// Returns the values of a row with error bounds, in the same order; `None` for a missing value or an unknown error.
    ///
    /// The load itself has no error. Computing the bounds takes about three evaluations of g or F.
    pub fn estimates(&self, index: usize, row: &Row) -> Vec<(Quantity, Option<Estimate>)> {
        let found = row.indented.state.and_then(|state| Some((self.bounds(index, &state)?, state)));
        let own = |(datum, value): &(Quantity, Result<f64, &'static str>)| {
            let (own, state) = found.filter(|_| value.is_ok())?;
            let estimate = self.part(|| self.estimate(*datum, row, &state, &own))??.scaled(self.scene.system.out(datum.dimension()));
            estimate.error.is_finite().then_some(estimate)
        };
        row.values.iter().map(|each| (each.0, own(each))).collect()
    }

    /// Returns d, F and a of a state with error bounds, in output units; quantities with unknown errors are omitted.
    pub fn state_estimates(&self, index: usize, state: &State) -> Vec<(Quantity, Estimate)> {
        let Some(own) = self.bounds(index, state) else { return Vec::new() };
        let all = [(Quantity::Depth, own.depth), (Quantity::Force, own.force), (Quantity::Radius, own.radius)];
        let shown = all.map(|(quantity, estimate)| (quantity, estimate.scaled(self.scene.system.out(quantity.dimension()))));
        shown.into_iter().filter(|(_, own)| own.error.is_finite()).collect()
    }

    /// Returns the error bounds of a state.
    fn bounds(&self, index: usize, state: &State) -> Option<Estimates> {
        self.bounds_under(self.load(index)?.1, state)
    }

    pub(super) fn bounds_under(&self, load: Load, state: &State) -> Option<Estimates> {
        let touch = if self.scene.counts_from_touch() { self.indentation.first_touch() } else { 0.0 };
        let bound = || {
            let mut own = self.indentation.estimates(state, load, ROUNDED).ok()?;
            // The radius of first contact is found by sampling.
            if touch != 0.0 {
                own.depth = own.depth + Estimate::estimated(0.0, 4.0 * f64::EPSILON * touch.abs(), 0);
            }
            Some(own)
        };
        self.part(bound)?
    }

    fn estimate(&self, datum: Quantity, row: &Row, state: &State, own: &Estimates) -> Option<Estimate> {
        let modulus = self.scene.effective_modulus;
        let effective_modulus = Bounded { value: modulus, error: ROUNDED * modulus };
        let loaded = Loaded { depth: own.depth, force: own.force, radius: own.radius, effective_modulus };
        if let Some(found) = datum.of_state(&loaded) {
            return found.ok();
        }
        if state.force == 0.0 {
            return Some(Estimate::exact(0.0));
        }
        let (_, computed) = row.computed.iter().find(|(own, _)| *own == datum)?;
        if datum == Quantity::Energy {
            let energy = self.indentation.energy_estimate(*computed, state, own);
            return Some(Estimate { error: energy.error + ROUNDED * energy.value, ..energy });
        }
        // Bounds the change of the value within the error of the radius; E* is a factor of every value.
        let Estimate { value: a, error, .. } = own.radius;
        let moved = |a: f64| -> Option<f64> {
            let found = self.computed(datum, &State { radius: a, ..*state }).ok()?.ok()?;
            Some((found.value - computed.value).abs() + found.error)
        };
        let (step, share) = step_of(a, error);
        let spread = if error == 0.0 { 0.0 } else { share * moved(a - step)?.max(moved(a + step)?) };
        Some(Estimate::estimated(computed.value, computed.error + spread + ROUNDED * computed.value.abs(), computed.evaluations))
    }

    /// Records that the work budget was exhausted, and returns the message.
    pub(super) fn point_is_cut(&self) -> &'static str {
        self.cut.set(true);
        UNFINISHED
    }

    /// Returns true if the bodies first touch away from the axis, so that depths from the apex and from first touch differ.
    pub fn touches_beside_the_axis(&self) -> bool {
        self.indentation.first_touch() != 0.0
    }

    /// Returns the simple shape with the closest force at the state's depth, and its error.
    fn regime(&self, state: &State) -> Option<Regime> {
        let is_flat = self.scene.tip.is_none() && self.scene.profile.is_flat();
        if state.force <= 0.0 || state.radius <= 0.0 || is_flat {
            return None;
        }
        let tip =
            || *self.tip.get_or_init(|| Simple::tip(|r| Some(self.indentation.shape().profile(r).ok()?.estimate.value), state.radius));
        let known = &self.scene.relatives;
        let tip = if known.is_empty() { tip() } else { None };
        let flat = (state.boundary == Boundary::Rim).then_some(Simple::Flat { radius: state.radius });
        let touch = self.indentation.first_touch();
        let wrong = |simple: Simple| {
            let force_error = simple.force(self.scene.effective_modulus, state.depth - touch) / state.force - 1.0;
            force_error.is_finite().then_some(Regime { simple, force_error, since_touch: touch != 0.0 })
        };
        let all = known.iter().copied().chain(tip).chain(flat).filter_map(wrong);
        let nearest = all.min_by(|one, other| one.force_error.abs().total_cmp(&other.force_error.abs()));
        nearest.filter(|own| own.force_error.abs() > SAME_SHAPE)
    }

    /// Returns a number of a state; its estimate is stored in `computed` if the number does not follow from depth, force and radius.
    fn datum(
        &self,
        datum: Quantity,
        state: &State,
        computed: &mut Vec<(Quantity, Estimate)>,
    ) -> Result<Result<f64, &'static str>, ContactError> {
        if let Some(known) = of_state(datum, state, self.scene.effective_modulus) {
            return Ok(known);
        }
        if datum == Quantity::Energy {
            self.count(|asked| asked.energies += 1);
        }
        let found = self.computed(datum, state)?;
        if let Ok(own) = &found {
            computed.push((datum, *own));
        }
        Ok(found.map(|own| own.value).map_err(|reason| reason.fixed_text().unwrap_or(FAILED)))
    }

    fn computed(&self, datum: Quantity, state: &State) -> Result<Result<Estimate, Reason>, ContactError> {
        let found = datum.number(&self.indentation.contact(state), state.radius, state.radius)?;
        Ok(found.map(|own| own.estimate))
    }

    /// Returns the state of a load for curves; `None` without a valid contact or if the index is out of range.
    pub fn state(&self, index: usize, formally: bool) -> Option<State> {
        let (_, indented) = self.solved(index)?;
        indented.state.filter(|_| formally || indented.is_valid())
    }

    /// Returns a load as shown in the output.
    fn shown_load(&self, index: usize, own: f64) -> f64 {
        let dimension = if self.scene.control == Control::Force { Dimension::FORCE } else { Dimension::LENGTH };
        let exact = self.scene.shown.as_ref().and_then(|shown| shown.loads.get(index));
        exact.unwrap_or_else(|| own * self.scene.system.out(dimension))
    }

    /// Returns the depth of a load's state as shown in the output.
    pub fn shown_depth(&self, index: usize, state: &State) -> f64 {
        let given = self.scene.control == Control::Depth && self.scene.depth_from == DepthFrom::Apex;
        let load = given.then(|| self.scene.loads.get(index)).flatten();
        load.map_or_else(|| state.depth * self.scene.system.out(Dimension::LENGTH), |own| self.shown_load(index, own))
    }

    /// Returns the coordinates of a curve: radii, or depths below the surface.
    pub fn grid(&self, curve: Quantity) -> &'a Loads {
        if curve.coordinate() == "z" { &self.scene.outputs.depths } else { &self.scene.outputs.at }
    }

    /// Returns a curve on its grid, each point with its coordinate in computing units.
    pub fn curve(&self, curve: Quantity, state: Option<State>) -> Vec<(f64, Point)> {
        let grid = self.grid(curve);
        let shown = self.scene.shown.as_ref().map(|own| if curve.coordinate() == "z" { &own.depths } else { &own.at });
        let at: Vec<f64> = (0..grid.len()).filter_map(|index| grid.get(index)).collect();
        let points = at.iter().copied().zip(self.points(curve, state.as_ref(), &at)).enumerate();
        points.map(|(index, (at, own))| (at, Point { at: shown.and_then(|own| own.get(index)).unwrap_or(own.at), ..own })).collect()
    }

    /// Returns a curve at coordinates in computing units; p, u and the stress require the state.
    pub fn points(&self, curve: Quantity, state: Option<&State>, at: &[f64]) -> Vec<Point> {
        if at.len() > self.many.get() {
            self.expect(at.len());
        }
        let found = each_point(at, 1, |block: &[f64]| {
            let found = block.iter().map(|at| self.reading(curve, state, *at)).collect();
            self.told();
            found
        });
        let known = |own: Result<Reading, Absence<&'static str>>| {
            own.map_err(|absence| match absence {
                Absence::Failed(why) => why,
                Absence::Unfinished => self.point_is_cut(),
            })
        };
        at.iter().zip(found).map(|(at, own)| self.point(curve, state, *at, known(own))).collect()
    }

    fn point(&self, curve: Quantity, state: Option<&State>, at: f64, found: Result<Reading, &'static str>) -> Point {
        let system = &self.scene.system;
        let factor = system.out(curve.dimension());
        let mut bound = found.map_or(Bound::Proven, |own| own.estimate.bound);
        let value = found.and_then(|own| {
            let inherited = match state.filter(|own| curve.kind() != Kind::Shape && own.boundary != Boundary::Apart && own.radius > 0.0) {
                None => 0.0,
                Some(state) => {
                    let doubt = self.doubt(state).ok_or("the error of the contact radius is unknown")?;
                    bound = bound.and(doubt.bound);
                    doubt.of_point(curve, at, own.estimate.value)
                }
            };
            let (value, error) = (own.estimate.value * factor, (own.estimate.error + inherited) * factor.abs());
            if value.is_finite() && error.is_finite() { Ok((value, error)) } else { Err("the value is not finite") }
        });
        Point { at: at * system.out(Dimension::LENGTH), value, bound }
    }

    fn reading(&self, curve: Quantity, state: Option<&State>, at: f64) -> Result<Reading, &'static str> {
        let zero = || Reading { estimate: Estimate::exact(0.0), method: "exact" };
        let outside = "the profile ends before this radius";
        if curve.kind() == Kind::Shape {
            self.count(|asked| asked.shapes += 1);
            if self.indentation.rim().is_some_and(|c| at > c) {
                return Err(outside);
            }
            if at == 0.0 {
                return Ok(zero());
            }
            return match curve.number(self.indentation.shape(), at, at) {
                Err(ContactError::Transform(TransformError::OutOfDomain { .. })) => Err(outside),
                Err(_) => Err(FAILED),
                Ok(found) => found.map_err(|_| outside),
            };
        }
        let Some(state) = state else { return Err("the load has no valid contact") };
        if state.boundary == Boundary::Apart || state.radius == 0.0 {
            return Ok(zero());
        }
        self.count(|asked| match curve {
            Quantity::Pressure => asked.pressures += 1,
            Quantity::AxialStress => asked.stresses += 1,
            _ => asked.displacements += 1,
        });
        let found = match curve {
            Quantity::Pressure => self.for_pressures(state).pressure(at, state.radius),
            _ => curve.number(&self.contact(state), at, state.radius),
        };
        found.map_err(|_| FAILED)?.map_err(|reason| reason.fixed_text().unwrap_or(FAILED))
    }
}

impl<'a> Run<'a> {
    /// Expects this many pressures from now on; the next state decides whether they come from an expansion.
    pub(super) fn expect(&self, pressures: usize) {
        self.many.set(pressures);
        self.expensive.set(None);
    }

    /// The contact of a state, with one expansion for all pressures where these are many and each of them is expensive.
    pub(super) fn for_pressures(&self, state: &State) -> Contact<'a, Expanded<Superposition<'a>>> {
        let contact = self.contact(state);
        // The first state decides for all.
        let is_chosen = self.expensive.get().unwrap_or_else(|| contact.are_expensive(state.radius, self.many.get()));
        self.expensive.set(Some(is_chosen));
        let known = self.expansion.borrow().clone().filter(|own| own.0 == *state);
        let (_, curve) = known.unwrap_or_else(|| {
            let curve = if is_chosen { contact.evaluator().pressure_curve(state.radius) } else { None };
            let own = (*state, curve.map(Arc::new));
            // What a budget cut short is not kept for later points.
            if !work::is_exhausted() {
                self.expansion.replace(Some(own.clone()));
            }
            own
        });
        contact.with_pressures(curve)
    }
}

/// Returns the theoretical infinite value of a curve from the reason for a missing value; `None` for other reasons.
pub fn infinite_value(curve: Quantity, why: &str) -> Option<f64> {
    let all = [Reason::Apex, Reason::Kink, Reason::Rim, Reason::ConcaveApex, Reason::ConcaveKink];
    let pressure = all.iter().find(|own| own.fixed_text() == Some(why))?.infinite_pressure()?;
    // σ_zz on the surface is −p.
    Some(if curve == Quantity::AxialStress { -pressure } else { pressure })
}

/// The default reason for a missing value.
const FAILED: &str = "no digit of the value is reliable";

/// Returns a quantity that follows from depth, force and radius of a state; `None` for other quantities.
pub(super) fn of_state(datum: Quantity, state: &State, effective_modulus: f64) -> Option<Result<f64, &'static str>> {
    if state.force == 0.0 && datum == Quantity::Energy {
        return Some(Ok(0.0));
    }
    let [depth, force, radius] = [state.depth, state.force, state.radius].map(Estimate::exact);
    let found = datum.of_state(&Loaded { depth, force, radius, effective_modulus: Bounded::exact(effective_modulus) })?;
    Some(found.map(|own| own.value).map_err(|reason| reason.fixed_text().unwrap_or(FAILED)))
}

/// Relative rounding error of E* and of the load, from unit conversion and from combining elastic constants.
const ROUNDED: f64 = 2.0 * f64::EPSILON;

/// Returns an error for overflow and, in a contact under load, for underflow.
fn representable(value: f64, pressed: bool) -> Result<f64, &'static str> {
    if !value.is_finite() {
        return Err("it is too large for a 64-bit float in these units");
    }
    if pressed && value.abs() < f64::MIN_POSITIVE {
        return Err("it is too small for a 64-bit float in these units");
    }
    Ok(value)
}

/// Returns the error for a profile of points without a vertical side.
fn of_tip(error: &ContactError) -> SceneError {
    let help = "expected a radius in [profile], or invert = true for heights that decrease from the apex outward";
    let own = SceneError::from(error.clone());
    if matches!(error, ContactError::Missing { .. }) { own.help(help) } else { own }
}

/// Converts errors that occur only during computation, with lengths in output units.
fn late(error: &ContactError, scene: &Scene) -> SceneError {
    match error {
        ContactError::Transform(TransformError::OutOfDomain { symbol: "radius", at, .. }) => {
            let named = (scene.system.out(Dimension::LENGTH), scene.system.unit_name(Dimension::LENGTH));
            let limits = scene.profile.limits().chain(scene.bodies.iter().flat_map(crate::transform::Profile::limits));
            let end = limits.filter_map(|own| to_f64(own).ok()).min_by(f64::total_cmp);
            let end = end.map_or_else(String::new, |end| format!(", which ends at r = {}", in_unit(end, &named)));
            SceneError::value(format!("radius = {} is outside the profile{end}", in_unit(*at, &named)))
                .help("expected a radius inside the profile")
        }
        other => other.clone().into(),
    }
}

/// Returns the row of a load for which the budget was exhausted.
fn unfinished() -> Indented {
    let finding = Finding { rule: super::row::UNFINISHED, severity: Severity::Error, message: UNFINISHED.to_owned(), at: None };
    Indented { state: None, findings: vec![finding], radii: None }
}

/// The rule of a finding about a load or a number that cannot be computed.
const NOT_COMPUTABLE: &str = "not_computable";

fn not_computable(error: &ContactError) -> Indented {
    let finding = Finding { rule: NOT_COMPUTABLE, severity: Severity::Error, message: error.to_string(), at: None };
    Indented { state: None, findings: vec![finding], radii: None }
}
