//! f′ at the nodes of a quadrature over the angle t, r = x sin t.

use crate::integrate::integral::{MOST_POINTS, NumericSegment, with_ulps};
use crate::integrate::source::f_prime::Scratch;
use crate::num::Bounded;
use crate::num::quadrature::growth_below_normal;

/// Up to [`MOST_POINTS`] nodes of one segment.
pub(crate) struct Nodes {
    /// r − lower, and bounds on its error.
    pub(crate) distances: [f64; MOST_POINTS],
    pub(crate) doubts: [f64; MOST_POINTS],
    pub(crate) slopes: [Bounded; MOST_POINTS],
}

impl NumericSegment {
    /// Returns f′ at nodes beyond the radius `from`. Each angle is given twice: measured from the angle of `from`, and as the
    /// remainder to π/2.
    pub(crate) fn f_prime_over_angle(
        &self,
        from: f64,
        x: f64,
        angles: impl ExactSizeIterator<Item = (f64, f64)>,
        scratch: &mut Scratch,
    ) -> Nodes {
        let count = angles.len().min(MOST_POINTS);
        let (mut distances, mut doubts) = ([0.0; MOST_POINTS], [0.0; MOST_POINTS]);
        let (mut normal, mut growths) = ([0.0; MOST_POINTS], [0.0; MOST_POINTS]);
        let (mut values, mut errors) = ([0.0; MOST_POINTS], [0.0; MOST_POINTS]);
        let first = (from - self.lower.value) / x;
        let places = distances.iter_mut().zip(&mut doubts).zip(&mut normal).zip(&mut growths);
        for ((((distance, doubt), normal), growth), (v, rest)) in places.zip(angles) {
            // r − from = 2x sin(v/2) sin(π/2 − t_from − v/2): every factor is positive.
            let share = first + 2.0 * (0.5 * v).sin() * (rest + 0.5 * v).sin();
            if self.varies_next_to_lower() {
                *growth = growth_below_normal(x, share);
            }
            *distance = x * share;
            // Below the smallest normal number f′ has too few digits.
            *normal = distance.max(f64::MIN_POSITIVE);
            // The error of the lower end itself; next to that end `smear` bounds its effect.
            let own = if *normal > 2.0 * self.lower.error { self.lower.error } else { 0.0 };
            *doubt = with_ulps(*normal, 12.0).error + own;
        }
        self.f_prime.block(&normal[..count], &doubts[..count], &mut values[..count], &mut errors[..count], scratch);
        let mut slopes = [Bounded::exact(0.0); MOST_POINTS];
        for (((f_prime, value), error), growth) in slopes.iter_mut().zip(values).zip(errors).zip(growths) {
            *f_prime = Bounded { value, error: error + growth * value.abs() };
        }
        Nodes { distances, doubts, slopes }
    }

    /// Returns true if f′ may change by more than rounding within the smallest normal number of the lower end.
    pub(crate) fn varies_next_to_lower(&self) -> bool {
        self.singular || self.lower.value == 0.0
    }
}
