//! Contact radii of smooth edges: the roots of g(a) = d and of F(a) = F, followed from load to load.

use super::curvature::Curvature;
use super::{Boundary, Indentation, Load, State};
use crate::contact::radius::overflow;
use crate::contact::{Contact, ContactError};
use crate::num::roots::{RootOptions, bracketed};
use crate::num::{Bounded, work};
use crate::transform::{Quantities, Superposition, TransformError};
use std::cell::Cell;

/// The last roots with the rise at the newest: the next load is often a near one.
#[derive(Default)]
pub(super) struct Follower {
    depths: Cell<Option<Last>>,
    forces: Cell<Option<Last>>,
}

#[derive(Clone, Copy)]
struct Last {
    target: f64,
    root: f64,
    rise: f64,
    /// Targets and roots before this one, the newest first.
    before: [(f64, f64); BEFORE],
    known: usize,
}

/// How many earlier roots foretell the next one.
const BEFORE: usize = 3;

impl Last {
    fn first(target: f64, root: f64, rise: f64) -> Self {
        Self { target, root, rise, before: [(0.0, 0.0); BEFORE], known: 0 }
    }

    /// The next root behind this one.
    fn next(self, target: f64, root: f64, rise: f64) -> Self {
        let [one, two, _] = self.before;
        Self { target, root, rise, before: [(self.target, self.root), one, two], known: (self.known + 1).min(BEFORE) }
    }

    /// The root at a target by the polynomial through the known ones (Neville's scheme), or by the rise where there is but one.
    fn foretold(&self, target: f64) -> f64 {
        let by_rise = self.root - (self.target - target) / self.rise;
        let mut places = [0.0; BEFORE + 1];
        let mut values = [0.0; BEFORE + 1];
        let all = std::iter::once((self.target, self.root)).chain(self.before.into_iter().take(self.known));
        for ((place, value), (t, root)) in places.iter_mut().zip(&mut values).zip(all) {
            (*place, *value) = (t, root);
        }
        for level in 1..=self.known {
            for i in 0..=self.known - level {
                let (near, far) = (places[i], places[i + level]);
                values[i] = values[i] + (target - near) / (far - near) * (values[i + 1] - values[i]);
            }
        }
        if self.known > 0 && values[0].is_finite() { values[0] } else { by_rise }
    }
}

/// A root, the nearest evaluated point, and the value at this point.
#[derive(Clone, Copy)]
struct Root {
    radius: f64,
    asked: f64,
    value: f64,
}

/// Maximum number of secant steps before bisection.
const MOST_SECANTS: u32 = 12;
/// So near to the root its square is below rounding.
const CLOSE: f64 = 3e-9;
/// Outermost radius that is tried, and the innermost one.
const FARTHEST: f64 = 1e150;
const NEAREST: f64 = 1e-290;

/// The shortest relative distance to a place without a value that is halved.
const CLOSEST: f64 = 1e-12;

/// g is not evaluated at radii where this many times the largest f so far is still below the load, because it costs far more than
/// f.
const BELOW: f64 = 100.0;
/// Maximum number of steps of the search once g falls or has no value.
const SEARCHING: u64 = 30_000_000;

/// How far a profile without an end is looked at.
pub(super) struct Horizon {
    /// About the contact radius of the largest load: the first power of ten at which g or F has reached it.
    pub(super) scale: f64,
    /// The first radius at which waves of f are too short to be resolved; infinite if there is none.
    pub(super) followed: f64,
}

