//! ∫₀^a (d − g)² dx, the strain energy divided by E*, with a bound proven by enclosures of f′.

use crate::evaluate::evaluator::{Evaluator, Reading};
use crate::integrate::abel::pieces::{Piece, PieceNode, Range, proven_sum};
use crate::integrate::error::TransformError;
use crate::integrate::integral::{NumericProfile, NumericSegment};
use crate::integrate::source::f_prime::Scratch;
use crate::num::bounded::UNIT;
use crate::num::{Bound, Bounded, Estimate, Region, work};
use std::cell::Cell;
use std::f64::consts::FRAC_PI_2;

/// Steps of work after which the proof is abandoned and nested rules are used.
const LONGEST: u64 = 60_000_000;
/// Below this fraction of a range that begins at the axis, a bound on |g| is tried first.
const NEXT_TO_THE_AXIS: f64 = 1e-2;
/// The relative tolerance of the rules.
const TOLERANCE: f64 = 1e-13;

impl Evaluator<'_> {
    /// ∫₀^a (d − g)² dx for a profile of few pieces; `None` if f′ has no enclosure that bounds the error of a rule.
    pub(crate) fn proven_squared_gap(&self, a: f64, depth: Bounded) -> Option<Result<Reading, TransformError>> {
        if let Err(error) = self.check_domain("a", a) {
            return Some(Err(error));
        }
        let typed = self.typed().ok()?;
        let mut ends = vec![0.0];
        ends.extend(self.breakpoints_below(a));
        ends.push(a);
        let (evaluations, bound, way) = (Cell::new(0), Cell::new(Bound::Proven), Cell::new(""));
        let equivalent = |x: f64| match self.equivalent(x) {
            Ok(Reading { estimate, .. }) => {
                evaluations.set(evaluations.get() + estimate.evaluations + 1);
                bound.set(bound.get().and(estimate.bound));
                way.set(estimate.way);
                estimate.bounded()
            }
            // NaN ends the sum; the nested rules report the error.
            Err(_) => Bounded::exact(f64::NAN),
        };
        let pairs = ends.windows(2).filter_map(|pair| Some((*pair.first()?, *pair.last()?)));
        // The point where g begins to increase has the rounding error of the breakpoint.
        let places = || typed.segments.iter().flat_map(|own| std::iter::once(own.lower).chain(own.upper));
        let clear = |at: f64| 32.0 * places().filter(|own| own.value == at).map(|own| own.error).fold(0.0, f64::max);
        let mut skipped = 0.0;
        let mut ranges = Vec::new();
        for (lower, upper) in pairs {
            let (after, before) = (lower + clear(lower), upper - clear(upper));
            if after >= before {
                // The uncertainties of both ends cover the whole range.
                skipped += upper - lower;
                continue;
            }
            skipped += (after - lower) + (upper - before);
            ranges.push(Gap { typed, equivalent: &equivalent, lower: after, upper: before, depth, slots: Vec::new() });
        }
        // Bound (d − g)² in the skipped ranges by the samples at their ends; rounding errors of g are negligible here.
        let size = |own: Bounded| own.value.abs() + own.error;
        let largest = ends.iter().map(|at| size(depth - equivalent(*at))).fold(0.0, f64::max);
        let more = Bounded { value: 0.0, error: 4.0 * skipped * largest * largest };
        let found = work::share(LONGEST, || proven_sum(&mut ranges, more, TOLERANCE, a))?.ok()??;
        let estimate = Estimate { evaluations: evaluations.get(), ..found }.resting_on(bound.get()).by(way.get());
        Some(Ok(Reading { estimate, method: "quadrature" }))
    }
}

/// (d − g(x))² between two breakpoints.
struct Gap<'a, F> {
    typed: &'a NumericProfile,
    equivalent: &'a F,
    lower: f64,
    upper: f64,
    depth: Bounded,
    slots: Vec<Region>,
}

impl<F: Fn(f64) -> Bounded> Gap<'_, F> {
    fn place(&self, place: PieceNode) -> f64 {
        let x = if place.from_above { self.upper - place.from_upper } else { self.lower + place.from_lower };
        x.clamp(self.lower, self.upper)
    }

    /// Returns d − g(x); near the axis, where g is expensive, from a bound on |g| if that is negligible compared with d.
    fn gap(&self, place: PieceNode, slots: &mut Vec<Region>) -> Bounded {
        let x = self.place(place);
        if x < NEXT_TO_THE_AXIS * self.upper && self.lower == 0.0 {
            let around = Around { lower: 0.0, low: 0.0, high: x, short: 0.0 };
            let largest = self.largest_equivalent(&around, slots);
            if largest <= 0.1 * UNIT * self.depth.value.abs() {
                return Bounded { value: self.depth.value, error: self.depth.error + largest };
            }
        }
        self.depth - (self.equivalent)(x)
    }

    /// A bound on |g| in a rectangle; infinite if unknown.
    fn largest_equivalent(&self, around: &Around, slots: &mut Vec<Region>) -> f64 {
        self.typed.segments.iter().map(|segment| around.largest_part(segment, self.upper, slots)).sum()
    }

    fn around(&self, piece: Piece, sigma: f64) -> Around {
        let (low, high, short) = piece.around(sigma);
        let (width, hair) = (self.upper - self.lower, 4.0 * UNIT * self.upper);
        let (low, high) = if piece.from_above { (width - high - hair, width - low + hair) } else { (low, high) };
        Around { lower: self.lower, low, high, short }
    }
}

