//! The contact radius at a given depth: the first root of g(a) = d, independent of the unit of length.

pub(super) mod features;
pub(super) mod unreachable;

use super::{Contact, ContactError};
use crate::num::roots::{RootOptions, bracketed};
use crate::num::{Bound, Estimate, work};
use crate::transform::{Quantities, Reading, TransformError};
use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

/// Samples of g in order of increasing radius; each search extends those of the previous one.
#[derive(Default)]
pub(super) struct DepthSamples(Mutex<SearchState>);

#[derive(Clone, Default)]
struct SearchState {
    places: Vec<(f64, f64)>,
    /// Indices of the first radius that was sampled, and of the next one.
    first: usize,
    next: usize,
    /// The smallest depth for which the samples begin early enough.
    smallest: f64,
    /// Number of consecutive radii at which the error of g exceeded its value.
    lost: u32,
    /// Indices of the radii up to which narrow features were looked for, from the radius before.
    examined: BTreeSet<usize>,
    /// The largest g so far, and the number of radii sampled since then.
    largest: f64,
    idle: u32,
    ended: bool,
    /// The error of a method that has no value of g from here on, so that nothing can be said about larger radii.
    refused: Option<TransformError>,
    /// The same while no radius has a value yet.
    skipped: Option<TransformError>,
}

/// Smallest radius sampled, relative to the end of the profile if it has one.
const NEAREST: f64 = 1e-40;
/// Smallest distance from the flat part of a tip, relative to its radius.
const NEAREST_TO_FLAT: f64 = 1e-14;
/// Smallest radius tried for depths below the first sample.
const LEAST: f64 = 1e-290;
/// Largest radius sampled on an unbounded profile, which the message of a proof names.
const FARTHEST: f64 = 1e150;
/// Number of decades sampled toward the end of a bounded profile.
const ENDS: i32 = 15;
/// An interval is bisected if ln g deviates by more than this from the power law of its neighbours.
const BENT: f64 = 1e-3;
/// Maximum number of bisections per decade, by the cost of one evaluation of g in steps.
const HALVINGS: [(u64, u32); 3] = [(5_000, 8), (200_000, 6), (u64::MAX, 4)];
/// Maximum number of waves that are resolved.
const MOST_WAVES: f64 = 500.0;
/// Maximum number of steps for that, with eight values of g for each wave.
const STEPS_FOR_WAVES: f64 = 8e7;
/// Number of bisections that are made in any case.
const CERTAIN: u32 = 2;
/// Maximum number of iterations to locate a local maximum of g, or the radius where g ceases to exist.
const MOST_ITERATIONS: u32 = 60;
/// The search ends after this many consecutive samples whose error exceeds their value.
const LOST: u32 = 3;
/// A search that has taken this many steps attempts to prove that no radius exists.
const EXPENSIVE: u64 = 1_000_000;
/// Maximum number of further radii searched for an accurate value of g.
const LEAP: usize = 20;
/// The distance from a root at which its sign is certain is increased by at most this factor at once.
const MOST_MISSING: f64 = 64.0;
/// Narrow features are looked for between this number of radii before a root.
const DECADES: usize = 4;
/// Ratio of depths below which the smaller one is negligible.
const NOTHING: f64 = 1e-9;
/// The search ends after this many consecutive samples without a new maximum of g.
const IDLE: u32 = 8;

