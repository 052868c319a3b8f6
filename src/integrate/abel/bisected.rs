//! g, F and G of an expression by pieces of the angle with proven rules.

use crate::eval::{RegionAlgebra, Tape};
use crate::integrate::abel::angle_substitution::NEAR_THE_LIMIT;
use crate::integrate::abel::over_root::{EndDistances, Weighted, proven_sum_over_roots};
use crate::integrate::abel::pieces::{MOST_NODES, Piece, PieceNode, Range, resolved};
use crate::integrate::error::TransformError;
use crate::integrate::integral::{NumericSegment, Weight};
use crate::integrate::source::f_prime::{Numbers, Scratch};
use crate::integrate::source::leading_power::LeadingPower;
use crate::integrate::source::limit::Limit;
use crate::num::bounded::UNIT;
use crate::num::stable::leg;
use crate::num::{Bounded, Estimate, Region, forms};

/// The largest N for which integrals are taken over the N-th root of the angle; larger ones were not measured.
const MOST_ROOT: i32 = 10;

impl NumericSegment {
    /// The integral with a proven bound; `None` if f′ is not an expression, its enclosures do not become small in time, or the
    /// bound exceeds the tolerance and the rounding error.
    ///
    /// # Errors
    /// [`TransformError::NotComputable`] if f′ is not finite.
    pub(crate) fn by_pieces(&self, x: f64, weight: Weight, tolerance: f64) -> Result<Option<Estimate>, TransformError> {
        if !self.f_prime.is_expression() || matches!(weight, Weight::Outside(_)) || !(x.is_normal() && self.lower.value < x) {
            return Ok(None);
        }
        let Some(range) = self.enclosed(x, weight) else { return Ok(None) };
        let power = self.fractional_power(range.power);
        proven_sum_over_roots(&[(range, power)], MOST_ROOT, Bounded::exact(0.0), tolerance, x)
    }

    /// The range with the data for enclosures near its ends; `None` if f′ has a singularity of unknown power.
    fn enclosed(&self, x: f64, weight: Weight) -> Option<Angles<'_>> {
        let power = self.power_for(x);
        if self.singular && power.is_none() {
            return None;
        }
        // Near the end of f′, use the distance to that end, which is accurate.
        let limit = self.limit.as_ref().filter(|limit| x > NEAR_THE_LIMIT * limit.value.value && x < limit.value.value - limit.value.error);
        let limit = limit.and_then(|limit| Some((limit, limit.enclosing()?)));
        Some(Angles { power, limit, weight, ..Angles::over(self, x) })
    }

    /// Distances from the lower end between which one rule resolves f′, determined by enclosures; empty if one rule resolves the
    /// whole range, or without enclosures.
    ///
    /// They are used for integrals without a proven bound, which would otherwise miss narrow features between their nodes.
    pub(crate) fn features(&self, x: f64, tolerance: f64) -> Vec<f64> {
        /// The two halves of a range are always separated.
        const SMOOTH: usize = 4;
        if !(self.f_prime.is_expression() && x.is_normal() && self.lower.value < x) {
            return Vec::new();
        }
        let is_whole = !self.singular && self.upper.is_none_or(|upper| upper.value >= x);
        if is_whole && self.sufficient(x, Weight::Equivalent).is_some() {
            return Vec::new();
        }
        let Some(mut range) = self.enclosed(x, Weight::Equivalent) else { return Vec::new() };
        let places = resolved(&mut range, tolerance, x);
        if places.len() <= SMOOTH { Vec::new() } else { places.into_iter().map(|place| range.delta(place).0).collect() }
    }
}

/// The range of one integral: r = x cos τ from the lower end of the segment to its end or to x.
#[derive(Clone)]
pub(crate) struct Angles<'a> {
    pub(crate) segment: &'a NumericSegment,
    /// f′ = δ^s h(δ) at the lower end: s, and h for enclosures.
    power: Option<&'a LeadingPower>,
    /// The end of f′, if x is near to it, and f′ over the distance to the end for enclosures.
    limit: Option<(&'a Limit, &'a Tape)>,
    pub(crate) x: f64,
    weight: Weight,
    /// The angle between both ends, and the angle from the upper end to the point r = x.
    pub(crate) width: f64,
    beyond: f64,
    /// Relative error of an angle to either end, in units of the rounding of one operation.
    pub(crate) rounding: f64,
    pub(crate) slots: Vec<Region>,
}

