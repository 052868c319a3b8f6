//! What a profile looks like to every load of a scene: where g rises, where f has troughs, how far both were looked at.

use super::curvature::{Curvature, Kink};
use super::root::Horizon;
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
    /// True where g rises from the flat part to the reach.
    pub(super) rising: bool,
    /// Where g was first seen to fall; the reach where it never does.
    pub(super) first_fall: f64,
    /// Radii with g there; empty where g rises anyway.
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

impl<'a> Landscape<'a> {
    /// Looks at a profile up to `rim` or its end; an endless one up to the horizon.
    ///
    /// # Errors
    /// [`TransformError`] where the profile cannot be evaluated.
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
        let places = places(evaluator, flat, scale, reach);
        let mut own = Self {
            curvature,
            kinks,
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
        own.steep = own.first_steep(&places);
        let concave = own.kinks.iter().any(|kink| kink.jump < 0.0 && kink.at < reach);
        let bent = places.iter().any(|r| {
            let bend = own.curvature.bend(*r);
            bend.value < -bend.error
        });
        if concave || bent {
            own.sample(evaluator, &places)?;
        }
        Ok(own)
    }

    /// The first radius at which |f′| exceeds the bound, to about six digits.
    fn first_steep(&self, places: &[f64]) -> Option<f64> {
        let steep = |r: f64| self.curvature.slope(r).value.abs() > STEEP;
        let mut from = self.flat;
        for place in places {
            if steep(*place) {
                let mut to = *place;
                for _ in 0..24 {
                    let middle = 0.5 * (from + to);
                    if steep(middle) { to = middle } else { from = middle }
                }
                return Some(to);
            }
            from = *place;
        }
        None
    }

    /// g, f and its troughs at every place.
    fn sample(&mut self, evaluator: &Superposition<'_>, places: &[f64]) -> Result<(), TransformError> {
        let mut before = (self.flat, 0.0, 0.0);
        let mut fallen = None;
        for x in places {
            // Places without a value are no evidence.
            let Ok(g) = evaluator.slope(*x) else { continue };
            let g = g.estimate;
            if fallen.is_none() && g.value + g.error < before.1 - before.2 {
                fallen = Some(before.0);
            }
            before = (*x, g.value, g.error);
            self.samples.push((*x, g.value));
        }
        self.rising = fallen.is_none();
        self.first_fall = fallen.unwrap_or(self.reach);
        if self.rising {
            self.samples.clear();
            return Ok(());
        }
        let mut falling = false;
        let mut last = 0.0;
        for r in places {
            if let Ok(f) = evaluator.height(*r) {
                self.lowest = self.lowest.min(f.estimate.value);
            }
            let slope = self.curvature.slope(*r);
            if falling && slope.value > slope.error {
                self.troughs.push(0.5 * (last + *r));
            }
            if slope.value.abs() > slope.error {
                falling = slope.value < 0.0;
            }
            last = *r;
        }
        Ok(())
    }

    /// The brackets in which g rises through `depth`, from the axis outward.
    pub(super) fn rises_through(&self, depth: f64) -> Vec<(f64, f64)> {
        let mut found = Vec::new();
        let mut before = (self.flat, 0.0);
        for (x, g) in &self.samples {
            if before.1 < depth && *g >= depth {
                found.push((before.0, *x));
            }
            before = (*x, *g);
        }
        found
    }
}

/// Rising radii: evenly spaced ones about the largest load, geometric ones towards the axis and outward, breakpoints from both sides.
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