/// a(d) with its error.
///
/// # Errors
/// [`ContactError::Unreachable`] if no contact radius exists, [`ContactError::NotFound`] if the search finds none but cannot exclude one.
pub(super) fn of_depth<P: Quantities + ?Sized>(
    contact: &Contact<'_, P>,
    radii: &DepthSamples,
    depth: f64,
) -> Result<Reading, ContactError> {
    if !(depth >= 0.0 && depth.is_finite()) {
        return Err(ContactError::Unreachable { depth, reason: "expected a finite depth d >= 0" });
    }
    let evaluator = contact.evaluator();
    // g vanishes on the flat part of a worn tip, so the root lies beyond it.
    let (start, limit) = (evaluator.flat_radius()?, evaluator.limit());
    if depth == 0.0 {
        return Ok(Reading { estimate: Estimate::exact(start), method: "exact" });
    }
    let (mut evaluations, mut way) = (0, "");
    let mut height = |a: f64| match evaluator.equivalent(a) {
        Ok(g) => {
            evaluations += g.estimate.evaluations + 1;
            way = g.estimate.way;
            Ok(g.estimate)
        }
        // g overflows beyond every root.
        Err(TransformError::Overflow { is_negative, .. }) => Ok(Estimate::exact(overflow(is_negative))),
        Err(other) => Err(other),
    };
    let stays_below = || unreachable::stays_below(evaluator, depth);
    let near = || near_axis(evaluator, start, |_, g| g < depth);
    let wave = |a: f64| evaluator.shortest_wave(a);
    let features = |lower: f64, upper: f64| contact.features.between(evaluator, lower, upper);
    let span = Span { near: &near, start, limit, wave: &wave, features: &features };
    let found = root(&mut height, &stays_below, radii, depth, span)?;
    let (a, CertainSigns { reach, bound, .. }) = found.map_err(|absence| match absence {
        NoRadius::Proven(reason) => ContactError::Unreachable { depth, reason },
        NoRadius::Unproven(reason) => ContactError::NotFound { depth, reason },
    })?;
    Ok(Reading { estimate: Estimate { error: reach, evaluations, bound, way, ..Estimate::exact(a) }, method: "root" })
}

/// The radii that a search covers.
pub(super) struct Span<'a> {
    /// Returns a radius up to which the function is proven to stay below the value, or 0.
    pub(super) near: &'a dyn Fn() -> f64,
    /// The end of the flat part of the tip.
    pub(super) start: f64,
    /// The end of the profile.
    pub(super) limit: f64,
    /// The length of the shortest wave of f at a radius.
    pub(super) wave: &'a dyn Fn(f64) -> f64,
    /// The radii between two others at which the function may have a maximum that is narrow.
    pub(super) features: &'a dyn Fn(f64, f64) -> Vec<f64>,
}

/// The largest of the radii to sample up to which `is_below` holds for the radius and a bound on |g| there; 0 if there is none.
pub(super) fn near_axis<P: Quantities + ?Sized>(shape: &P, start: f64, is_below: impl Fn(f64, f64) -> bool) -> f64 {
    if start > 0.0 {
        return 0.0;
    }
    let places = outward(start, shape.limit());
    let kink = shape.breakpoints_below(f64::INFINITY).first().copied().unwrap_or(f64::INFINITY);
    let is_proven = |a: &f64| *a <= kink && unreachable::bound_at_axis(shape, *a).is_some_and(|most| is_below(*a, most));
    places.into_iter().take_while(is_proven).last().unwrap_or(0.0)
}

/// The infinity in place of a value that overflows.
pub(in crate::contact) fn overflow(is_negative: bool) -> f64 {
    if is_negative { f64::NEG_INFINITY } else { f64::INFINITY }
}

