//! The pressure by one integral over f′ and f″, with its logarithmic singularity and its kinks.

use crate::integrate::admit::finite_and_not_negative;
use crate::integrate::ask::{ELLIPTIC, LEGENDRE, LEGENDRE_SAMPLED, OVER_U, OVER_U_SAMPLED, PIECES, STRAIGHT, not_this_way};
use crate::integrate::error::TransformError;
use crate::integrate::integral::{MOST_POINTS, NumericProfile, NumericSegment, reached, settled, with_ulps};
use crate::integrate::numbers::sum_to;
use crate::integrate::source::endpoint::Endpoint;
use crate::integrate::source::f_prime::{Numbers, Scratch};
use crate::num::quadrature::{Options, Panel, Point, integrate_blocks};
use crate::num::{Bounded, Estimate, special, work};

impl NumericProfile {
    /// ∫_s^a g′(x)/√(x²−s²) dx, which is p(s)·π/E* under a smooth edge: kink by kink if f is straight between them, by the terms of f′
    /// or by values of g′ if one smooth piece reaches up to a, else by [`Self::pressure_by_elliptic_kernel`].
    ///
    /// `None` if the value is theoretically infinite: at a kink, and at the axis under a tip with f′(0) ≠ 0.
    ///
    /// # Errors
    /// [`TransformError`] if (r f′)′ is not finite below a, or no digit is reliable.
    pub fn pressure(&self, s: f64, a: f64, tolerance: f64) -> Result<Option<Estimate>, TransformError> {
        finite_and_not_negative("r", s)?;
        finite_and_not_negative("a", a)?;
        let way = |key: &'static str| self.pressure_of_smooth(key, s, a, tolerance);
        let proven = way(STRAIGHT).or_else(|| way(LEGENDRE)).or_else(|| self.proven_pressure(s, a, tolerance));
        match proven.or_else(|| way(LEGENDRE_SAMPLED)).or_else(|| way(OVER_U_SAMPLED)) {
            Some(found) => Ok(Some(found)),
            None => self.pressure_by_elliptic_kernel(s, a, tolerance),
        }
    }

    /// The same, only by the way with the given key.
    ///
    /// # Errors
    /// As [`Self::pressure`], and [`TransformError::NotThisWay`] if the way does not apply.
    pub(crate) fn pressure_in_the_way(
        &self,
        key: &'static str,
        s: f64,
        a: f64,
        tolerance: f64,
    ) -> Result<Option<Estimate>, TransformError> {
        match key {
            ELLIPTIC => self.pressure_by_elliptic_kernel(s, a, tolerance),
            _ => self.pressure_of_smooth(key, s, a, tolerance).map(Some).ok_or(not_this_way(key)),
        }
    }

    /// By one of the ways for integrals without kinks, or split at them; `None` if the way does not apply.
    fn pressure_of_smooth(&self, key: &'static str, s: f64, a: f64, tolerance: f64) -> Option<Estimate> {
        let found = match key {
            STRAIGHT => self.pressure_of_straight_pieces(s, a),
            LEGENDRE => self.pressure_by_proven_series(s, a, tolerance),
            OVER_U => self.pressure_by_proven_slopes(s, a, tolerance),
            PIECES if s == 0.0 => self.pressure_on_axis(a, tolerance),
            PIECES => self.pressure_by_pieces(s, a, tolerance),
            LEGENDRE_SAMPLED => self.pressure_by_series(s, a, tolerance),
            OVER_U_SAMPLED => self.pressure_by_slopes(s, a, tolerance),
            _ => None,
        };
        found.map(|own| own.by(key))
    }

    /// By values of g′ or by pieces; the more accurate result if neither meets the tolerance.
    fn proven_pressure(&self, s: f64, a: f64, tolerance: f64) -> Option<Estimate> {
        let enough = |own: &Estimate| own.error <= tolerance * own.value.abs();
        let slopes = self.pressure_of_smooth(OVER_U, s, a, tolerance);
        if slopes.as_ref().is_some_and(enough) {
            return slopes;
        }
        match (slopes, self.pressure_of_smooth(PIECES, s, a, tolerance)) {
            (Some(one), Some(other)) => Some(if one.is_better_than(other) { one } else { other }),
            (one, other) => one.or(other),
        }
    }

    /// The same as one integral, ∫₀^a (r f′)′ K(r, s) dr + Σ b δ K(b, s), δ the jump of f′ at b; K by Carlson's R_F.
    ///
    /// `None` if the value is theoretically infinite: at a kink, and at the axis under a tip with f′(0) ≠ 0.
    ///
    /// # Errors
    /// [`TransformError`] if (r f′)′ is not finite below a, or no digit is reliable.
    pub fn pressure_by_elliptic_kernel(&self, s: f64, a: f64, tolerance: f64) -> Result<Option<Estimate>, TransformError> {
        finite_and_not_negative("r", s)?;
        finite_and_not_negative("a", a)?;
        let Some(total) = self.pressure_of_jumps(s, a) else { return Ok(None) };
        if s == 0.0 && self.starts_steeply(a) {
            return Ok(None);
        }
        let mut size = 0.0;
        let found = sum_to(tolerance, |tolerance| {
            size = total.value.abs();
            let mut sum = Estimate::from_bounded(total, 0);
            for segment in &self.segments {
                for part in segment.pressure(s, a, tolerance)? {
                    size += part.value.abs();
                    sum = sum + part;
                }
            }
            Ok(sum)
        })?;
        settled(found.by(ELLIPTIC), a, || size).map(Some)
    }

