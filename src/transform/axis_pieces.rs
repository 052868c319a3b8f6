//! The pressure on the axis by pieces of the angle with proven rules.

use super::angle_substitution::NEAR_THE_LIMIT;
use super::bisected::Angles;
use super::integral::NumericProfile;
use super::leading_power::LeadingPower;
use super::pieces::{MOST_NODES, Piece, Place, Range, proven_sum};
use super::slope_source::{Numbers, Scratch};
use crate::num::bounded::UNIT;
use crate::num::{Bounded, Estimate, Region};

impl NumericProfile {
    /// ∫₀^a (r f′)′ arccos(r/a)/r dr + Σ δ arccos(b/a), which is p(0)·π/E*, with a proven bound; `None` if the enclosures of (r f′)′ do not
    /// become small in time.
    pub(super) fn pressure_on_axis(&self, a: f64, tolerance: f64) -> Option<Estimate> {
        if !a.is_normal() || self.starts_steeply(a) {
            return None;
        }
        let jumps = self.pressure_of_jumps(0.0, a)?;
        let mut ranges = Vec::new();
        for segment in self.segments.iter().filter(|segment| segment.lower.value < a) {
            // Next to the end of f′ only the distance to it has digits, and a breakpoint that is known to a rounding smears the kernel.
            let ends_nearby = segment.limit.as_ref().is_some_and(|limit| a > NEAR_THE_LIMIT * limit.value.value);
            let is_rough = segment.lower.error > 0.0 || segment.upper.is_some_and(|upper| upper.error > 0.0 && upper.value < a);
            if ends_nearby || is_rough {
                return None;
            }
            // On the axis it is divided by r.
            let power = if segment.lower.value == 0.0 { segment.leading_power_of_bend() } else { segment.power_of_bend_for(a) };
            let bend = segment.bend().ok()?;
            ranges.push(Axis { angles: Angles::over(segment, a), bend, power });
        }
        proven_sum(&mut ranges, jumps, tolerance, a).ok().flatten()
    }
}

/// r = a cos φ from the lower end of a segment to its end or to the edge, φ = arccos(r/a): (r f′)′ φ a sin φ/r.
struct Axis<'a> {
    angles: Angles<'a>,
    bend: &'a Numbers,
    /// (r f′)′ = δ^s h(δ) at the lower end: s, and h for enclosures.
    power: Option<&'a LeadingPower>,
}

impl Axis<'_> {
    /// φ a sin φ.
    fn weight(&self, phi: Region, sine: Region) -> f64 {
        self.angles.x * phi.largest() * sine.largest()
    }
}

impl Range for Axis<'_> {
    fn width(&self) -> f64 {
        self.angles.width
    }

    fn size_at(&self, place: Place) -> f64 {
        let (delta, phi) = self.angles.delta(place);
        let r = self.angles.segment.lower.value + delta;
        self.bend.plain(delta) * phi * self.angles.x * phi.sin() / r
    }

    fn largest(&mut self, piece: Piece, sigma: f64) -> f64 {
        let radii = self.angles.radii(piece, sigma);
        let segment = self.angles.segment;
        let mut slots = std::mem::take(&mut self.angles.slots);
        // From the lower end on δ has digits that the cosine lacks.
        let r = if segment.lower.value == 0.0 { radii.delta } else { radii.r };
        let mut ratio = segment.largest_bend(radii.delta, &mut slots) * r.recip().largest();
        if segment.lower.value == 0.0 && !(ratio.is_finite()) {
            // It vanishes at the axis: by the maximum principle |(r f′)′/r| ≤ M/R within |r| ≤ R.
            let reach = 2.0 * r.largest();
            ratio = segment.largest_bend(Region::new((-reach, reach), (-reach, reach)), &mut slots) / reach * (1.0 + 8.0 * UNIT);
        }
        self.angles.slots = slots;
        let largest = ratio * self.weight(radii.phi, radii.sine) * (1.0 + 8.0 * UNIT);
        if largest.is_nan() { f64::INFINITY } else { largest }
    }

    /// By (r f′)′ = δ^s h(δ), where δ/v falls: r is concave in the angle v from the lower end.
    fn tail(&mut self, piece: Piece) -> f64 {
        let Some(own) = self.power.filter(|_| !piece.from_above) else { return f64::INFINITY };
        let radii = self.angles.radii(piece, 0.0);
        let mut slots = std::mem::take(&mut self.angles.slots);
        let rest = own.rest_over(radii.delta, &mut slots);
        self.angles.slots = slots;
        let lower = self.angles.segment.lower.value;
        // On the axis the kernel takes one power of r.
        let (power, over) = if lower == 0.0 { (own.exponent - 1.0, 1.0) } else { (own.exponent, lower) };
        let v = piece.to * (1.0 + 8.0 * UNIT);
        let slope = self.angles.delta(Place { from_lower: v, from_upper: self.angles.width - v, from_above: false }).0 / v;
        let steepness = if power < 0.0 { (slope * (1.0 - 1e-9)).powf(power) } else { self.angles.x.powf(power) };
        let bound = rest / over * steepness * v.powf(1.0 + power) / (1.0 + power) * self.weight(radii.phi, radii.sine) * (1.0 + 1e-9);
        if bound >= 0.0 && 1.0 + power > 0.0 { bound + f64::MIN_POSITIVE } else { f64::INFINITY }
    }

    fn fill(&self, places: &[Place], values: &mut [f64], errors: &mut [f64], scratch: &mut Scratch) {
        let (mut deltas, mut doubts, mut weights) = ([0.0; MOST_NODES], [0.0; MOST_NODES], [Bounded::exact(0.0); MOST_NODES]);
        let count = places.len();
        for (((place, delta), doubt), weight) in places.iter().zip(&mut deltas).zip(&mut doubts).zip(&mut weights) {
            let (own, phi) = self.angles.delta(*place);
            (*delta, *doubt) = (own, 16.0 * UNIT * own);
            let value = phi * self.angles.x * phi.sin() / (self.angles.segment.lower.value + own);
            // Next to the edge the angle is counted from there, next to the lower end from that one.
            *weight = Bounded { value, error: 48.0 * UNIT * value };
        }
        self.bend.block(&deltas[..count], &doubts[..count], values, errors, scratch);
        for ((value, error), weight) in values.iter_mut().zip(errors).zip(weights) {
            let found = Bounded { value: *value, error: *error } * weight;
            (*value, *error) = (found.value, found.error);
        }
    }
}