/// The reason why a search found no radius.
pub(in crate::contact) enum NoRadius {
    /// No radius exists.
    Proven(&'static str),
    /// A radius may exist.
    Unproven(&'static str),
}

/// The smallest radius at which a function reaches a value, with its error; or the reason why none was found.
///
/// `stays_below` returns the reason if it proves that no radius exists, at least up to the end. It is called at most once: when a value has
/// no digits, when the search has become expensive, or at the end of the search.
pub(super) fn root(
    height: &mut dyn FnMut(f64) -> Result<Estimate, TransformError>,
    stays_below: &dyn Fn() -> Option<NoRadius>,
    radii: &DepthSamples,
    target: f64,
    span: Span<'_>,
) -> Result<Result<(f64, CertainSigns), NoRadius>, ContactError> {
    let Span { near, start, limit, wave, features } = span;
    let mut with_digits = |a: f64| {
        let Estimate { value, error, .. } = height(a)?;
        if error > value.abs() { Err(TransformError::NoDigits { at: a, value, error }) } else { Ok(value) }
    };
    let places = outward(start, limit);
    let mut look = RootSearch { height: &mut with_digits, stays_below, near, start, limit, wave, features, places, refused: None };
    let (lower, upper) = match look.bracket(radii, target)? {
        Ok(found) => found,
        Err(absence) => return Ok(Err(absence)),
    };
    let mut gap = |a: f64| if a <= start { Ok(-target) } else { height(a).map(|own| own.value - target) };
    let a = bracketed(&mut gap, lower, upper, &RootOptions::default())?.x;
    let mut gap = |a: f64| {
        let own = height(a)?;
        Ok(if own.value.is_finite() { own + Estimate::exact(-target) } else { own })
    };
    Ok(certain(&mut gap, a, start, limit)?
        .map(|certain| (a, certain))
        .ok_or(NoRadius::Unproven("the errors are too large to show where it is reached")))
}

/// The neighbourhood of a root beyond which the sign of an increasing function is certain.
pub(super) struct CertainSigns {
    /// The distance from the root.
    pub(super) reach: f64,
    /// The largest |value| with its error at the evaluated points within that distance.
    pub(super) spread: f64,
    /// Whether the signs are proven.
    pub(super) bound: Bound,
}

/// The smallest distance from a root `a` of an increasing function at which its sign is certain on both sides, if any.
///
/// The function is evaluated neither at `start`, below which it is negative, nor at `limit`, where it ends.
pub(super) fn certain(
    gap: &mut dyn FnMut(f64) -> Result<Estimate, ContactError>,
    a: f64,
    start: f64,
    limit: f64,
) -> Result<Option<CertainSigns>, ContactError> {
    let mut reach = f64::EPSILON * a;
    while reach < a {
        let below = if a - reach > start { Some(gap(a - reach)?) } else { None };
        let above = if a + reach < limit { Some(gap(a + reach)?) } else { None };
        if below.is_none_or(|own| own.value < -own.error) && above.is_none_or(|own| own.value > own.error) {
            let both = below.into_iter().chain(above);
            let spread = both.clone().map(|own| own.value.abs() + own.error).fold(0.0, f64::max);
            return Ok(Some(CertainSigns { reach, spread, bound: both.fold(Bound::Proven, |bound, own| bound.and(own.bound)) }));
        }
        // The difference grows with the distance, the errors do not.
        let error = below.into_iter().chain(above).map(|own| own.error).fold(0.0, f64::max);
        let half = match (below, above) {
            (Some(below), Some(above)) => 0.5 * (above.value - below.value),
            (one, other) => one.or(other).map_or(0.0, |own| own.value.abs()),
        };
        let missing = if half > 0.0 { (error / half).max(2.0) } else { 2.0 };
        reach *= missing.min(MOST_MISSING).log2().ceil().exp2();
    }
    Ok(None)
}

/// Samples g outward from the flat part of the tip.
struct RootSearch<'a> {
    height: &'a mut dyn FnMut(f64) -> Result<f64, TransformError>,
    stays_below: &'a dyn Fn() -> Option<NoRadius>,
    /// See [`Span`].
    near: &'a dyn Fn() -> f64,
    start: f64,
    limit: f64,
    wave: &'a dyn Fn(f64) -> f64,
    features: &'a dyn Fn(f64, f64) -> Vec<f64>,
    /// The radii to sample, in increasing order.
    places: Vec<f64>,
    /// The error of a method that has no value at some radius.
    refused: Option<TransformError>,
}

/// One radius per decade, and toward the end of a bounded profile one per decade of the distance to it.
fn outward(start: f64, limit: f64) -> Vec<f64> {
    let powers = |from: f64| (0..).map(move |step| from * 10f64.powi(step));
    let (nearest, end) = if limit.is_finite() { (NEAREST * limit, 0.5 * limit) } else { (NEAREST, FARTHEST) };
    let nearest = if start > 0.0 { NEAREST_TO_FLAT * start } else { nearest };
    let mut list: Vec<f64> = powers(nearest).map(|offset| start + offset).take_while(|a| *a < end).filter(|a| *a > start).collect();
    if limit.is_finite() {
        list.extend((0..=ENDS).map(|step| limit - 0.5 * (limit - start) * 0.1f64.powi(step)).filter(|a| *a >= end));
        list.push(limit.next_down());
        list.retain(|a| *a > start && *a < limit);
        list.dedup();
    }
    list
}

impl RootSearch<'_> {
    /// g at a radius; the first error of a method without a value is kept.
    fn value(&mut self, a: f64) -> Result<f64, TransformError> {
        let found = (self.height)(a);
        if let Err(error @ (TransformError::NotThisWay { .. } | TransformError::NoSuchWay { .. })) = &found {
            self.refused.get_or_insert_with(|| error.clone());
        }
        found
    }