/// The regions of r, r − lower, and limit − r for an angle in a region.
pub(crate) struct Radii {
    pub(crate) r: Region,
    pub(crate) delta: Region,
    below: Option<Region>,
    /// The angle to the point r = x, and its sine.
    pub(crate) phi: Region,
    pub(crate) sine: Region,
}

impl<'a> Angles<'a> {
    /// The range of g, from the lower end of a segment to its end or to x.
    pub(crate) fn over(segment: &'a NumericSegment, x: f64) -> Self {
        let end = segment.upper.map_or(f64::INFINITY, |upper| upper.value);
        let width = forms::angle_between(segment.lower.value, end, x);
        let beyond = if end < x { leg(x, end).atan2(end) } else { 0.0 };
        Self { segment, power: None, limit: None, x, weight: Weight::Equivalent, width, beyond, rounding: 16.0, slots: Vec::new() }
    }

    /// r − lower and the angle to r = x, from the angles to both ends.
    pub(crate) fn delta(&self, place: PieceNode) -> (f64, f64) {
        let rest = self.beyond + place.from_upper;
        let delta = 2.0 * self.x * (0.5 * place.from_lower).sin() * (rest + 0.5 * place.from_lower).sin();
        (delta.max(f64::MIN_POSITIVE), rest)
    }

    /// limit − r at an angle to r = x, and a bound on its error.
    fn below(&self, limit: &Limit, rest: f64) -> (f64, f64) {
        let half = (0.5 * rest).sin();
        let gap = limit.value.value - self.x;
        let below = (gap + 2.0 * self.x * half * half).max(f64::MIN_POSITIVE);
        (below, self.rounding * UNIT * below + limit.value.error)
    }

    /// The weight, and bounds on its relative and absolute error.
    fn factor(&self, delta: f64, rest: f64) -> (f64, f64, f64) {
        match self.weight {
            Weight::Force => {
                let share = (self.segment.lower.value + delta) / self.x;
                (share * share, (2.0 * self.rounding + 12.0) * UNIT, 0.0)
            }
            Weight::Integral => (rest.sin() * rest.sin(), self.rounding * UNIT, self.rounding * UNIT),
            Weight::Equivalent | Weight::Outside(_) => (1.0, 0.0, 0.0),
        }
    }

    pub(crate) fn radii(&self, piece: Piece, sigma: f64) -> Radii {
        self.radii_over(EndDistances::of(piece, sigma, self.width))
    }

    fn radii_over(&self, angles: EndDistances) -> Radii {
        let hair = 4.0 * UNIT * self.width;
        let width = Region::new((self.width - hair, self.width + hair), (0.0, 0.0));
        let beyond = Region::new((self.beyond * (1.0 - 4.0 * UNIT), self.beyond * (1.0 + 4.0 * UNIT)), (0.0, 0.0));
        let (v, rest) = (angles.from_lower, beyond + angles.from_upper);
        let half_v = Region::real(0.5) * v;
        let x = Region::real(self.x);
        let lower = self.segment.lower;
        let lower = Region::new((lower.value - lower.error, lower.value + lower.error), (0.0, 0.0));
        // Both enclose all values of δ; the product is accurate near the lower end, the cosine is sharper near the upper end.
        let doubt = Region::new((-self.segment.lower.error, self.segment.lower.error), (0.0, 0.0));
        let by_product = x * Region::real(2.0) * half_v.sin() * (beyond + width - half_v).sin() + doubt;
        let r = x * rest.cos();
        let delta = by_product.and(r - lower);
        let below = self.limit.map(|(limit, _)| {
            let (from, to) = (limit.value.value - limit.value.error - self.x, limit.value.value + limit.value.error - self.x);
            let gap = Region::new((from.next_down(), to.next_up()), (0.0, 0.0));
            gap + x * Region::real(2.0) * (Region::real(0.5) * rest).sin().powi(2)
        });
        Radii { r, delta: if angles.is_real { delta.above_zero() } else { delta }, below, phi: rest, sine: rest.sin() }
    }

    fn weight(&self, radii: &Radii) -> f64 {
        match self.weight {
            Weight::Force => (radii.r.largest() / self.x).powi(2) * (1.0 + 8.0 * UNIT),
            Weight::Integral => radii.sine.largest() * radii.sine.largest(),
            Weight::Equivalent | Weight::Outside(_) => 1.0,
        }
    }
}

