//! The exact solution of a scene for the data: states by load, and pressures in blocks.

mod states;

use crate::contact::{Boundary, Contact, ContactError, Indentation, Load, Part, Setup, State};
use crate::expr::Bindings;
use crate::num::stable::leg;
use crate::scene::MeasuredTip;
use crate::scene::{DepthFrom, Scene};
use crate::transform::{Evaluator, Method, PressureCurve, Quantities, Solution, Superposition};
use std::cell::OnceCell;
use std::f64::consts::PI;
use std::sync::Arc;

pub(in crate::validate) use states::States;

/// The exact solution of a scene.
pub(in crate::validate) struct Exact<'a> {
    indentation: Indentation<'a>,
    from_touch: bool,
    /// The formula of the profile, if it has one, whose pressures can be computed in blocks.
    formula: Option<&'a Solution>,
    modulus: f64,
    method: Method,
    tolerance: f64,
}

/// Singularities of the profile that a pixel cannot resolve.
pub(in crate::validate) struct Singularities {
    /// True if the tip is not smooth at the axis.
    pub(in crate::validate) apex: bool,
    /// The radii of kinks.
    pub(in crate::validate) kinks: Vec<f64>,
    /// Radii at which only the curvature jumps.
    pub(in crate::validate) bends: Vec<f64>,
}

impl<'a> Exact<'a> {
    /// Creates the exact solution; `largest` is the largest load of the data.
    pub(in crate::validate) fn new(scene: &Scene, solution: &'a Solution, largest: Load) -> Result<Self, ContactError> {
        let Scene { effective_modulus, rim, tolerance, method, .. } = *scene;
        let setup = Setup { effective_modulus, rim, tolerance, method };
        let tips = || scene.tip.as_ref().map(MeasuredTip::profile).map(|own| Part::new(Arc::clone(own))).into_iter().collect();
        let bodies = scene.parts()?;
        let made = |largest| Indentation::between(&bodies, Some(solution), tips(), setup, largest);
        // Do not fail for absurd loads, such as data in wrong units.
        let indentation = made(largest).or_else(|_| made(Load::Depth(0.0)))?;
        let formula = scene.tip.is_none().then_some(solution);
        let from_touch = scene.depth_from == DepthFrom::FirstTouch;
        Ok(Self { indentation, from_touch, formula, modulus: effective_modulus, method, tolerance })
    }

    /// Returns the state under a load if it is valid; depths of the data may be relative to first touch.
    pub(in crate::validate) fn state(&self, load: Load) -> Option<State> {
        let load = match load {
            Load::Depth(depth) if self.from_touch => Load::Depth(depth + self.indentation.first_touch()),
            other => other,
        };
        let solved = self.indentation.solve(load).ok()?;
        let valid = solved.is_valid();
        solved.state.filter(|_| valid)
    }

    /// Returns the depth of a state with the reference of the data.
    pub(in crate::validate) fn depth(&self, state: &State) -> f64 {
        if self.from_touch { state.depth - self.indentation.first_touch() } else { state.depth }
    }

    /// Returns U = E* ∫₀^a (d − g)² dx of a state.
    pub(in crate::validate) fn energy(&self, state: &State) -> Option<f64> {
        Some(self.indentation.energy(state).ok()?.estimate.value)
    }

    /// Returns k = 2E* a of a state.
    pub(in crate::validate) fn stiffness(&self, state: &State) -> Option<f64> {
        Some(self.contact(state).stiffness(state.radius).ok()?.estimate.value)
    }

    /// Returns the contact of a state.
    pub(in crate::validate) fn contact(&self, state: &State) -> Contact<'a, Superposition<'a>> {
        self.indentation.contact(state)
    }

    /// Returns the contact with a smooth edge.
    pub(in crate::validate) fn shape(&self) -> &Contact<'a, Superposition<'a>> {
        self.indentation.shape()
    }

    /// Returns the contact of the formula with a smooth edge; `None` for a measured tip.
    pub(in crate::validate) fn formula(&self) -> Option<Formula<'a>> {
        let evaluator = Evaluator::new(self.formula?, &Bindings::default(), self.method, self.tolerance).ok()?;
        Some(Formula { contact: Contact::new(evaluator, self.modulus, None, self.tolerance), closes: OnceCell::new() })
    }

    /// Returns the pressures under a state, prepared for many points.
    pub(in crate::validate) fn pressures<'c>(&'c self, formula: Option<&'c Formula<'c>>, state: &State) -> Pressures<'c> {
        Pressures::new(self, formula, state, u64::MAX)
    }

    /// Returns the singularities within a radius.
    pub(in crate::validate) fn sharp(&self, within: f64) -> Singularities {
        let bend = |r: f64| self.indentation.shape().profile(r).map_or(0.0, |own| own.estimate.value.abs() / (r * r));
        let (near, nearer) = (bend(1e-3 * within), bend(1e-5 * within));
        let kinks: Vec<f64> = self.indentation.kinks().map(|own| own.0).filter(|own| *own > 0.0).collect();
        let is_kink = |at: f64| kinks.iter().any(|own| (own - at).abs() <= 1e-9 * at);
        let mut bends = self.indentation.shape().evaluator().breakpoints_below(within);
        bends.retain(|own| *own > 0.0 && !is_kink(*own));
        // A measured tip has a breakpoint at every point, where the curvature hardly jumps.
        if bends.len() > MOST_BENDS {
            bends.clear();
        }
        Singularities { apex: nearer > 1.5 * near, kinks, bends }
    }

    /// Returns the distance between the edge of a contact and the nearest kink inside; the contact radius if there is none.
    pub(in crate::validate) fn room(&self, state: &State) -> f64 {
        let a = state.radius;
        self.indentation.kinks().map(|own| own.0).filter(|own| *own > 0.0 && *own < a).fold(a, |room, kink| room.min(a - kink))
    }

    /// Returns f(r)/r² near the axis.
    pub(in crate::validate) fn bend(&self, within: f64) -> Option<f64> {
        let r = 1e-4 * within;
        let height = self.indentation.shape().profile(r).ok()?.estimate.value;
        Some(height / (r * r)).filter(|own| own.is_finite() && *own > 0.0)
    }
}

