//! The pressure as the integral of g′ over u, x = s cosh u, with g′ by nested rules, which avoids the elliptic kernel.

use crate::integrate::error::TransformError;
use crate::integrate::integral::{NumericProfile, NumericSegment, Weight, stricter};
use crate::integrate::source::f_prime::Numbers;
use crate::num::bounded::UNIT;
use crate::num::quadrature::{EvenIntegrand, Known, Mean, Middles, Nodes, mean};
use crate::num::stable::leg;
use crate::num::{Estimate, Region};
use std::f64::consts::FRAC_PI_2;

/// Most values of g′ before the single integral is used instead.
const MOST_VALUES: u64 = 80;
/// The fraction of the tolerance for each value of g′.
const INNER: f64 = 0.3;

impl NumericProfile {
    /// ∫_s^a g′(x)/√(x²−s²) dx = ∫₀^U g′(s cosh u) du, cosh U = a/s, if one segment without a kink reaches from the axis to
    /// a; `None` if it does not, or if the rules do not meet the tolerance.
    pub(crate) fn pressure_by_slopes(&self, s: f64, a: f64, tolerance: f64) -> Option<Estimate> {
        let [segment] = self.segments.as_slice() else { return None };
        let whole = segment.lower.value == 0.0 && segment.upper.is_none_or(|upper| upper.value - upper.error >= a);
        if !whole || segment.singular || s <= 0.0 || s >= a {
            return None;
        }
        let bend = segment.bend().ok()?;
        let reach = (leg(a, s) / s).asinh();
        let mut slopes = Slopes { segment, bend, s, a, reach, tolerance, largest: 0.0, evaluations: 0 };
        let accepted = |value: f64| 0.95 * tolerance * value.abs();
        let Mean { value, left_out, noise, reached, .. } = mean(&mut slopes, MOST_VALUES, accepted).ok()?;
        let (value, left_out, noise) = (reach * value, reach * left_out, reach * noise);
        // If the truncation error exceeds the rounding noise, report at least the requested tolerance as the error.
        let least = if left_out > noise { 0.97 * tolerance * value.abs() } else { 0.0 };
        let error = least.max(left_out + noise) + 8.0 * UNIT * value.abs();
        reached.then_some(Estimate::estimated(value, error, slopes.evaluations))
    }
}

impl NumericProfile {
    /// The same with a proven bound, if the enclosure of (r f′)′ around the contact proves that certain rules suffice for g′ and
    /// for its integral; `None` otherwise.
    pub(crate) fn pressure_by_proven_slopes(&self, s: f64, a: f64, tolerance: f64) -> Option<Estimate> {
        /// The largest u: a/s = 10¹³.
        const FARTHEST: f64 = 30.0;
        /// A fraction of the mean below the rounding error.
        const NOTHING: f64 = 0.25 * f64::EPSILON;
        /// Half-widths of the ellipses.
        const SIGMAS: [f64; 6] = [1.6, 1.1, 0.75, 0.5, 0.32, 0.2];
        let [segment] = self.segments.as_slice() else { return None };
        if !(s > 0.0 && s < a) {
            return None;
        }
        let bend = segment.bend().ok()?;
        let f_prime_at = segment.bend_rule(bend, a)?;
        let reach = (leg(a, s) / s).asinh();
        // The number of rounding errors of x grows like u.
        if reach > FARTHEST {
            return None;
        }
        let size = f_prime_at(a).ok()?.value.abs().max(f_prime_at(s).ok()?.value.abs());
        let (mut best, mut slots): (Option<(Known, f64)>, Vec<Region>) = (None, Vec::new());
        for sigma in SIGMAS {
            // r lies between 0 and x = s cosh u, with u in one half of the ellipse, which suffices by symmetry.
            let (wide, high) = (reach * sigma.cosh() * (1.0 + 1e-9), reach * sigma.sinh() * (1.0 + 1e-9));
            let x = Region::real(s) * Region::new((0.0, wide), (-high, high)).cosh();
            let largest = segment.largest_bend(x.with_zero(), &mut slots) * FRAC_PI_2;
            if !largest.is_finite() {
                continue;
            }
            let Some(known) = Known::fewest(sigma, largest, NOTHING * size) else { break };
            if best.is_some_and(|(own, _)| own.rule <= known.rule) {
                break;
            }
            // The rounding of a node, relative to u, changes the value by the derivative, which Cauchy's formula bounds.
            best = Some((known, largest / (sigma.cosh() - 1.0)));
        }
        let (known, steepness) = best?;
        let mut slopes = ProvenSlopes { f_prime_at: &f_prime_at, s, a, reach, evaluations: 0 };
        let Mean { value, noise, .. } = known.mean(&mut slopes).ok()?;
        let rounding = (8.0 + 4.0 / reach) * UNIT * steepness;
        let (value, left_out, noise) = (reach * value, reach * known.left_out, reach * (noise + rounding));
        let error = (left_out + noise + 8.0 * UNIT * value.abs()) * (1.0 + 8.0 * UNIT);
        let enough = error <= tolerance * value.abs() || left_out <= 0.1 * error;
        enough.then_some(Estimate { error, evaluations: slopes.evaluations, ..Estimate::exact(value) })
    }
}

