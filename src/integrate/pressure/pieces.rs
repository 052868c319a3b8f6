//! The pressure by pieces of the radius with proven rules: kinks, narrow features and the logarithm of the kernel included.

use crate::integrate::abel::over_root::{EndDistances, Weighted, proven_sum_over_roots};
use crate::integrate::abel::pieces::{MOST_NODES, Piece, PieceNode, Range};
use crate::integrate::integral::{NumericProfile, NumericSegment};
use crate::integrate::pressure::direct::{Distances, KERNEL, kernel};
use crate::integrate::source::endpoint::Endpoint;
use crate::integrate::source::f_prime::{Numbers, Scratch};
use crate::integrate::source::leading_power::LeadingPower;
use crate::num::bounded::UNIT;
use crate::num::{Bounded, Estimate, Region, work};

/// The largest N for which integrals are taken over the N-th root of the radius; for 10 they take up to six times the work.
const MOST_ROOT: i32 = 4;
/// Steps of a bound on a kernel over a piece.
const ENCLOSED_KERNEL: u64 = 45;

impl NumericProfile {
    /// ∫₀^a (r f′)′ K(r, s) dr + Σ b δ K(b, s) with a proven bound, as [`Self::pressure_by_elliptic_kernel`]; `None` where the enclosures of (r
    /// f′)′ do not become small in time, and at the axis, where K is infinite.
    pub(crate) fn pressure_by_pieces(&self, s: f64, a: f64, tolerance: f64) -> Option<Estimate> {
        if !(s > 0.0 && s < a && a.is_normal()) {
            return None;
        }
        let jumps = self.pressure_of_jumps(s, a)?;
        pressure_of_segments(self.segments.iter(), s, a, jumps, tolerance)
    }
}

/// ∫ (r f′)′ K(r, s) dr over segments and `more`, with a proven bound; `None` as [`NumericProfile::pressure_by_pieces`], and
/// where a segment begins at s = 0.
pub(crate) fn pressure_of_segments<'a>(
    segments: impl Iterator<Item = &'a NumericSegment>,
    s: f64,
    a: f64,
    more: Bounded,
    tolerance: f64,
) -> Option<Estimate> {
    let mut ranges = Vec::new();
    let (unit, place_of_s) = (Region::real(1.0) / Region::real(a), place_of_s(s, a));
    for segment in segments {
        let (lower, edge) = (segment.ends.0, Endpoint::exact(a));
        let end = segment.ends.1.filter(|upper| upper.to(edge) > 0.0).unwrap_or(edge);
        if lower.to(end) <= 0.0 {
            continue;
        }
        let bend = segment.bend().ok()?;
        let mut add = |from: Endpoint, to: Endpoint| {
            let power = if from == lower { segment.power_of_bend_for(to.at) } else { None };
            let range = Radii { segment, bend, power, from, to, s, a, unit, place_of_s, rounding: 0.0, slots: Vec::new() };
            let fractional = if from == lower { segment.fractional_power_of_bend(power) } else { None };
            ranges.push((range, fractional));
        };
        if s > lower.at && s < end.at {
            add(lower, Endpoint::exact(s));
            add(Endpoint::exact(s), end);
        } else {
            add(lower, end);
        }
    }
    let found = proven_sum_over_roots(&ranges, MOST_ROOT, more, tolerance, a).ok().flatten()?;
    let smear: f64 = ranges.iter().map(|(range, _)| range.smear()).sum();
    Some(Estimate { error: found.error + smear, ..found })
}

/// The range from `from` to `to`, which lies on one side of s.
#[derive(Clone)]
struct Radii<'a> {
    segment: &'a NumericSegment,
    bend: &'a Numbers,
    /// (r f′)′ = δ^σ h(δ) at the lower end of the segment: σ, and h for enclosures.
    power: Option<&'a LeadingPower>,
    from: Endpoint,
    to: Endpoint,
    s: f64,
    a: f64,
    /// 1/a.
    unit: Region,
    /// s and a − s in units of a.
    place_of_s: (Region, Region),
    /// Further relative error of a radius, in units of the rounding of one operation.
    rounding: f64,
    slots: Vec<Region>,
}

/// s and a − s in units of a.
fn place_of_s(s: f64, a: f64) -> (Region, Region) {
    let ratio = |own: f64| Region::new(((own / a).next_down(), (own / a).next_up()), (0.0, 0.0));
    let rest = a - s;
    (ratio(s), Region::new(((rest / a).next_down() * (1.0 - UNIT), (rest / a).next_up() * (1.0 + UNIT)), (0.0, 0.0)))
}

