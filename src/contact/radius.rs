//! The contact radius that belongs to a depth: the first root of g(a) = d, found alike in every unit of length.

use super::{Contact, ContactError};
use crate::num::roots::{RootOptions, bracketed};
use crate::num::{Estimate, work};
use crate::transform::{Quantities, Reading, TransformError};
use std::sync::{Mutex, PoisonError};

/// Radii with g there, from the flat part of the tip outward, as far as a search has come; later searches go on from there.
#[derive(Default)]
pub(super) struct Radii(Mutex<Seen>);

#[derive(Clone, Default)]
struct Seen {
    places: Vec<(f64, f64)>,
    /// The number of the next power of ten.
    next: usize,
    /// Powers of ten in a row at which g had no digits.
    lost: u32,
    /// The largest g so far, and the powers of ten since then.
    largest: f64,
    idle: u32,
    ended: bool,
}

/// The innermost radius of the first look, relative to the end of the profile where it has one …
const NEAREST: f64 = 1e-40;
/// … or the distance from a flat part in its own lengths.
const NEAREST_TO_FLAT: f64 = 1e-14;
/// The innermost radius at all, for tiny depths, and the outermost one.
const LEAST: f64 = 1e-290;
const FARTHEST: f64 = 1e60;
/// How near the end of a profile is looked at, relative to it: powers of ten.
const ENDS: i32 = 15;
/// A step of two neighbouring places is halved where the next one is off the power law before it by more than this …
const BENT: f64 = 1e-3;
/// … so many times at most, by the steps that one value of g costs: 256, 64 or 16 parts of a power of ten.
const HALVINGS: [(u64, u32); 3] = [(5_000, 8), (200_000, 6), (u64::MAX, 4)];
/// Steps up a hump, and toward a place beyond which there is no g.
const STEPS: u32 = 60;
/// So many powers of ten without digits end the look, and so many in which g rises to nothing new.
const LOST: u32 = 3;
const IDLE: u32 = 8;

/// a(d) with its error.
///
/// # Errors
/// [`ContactError::Unreachable`] where g reaches the depth nowhere that was looked at.
pub(super) fn of_depth<P: Quantities>(contact: &Contact<'_, P>, radii: &Radii, depth: f64) -> Result<Reading, ContactError> {
    if depth < 0.0 {
        return Err(ContactError::Unreachable { depth, reason: "a negative depth means no contact; d >= 0 would be accepted" });
    }
    let evaluator = contact.evaluator();
    // The flat part of a worn tip carries no depth: the root lies beyond it.
    let (start, limit) = (evaluator.flat_radius()?, evaluator.limit());
    if depth == 0.0 {
        return Ok(Reading { estimate: Estimate::exact(start), method: "exact" });
    }
    let mut evaluations = 0;
    let mut height = |a: f64| -> Result<f64, TransformError> {
        let g = match evaluator.slope(a) {
            Ok(g) => g.estimate,
            // An overflow lies beyond every root.
            Err(TransformError::Overflow { .. }) => return Ok(f64::INFINITY),
            Err(other) => return Err(other),
        };
        evaluations += g.evaluations + 1;
        let lost = g.error > g.value.abs() && g.error > 1e-3 * depth;
        if lost { Err(TransformError::NoDigits { at: a, value: g.value, error: g.error }) } else { Ok(g.value) }
    };
    let found = Look { height: &mut height, start, places: outward(start, limit) }.bracket(radii, depth)?;
    let Some((lower, upper)) = found else {
        let reason = if limit.is_finite() {
            "g stays below this depth as far as the profile goes"
        } else {
            "g stays below this depth at every radius that was tried"
        };
        return Err(ContactError::Unreachable { depth, reason });
    };
    let mut gap = |a: f64| if a <= start { Ok(-depth) } else { height(a).map(|g| g - depth) };
    let a = bracketed(&mut gap, lower, upper, &RootOptions::default())?.x;
    let noise = evaluator.slope(a)?.estimate.error + f64::EPSILON * depth;
    let Some(error) = certain(&mut gap, a, start, limit, noise)? else {
        return Err(ContactError::Unreachable { depth, reason: "g does not rise through this depth" });
    };
    Ok(Reading { estimate: Estimate::estimated(a, error, evaluations), method: "root" })
}

/// How far from `a` one must go on either side until g − d has its sign beyond doubt; nothing where it never has.
fn certain(
    gap: &mut dyn FnMut(f64) -> Result<f64, TransformError>,
    a: f64,
    start: f64,
    limit: f64,
    noise: f64,
) -> Result<Option<f64>, TransformError> {
    let mut reach = f64::EPSILON * a;
    while reach < a {
        let (below, above) = (a - reach, a + reach);
        let settled_below = below <= start || gap(below)? < -noise;
        let settled_above = above >= limit || gap(above)? > noise;
        if settled_below && settled_above {
            return Ok(Some(reach));
        }
        reach *= 2.0;
    }
    Ok(None)
}

/// A look at g from the flat part outward.
struct Look<'a> {
    height: &'a mut dyn FnMut(f64) -> Result<f64, TransformError>,
    start: f64,
    /// Powers of ten, and steps toward the end of the profile.
    places: Vec<f64>,
}

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

