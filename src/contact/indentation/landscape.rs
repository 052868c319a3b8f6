//! What a profile looks like to every load of a scene: where g rises, where f has troughs, how far both were looked at.

use super::cells::Cells;
use super::curvature::{Curvature, Kink};
use super::root::Horizon;
use crate::num::roots::{RootOptions, bracketed};
use crate::num::{NumError, work};
use crate::transform::{Quantities, Superposition, TransformError};

/// The shape beyond single loads, looked at once.
pub(super) struct Landscape<'a> {
    /// Slope and bend of the profile.
    pub(super) curvature: Curvature<'a>,
    /// Places where f′ jumps.
    pub(super) kinks: Vec<Kink>,
    /// The end of what was looked at: the rim, the end of the profile, or far beyond the largest load.
    pub(super) reach: f64,
    /// The reach, where it ends because waves of f become too short to be followed.
    pub(super) followed: Option<f64>,
    /// The flat part around the axis: g is 0 up to here.
    pub(super) flat: f64,
    /// The bend enclosed; `None` if f′ has no enclosures.
    pub(super) cells: Option<Cells>,
    /// g is proven to rise up to here.
    pub(super) risen: f64,
    /// The radii that were looked at, rising, and how many they are.
    pub(super) places: Vec<f64>,
    pub(super) looked: u64,
    /// True if g rises from the flat part to the reach, as far as was looked.
    pub(super) rising: bool,
    /// Where g was first seen to fall; the reach where it never does.
    pub(super) first_fall: f64,
    /// Radii with g there; empty if g rises anyway.
    pub(super) samples: Vec<(f64, f64)>,
    /// Radii at which f has a minimum.
    pub(super) troughs: Vec<f64>,
    /// The smallest f, at most 0: the depth of the first touch.
    pub(super) lowest: f64,
    /// The first radius at which the slope exceeds [`STEEP`].
    pub(super) steep: Option<f64>,
}

/// Beyond this slope a half-space is a poor model of the surface.
pub(super) const STEEP: f64 = 0.3;

/// Radii per power of ten at which the bend is looked at.
const PER_DECADE: i32 = 24;
/// How far towards the axis, and beyond the largest load, in powers of ten.
const INWARD: i32 = 12;
const OUTWARD: i32 = 5;
/// Evenly spaced radii up to twice the largest load.
const EVEN: i32 = 512;
/// The bend is enclosed from this share of the largest load on …
const FLOOR: f64 = 1e-12;
/// … and finely up to this multiple of it, where it has no sign.
const FINE: f64 = 4.0;
/// Maximum number of steps for values of g near the largest load.
const NEAR: u64 = 80_000_000;
/// Maximum number of steps for values of g far out, each of which may integrate over many waves.
const FAR: u64 = 30_000_000;
/// Every sixteenth place near the largest load is always evaluated.
const COARSE: usize = 16;
/// Maximum number of radii near ranges where the bend is certainly negative.
const MOST_DENTS: usize = 200;