    /// Σ b δ K(b, s) over the jumps δ of f′; `None` at one of them.
    pub(crate) fn pressure_of_jumps(&self, s: f64, a: f64) -> Option<Bounded> {
        let mut total = Bounded::exact(0.0);
        for Jump { at, end, height } in self.jumps(a) {
            if height.value == 0.0 && (height.error == 0.0 || at.value == s) {
                continue;
            }
            if at.value == s {
                return None;
            }
            total = total + at * height * kernel_at(end, s, a);
        }
        Some(total)
    }

    /// The jumps of f′ below a, at the ends of segments; jumps smaller than their error are dropped.
    pub(crate) fn jumps(&self, a: f64) -> Vec<Jump> {
        let mut jumps: Vec<Jump> = Vec::new();
        let mut add = |at: Bounded, end: Endpoint, height: Bounded| match jumps.iter_mut().find(|own| own.at.value == at.value) {
            Some(own) => own.height = own.height + height,
            None => jumps.push(Jump { at, end, height }),
        };
        let is_below = |end: &Endpoint| end.to(Endpoint::exact(a)) > 0.0;
        for segment in &self.segments {
            if segment.lower.value > 0.0 && is_below(&segment.ends.0) {
                add(segment.lower, segment.ends.0, segment.f_prime_at(0.0));
            }
            if let (Some(upper), Some(end)) = (segment.upper, segment.ends.1.filter(is_below)) {
                add(upper, end, -segment.f_prime_at(upper.value - segment.lower.value));
            }
        }
        for Jump { height, .. } in &mut jumps {
            if height.value.abs() <= height.error {
                height.value = 0.0;
            }
        }
        jumps
    }

    /// Returns true if f′ does not vanish at the axis, so that the pressure is infinite there; a is the contact radius.
    pub(crate) fn starts_steeply(&self, a: f64) -> bool {
        let Some(first) = self.segments.iter().find(|segment| segment.lower.value == 0.0) else { return false };
        let r = (1e-12 * a).max(1e3 * f64::MIN_POSITIVE);
        let (near, nearer) = (first.f_prime_at(r), first.f_prime_at(1e-3 * r));
        // f′ ~ r^m with m > 0 decreases by 10^(3m); a slower decrease, or rounding noise, counts as steep.
        nearer.value.abs() > nearer.error && nearer.value.abs() > 0.99 * near.value.abs()
    }
}

/// A jump of f′.
#[derive(Clone, Copy)]
pub(crate) struct Jump {
    pub(crate) at: Bounded,
    pub(crate) end: Endpoint,
    pub(crate) height: Bounded,
}

/// If a − s is below this fraction of the radius, it is treated as a separate length scale.
const NARROW: f64 = 1e-5;

impl NumericSegment {
    pub(crate) fn f_prime_at(&self, delta: f64) -> Bounded {
        self.f_prime.at(Bounded::exact(delta), &mut Vec::new())
    }

    /// ∫ (r f′)′ K(r, s) dr over the interval below a, split at s.
    ///
    /// A part may have no reliable digit, as near the axis; only the error of the sum is checked.
    fn pressure(&self, s: f64, a: f64, tolerance: f64) -> Result<Vec<Estimate>, TransformError> {
        let (lower, place, edge) = (self.ends.0, Endpoint::exact(s), Endpoint::exact(a));
        let end = self.ends.1.filter(|own| own.to(edge) > 0.0).unwrap_or(edge);
        let mut parts = Vec::new();
        if lower.to(end) <= 0.0 {
            return Ok(parts);
        }
        let bend = self.bend()?;
        let mut places = vec![lower];
        if s > lower.at && s < end.at {
            places.push(place);
        }
        places.push(end);
        if s > lower.at && s < end.at && a - s < NARROW * (s - lower.at) {
            // Near the edge the kernel is a root down to the distance a − s and a logarithm below, too narrow for distant nodes.
            let mut step = 4.0 * (a - s);
            while step < 0.25 * (s - lower.at) {
                places.push(Endpoint::exact(s - step));
                step *= 1e3;
            }
            places.sort_by(|one, other| one.at.total_cmp(&other.at));
            places.dedup_by_key(|own| own.at);
        }
        for pair in places.windows(2) {
            let [from, to] = pair else { continue };
            parts.push(self.pressure_between(bend, *from, *to, s, a, tolerance)?);
        }
        Ok(parts)
    }