/// g′(s cosh u) by one rule.
struct ProvenSlopes<'a, F> {
    f_prime_at: &'a F,
    s: f64,
    a: f64,
    reach: f64,
    evaluations: u64,
}

impl<F: Fn(f64) -> Result<Estimate, TransformError>> EvenIntegrand for ProvenSlopes<'_, F> {
    const BOUNDED: bool = true;
    const BLOCK: usize = 8;
    const TOGETHER: bool = false;

    fn fill(&mut self, nodes: Nodes<'_>, values: &mut [f64], errors: &mut [f64]) {
        for ((value, error), z) in values.iter_mut().zip(errors).zip(nodes.z) {
            let x = (self.s * (self.reach * z).cosh()).min(self.a);
            let found = (self.f_prime_at)(x).unwrap_or(Estimate::estimated(f64::NAN, f64::NAN, 0));
            (*value, *error) = (found.value, found.error);
            self.evaluations += found.evaluations;
        }
    }

    fn displacement(&self, _middles: Middles<'_>, _values: &[f64]) -> f64 {
        // The bound applies to all nodes together.
        0.0
    }
}

/// g′(s cosh u) = ∫₀^{π/2} (r f′)′ dt, even in u.
struct Slopes<'a> {
    segment: &'a NumericSegment,
    bend: &'a Numbers,
    s: f64,
    a: f64,
    reach: f64,
    tolerance: f64,
    /// The largest |g′| so far, used as the scale of errors because g′ may vanish.
    largest: f64,
    evaluations: u64,
}

impl EvenIntegrand for Slopes<'_> {
    const BOUNDED: bool = true;
    const BLOCK: usize = 8;
    const TOGETHER: bool = false;

    fn fill(&mut self, nodes: Nodes<'_>, values: &mut [f64], errors: &mut [f64]) {
        for ((value, error), z) in values.iter_mut().zip(errors).zip(nodes.z) {
            let x = (self.s * (self.reach * z).cosh()).min(self.a);
            let tolerance = INNER * self.tolerance;
            let found = self.segment.nested(self.bend, x, Weight::Equivalent, (tolerance, stricter(tolerance)), self.largest);
            // NaN makes the outer rules give up.
            let found = found.ok().flatten().unwrap_or(Estimate::estimated(f64::NAN, f64::NAN, 0));
            (*value, *error) = (found.value, found.error);
            self.largest = if found.value.abs() > self.largest { found.value.abs() } else { self.largest };
            self.evaluations += found.evaluations;
        }
    }

    fn displacement(&self, middles: Middles<'_>, values: &[f64]) -> f64 {
        // x has a few rounding errors, including those of u; dx/x = tanh u du, and coth u ≤ 1 + 1/u.
        let roundings = (4.0 + 2.0 * self.reach) * UNIT;
        let steps = values.iter().zip(values.get(1..).unwrap_or_default()).zip(middles.reciprocals);
        steps.map(|((a, b), over)| (b - a).abs() * (1.0 + over / self.reach)).sum::<f64>() * roundings / self.reach
    }
}