/// A profile with more curvature jumps is treated as a measured tip.
const MOST_BENDS: usize = 8;

/// The contact of a formula with a smooth edge.
pub(in crate::validate) struct Formula<'a> {
    contact: Contact<'a>,
    /// True if pressures can be computed without quadrature.
    closes: OnceCell<bool>,
}

impl Formula<'_> {
    /// Returns true if p under the contact radius a needs no quadrature; the first radius decides for all.
    fn closes(&self, a: f64) -> bool {
        let known = |t: f64| matches!(self.contact.pressure(t * a, a), Ok(Ok(own)) if own.estimate.evaluations == 0);
        *self.closes.get_or_init(|| [0.21, 0.55, 0.87].into_iter().all(known))
    }
}

/// Pressures under one state: closed forms in blocks, else a curve that is built once.
pub(in crate::validate) struct Pressures<'c> {
    /// The part for a smooth edge; the contribution of a rim is added.
    formula: Option<&'c Contact<'c>>,
    shape: &'c Contact<'c, Superposition<'c>>,
    pub(in crate::validate) state: State,
    /// The singularities within the contact.
    pub(in crate::validate) sharp: Singularities,
    curve: Option<PressureCurve<'c>>,
    /// p next to the axis where it is the same as on the axis; filled when it is first needed.
    next_to_axis: OnceCell<Option<f64>>,
    factor: f64,
    excess: f64,
}

/// Part of the contact radius below which a finite pressure is taken from the axis, because a curve needs quadrature there, …
const NEXT_TO_AXIS: f64 = 1e-7;
/// … and the largest relative change of the pressure over that part.
const SAME: f64 = 1e-6;

/// Number of points above which a curve costs less than quadrature at each point.
const MANY: u64 = 20;
/// Relative error of a curve above which quadrature is used instead.
const CURVE: f64 = 1e-8;

impl<'c> Pressures<'c> {
    /// Takes the contact of the formula, if there is one, and the expected number of points.
    pub(in crate::validate) fn new(exact: &'c Exact<'c>, formula: Option<&'c Formula<'c>>, state: &State, rows: u64) -> Self {
        let (a, shape) = (state.radius, exact.shape());
        let equivalent = || shape.evaluator().equivalent(a).map_or(f64::NAN, |own| own.estimate.value);
        let excess = if state.boundary == Boundary::Rim { state.depth - equivalent() } else { 0.0 };
        let open = formula.filter(|own| rows >= MANY && a > 0.0 && !own.closes(a));
        let curve = open.and_then(|own| PressureCurve::new(own.contact.evaluator().typed().ok()?, a).ok());
        let (formula, sharp) = (formula.map(|own| &own.contact), exact.sharp(a));
        let (next_to_axis, factor) = (OnceCell::new(), shape.effective_modulus() / PI);
        Self { formula, shape, state: *state, sharp, curve, next_to_axis, factor, excess }
    }

    /// Returns p at every r, clamped to at least 0; NaN if p is infinite or cannot be computed.
    pub(in crate::validate) fn at(&self, r: &[f64], out: &mut Vec<f64>) {
        out.clear();
        let a = self.state.radius;
        let inside: Vec<f64> = r.iter().copied().filter(|r| *r < a).collect();
        let mut found = match (&self.curve, self.formula) {
            (None, Some(formula)) => formula.pressures(&inside, a).ok().map(Vec::into_iter),
            _ => None,
        };
        let alone = |r: f64| self.shape.pressure(r, a).ok().and_then(Result::ok).map(|own| own.estimate.value);
        out.extend(r.iter().map(|r| {
            if *r > a || (*r == a && self.excess == 0.0) {
                return 0.0;
            }
            let edge = if self.excess == 0.0 { 0.0 } else { self.factor * self.excess / leg(a, *r) };
            let smooth = match (&self.curve, &mut found) {
                _ if *r == a => None,
                _ if *r < NEXT_TO_AXIS * a && self.next_to_axis().is_some() => self.next_to_axis(),
                (Some(curve), _) => match curve.at(*r) {
                    Ok(Some(own)) if own.error <= CURVE * own.value.abs() => Some(self.factor * own.value),
                    Ok(None) => None,
                    _ => alone(*r),
                },
                (None, Some(list)) => list.next().and_then(Result::ok).map(|own| own.estimate.value),
                (None, None) => alone(*r),
            };
            smooth.map_or(f64::NAN, |smooth| smooth + edge)
        }));
    }
    fn next_to_axis(&self) -> Option<f64> {
        *self.next_to_axis.get_or_init(|| {
            let curve = self.curve.as_ref()?;
            let pressure = |r: f64| Some(curve.at(r).ok()??.value);
            let (on_axis, beside) = (pressure(0.0)?, pressure(NEXT_TO_AXIS * self.state.radius)?);
            ((on_axis - beside).abs() <= SAME * beside.abs()).then_some(self.factor * on_axis)
        })
    }
}