/// The terms of the kernel, in units of a.
struct Lengths {
    r: Region,
    /// |r − s|.
    difference: Region,
    /// a − r.
    below_edge: Region,
    /// r − lower, in the unit of r.
    delta: Region,
}

impl Radii<'_> {
    fn is_outside(&self) -> bool {
        self.s <= self.from.at
    }

    fn distances(&self, place: PieceNode) -> (f64, f64, Distances) {
        let (up, down) = (place.from_lower, place.from_upper);
        let (s, edge) = (Endpoint::exact(self.s), Endpoint::exact(self.a));
        let delta = (self.segment.ends.0.to(self.from) + up).max(f64::MIN_POSITIVE);
        let difference = if self.is_outside() { s.to(self.from) + up } else { self.to.to(s) + down };
        let r = if up < down { self.from.at + up } else { self.to.at - down };
        (r, delta, Distances { difference, below_edge: self.to.to(edge) + down, is_beyond: self.is_outside() })
    }

    /// The change of the integral due to the uncertainty of the ends of the segment.
    fn smear(&self) -> f64 {
        let width = self.width();
        let at = |share: f64| {
            self.size_at(PieceNode { from_lower: share * width, from_upper: (1.0 - share) * width, from_above: share > 0.5 }).abs()
        };
        let lower = if self.from == self.segment.ends.0 { self.from.doubt } else { 0.0 };
        let upper = self.segment.ends.1.filter(|upper| *upper == self.to).map_or(0.0, |upper| upper.doubt);
        let of = |error: f64, share: f64| if error > 0.0 { 4.0 * error * at(share) } else { 0.0 };
        of(lower, 1e-6) + of(upper, 1.0 - 1e-6)
    }

    fn lengths(&self, piece: Piece, sigma: f64) -> Lengths {
        self.lengths_over(EndDistances::of(piece, sigma, self.width()))
    }

    fn lengths_over(&self, radii: EndDistances) -> Lengths {
        let v = if radii.from_above { radii.from_upper } else { radii.from_lower };
        // A difference of two places with its roundings.
        let gap = |from: Endpoint, to: Endpoint| {
            let own = from.to(to);
            let more = if from.is_split() || to.is_split() { 4.0 * UNIT * own.abs() } else { 0.0 };
            if own == 0.0 { Region::real(0.0) } else { Region::new(((own - more).next_down(), (own + more).next_up()), (0.0, 0.0)) }
        };
        let (from, to, s, a) = (self.from, self.to, Endpoint::exact(self.s), Endpoint::exact(self.a));
        let lower = self.segment.ends.0;
        let place = |own: Endpoint| match own.is_split() {
            true => Region::new((own.at.next_down(), own.at.next_up()), (0.0, 0.0)),
            false => Region::real(own.at),
        };
        let (r, difference, below_edge, delta) = if radii.from_above {
            let difference = if self.is_outside() { gap(s, to) - v } else { gap(to, s) + v };
            (place(to) - v, difference, gap(to, a) + v, gap(lower, to) - v)
        } else {
            let difference = if self.is_outside() { gap(s, from) + v } else { gap(from, s) - v };
            (place(from) + v, difference, gap(from, a) - v, gap(lower, from) + v)
        };
        let delta = if radii.is_real { delta.above_zero() } else { delta };
        Lengths { r: r * self.unit, difference: difference * self.unit, below_edge: below_edge * self.unit, delta }
    }

    /// A bound on |K|·a, by that on R_F where its arguments have positive real parts.
    fn largest_kernel(&self, own: &Lengths, is_real: bool) -> f64 {
        work::spend(ENCLOSED_KERNEL);
        let one = Region::real(1.0);
        let (s, rest) = self.place_of_s;
        let edge = if is_real { own.below_edge.above_zero() } else { own.below_edge } * (one + own.r);
        let spread = own.difference * (own.r + s);
        let (root, form) = if self.is_outside() {
            let square = own.r.powi(2);
            (edge.sqrt(), Region::elliprf(square * spread, spread, square * rest * (one + s)))
        } else {
            let square = s.powi(2);
            ((rest * (one + s)).sqrt(), Region::elliprf(square * spread, spread, square * edge))
        };
        (root * form).largest()
    }

    fn largest_bend(&mut self, own: &Lengths) -> f64 {
        self.segment.largest_bend(own.delta, &mut self.slots)
    }

    /// ∫ |K| dr over a piece that begins at s, which has no unit: R_F(x, y, z) ≤ R_C(z, x) for x ≤ y, and R_C(z, x) ≤
    /// ln(4z/x)/√(2z) for 2x ≤ z.
    fn logarithm(&self, piece: Piece, own: &Lengths) -> f64 {
        let one = Region::real(1.0);
        let (s, rest) = self.place_of_s;
        let edge = own.below_edge.above_zero() * (one + own.r);
        let (root, square, z) = if self.is_outside() {
            let square = own.r.powi(2);
            (edge.sqrt(), square, square * rest * (one + s))
        } else {
            let square = s.powi(2);
            ((rest * (one + s)).sqrt(), square, square * edge)
        };
        // x = X·|r − s| with X at least this.
        let least = 1.0 / (square * (own.r + s)).recip().largest();
        let (z_least, z_most) = (1.0 / z.recip().largest(), z.largest());
        let length = piece.to / self.a * (1.0 + 4.0 * UNIT);
        let sure = 2.0 * least * length <= z_least;
        if !sure {
            return f64::INFINITY;
        }
        let mean = (4.0 * z_most / (least * length)).ln() + 1.0;
        root.largest() * mean / (2.0 * z_least).sqrt() * length * (1.0 + 1e-9)
    }
}