    /// The first pair of adjacent radii between which g reaches the depth.
    fn bracket(&mut self, radii: &DepthSamples, depth: f64) -> Result<Result<(f64, f64), NoRadius>, ContactError> {
        let begin = work::left();
        let mut asked = false;
        let mut seen = radii.0.lock().unwrap_or_else(PoisonError::into_inner).clone();
        if seen.next == 0 || depth < seen.smallest {
            let near = (self.near)();
            // The two radii before the first one that counts show where g deviates from a power law.
            let first = self.places.partition_point(|a| *a <= near).saturating_sub(3);
            if seen.next == 0 || first < seen.first {
                seen = SearchState { first, next: first, ..SearchState::default() };
            }
            seen.smallest = depth;
        }
        let mut from = 0;
        let place = loop {
            if let Some(place) = seen.places.iter().skip(from).position(|(_, g)| *g >= depth) {
                break Some(from + place);
            }
            if let Some(refused) = seen.refused.clone() {
                *radii.0.lock().unwrap_or_else(PoisonError::into_inner) = seen;
                return Err(refused.into());
            }
            if seen.ended {
                match seen.skipped.clone().filter(|_| seen.places.is_empty()) {
                    Some(error) => return Err(error.into()),
                    None => break None,
                }
            }
            if !asked && (seen.lost > 0 || begin.saturating_sub(work::left()) > EXPENSIVE) {
                asked = true;
                if let Some(absence) = (self.stays_below)() {
                    *radii.0.lock().unwrap_or_else(PoisonError::into_inner) = seen;
                    return Ok(Err(absence));
                }
            }
            // A local maximum may be inserted before the last two samples.
            from = seen.places.len().saturating_sub(3);
            let mut further = seen.clone();
            self.go_on(&mut further);
            if let Err(cut) = work::check() {
                // Keep the samples that were complete before the budget ran out.
                *radii.0.lock().unwrap_or_else(PoisonError::into_inner) = seen;
                return Err(TransformError::from(cut).into());
            }
            // A gap between two radii may hide a hump.
            match self.refused.take() {
                None => seen = further,
                Some(error) => seen.refused = Some(error),
            }
        };
        let place = self.with_features(&mut seen, place, depth);
        if let Err(cut) = work::check() {
            return Err(TransformError::from(cut).into());
        }
        let found = place.and_then(|place| Some((place, seen.places.get(place)?.0)));
        let Some((place, upper)) = found else {
            *radii.0.lock().unwrap_or_else(PoisonError::into_inner) = seen;
            let proof = if asked { None } else { (self.stays_below)() };
            return Ok(Err(proof.unwrap_or(NoRadius::Unproven("it is not reached at any radius that was tried"))));
        };
        let before = place.checked_sub(1).and_then(|before| seen.places.get(before)).map(|own| own.0);
        *radii.0.lock().unwrap_or_else(PoisonError::into_inner) = seen;
        match before {
            Some(lower) => Ok(Ok((lower, upper))),
            None if self.start > 0.0 => Ok(Ok((self.start, upper))),
            None => self.inward(upper, depth).map(Ok),
        }
    }

    /// The first sample that reaches the depth once narrow features before it, or before the largest sample, are sampled as well.
    fn with_features(&mut self, seen: &mut SearchState, place: Option<usize>, depth: f64) -> Option<usize> {
        let largest = || seen.places.iter().max_by(|one, other| one.1.total_cmp(&other.1));
        let (reached, _) = place.map_or_else(largest, |place| seen.places.get(place)).copied()?;
        let last = self.places.partition_point(|a| *a < reached);
        // Beyond the largest sample, a feature may be the only place that reaches the depth.
        let last = if place.is_some() { last } else { last + 1 };
        let mut is_changed = false;
        for index in last.saturating_sub(DECADES - 1)..=last {
            let lower = index.checked_sub(1).and_then(|before| self.places.get(before)).copied().unwrap_or(self.start);
            let Some(upper) = self.places.get(index).copied() else { continue };
            if !seen.examined.insert(index) {
                continue;
            }
            let mut found = false;
            for a in (self.features)(lower, upper) {
                let at = seen.places.partition_point(|own| own.0 < a);
                if seen.places.get(at).is_some_and(|own| own.0 == a) {
                    continue;
                }
                if let Ok(g) = self.value(a) {
                    seen.places.insert(at, (a, g));
                    found = true;
                }
            }
            if found {
                let within = |own: &(f64, f64)| own.0 <= upper;
                let first = seen.places.partition_point(|own| own.0 < lower).saturating_sub(1);
                let end = (seen.places.partition_point(within) + 1).min(seen.places.len());
                let mut beyond = seen.places.split_off(end);
                self.climb(first, &mut seen.places);
                seen.places.append(&mut beyond);
                is_changed = true;
            }
        }
        self.refused = None;
        if is_changed { seen.places.iter().position(|(_, g)| *g >= depth) } else { place }
    }