impl<'a> Landscape<'a> {
    /// Looks at a profile up to `rim` or its end; an endless one up to the horizon.
    ///
    /// # Errors
    /// [`TransformError`] if the profile cannot be evaluated.
    pub(super) fn new(
        evaluator: &Superposition<'a>,
        curvature: Curvature<'a>,
        rim: Option<f64>,
        horizon: &Horizon,
    ) -> Result<Self, TransformError> {
        let kinks = curvature.kinks();
        let limit = evaluator.limit();
        let end = rim.map_or_else(|| if limit.is_finite() { limit.next_down() } else { f64::INFINITY }, |c| c.min(limit.next_down()));
        let far = (horizon.scale * 10f64.powi(OUTWARD)).min(horizon.followed);
        let (scale, reach) = if end.is_finite() { (end, end) } else { (horizon.scale, far) };
        let flat = Some(evaluator.flat_radius()?).filter(|flat| *flat < end).unwrap_or(0.0);
        let mut places = places(evaluator, flat, scale, reach);
        let cells = Cells::new(&curvature, &kinks, FLOOR * scale, (FINE * scale).min(reach), reach);
        let bends_up = cells.as_ref().is_some_and(Cells::bends_up);
        let risen = cells.as_ref().map_or(0.0, |own| if bends_up { reach } else { own.risen() });
        let mut dents = Vec::new();
        if let (Some(own), true) = (&cells, risen < reach) {
            dents = own.dents(&places, MOST_DENTS);
            dents.retain(|r| *r > flat && *r < reach);
            places.extend(&dents);
            places.sort_by(f64::total_cmp);
            places.dedup();
        }
        let mut own = Self {
            curvature,
            kinks,
            cells,
            risen,
            looked: places.len() as u64,
            places: Vec::new(),
            reach,
            followed: (!end.is_finite() && reach == horizon.followed).then_some(reach),
            flat,
            rising: true,
            first_fall: reach,
            samples: Vec::new(),
            troughs: Vec::new(),
            lowest: 0.0,
            steep: None,
        };
        own.steep = first_steep(&own.curvature, flat, &places);
        own.places.clone_from(&places);
        if risen >= reach {
            return Ok(own);
        }
        let concave = own.kinks.iter().any(|kink| kink.jump < 0.0 && kink.at < reach);
        let bent = places.iter().any(|r| {
            let bend = own.curvature.bend(*r);
            bend.value < -bend.error
        });
        if concave || bent {
            let list = telling(&places, own.cells.as_ref().map(Cells::rising_ranges).unwrap_or_default());
            own.sample(evaluator, &places, &SamplingPlaces { list, dents: &dents, enough: 2.0 * scale })?;
        }
        Ok(own)
    }

    /// g at the radii that determine where it increases, and the minima of f between them.
    fn sample(&mut self, evaluator: &Superposition<'_>, places: &[f64], telling: &SamplingPlaces<'_>) -> Result<(), TransformError> {
        let mut seen = Vec::new();
        // Skips places where g cannot be evaluated.
        let mut look = |x: f64| seen.extend(evaluator.equivalent(x).ok().map(|g| (x, g.estimate.value, g.estimate.error)));
        let (coarse, fine) = telling.near();
        look_while(&coarse, u64::MAX, &mut look);
        let thinned = look_while(&fine, NEAR, &mut look).is_some();
        let far = telling.far();
        let cut = look_while(far, FAR, &mut look);
        if let Some(cut) = cut {
            self.reach = cut.checked_sub(1).and_then(|last| far.get(last)).map_or(telling.enough, |last| *last);
            self.followed = Some(self.reach);
            self.places.retain(|r| *r <= self.reach);
            if cut == 0 {
                look(self.reach);
            }
        }
        seen.sort_by(|one, other| one.0.total_cmp(&other.0));
        self.looked = if thinned { seen.len() } else { self.places.len() } as u64;
        let mut before = (self.flat, 0.0, 0.0);
        let mut fallen = None;
        for (x, g, error) in seen {
            if fallen.is_none() && g + error < before.1 - before.2 {
                fallen = Some(before.0);
            }
            before = (x, g, error);
            self.samples.push((x, g));
        }
        self.rising = fallen.is_none();
        self.first_fall = fallen.unwrap_or(self.reach);
        if self.rising {
            self.samples.clear();
            return Ok(());
        }
        let mut falling = None;
        for r in places.iter().filter(|r| **r <= self.reach) {
            let f_prime = self.curvature.f_prime(*r);
            if let Some(from) = falling
                && f_prime.value > f_prime.error
            {
                self.troughs.push(self.trough(from, *r));
            }
            if f_prime.value.abs() > f_prime.error {
                falling = (f_prime.value < 0.0).then_some(*r);
            }
        }
        // The smallest f is at a root of f′, at a kink, or at the end.
        let kinks = self.curvature.breakpoints();
        let candidates = self.troughs.iter().chain(kinks.iter().filter(|at| **at < self.reach)).chain([&self.reach]);
        let heights = candidates.filter_map(|r| Some(evaluator.height(*r).ok()?.estimate.value));
        self.lowest = heights.fold(0.0, f64::min);
        Ok(())
    }

