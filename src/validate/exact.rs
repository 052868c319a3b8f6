//! The exact solution of a scene, asked by data: states by load, and pressures by the block.

use crate::contact::{Boundary, Contact, ContactError, Indentation, Load, Part, Setup, State};
use crate::expr::Bindings;
use crate::num::stable::leg;
use crate::scene::MeasuredTip;
use crate::scene::{DepthFrom, Scene};
use crate::transform::{Curve, Evaluator, Method, PressureCurve, Quantities, Solution, Superposition};
use std::f64::consts::PI;
use std::sync::Arc;

/// A scene's indentation.
pub(super) struct Exact<'a> {
    indentation: Indentation<'a>,
    from_touch: bool,
    /// The formula alone, where the profile is one: its pressures are known by the block.
    formula: Option<&'a Solution>,
    modulus: f64,
    method: Method,
    tolerance: f64,
}

/// Slopes of the profile that a pixel cannot follow.
pub(super) struct Sharp {
    /// True where the tip is not smooth at the axis.
    pub(super) apex: bool,
    /// The radii of kinks.
    pub(super) kinks: Vec<f64>,
}

impl<'a> Exact<'a> {
    /// `largest` is the largest load of the data.
    pub(super) fn new(scene: &Scene, solution: &'a Solution, largest: Load) -> Result<Self, ContactError> {
        let Scene { effective_modulus, rim, tolerance, method, .. } = *scene;
        let setup = Setup { effective_modulus, rim, tolerance, method };
        // Absurd loads, as of data in wrong units, are no reason to stop.
        let tips = || scene.tip.as_ref().map(MeasuredTip::profile).map(|own| Part::new(Arc::clone(own))).into_iter().collect();
        let bodies = scene.parts()?;
        let made = |largest| Indentation::between(&bodies, Some(solution), tips(), setup, largest);
        // Absurd loads, as of data in wrong units, are no reason to stop.
        let indentation = made(largest).or_else(|_| made(Load::Depth(0.0)))?;
        let formula = scene.tip.is_none().then_some(solution);
        let from_touch = scene.depth_from == DepthFrom::FirstTouch;
        Ok(Self { indentation, from_touch, formula, modulus: effective_modulus, method, tolerance })
    }

    /// The state of a load, where a valid one belongs to it; depths of the data may count from the first touch.
    pub(super) fn state(&self, load: Load) -> Option<State> {
        let load = match load {
            Load::Depth(depth) if self.from_touch => Load::Depth(depth + self.indentation.first_touch()),
            other => other,
        };
        let solved = self.indentation.solve(load).ok()?;
        let valid = solved.is_valid();
        solved.state.filter(|_| valid)
    }

    /// The depth of a state as the data count it.
    pub(super) fn depth(&self, state: &State) -> f64 {
        if self.from_touch { state.depth - self.indentation.first_touch() } else { state.depth }
    }

    /// The contact of a state.
    pub(super) fn contact(&self, state: &State) -> Contact<'a, Superposition<'a>> {
        self.indentation.contact(state)
    }

    /// The contact with a smooth edge.
    pub(super) fn shape(&self) -> &Contact<'a, Superposition<'a>> {
        self.indentation.shape()
    }

    /// The formula's contact with a smooth edge; `None` for a measured tip.
    pub(super) fn formula(&self) -> Option<Contact<'a>> {
        let evaluator = Evaluator::new(self.formula?, &Bindings::default(), self.method, self.tolerance).ok()?;
        Some(Contact::new(evaluator, self.modulus, None, self.tolerance))
    }

    /// What is sharp within a radius.
    pub(super) fn sharp(&self, within: f64) -> Sharp {
        let bend = |r: f64| self.indentation.shape().profile(r).map_or(0.0, |own| own.estimate.value.abs() / (r * r));
        let (near, nearer) = (bend(1e-3 * within), bend(1e-5 * within));
        let kinks = self.indentation.kinks().map(|own| own.0).filter(|own| *own > 0.0).collect();
        Sharp { apex: nearer > 1.5 * near, kinks }
    }

    /// f(r)/r² near the axis.
    pub(super) fn bend(&self, within: f64) -> Option<f64> {
        let r = 1e-4 * within;
        let height = self.indentation.shape().profile(r).ok()?.estimate.value;
        Some(height / (r * r)).filter(|own| own.is_finite() && *own > 0.0)
    }
}

/// Pressures under one state: closed forms by the block, else a curve that is built once.
pub(super) struct Pressures<'c> {
    /// With a smooth edge; what a rim adds stands beside it.
    formula: Option<&'c Contact<'c>>,
    shape: &'c Contact<'c, Superposition<'c>>,
    a: f64,
    curve: Option<PressureCurve<'c>>,
    factor: f64,
    excess: f64,
}

/// Points from which on a curve is worth its making.
const MANY: u64 = 400;

impl<'c> Pressures<'c> {
    /// Takes the formula's contact, where there is one, and how many points will be asked for.
    pub(super) fn new(exact: &'c Exact<'c>, formula: Option<&'c Contact<'c>>, state: &State, rows: u64) -> Self {
        let (a, shape) = (state.radius, exact.shape());
        let known = |t: f64, own: &Contact<'_>| matches!(own.pressure(t * a, a), Ok(Ok(own)) if own.estimate.evaluations == 0);
        let slope = || shape.evaluator().slope(a).map_or(f64::NAN, |own| own.estimate.value);
        let excess = if state.boundary == Boundary::Rim { state.depth - slope() } else { 0.0 };
        let open = formula.filter(|own| rows >= MANY && a > 0.0 && ![0.21, 0.55, 0.87].iter().all(|t| known(*t, own)));
        let typed = open.and_then(|own| own.evaluator().typed().ok());
        let curve = typed.and_then(|own| Curve::new(own, a, 1e-8).ok()?.pressures(a).ok());
        Self { formula, shape, a, curve, factor: shape.effective_modulus() / PI, excess }
    }

    /// p at every r, each at least 0; NaN where it is infinite or cannot be computed.
    pub(super) fn at(&self, r: &[f64], out: &mut Vec<f64>) {
        out.clear();
        let a = self.a;
        let inside: Vec<f64> = r.iter().copied().filter(|r| *r < a).collect();
        let mut found = match (&self.curve, self.formula) {
            (None, Some(formula)) => formula.pressures(&inside, a).ok().map(Vec::into_iter),
            _ => None,
        };
        out.extend(r.iter().map(|r| {
            if *r > a || (*r == a && self.excess == 0.0) {
                return 0.0;
            }
            let edge = if self.excess == 0.0 { 0.0 } else { self.factor * self.excess / leg(a, *r) };
            let smooth = match (&self.curve, &mut found) {
                _ if *r == a => None,
                (Some(curve), _) => curve.at(*r).ok().flatten().map(|own| self.factor * own.value),
                (None, Some(list)) => list.next().and_then(Result::ok).map(|own| own.estimate.value),
                (None, None) => self.shape.pressure(*r, a).ok().and_then(Result::ok).map(|own| own.estimate.value),
            };
            smooth.map_or(f64::NAN, |smooth| smooth + edge)
        }));
    }
}