/// The rectangle that encloses the Bernstein ellipse of a piece of a range.
struct Around {
    /// The lower end of the range.
    lower: f64,
    /// The real parts, measured from that end.
    low: f64,
    high: f64,
    /// The largest imaginary part.
    short: f64,
}

impl Around {
    /// The real parts measured from another point, at most the lower end of the range.
    fn from(&self, place: f64) -> (f64, f64) {
        let distance = self.lower - place;
        // The difference of two near numbers is exact.
        let hair = if self.lower <= 2.0 * place { 0.0 } else { 2.0 * UNIT * (self.lower + self.high) };
        (distance + self.low - hair, distance + self.high + hair)
    }

    /// The region of x measured from a point with an uncertainty.
    fn region(&self, place: f64, doubt: f64) -> Region {
        let (low, high) = self.from(place);
        Region::new((low - doubt, high + doubt), (-self.short, self.short))
    }

    /// A bound on |x ∫ f′/√(x²−r²) dr| over a segment, r between its lower end and x or its upper end, for every x in the
    /// rectangle, in which it is analytic; infinite if unknown.
    fn largest_part(&self, segment: &NumericSegment, upper: f64, slots: &mut Vec<Region>) -> f64 {
        let (begin, doubt) = (segment.lower.value, segment.lower.error);
        if begin >= upper {
            return 0.0;
        }
        let ended = segment.upper.filter(|end| end.value <= self.lower);
        let (low, _) = self.from(begin);
        let from_begin = self.region(begin, doubt);
        let path = match ended {
            Some(end) => Region::interval(0.0, end.value - begin + 2.0 * doubt),
            None if self.short == 0.0 => from_begin.with_zero().above_zero(),
            None => from_begin.with_zero(),
        };
        let power = segment.power_for(upper);
        // If the ellipse contains the lower end, f′ must be analytic there; otherwise only between the two.
        let is_right = ended.map_or(low > doubt, |end| self.from(end.value).0 > end.error);
        if !(self.short == 0.0 || is_right || (ended.is_none() && begin == 0.0 && power.is_none())) {
            return f64::INFINITY;
        }
        // f′ = δ^s h(δ).
        let along = if ended.is_some() { path } else { from_begin.above_zero() };
        let plain = if power.is_none() { segment.largest_f_prime(path, slots) } else { f64::INFINITY };
        let power = power.or_else(|| segment.leading_power().filter(|_| is_right && plain.is_infinite()));
        let (exponent, largest) = power.map_or((0.0, plain), |own| (own.exponent, own.rest_over(along, slots)));
        let steep = exponent.min(0.0);
        let size = self.region(0.0, 0.0).largest();
        if begin == 0.0 && ended.is_none() {
            // r = x sin t, and sin t ≥ 2t/π.
            return largest * size.powf(1.0 + exponent) * FRAC_PI_2 / (1.0 + steep);
        }
        // For r on the straight line from b to the end, |x − r| is at least the remaining length, |x + r| at least Re x + b, and
        // ∫₀¹ s^p/√(1 − s) ds ≤ 2 for p ≥ 0.
        let length = path.largest();
        let share = if steep < 0.0 { 1.42 / (1.0 + steep) + 2.83 } else { 2.0 };
        largest * size * length.powf(exponent + 0.5) * share / (begin + low + begin).sqrt()
    }
}

impl<F: Fn(f64) -> Bounded> Range for Gap<'_, F> {
    fn width(&self) -> f64 {
        self.upper - self.lower
    }

    fn size_at(&self, place: PieceNode) -> f64 {
        let gap = self.depth - (self.equivalent)(self.place(place));
        gap.value * gap.value
    }

    fn largest(&mut self, piece: Piece, sigma: f64) -> f64 {
        let around = self.around(piece, sigma);
        let mut slots = std::mem::take(&mut self.slots);
        let g = self.largest_equivalent(&around, &mut slots);
        self.slots = slots;
        let largest = (self.depth.value.abs() + self.depth.error + g).powi(2) * (1.0 + 1e-9);
        if largest.is_nan() { f64::INFINITY } else { largest }
    }

    fn fill(&self, places: &[PieceNode], values: &mut [f64], errors: &mut [f64], _scratch: &mut Scratch) {
        let (mut variation, mut before, mut slots): (f64, Option<f64>, _) = (0.0, None, Vec::new());
        for ((value, error), place) in values.iter_mut().zip(errors.iter_mut()).zip(places) {
            let gap = self.gap(*place, &mut slots);
            let square = gap * gap;
            (*value, *error) = (square.value, square.error);
            variation += before.map_or(0.0, |before| (before - square.value).abs());
            before = Some(square.value);
        }
        // The rounding error of every node is at most this; it changes the mean by the variation over the length.
        let length = places.first().zip(places.last()).map_or(0.0, |(first, last)| (last.from_lower - first.from_lower).abs());
        let moved = 4.0 * UNIT * self.upper * variation / length;
        errors.iter_mut().for_each(|error| *error += moved);
    }
}
