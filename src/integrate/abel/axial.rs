//! The stress on the axis below the surface, as one integral straight from f′ whose weight is positive.

use crate::integrate::admit::finite_and_not_negative;
use crate::integrate::ask::BISECTION;
use crate::integrate::error::TransformError;
use crate::integrate::integral::{NumericProfile, NumericSegment, magnitude, settle};
use crate::integrate::numbers::sum_to;
use crate::integrate::source::f_prime::Scratch;
use crate::num::quadrature::{Options, Panel, Point, integrate_blocks};
use crate::num::stable::leg;
use crate::num::{Bounded, Estimate, forms};

impl NumericProfile {
    /// ∫₀^a g′(x) x(x²+3z²)/(x²+z²)² dx, which is −σ_zz(z)·π/E* at the depth z ≥ 0 on the axis under a smooth edge; at z = 0 it
    /// is p(0)·π/E*, for a profile whose slope vanishes at the axis like a power of r.
    ///
    /// With g′ by (r f′)′ the inner integral is
    /// K(r) = ∫_r^a W(x)/√(x²−r²) dx = (1/Q)(1 + z²/Q²) arctan(w/Q) + z² w/(Q² H), Q² = r² + z², w² = a² − r², H = a² + z²;
    /// by parts −r K′ stands with f′, a sum of positive terms, so that nothing cancels at any z, and kinks need no care.
    ///
    /// # Errors
    /// [`TransformError`] if f′ is not finite below a, or no digits can be promised.
    pub fn axial(&self, z: f64, a: f64, tolerance: f64) -> Result<Estimate, TransformError> {
        finite_and_not_negative("z", z)?;
        finite_and_not_negative("a", a)?;
        let total = sum_to(tolerance, |tolerance| {
            let mut parts = self.segments.iter().map(|segment| segment.axial(z, a, tolerance));
            parts.try_fold(Estimate::exact(0.0), |sum, part| Ok(sum + part?))
        })?;
        Ok(total.by(BISECTION))
    }
}

/// √(a² − r²)·(−r K′(r)) in units in which the larger of a and z is 1; r = a sin t with the cosine given apart.
fn weight(r: f64, cosine: f64, z: f64, a: f64) -> f64 {
    let scale = a.max(z);
    let (r, w, z, a) = (r / scale, a / scale * cosine, z / scale, a / scale);
    // The hypotenuse does not underflow where the squares would.
    let q = r.hypot(z);
    let (share, below, reach) = ((r / q) * (r / q), (z / q) * (z / q), w / q);
    // r²[(1 + wA/Q)/Q² + z²(1 + 3wA/Q)/Q⁴ + z²(1 + 2w²/Q²)/(Q² H)], A = arctan(w/Q).
    let angle = reach * reach.atan();
    share * (1.0 + angle + below * (1.0 + 3.0 * angle) + z * z / (a * a + z * z) * (1.0 + 2.0 * reach * reach))
}

impl NumericSegment {
    fn axial(&self, z: f64, a: f64, tolerance: f64) -> Result<Estimate, TransformError> {
        let lower = self.lower.value;
        let end = self.upper.map_or(a, |upper| upper.value.min(a));
        let zero = Estimate::exact(0.0);
        let heaviest = |r: f64| weight(r, leg(a, r.min(a)) / a, z, a);
        let smear = self.smear(a);
        let smear = if smear > 0.0 { smear * heaviest(lower.min(a)).max(heaviest(end)) } else { 0.0 };
        if lower >= end {
            return Ok(Estimate { error: smear, ..zero });
        }
        // The weight turns from r² to a constant about r = z: both sides are smooth in their own scale.
        let mut places = vec![lower];
        let mut at = z;
        while at > 0.0 && at < end {
            if at > lower {
                places.push(at);
            }
            at *= WIDER;
        }
        places.push(end);
        places.extend(self.features(a, tolerance).iter().map(|delta| lower + delta).filter(|place| *place > lower && *place < end));
        places.sort_by(f64::total_cmp);
        places.dedup();
        let mut total = Estimate { error: smear, ..zero };
        for pair in places.windows(2) {
            let [from, to] = pair else { continue };
            total = total + self.axial_between(*from, *to, z, a, tolerance)?;
        }
        Ok(total)
    }

    fn axial_between(&self, from: f64, to: f64, z: f64, a: f64, tolerance: f64) -> Result<Estimate, TransformError> {
        let lower = self.lower.value;
        let width = forms::angle_between(from, if to < a { to } else { f64::INFINITY }, a);
        let beyond = if to < a { leg(a, to).atan2(to) } else { 0.0 };
        let mut scratch = Scratch::take();
        let mut integrand = |points: &[Point], heights: &mut [Bounded]| {
            let angle = |point: &Point| (point.from_lower, beyond + point.from_upper);
            let nodes = self.f_prime_over_angle(from, a, points.iter().map(angle), &mut scratch);
            for (((height, point), f_prime), distance) in heights.iter_mut().zip(points).zip(nodes.slopes).zip(nodes.distances) {
                let factor = weight(lower + distance, angle(point).1.sin(), z, a);
                *height = f_prime * Bounded { value: factor, error: 64.0 * f64::EPSILON * factor + f64::MIN_POSITIVE };
            }
        };
        let panel = if self.singular && from == lower { Panel::singular(0.0, width) } else { Panel::smooth(0.0, width) };
        let options = Options { rel_tol: tolerance, charge_x: false, ..Options::default() };
        let result = integrate_blocks(&mut integrand, &[panel], &options);
        let inner = |v: f64| {
            let mut found = [Bounded::exact(0.0)];
            integrand(&[Point { x: v, from_lower: v, from_upper: width - v }], &mut found);
            found[0].value
        };
        let mut found = settle(result, a, || magnitude(width, inner))?;
        found.error += 8.0 * f64::EPSILON * found.value.abs();
        Ok(found)
    }
}

/// The ratio of the radii between which the weight is smooth in its own scale.
const WIDER: f64 = 8.0;