impl Look<'_> {
    /// The first step outward in which g reaches the depth: the radii before and after it.
    fn bracket(&mut self, radii: &Radii, depth: f64) -> Result<Option<(f64, f64)>, ContactError> {
        let mut seen = radii.0.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let mut from = 0;
        let place = loop {
            if let Some(place) = seen.places.iter().skip(from).position(|(_, g)| *g >= depth) {
                break Some(from + place);
            }
            if seen.ended {
                break None;
            }
            // The top of a hump may be put in before the last two places.
            from = seen.places.len().saturating_sub(3);
            let mut further = seen.clone();
            self.go_on(&mut further);
            if let Err(cut) = work::check() {
                // What was seen before stays seen.
                *radii.0.lock().unwrap_or_else(PoisonError::into_inner) = seen;
                return Err(TransformError::from(cut).into());
            }
            seen = further;
        };
        let found = place.and_then(|place| Some((place, seen.places.get(place)?.0)));
        let Some((place, upper)) = found else {
            *radii.0.lock().unwrap_or_else(PoisonError::into_inner) = seen;
            return Ok(None);
        };
        let before = place.checked_sub(1).and_then(|before| seen.places.get(before)).map(|own| own.0);
        *radii.0.lock().unwrap_or_else(PoisonError::into_inner) = seen;
        match before {
            Some(lower) => Ok(Some((lower, upper))),
            None if self.start > 0.0 => Ok(Some((self.start, upper))),
            None => self.inward(upper, depth).map(Some),
        }
    }

    /// Powers of ten inward until g is below the depth.
    fn inward(&mut self, mut upper: f64, depth: f64) -> Result<(f64, f64), ContactError> {
        while upper > LEAST {
            let lower = 0.1 * upper;
            if (self.height)(lower)? < depth {
                return Ok((lower, upper));
            }
            upper = lower;
        }
        Err(ContactError::Unreachable { depth, reason: "the radius lies below the smallest number; a larger depth would be accepted" })
    }

    /// The next power of ten, with the places before it where g is no power law, and the top of a hump.
    fn go_on(&mut self, seen: &mut Seen) {
        let Some(a) = self.places.get(seen.next).copied() else {
            seen.ended = true;
            return;
        };
        seen.next += 1;
        let before = work::left();
        let found = (self.height)(a);
        let cost = before.saturating_sub(work::left());
        let here = match found {
            Ok(g) => (a, g),
            Err(TransformError::NoDigits { .. }) if seen.places.is_empty() || seen.lost < LOST => {
                seen.lost += u32::from(!seen.places.is_empty());
                return;
            }
            Err(_) if seen.places.is_empty() => return,
            Err(_) => return self.approach(a, seen),
        };
        seen.lost = 0;
        let known = seen.places.len();
        if let [.., one, two] = seen.places.as_slice()
            && !self.is_power(*one, *two, here)
        {
            let two = *two;
            let halvings = HALVINGS.into_iter().find(|(most, _)| cost <= *most).map_or(0, |(_, halvings)| halvings);
            self.between(two, here, (halvings, halvings.saturating_sub(2)), &mut seen.places);
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

    /// Halves a step and its parts where g is no power law.
    ///
    /// Two halvings are made in any case, `doubted` tells above which: a wave may have its own value in the middle.
    fn between(&mut self, one: (f64, f64), two: (f64, f64), (halvings, doubted): (u32, u32), places: &mut Vec<(f64, f64)>) {
        let middle = self.start + ((one.0 - self.start) * (two.0 - self.start)).sqrt();
        if halvings == 0 || middle <= one.0 || middle >= two.0 || work::is_exhausted() {
            return;
        }
        let Ok(g) = (self.height)(middle) else { return };
        let here = (middle, g);
        if halvings > doubted || !self.is_power(one, here, two) {
            self.between(one, here, (halvings - 1, doubted), places);
            places.push(here);
            self.between(here, two, (halvings - 1, doubted), places);
        } else {
            places.push(here);
        }
    }

    /// Whether a third place lies on the power law through two.
    fn is_power(&self, one: (f64, f64), two: (f64, f64), other: (f64, f64)) -> bool {
        let [x, y, z] = [one, two, other].map(|(a, _)| (a - self.start).ln());
        let [f, g, h] = [one, two, other].map(|(_, g)| g.ln());
        let foretold = f + (g - f) * (z - x) / (y - x);
        (one.1 == two.1 && two.1 == other.1) || (foretold - h).abs() <= BENT
    }

    /// Steps halfway toward a radius at which there is no g.
    fn approach(&mut self, mut outer: f64, seen: &mut Seen) {
        seen.ended = true;
        for _ in 0..STEPS {
            let Some((inner, _)) = seen.places.last().copied() else { return };
            let a = inner + 0.5 * (outer - inner);
            if a <= inner || a >= outer || work::is_exhausted() {
                return;
            }
            match (self.height)(a) {
                Ok(g) => seen.places.push((a, g)),
                Err(_) => outer = a,
            }
        }
    }

    /// The top of every hump between its neighbours, by the golden section, among the places from one on.
    fn climb(&mut self, from: usize, places: &mut Vec<(f64, f64)>) {
        const GOLDEN: f64 = 0.381_966_011_250_105_1;
        let mut tops = Vec::new();
        for window in places.get(from..).unwrap_or_default().windows(3) {
            let [before, own, after] = window else { continue };
            if !(own.1 > before.1 && own.1 >= after.1) {
                continue;
            }
            let (mut low, mut high, mut best) = (before.0, after.0, *own);
            for _ in 0..STEPS {
                if high - low <= 1e-8 * best.0 {
                    break;
                }
                // Into the longer side.
                let a = if best.0 - low > high - best.0 { best.0 - GOLDEN * (best.0 - low) } else { best.0 + GOLDEN * (high - best.0) };
                let Ok(g) = (self.height)(a) else { break };
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