    /// Where f′ changes its sign between a radius at which f falls and one at which it rises.
    fn trough(&self, from: f64, to: f64) -> f64 {
        let root = bracketed(|r| Ok::<f64, NumError>(self.curvature.f_prime(r).value), from, to, &RootOptions::default());
        root.map_or(0.5 * (from + to), |own| own.x)
    }

    /// Returns the brackets in which g rises through `depth`, from the axis outward.
    ///
    /// Brackets beyond the first sample above `depth` are left out, since they hold no contact radius; see
    /// [`Landscape::exceeds`].
    pub(super) fn rises_through(&self, depth: f64) -> Vec<(f64, f64)> {
        let mut found = Vec::new();
        let mut before = (self.flat, 0.0);
        let mut exceeded = false;
        for (x, g) in &self.samples {
            if before.1 < depth && *g >= depth {
                found.push((before.0, *x));
            }
            exceeded = exceeded || surely_above(*g, depth);
            if exceeded && !found.is_empty() {
                break;
            }
            before = (*x, *g);
        }
        found
    }

    /// Returns the samples at which g begins to fall, in ascending order.
    pub(super) fn falls(&self) -> impl Iterator<Item = f64> + '_ {
        let rises = |pair: &[(f64, f64)]| matches!(pair, [one, two] if one.1 <= two.1);
        let runs = self.samples.windows(2).zip(self.samples.windows(2).skip(1));
        runs.filter(move |(before, beyond)| rises(before) && !rises(beyond)).filter_map(|(_, beyond)| Some(beyond.first()?.0))
    }

    /// Returns true if g exceeds `depth` at a sample below `radius`.
    ///
    /// Such a radius is not a contact radius of that depth: d − g(x) = (2/E*) ∫_x^a r p/√(r²−x²) dr is negative only if the
    /// pressure p is negative somewhere.
    pub(super) fn exceeds(&self, depth: f64, radius: f64) -> bool {
        self.samples.iter().take_while(|(x, _)| *x < radius).any(|(_, g)| surely_above(*g, depth))
    }
}

/// Calls `look` for each place until more than `most` steps are spent; returns the index of the first place that was skipped.
fn look_while(places: &[f64], most: u64, look: &mut impl FnMut(f64)) -> Option<usize> {
    let begin = work::left();
    places.iter().position(|x| {
        // Once the budget is used up, the result is discarded.
        let is_spent = begin.saturating_sub(work::left()) > most || work::is_exhausted();
        if !is_spent {
            look(*x);
        }
        is_spent
    })
}

/// Returns true if g exceeds a depth by more than rounding.
fn surely_above(g: f64, depth: f64) -> bool {
    g > depth + 1e-9 * depth.abs()
}

/// The places at which g is evaluated to find where it rises.
struct SamplingPlaces<'p> {
    list: Vec<f64>,
    /// Places in and around narrow ranges with a negative bend.
    dents: &'p [f64],
    /// Largest radius of a near place.
    enough: f64,
}

impl SamplingPlaces<'_> {
    /// Returns the near places that are always evaluated, and the others from coarse to fine.
    fn near(&self) -> (Vec<f64>, Vec<f64>) {
        let near = self.list.get(..self.list.len() - self.far().len()).unwrap_or_default();
        let (mut coarse, mut levels) = (Vec::new(), vec![Vec::new(); COARSE.ilog2() as usize]);
        for (index, x) in near.iter().enumerate() {
            let level = levels.len().checked_sub(1 + index.trailing_zeros() as usize);
            match level.and_then(|level| levels.get_mut(level)) {
                Some(fine) if index + 1 < near.len() && !self.dents.contains(x) => fine.push(*x),
                _ => coarse.push(*x),
            }
        }
        (coarse, levels.concat())
    }

    fn far(&self) -> &[f64] {
        self.list.get(self.list.partition_point(|x| *x <= self.enough)..).unwrap_or_default()
    }
}