impl Horizon {
    pub(super) fn of(contact: &Contact<'_, Superposition<'_>>, curvature: &Curvature<'_>, rim: Option<f64>, load: Load) -> Self {
        let limit = contact.evaluator().limit();
        if let Some(end) = rim.or(limit.is_finite().then_some(limit)) {
            return Self { scale: end, followed: f64::INFINITY };
        }
        let outer = contact.evaluator().breakpoints_below(f64::INFINITY).last().copied();
        let steps = (-60..=60).map(|step| outer.unwrap_or(1.0) * 10f64.powf(0.5 * f64::from(step)));
        let followed = steps.clone().find(|a| !is_followed(curvature, *a)).unwrap_or(f64::INFINITY);
        if let Load::Radius(radius) = load
            && radius > 0.0
            && radius.is_finite()
        {
            return Self { scale: radius, followed: followed.max(10.0 * radius) };
        }
        let (mut seen, mut largest, mut high) = (Vec::new(), f64::NEG_INFINITY, 0.0f64);
        let begin = work::left();
        for a in steps.take_while(|a| *a < followed) {
            high = contact.evaluator().height(a).map_or(high, |f| high.max(f.estimate.value.abs()));
            let is_far = match load {
                Load::Radius(_) => false,
                Load::Depth(target) => BELOW * high < target,
                Load::Force(target) => BELOW * high * a * contact.effective_modulus() < target,
            };
            if is_far {
                seen.push((a, high));
                continue;
            }
            let depth = contact.depth(a).ok().map(|g| g.estimate.value);
            let is_reached = match load {
                Load::Radius(radius) => a >= radius,
                Load::Depth(target) => depth.is_some_and(|own| own >= target),
                Load::Force(target) => contact.any_force(a).is_ok_and(|f| f.estimate.value >= target),
            };
            if is_reached {
                return Self { scale: a.max(outer.unwrap_or(0.0)), followed };
            }
            if let Some(own) = depth {
                seen.push((a, own));
                largest = largest.max(own);
            }
            let rises = depth.is_some_and(|own| own > 0.0 && own >= largest);
            if work::is_exhausted() || (!rises && begin.saturating_sub(work::left()) > SEARCHING) {
                break;
            }
        }
        // Without an end, the place where the largest g is almost reached is what matters.
        let largest = seen.iter().fold(f64::NEG_INFINITY, |most, (_, g)| most.max(*g));
        let almost = seen.iter().find(|(_, g)| *g >= largest - 0.01 * largest.abs());
        Self { scale: almost.map_or(outer.unwrap_or(1.0), |(a, _)| *a), followed }
    }
}

/// Places of f′ within the window.
const LOOKS: u32 = 32;
/// Four steps between the even radii of the landscape, as a part of the radius.
const WINDOW: f64 = 1.0 / 64.0;

/// Whether the even radii of a landscape up to twice this radius are close enough for the waves of f, two to a wave: the second
/// differences of f′ over four of them change sign less than four times. Waves that leave (r f′)′ positive need not be: g rises
/// all the same.
fn is_followed(curvature: &Curvature<'_>, a: f64) -> bool {
    let radii = (0..=LOOKS).map(|i| a * (1.0 - WINDOW * f64::from(i) / f64::from(LOOKS)));
    if radii.clone().all(|r| curvature.bend(r).value > 0.0) {
        return true;
    }
    let f_primes: Vec<Bounded> = radii.map(|r| curvature.f_prime(r)).collect();
    let size = f_primes.iter().fold(0.0f64, |most, f_prime| most.max(f_prime.value.abs()));
    let (mut changes, mut last) = (0, 0.0);
    for own in f_primes.windows(3) {
        let [one, two, three] = own else { continue };
        let bend = (one.value - two.value) - (two.value - three.value);
        // Ignores rounding errors, such as those of 1 - sin(r)/r next to the axis.
        if bend.abs() > 1e-6 * size + one.error + 2.0 * two.error + three.error {
            changes += u32::from(bend * last < 0.0);
            last = bend;
        }
    }
    changes < 4
}