    /// Divides the radius by ten until g is less than the depth.
    fn inward(&mut self, mut upper: f64, depth: f64) -> Result<(f64, f64), ContactError> {
        while upper > LEAST {
            let lower = 0.1 * upper;
            if self.value(lower)? < depth {
                return Ok((lower, upper));
            }
            upper = lower;
        }
        Err(ContactError::Unreachable { depth, reason: "the contact radius underflows; expected a larger one" })
    }

    /// Samples the next radius.
    fn go_on(&mut self, seen: &mut SearchState) {
        let Some(a) = self.places.get(seen.next).copied() else {
            seen.ended = true;
            return;
        };
        seen.next += 1;
        let before = work::left();
        let found = self.value(a);
        let cost = before.saturating_sub(work::left());
        let here = match found {
            Ok(g) => (a, g),
            Err(TransformError::NoDigits { .. }) if seen.places.is_empty() || seen.lost < LOST => {
                seen.lost += u32::from(!seen.places.is_empty());
                return;
            }
            // Next to the axis a method may have no value; smaller roots are looked for there once a larger radius has one.
            Err(TransformError::NotThisWay { .. }) if seen.places.is_empty() => {
                seen.skipped = self.refused.take();
                return;
            }
            Err(_) if seen.places.is_empty() => return,
            Err(error @ (TransformError::NotThisWay { .. } | TransformError::NoSuchWay { .. })) => {
                self.approach(a, seen);
                self.refused = None;
                seen.refused = Some(error);
                return;
            }
            Err(error) => {
                if !(matches!(error, TransformError::NoDigits { .. }) && self.leap(seen)) {
                    self.approach(a, seen);
                }
                return;
            }
        };
        seen.lost = 0;
        self.accept(here, cost, seen);
    }

    /// Adds a sample, refines the interval before it, and adds the local maxima of g.
    fn accept(&mut self, here: (f64, f64), cost: u64, seen: &mut SearchState) {
        let known = seen.places.len();
        if let [.., one, two] = seen.places.as_slice()
            && !self.is_power(*one, *two, here)
        {
            let two = *two;
            self.between(two, here, cost, 0, &mut seen.places);
        }
        seen.places.push(here);
        self.climb(known.saturating_sub(2), &mut seen.places);
        let largest = seen.places.iter().skip(known.saturating_sub(2)).fold(0.0, |most: f64, (_, g)| most.max(*g));
        if largest > seen.largest * (1.0 + 1e-9) || largest == 0.0 {
            (seen.largest, seen.idle) = (largest, 0);
        } else {
            seen.idle += 1;
        }
        seen.ended = here.1 == f64::INFINITY || seen.idle >= IDLE;
    }

    /// Continues at the next radius with an accurate g that makes all samples so far negligible; returns false if there is none.
    ///
    /// Rounding turns a function such as exp(r)-1-r into a line near the axis, and into noise up to a larger radius.
    fn leap(&mut self, seen: &mut SearchState) -> bool {
        let rest: Vec<f64> = self.places.iter().skip(seen.next).take(LEAP).copied().collect();
        let found = rest.into_iter().position(|a| self.value(a).is_ok_and(|g| g > seen.largest / NOTHING));
        let Some(steps) = found else { return false };
        *seen = SearchState { first: seen.first, next: seen.next + steps, smallest: seen.smallest, ..SearchState::default() };
        true
    }