/// The places without those inside ranges in which g is proven to rise: between the ends of such a range g has no other root.
fn telling(places: &[f64], rising: Vec<(f64, f64)>) -> Vec<f64> {
    let mut ranges = rising.into_iter().peekable();
    let mut inside = |from: f64, to: f64| {
        while ranges.next_if(|range| range.1 < to).is_some() {}
        ranges.peek().is_some_and(|range| range.0 <= from)
    };
    let neighbours = places.iter().zip(places.iter().skip(2)).map(|(before, next)| inside(*before, *next));
    // The outermost places have no neighbours.
    let between = std::iter::once(false).chain(neighbours).chain([false]);
    places.iter().copied().zip(between).filter_map(|(place, inside)| (!inside).then_some(place)).collect()
}

/// The first radius at which |f′| exceeds the bound, to about six digits.
pub(super) fn first_steep(curvature: &Curvature<'_>, flat: f64, places: &[f64]) -> Option<f64> {
    first(|r| curvature.f_prime(r).value.abs() > STEEP, flat, places)
}

/// The first radius at which something is true that is not so before; places are rising.
pub(super) fn first(is_so: impl Fn(f64) -> bool, mut from: f64, places: &[f64]) -> Option<f64> {
    let mut to = places.iter().copied().find(|place| {
        let found = is_so(*place);
        from = if found { from } else { *place };
        found
    })?;
    for _ in 0..24 {
        let middle = 0.5 * (from + to);
        if is_so(middle) { to = middle } else { from = middle }
    }
    // The places are a tenth apart or less.
    Some(rounded(to, 7))
}

/// Rising radii: evenly spaced ones about the largest load, geometric ones towards the axis and outward, breakpoints from both
/// sides.
fn places(evaluator: &Superposition<'_>, flat: f64, scale: f64, reach: f64) -> Vec<f64> {
    let ratio = 10f64.powf(1.0 / f64::from(PER_DECADE));
    let mut list: Vec<f64> = (-INWARD * PER_DECADE..=OUTWARD * PER_DECADE).map(|step| scale * ratio.powi(step)).collect();
    let wide = (2.0 * scale).min(reach);
    list.extend((1..=EVEN).map(|step| wide * f64::from(step) / f64::from(EVEN)));
    for b in evaluator.breakpoints_below(reach) {
        list.extend([b * (1.0 - 1e-9), b * (1.0 + 1e-9), b * (1.0 + 1e-6), b * (1.0 + 1e-3)]);
    }
    list.push(reach);
    list.retain(|r| *r > flat && *r <= reach);
    list.sort_by(f64::total_cmp);
    list.dedup();
    list
}

/// Minimum number of radii that are looked at, used if a value is expensive.
const FEWEST_LOOKS: u64 = 16;
/// Maximum number of steps for all of them together, unless they are already as few as possible.
const LOOKING: u64 = 20_000_000;

/// Returns how many values [`LOOKING`] suffices for, at most `most`, if each takes as many steps as this one.
pub(super) fn affordable<T>(most: u32, value: impl Fn() -> T) -> u32 {
    // The first call compiles what later calls reuse, so the second one is measured.
    value();
    let begin = work::left();
    value();
    let cost = begin.saturating_sub(work::left()).max(1);
    (LOOKING / cost).clamp(FEWEST_LOOKS, u64::from(most)) as u32
}

/// A radius rounded to the given number of digits after the first.
pub(super) fn rounded(radius: f64, digits: usize) -> f64 {
    format!("{radius:.digits$e}").parse().unwrap_or(radius)
}