impl Weighted for Radii<'_> {
    fn largest_over(&mut self, radii: EndDistances) -> f64 {
        let own = self.lengths_over(radii);
        let kernel = self.largest_kernel(&own, radii.is_real);
        if !kernel.is_finite() {
            return f64::INFINITY;
        }
        let largest = self.largest_bend(&own) * kernel / self.a * (1.0 + 8.0 * UNIT);
        if largest.is_nan() { f64::INFINITY } else { largest }
    }

    fn weight_over(&mut self, radii: EndDistances) -> f64 {
        self.largest_kernel(&self.lengths_over(radii), radii.is_real) / self.a * (1.0 + 8.0 * UNIT)
    }

    fn ratio(&self, _: Region) -> Option<Region> {
        Some(Region::real(1.0))
    }

    fn add_rounding(&mut self, units: f64) {
        self.rounding += units;
    }
}

impl Range for Radii<'_> {
    fn width(&self) -> f64 {
        self.from.to(self.to)
    }

    fn size_at(&self, place: PieceNode) -> f64 {
        let (r, delta, distances) = self.distances(place);
        self.bend.plain(delta) * kernel(r, self.s, self.a, &distances).value
    }

    fn largest(&mut self, piece: Piece, sigma: f64) -> f64 {
        self.largest_over(EndDistances::of(piece, sigma, self.width()))
    }

    fn tail(&mut self, piece: Piece) -> f64 {
        let own = self.lengths(piece, 0.0);
        let at_s = if piece.from_above { self.to.at == self.s } else { self.from.at == self.s };
        let bound = if at_s {
            self.largest_bend(&own) * self.logarithm(piece, &own)
        } else if let Some(leading) = self.power.filter(|_| !piece.from_above && self.segment.ends.0.doubt == 0.0) {
            let (rest, power) = (leading.rest_over(own.delta, &mut self.slots), leading.exponent);
            // Factor by factor: lengths may be tiny.
            rest * (self.largest_kernel(&own, true) * (piece.to / self.a)) * piece.to.powf(power) / (1.0 + power)
        } else {
            f64::INFINITY
        };
        // Something may have underflowed on the way.
        if bound.is_nan() { f64::INFINITY } else { bound * (1.0 + 1e-9) + f64::MIN_POSITIVE }
    }

    fn fill(&self, places: &[PieceNode], values: &mut [f64], errors: &mut [f64], scratch: &mut Scratch) {
        let (mut deltas, mut doubts, mut kernels) = ([0.0; MOST_NODES], [0.0; MOST_NODES], [Bounded::exact(0.0); MOST_NODES]);
        let (count, end) = (places.len(), self.segment.ends.0.doubt);
        work::spend(KERNEL * count as u64);
        for (((place, delta), doubt), weight) in places.iter().zip(&mut deltas).zip(&mut doubts).zip(&mut kernels) {
            let (r, own, distances) = self.distances(*place);
            *delta = own;
            *doubt = (8.0 + self.rounding) * UNIT * own + if own > 2.0 * end { end } else { 0.0 };
            // Next to the axis, |r ∂K/∂r| ≤ K.
            let own = kernel(r, self.s, self.a, &distances);
            *weight = Bounded { error: own.error + self.rounding * UNIT * own.value.abs(), ..own };
        }
        self.bend.block(&deltas[..count], &doubts[..count], values, errors, scratch);
        for ((value, error), weight) in values.iter_mut().zip(errors).zip(kernels) {
            let found = Bounded { value: *value, error: *error } * weight;
            (*value, *error) = (found.value, found.error);
        }
    }
}