    /// Bisects an interval recursively wherever g deviates from a power law, as often as the cost of g next to its upper end allows, and
    /// within the first waves to an eighth of a wave.
    ///
    /// The first [`CERTAIN`] bisections are always made, because an oscillation may match the power law at one point.
    fn between(&mut self, one: (f64, f64), two: (f64, f64), cost: u64, level: u32, places: &mut Vec<(f64, f64)>) {
        let most = HALVINGS.into_iter().find(|(most, _)| cost <= *most).map_or(0, |(_, halvings)| halvings);
        let middle = self.middle(one.0, two.0);
        let most_waves = (STEPS_FOR_WAVES / (8.0 * cost.max(1) as f64)).min(MOST_WAVES);
        let wave = [one.0, middle, two.0].into_iter().map(|a| (self.wave)(a)).fold(f64::INFINITY, f64::min);
        let has_waves = 8.0 * (two.0 - one.0) > wave && one.0 < most_waves * wave;
        if (level >= most && !has_waves) || middle <= one.0 || middle >= two.0 || work::is_exhausted() {
            return;
        }
        let before = work::left();
        let Ok(g) = self.value(middle) else { return };
        let nearer = before.saturating_sub(work::left());
        let here = (middle, g);
        if level < CERTAIN || has_waves || !self.is_power(one, here, two) {
            self.between(one, here, nearer, level + 1, places);
            places.push(here);
            self.between(here, two, cost, level + 1, places);
        } else {
            places.push(here);
        }
    }

    /// The geometric mean of two distances from the flat part of the tip, or from the end of the profile where that is nearer.
    fn middle(&self, one: f64, two: f64) -> f64 {
        if self.is_near_end(one) {
            return self.limit - ((self.limit - one) * (self.limit - two)).sqrt();
        }
        self.start + ((one - self.start) * (two - self.start)).sqrt()
    }

    /// Returns `true` in the outer half of a profile with an end.
    fn is_near_end(&self, a: f64) -> bool {
        self.limit.is_finite() && a - self.start > self.limit - a
    }

    /// Returns `true` if the third sample lies on the power law through the first two, of the distance from the flat part of the tip
    /// or, next to the end of the profile, from there; g may be negative at all three.
    fn is_power(&self, one: (f64, f64), two: (f64, f64), other: (f64, f64)) -> bool {
        let near_end = [one, two, other].iter().all(|(a, _)| self.is_near_end(*a));
        let [x, y, z] = [one, two, other].map(|(a, _)| if near_end { self.limit - a } else { a - self.start }.ln());
        let sign = if one.1 < 0.0 { -1.0 } else { 1.0 };
        // The logarithm of a value of the other sign is NaN, which lies on no power law.
        let [f, g, h] = [one, two, other].map(|(_, g)| (sign * g).ln());
        let foretold = f + (g - f) * (z - x) / (y - x);
        (one.1 == two.1 && two.1 == other.1) || (foretold - h).abs() <= BENT
    }

    /// Bisects toward the radius beyond which g does not exist, or has no value by the chosen method.
    fn approach(&mut self, mut outer: f64, seen: &mut SearchState) {
        for _ in 0..MOST_ITERATIONS {
            let Some((inner, _)) = seen.places.last().copied() else { break };
            let a = inner + 0.5 * (outer - inner);
            if a <= inner || a >= outer || work::is_exhausted() {
                break;
            }
            let before = work::left();
            match self.value(a) {
                Ok(g) => self.accept((a, g), before.saturating_sub(work::left()), seen),
                Err(_) => outer = a,
            }
        }
        seen.ended = true;
    }

    /// Adds the local maxima of g among the samples starting at `from`, located by golden-section search.
    fn climb(&mut self, from: usize, places: &mut Vec<(f64, f64)>) {
        const GOLDEN: f64 = 0.381_966_011_250_105_1;
        let mut tops = Vec::new();
        for window in places.get(from..).unwrap_or_default().windows(3) {
            let [before, own, after] = window else { continue };
            if !(own.1 > before.1 && own.1 >= after.1) {
                continue;
            }
            let (mut low, mut high, mut best) = (before.0, after.0, *own);
            for _ in 0..MOST_ITERATIONS {
                if high - low <= 1e-8 * best.0 {
                    break;
                }
                // Probe the longer of the two subintervals.
                let a = if best.0 - low > high - best.0 { best.0 - GOLDEN * (best.0 - low) } else { best.0 + GOLDEN * (high - best.0) };
                let Ok(g) = self.value(a) else { break };
                let end = if g > best.1 { best.0 } else { a };
                if (a > best.0) == (g > best.1) {
                    low = end;
                } else {
                    high = end;
                }
                if g > best.1 {
                    best = (a, g);
                }
            }
            tops.push(best);
        }
        if !tops.is_empty() {
            places.extend(tops);
            places.sort_by(|one, other| one.0.total_cmp(&other.0));
            places.dedup_by(|one, other| one.0 == other.0);
        }
    }
}
