//! The pressure as the integral of g′ over u, x = s cosh u, g′ itself by nested rules: no elliptic kernel.

use super::integral::{NumericProfile, NumericSegment, Weight, stricter};
use super::slope_source::Numbers;
use crate::num::Estimate;
use crate::num::bounded::UNIT;
use crate::num::quadrature::{EvenIntegrand, Mean, Middles, Nodes, mean};

/// Most values of g′ before the single integral is taken instead.
const MOST: u64 = 80;
/// The share of the tolerance that every g′ gets.
const INNER: f64 = 0.3;

impl NumericProfile {
    /// ∫_s^a g′(x)/√(x²−s²) dx = ∫₀^U g′(s cosh u) du, cosh U = a/s, where one segment without a kink reaches from the axis to
    /// a; `None` where it does not, or where the rules do not meet the tolerance.
    pub(super) fn pressure_by_slopes(&self, s: f64, a: f64, tolerance: f64) -> Option<Estimate> {
        let [segment] = self.segments.as_slice() else { return None };
        let whole = segment.lower.value == 0.0 && segment.upper.is_none_or(|upper| upper.value - upper.error >= a);
        if !whole || segment.singular || s <= 0.0 || s >= a {
            return None;
        }
        let bend = segment.bend().ok()?;
        let reach = (((a - s) * (a + s)).sqrt() / s).asinh();
        let mut slopes = Slopes { segment, bend, s, a, reach, tolerance, largest: 0.0, evaluations: 0 };
        let accepted = |value: f64| 0.95 * tolerance * value.abs();
        let Mean { value, left_out, noise, reached, .. } = mean(&mut slopes, MOST, accepted).ok()?;
        let (value, left_out, noise) = (reach * value, reach * left_out, reach * noise);
        // No more is promised than was asked for where the rules leave out more than rounding noise.
        let least = if left_out > noise { 0.97 * tolerance * value.abs() } else { 0.0 };
        let error = least.max(left_out + noise) + 8.0 * UNIT * value.abs();
        reached.then_some(Estimate::estimated(value, error, slopes.evaluations))
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
    /// The largest |g′| so far: next to a zero of g′ its own size is no measure.
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
            let found = self.segment.nested(self.bend, x, Weight::Slope, (tolerance, stricter(tolerance)), self.largest);
            // Where there is no value the rules above give up.
            let found = found.ok().flatten().unwrap_or(Estimate::estimated(f64::NAN, f64::NAN, 0));
            (*value, *error) = (found.value, found.error);
            self.largest = if found.value.abs() > self.largest { found.value.abs() } else { self.largest };
            self.evaluations += found.evaluations;
        }
    }

    fn displacement(&self, middles: Middles<'_>, values: &[f64]) -> f64 {
        // x is right to a few roundings, those of u among them; dx/x = tanh u du, and coth u ≤ 1 + 1/u.
        let roundings = (4.0 + 2.0 * self.reach) * UNIT;
        let steps = values.iter().zip(values.get(1..).unwrap_or_default()).zip(middles.reciprocals);
        steps.map(|((a, b), over)| (b - a).abs() * (1.0 + over / self.reach)).sum::<f64>() * roundings / self.reach
    }
}