    fn pressure_between(
        &self,
        bend: &Numbers,
        from: Endpoint,
        to: Endpoint,
        s: f64,
        a: f64,
        tolerance: f64,
    ) -> Result<Estimate, TransformError> {
        let (lower, place, edge) = (self.ends.0, Endpoint::exact(s), Endpoint::exact(a));
        let falling = self.falling_bend().filter(|_| self.ends.1.is_some_and(|upper| upper.at == to.at));
        let mut scratch = Scratch::take();
        let mut integrand = |points: &[Point], heights: &mut [Bounded]| {
            let (mut deltas, mut doubts, mut values, mut errors) =
                ([0.0; MOST_POINTS], [0.0; MOST_POINTS], [0.0; MOST_POINTS], [0.0; MOST_POINTS]);
            let count = points.len().min(MOST_POINTS);
            work::spend(KERNEL * count as u64);
            for ((point, delta), doubt) in points.iter().zip(&mut deltas).zip(&mut doubts) {
                // Every distance is a sum of terms of the same sign.
                *delta = (lower.to(from) + point.from_lower).max(f64::MIN_POSITIVE);
                *doubt = with_ulps(*delta, 8.0).error + if *delta > 2.0 * lower.doubt { lower.doubt } else { 0.0 };
            }
            bend.block(&deltas[..count], &doubts[..count], &mut values[..count], &mut errors[..count], &mut scratch);
            if let Some(falling) = falling {
                // Near the upper end, only the distance to it is accurate.
                let mut slots = Vec::new();
                let near = points.iter().zip(values.iter_mut().zip(&mut errors)).filter(|(point, _)| point.from_upper < point.from_lower);
                for (point, (value, error)) in near {
                    let own = falling.at(with_ulps(point.from_upper.max(f64::MIN_POSITIVE), 8.0), &mut slots);
                    (*value, *error) = (own.value, own.error);
                }
            }
            for (((point, height), value), error) in points.iter().zip(heights).zip(values).zip(errors) {
                let (up, down) = (point.from_lower, point.from_upper);
                let difference = if s <= from.at { place.to(from) + up } else { to.to(place) + down };
                let below_edge = to.to(edge) + down;
                let r = if up < down { from.at + up } else { to.at - down };
                let distances = Distances { difference, below_edge, is_beyond: s <= from.at };
                *height = Bounded { value, error } * kernel(r, s, a, &distances);
            }
        };
        let options = Options { rel_tol: tolerance, charge_x: false, ..Options::default() };
        let result = integrate_blocks(&mut integrand, &[Panel::singular(0.0, from.to(to))], &options);
        reached(result, a)
    }
}

/// |r − s| and a − r, without cancellation, and whether r > s, which rounded radii do not tell.
pub(crate) struct Distances {
    pub(crate) difference: f64,
    pub(crate) below_edge: f64,
    pub(crate) is_beyond: bool,
}

/// K(b, s); the error of a b without 30 digits affects the logarithm near the kink, and the root near the edge.
///
/// |∂K/∂b| ≤ 1/(|b−s|(b+s)) + K/b + K/(a−b): with u² = x² − M², K is an integral over u whose integrand and end depend on b.
pub(crate) fn kernel_at(b: Endpoint, s: f64, a: f64) -> Bounded {
    let from_s = Endpoint::exact(s).to(b);
    let distances = Distances { difference: from_s.abs(), below_edge: b.to(Endpoint::exact(a)), is_beyond: from_s > 0.0 };
    let kernel = kernel(b.at, s, a, &distances);
    if b.doubt == 0.0 {
        return kernel;
    }
    // The smallest distances while b varies by its error.
    let (gap, rest, sum) = (distances.difference - b.doubt, distances.below_edge - b.doubt, (b.at - b.doubt) + s);
    if gap.min(rest).min(sum) <= 0.0 {
        return Bounded { error: f64::INFINITY, ..kernel };
    }
    let size = kernel.value.abs() + kernel.error;
    // Ratios of lengths first: products of tiny ones underflow.
    let moved = (b.doubt / gap / sum + size * (b.doubt / b.at) + size * (b.doubt / rest)) * (1.0 + 16.0 * f64::EPSILON);
    Bounded { value: kernel.value, error: kernel.error + moved }
}

/// Steps of a kernel.
pub(crate) const KERNEL: u64 = 18;

/// K(r, s) = ∫_M^a dx/√((x²−r²)(x²−s²)), M = max(r, s), m = min(r, s), D = M² − m².
///
/// It is √((a−M)(a+M)) R_F(M²D, a²D, M²(a−m)(a+m)); in units of a, and with 1/M taken out of R_F, nothing underflows.
pub(crate) fn kernel(r: f64, s: f64, a: f64, distances: &Distances) -> Bounded {
    let (big, small) = if distances.is_beyond { (r / a, s / a) } else { (s / a, r / a) };
    let (edge, rest) = if distances.is_beyond { (distances.below_edge, a - s) } else { (a - s, distances.below_edge) };
    let (edge, rest, gap) = (edge / a, rest / a, distances.difference / a);
    // D/M² = (M − m)/M · (1 + m/M).
    let spread = gap / big * (1.0 + small / big);
    let value = (edge * (1.0 + big)).sqrt() / big * special::rf(big * gap * (1.0 + small / big), spread, rest * (1.0 + small));
    with_ulps(value / a, 64.0)
}