impl Weighted for Angles<'_> {
    fn largest_over(&mut self, angles: EndDistances) -> f64 {
        let radii = self.radii_over(angles);
        let f_prime = match (self.limit, radii.below) {
            (Some((_, tape)), Some(below)) if angles.from_above => {
                tape.run(&mut RegionAlgebra, &[below], &mut self.slots).map_or(f64::INFINITY, Region::largest)
            }
            _ => self.segment.largest_f_prime(radii.delta, &mut self.slots),
        };
        let largest = f_prime * self.weight(&radii) * (1.0 + 8.0 * UNIT);
        if largest.is_nan() { f64::INFINITY } else { largest }
    }

    fn weight_over(&mut self, angles: EndDistances) -> f64 {
        self.weight(&self.radii_over(angles)) * (1.0 + 8.0 * UNIT)
    }

    /// x sin θ/θ with |sin θ/θ − 1| ≤ |θ|²/6 · cosh |θ|.
    fn ratio(&self, angle: Region) -> Option<Region> {
        let theta = angle.largest();
        let off = theta * theta * theta.cosh() / 6.0 * (1.0 + 8.0 * UNIT);
        (theta <= 1.0).then(|| Region::real(self.x) * Region::new((1.0 - off, 1.0 + off), (-off, off)))
    }

    fn add_rounding(&mut self, units: f64) {
        self.rounding += units;
    }
}

impl Range for Angles<'_> {
    fn width(&self) -> f64 {
        self.width
    }

    fn size_at(&self, place: PieceNode) -> f64 {
        let (delta, rest) = self.delta(place);
        let f_prime = match self.limit {
            Some((limit, _)) if place.from_above => limit.f_prime.plain(self.below(limit, rest).0),
            _ => self.segment.f_prime.plain(delta),
        };
        f_prime * self.factor(delta, rest).0
    }

    fn largest(&mut self, piece: Piece, sigma: f64) -> f64 {
        self.largest_over(EndDistances::of(piece, sigma, self.width))
    }

    /// ∫₀^v |f′| dv ≤ C ∫₀^v δ^s dv, where δ/v decreases because r is concave in v.
    fn tail(&mut self, piece: Piece) -> f64 {
        let Some(own) = self.power else { return f64::INFINITY };
        if piece.from_above || self.segment.lower.error > 0.0 {
            return f64::INFINITY;
        }
        let radii = self.radii(piece, 0.0);
        let (rest, power) = (own.rest_over(radii.delta, &mut self.slots), own.exponent);
        let v = piece.to * (1.0 + 8.0 * UNIT);
        let f_prime = self.delta(PieceNode { from_lower: v, from_upper: self.width - v, from_above: false }).0 / v;
        // For s > 0, δ ≤ x v.
        let steepness = if power < 0.0 { (f_prime * (1.0 - 1e-9)).powf(power) } else { self.x.powf(power) };
        let bound = rest * steepness * v.powf(1.0 + power) / (1.0 + power) * self.weight(&radii) * (1.0 + 1e-9);
        if bound.is_nan() { f64::INFINITY } else { bound + f64::MIN_POSITIVE }
    }

    fn fill(&self, places: &[PieceNode], values: &mut [f64], errors: &mut [f64], scratch: &mut Scratch) {
        let (mut arguments, mut doubts, mut factors) = ([0.0; MOST_NODES], [0.0; MOST_NODES], [(0.0, 0.0, 0.0); MOST_NODES]);
        let count = places.len();
        let end = self.segment.lower.error;
        // All points of a piece are measured from the same end.
        let limit = self.limit.map(|(limit, _)| limit).filter(|_| places.first().is_some_and(|place| place.from_above));
        for (((place, argument), doubt), factor) in places.iter().zip(&mut arguments).zip(&mut doubts).zip(&mut factors) {
            let (delta, rest) = self.delta(*place);
            // δ is accurate towards the lower end; the width has a rounding error.
            (*argument, *doubt) = match limit {
                Some(limit) => self.below(limit, rest),
                None => (delta, self.rounding * UNIT * delta + if delta > 2.0 * end { end } else { 0.0 }),
            };
            *factor = self.factor(delta, rest);
        }
        let numbers: &Numbers = limit.map_or(&self.segment.f_prime, |limit| &limit.f_prime);
        numbers.block(&arguments[..count], &doubts[..count], values, errors, scratch);
        let varies = self.segment.varies_next_to_lower();
        for (((value, error), (factor, share, flat)), argument) in values.iter_mut().zip(errors).zip(factors).zip(arguments) {
            // `delta` is at least the smallest normal number, below which nothing can be proven.
            let unknown = if varies && argument <= f64::MIN_POSITIVE { f64::INFINITY } else { 0.0 };
            *error = *error * factor + value.abs() * (share * factor + flat) + unknown;
            *value *= factor;
        }
    }
}