impl Indentation<'_> {
    /// Every smooth contact at a depth, from the axis outward.
    pub(super) fn smooth_at_depth(&self, depth: f64) -> Result<Vec<State>, ContactError> {
        let mut gap = |a: f64| match self.contact.evaluator().equivalent(a) {
            Ok(g) => Ok(g.estimate.value - depth),
            // An overflow lies beyond every root.
            Err(TransformError::Overflow { is_negative, .. }) => Ok(overflow(is_negative)),
            Err(other) => Err(other),
        };
        let mut states = Vec::new();
        for Root { radius, asked, value } in self.roots(&self.follower.depths, &mut gap, depth, |own| own.landscape.rises_through(depth))? {
            // F_smooth(a) + 2E* a (d − g(a)) is right to second order in what a is off.
            let smooth = self.contact.any_force(asked)?.estimate.value;
            let force = smooth - 2.0 * self.contact.effective_modulus() * asked * value;
            states.push(State { depth, force, radius, boundary: Boundary::Smooth });
        }
        Ok(states)
    }

    /// Every smooth contact under a force.
    pub(super) fn smooth_at_force(&self, force: f64) -> Result<Vec<State>, ContactError> {
        let mut lack = |a: f64| match self.contact.any_force(a) {
            Ok(found) => Ok(found.estimate.value - force),
            Err(ContactError::Transform(TransformError::Overflow { is_negative, .. })) => Ok(overflow(is_negative)),
            Err(ContactError::Transform(error)) => Err(error),
            Err(_) => Err(TransformError::NotComputable { at: a }),
        };
        let samples = |own: &Self| {
            let mut found = Vec::new();
            let mut before = (own.landscape.flat, -force);
            for (x, carried) in own.carried() {
                let here = carried - force;
                if before.1 < 0.0 && here >= 0.0 {
                    found.push((before.0, *x));
                }
                before = (*x, here);
            }
            found
        };
        let mut states = Vec::new();
        for Root { radius, asked, value } in self.roots(&self.follower.forces, &mut lack, force, samples)? {
            let depth = self.contact.depth(asked)?.estimate.value;
            let depth = depth - value / (2.0 * self.contact.effective_modulus() * asked);
            states.push(State { depth, force, radius, boundary: Boundary::Smooth });
        }
        Ok(states)
    }

    /// F at the radii where g was sampled; computed with the first given force.
    fn carried(&self) -> &[(f64, f64)] {
        // Kept for later loads, whose budgets are their own.
        let all = || {
            let places = self.landscape.samples.iter().map(|(x, _)| *x);
            places.filter_map(|x| Some((x, self.contact.any_force(x).ok()?.estimate.value))).collect()
        };
        self.known.forces.get_or_init(|| work::unbroken(all))
    }

    /// The roots of a function that rises with g: the only one where g rises everywhere, else one per bracket.
    fn roots(
        &self,
        follower: &Cell<Option<Last>>,
        function: &mut impl FnMut(f64) -> Result<f64, TransformError>,
        target: f64,
        brackets: impl Fn(&Self) -> Vec<(f64, f64)>,
    ) -> Result<Vec<Root>, ContactError> {
        let mut found = Vec::new();
        if !self.landscape.rising {
            for (lower, upper) in brackets(self) {
                let lower = if lower > 0.0 { lower } else { inward(function, upper)? };
                let radius = bracketed(&mut *function, lower, upper, &RootOptions::default())?.x;
                found.push(Root { radius, asked: radius, value: function(radius)? });
            }
            return Ok(found);
        }
        if let Some(root) = self.followed(follower, function, target) {
            return Ok(vec![root]);
        }
        let Some((lower, upper)) = self.bracket(follower, function)? else { return Ok(found) };
        let root = bracketed(&mut *function, lower, upper, &RootOptions::default())?.x;
        let step = 1e-4 * (root - self.landscape.flat);
        let here = function(root)?;
        if step > 0.0
            && let Ok(before) = function(root - step)
        {
            follower.set(Some(Last::first(target, root, (here - before) / step)));
        }
        found.push(Root { radius: root, asked: root, value: here });
        Ok(found)
    }

    /// Secant steps from the last root; `None` if they do not settle.
    fn followed(
        &self,
        follower: &Cell<Option<Last>>,
        function: &mut impl FnMut(f64) -> Result<f64, TransformError>,
        target: f64,
    ) -> Option<Root> {
        let last = follower.get()?;
        let (flat, reach) = (self.landscape.flat, self.contact.evaluator().limit().min(self.setup.rim.unwrap_or(f64::INFINITY)));
        let (mut rise, mut before) = (last.rise, (last.root, last.target - target));
        let mut root = last.foretold(target);
        // A far load needs a bracket, and so does the neighbourhood of a flat part, where g starts like a root.
        if !(root - last.root).is_finite() || (root - last.root).abs() > 0.2 * (last.root - flat).min(last.root) {
            return None;
        }
        let mut step = (root - last.root) / (last.root - flat);
        for _ in 0..MOST_SECANTS {
            if root <= flat || root >= reach {
                return None;
            }
            let here = function(root).ok()?;
            if root != before.0 {
                rise = (here - before.1) / (root - before.0);
            }
            if rise.is_nan() || rise <= 0.0 {
                return None;
            }
            let next = here / rise;
            let relative = next / (root - flat);
            before = (root, here);
            root -= next;
            // The error of a secant step is about the product of the last two; what depends on it is right to second order.
            let near = relative.abs() < CLOSE && (relative * step).abs() < 1e-17 && (0.5..2.0).contains(&(rise / last.rise));
            if relative == 0.0 || near || relative.abs() < f64::EPSILON {
                follower.set(Some(last.next(target, root, rise)));
                return Some(Root { radius: root, asked: before.0, value: here });
            }
            step = relative;
        }
        None
    }

    /// Two radii between which a rising function changes its sign.
    fn bracket(
        &self,
        follower: &Cell<Option<Last>>,
        function: &mut impl FnMut(f64) -> Result<f64, TransformError>,
    ) -> Result<Option<(f64, f64)>, ContactError> {
        let (flat, limit) = (self.landscape.flat, self.contact.evaluator().limit());
        let end = if limit.is_finite() { limit.next_down() } else { FARTHEST }.min(self.setup.rim.unwrap_or(f64::INFINITY));
        let mut upper = follower.get().map_or(self.landscape.reach * 1e-3, |last| last.root).max(flat.max(NEAREST)).min(end);
        let mut factor = 2.0;
        let mut above = |a: f64| function(a).map(|value| value >= 0.0);
        // g may have no accurate value next to the end of a profile or far out; such a place is approached from below.
        let mut without = None;
        let starts_above = loop {
            match above(upper) {
                Ok(own) => break own,
                Err(error) if error.is_local() && upper > flat.max(NEAREST) => {
                    without = Some(upper);
                    upper = (upper / factor).max(flat).max(NEAREST);
                    factor *= factor.min(1e30);
                }
                Err(error) => return Err(error.into()),
            }
        };
        let mut lower = upper;
        factor = 2.0;
        if starts_above {
            while above(lower)? {
                if lower <= flat || lower <= NEAREST {
                    return Ok(None);
                }
                upper = lower;
                lower = (lower / factor).max(flat).max(NEAREST);
                factor *= factor.min(1e30);
            }
        } else {
            loop {
                match above(upper) {
                    Ok(true) => break,
                    Ok(false) if upper >= end => return Ok(None),
                    Ok(false) => lower = upper,
                    Err(error) if error.is_local() && upper - lower > CLOSEST * upper => {
                        without = Some(upper);
                    }
                    Err(error) => return Err(error.into()),
                }
                upper = without.map_or((upper * factor).min(end), |place| lower + 0.5 * (place - lower));
                factor *= factor.min(1e30);
            }
        }
        Ok(Some((lower, upper)))
    }
}

/// The first place inward of `upper` at which the function is negative.
fn inward(function: &mut impl FnMut(f64) -> Result<f64, TransformError>, upper: f64) -> Result<f64, ContactError> {
    let mut lower = upper;
    while function(lower)? >= 0.0 {
        lower *= 0.25;
        if lower < NEAREST {
            return Err(ContactError::Unreachable { depth: upper, reason: "the radius lies below the smallest number" });
        }
    }
    Ok(lower)
}
