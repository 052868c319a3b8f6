//! The pressure on the axis by pieces of the angle with proven rules.

use crate::integrate::abel::angle_substitution::NEAR_THE_LIMIT;
use crate::integrate::abel::bisected::Angles;
use crate::integrate::abel::pieces::{MOST_NODES, Piece, PieceNode, Range, proven_sum};
use crate::integrate::integral::{NumericProfile, NumericSegment};
use crate::integrate::pressure::pieces::pressure_of_segments;
use crate::integrate::source::f_prime::{Numbers, Scratch};
use crate::integrate::source::leading_power::LeadingPower;
use crate::num::bounded::UNIT;
use crate::num::{Bounded, Estimate, Region};

impl NumericProfile {
    /// ∫₀^a (r f′)′ arccos(r/a)/r dr + Σ δ arccos(b/a), which is p(0)·π/E*, with a proven bound; `None` if the enclosures of (r
    /// f′)′ do not become small in time.
    pub(crate) fn pressure_on_axis(&self, a: f64, tolerance: f64) -> Option<Estimate> {
        if !a.is_normal() || self.starts_steeply(a) {
            return None;
        }
        // Next to the end of f′ only the distance to it has digits.
        let ends_nearby = |segment: &NumericSegment| segment.limit.as_ref().is_some_and(|limit| a > NEAR_THE_LIMIT * limit.value.value);
        if self.segments.iter().any(|segment| segment.lower.value < a && ends_nearby(segment)) {
            return None;
        }
        let jumps = self.pressure_of_jumps(0.0, a)?;
        let (inner, outer): (Vec<_>, Vec<_>) = self.segments.iter().partition(|segment| segment.lower.value == 0.0);
        let outside = pressure_of_segments(outer.into_iter(), 0.0, a, jumps, tolerance)?;
        let mut ranges = Vec::new();
        for segment in inner {
            ranges.push(Axis { angles: Angles::over(segment, a), bend: segment.bend().ok()?, power: segment.leading_power_of_bend() });
        }
        let found = proven_sum(&mut ranges, outside.bounded(), tolerance, a).ok().flatten()?;
        let smear: f64 = ranges.iter_mut().map(Axis::smear).sum();
        let evaluations = found.evaluations + outside.evaluations;
        smear.is_finite().then_some(Estimate { error: found.error + smear, evaluations, ..found })
    }
}

/// r = a cos φ from the axis to the end of the first segment or to the edge, φ = arccos(r/a): (r f′)′ φ a sin φ/r.
struct Axis<'a> {
    angles: Angles<'a>,
    bend: &'a Numbers,
    /// (r f′)′ = r^s h(r) at the axis: s, and h for enclosures.
    power: Option<&'a LeadingPower>,
}

impl Axis<'_> {
    /// φ a sin φ.
    fn weight(&self, phi: Region, sine: Region) -> f64 {
        self.angles.x * phi.largest() * sine.largest()
    }

    /// Returns a bound on the change of the integral while the upper end varies within its error.
    fn smear(&mut self) -> f64 {
        let (x, width) = (self.angles.x, self.angles.width);
        let Some(end) = self.angles.segment.upper.filter(|upper| upper.value < x && upper.error > 0.0) else { return 0.0 };
        let phi = self.angles.delta(PieceNode { from_lower: width, from_upper: 0.0, from_above: true }).1;
        let arc = 2.0 * end.error / (x * phi.sin());
        arc * self.largest(Piece { from: 0.0, to: arc.min(0.5 * width), from_above: true }, 0.0)
    }
}

impl Range for Axis<'_> {
    fn width(&self) -> f64 {
        self.angles.width
    }

    fn size_at(&self, place: PieceNode) -> f64 {
        let (r, phi) = self.angles.delta(place);
        self.bend.plain(r) * phi * self.angles.x * phi.sin() / r
    }

    fn largest(&mut self, piece: Piece, sigma: f64) -> f64 {
        let radii = self.angles.radii(piece, sigma);
        let segment = self.angles.segment;
        let mut slots = std::mem::take(&mut self.angles.slots);
        let r = radii.delta;
        let mut ratio = segment.largest_bend(r, &mut slots) * r.recip().largest();
        if !ratio.is_finite() {
            // It vanishes at the axis: by the maximum principle |(r f′)′/r| ≤ M/R within |r| ≤ R.
            let reach = 2.0 * r.largest();
            ratio = segment.largest_bend(Region::new((-reach, reach), (-reach, reach)), &mut slots) / reach * (1.0 + 8.0 * UNIT);
        }
        self.angles.slots = slots;
        let largest = ratio * self.weight(radii.phi, radii.sine) * (1.0 + 8.0 * UNIT);
        if largest.is_nan() { f64::INFINITY } else { largest }
    }

    /// By (r f′)′ = r^s h(r), where r/v falls: r is concave in the angle v from the axis.
    fn tail(&mut self, piece: Piece) -> f64 {
        let Some(own) = self.power.filter(|_| !piece.from_above) else { return f64::INFINITY };
        let radii = self.angles.radii(piece, 0.0);
        let mut slots = std::mem::take(&mut self.angles.slots);
        let (exponent, rest) = own.beyond_zeros(radii.delta, &mut slots);
        self.angles.slots = slots;
        // The kernel takes one power of r.
        let power = exponent - 1.0;
        let v = piece.to * (1.0 + 8.0 * UNIT);
        let f_prime = self.angles.delta(PieceNode { from_lower: v, from_upper: self.angles.width - v, from_above: false }).0 / v;
        let steepness = if power < 0.0 { (f_prime * (1.0 - 1e-9)).powf(power) } else { self.angles.x.powf(power) };
        let bound = rest * steepness * v.powf(1.0 + power) / (1.0 + power) * self.weight(radii.phi, radii.sine) * (1.0 + 1e-9);
        if bound >= 0.0 && 1.0 + power > 0.0 { bound + f64::MIN_POSITIVE } else { f64::INFINITY }
    }

    fn fill(&self, places: &[PieceNode], values: &mut [f64], errors: &mut [f64], scratch: &mut Scratch) {
        let (mut deltas, mut doubts, mut weights) = ([0.0; MOST_NODES], [0.0; MOST_NODES], [Bounded::exact(0.0); MOST_NODES]);
        let count = places.len();
        for (((place, delta), doubt), weight) in places.iter().zip(&mut deltas).zip(&mut doubts).zip(&mut weights) {
            let (r, phi) = self.angles.delta(*place);
            (*delta, *doubt) = (r, 16.0 * UNIT * r);
            let value = phi * self.angles.x * phi.sin() / r;
            // The angle is measured from the nearer end: the edge or the axis.
            *weight = Bounded { value, error: 48.0 * UNIT * value };
        }
        self.bend.block(&deltas[..count], &doubts[..count], values, errors, scratch);
        for ((value, error), weight) in values.iter_mut().zip(errors).zip(weights) {
            let found = Bounded { value: *value, error: *error } * weight;
            (*value, *error) = (found.value, found.error);
        }
    }
}
