//! f as the integral of f′, for profiles given by f′ alone and for checks of formulas.

use crate::integrate::admit::finite_and_not_negative;
use crate::integrate::ask::BISECTION;
use crate::integrate::error::TransformError;
use crate::integrate::integral::{GRADES, NumericProfile, NumericSegment, magnitude, settle};
use crate::num::bounded::UNIT;
use crate::num::quadrature::{Options, Panel, Point, integrate};
use crate::num::{Bounded, Estimate};

/// Towards the end of f′ the range is cut where the distance to it has grown by this factor: a pole there is as narrow as that
/// distance.
const FACTOR: f64 = 8.0;

impl NumericProfile {
    /// f(r) − f(0) = ∫₀^r f′ dr.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    pub fn height(&self, r: f64, tolerance: f64) -> Result<Estimate, TransformError> {
        finite_and_not_negative("r", r)?;
        let mut total = Estimate::exact(0.0);
        for segment in &self.segments {
            let length = segment.upper.map_or(r, |u| u.value.min(r)) - segment.lower.value;
            if length > 0.0 {
                total = total + segment.rise(length, r, tolerance)?;
            }
        }
        Ok(total.by(BISECTION))
    }
}

impl NumericSegment {
    /// The increase of f from the lower end of the segment over a length.
    fn rise(&self, length: f64, r: f64, tolerance: f64) -> Result<Estimate, TransformError> {
        let mut slots = Vec::new();
        let cuts = self.cuts(length);
        let first = cuts.first().copied().unwrap_or(length);
        let mut integrand = |point: Point| {
            // Points count from the ends of their panels: the distance from the lower end has its digits on the first one.
            let delta = if point.x < first { point.bounded_from_lower() } else { Bounded { value: point.x, error: 4.0 * UNIT * point.x } };
            self.f_prime.at(delta, &mut slots)
        };
        let mut panels = Panel::chain(cuts.iter().copied().chain([length]));
        if let (true, Some(panel)) = (self.singular, panels.first_mut()) {
            *panel = Panel::singular(0.0, first);
        }
        let options = Options { rel_tol: tolerance, charge_x: false, ..Options::default() };
        let result = integrate(&mut integrand, &panels, &options);
        let inner = |v: f64| integrand(Point { x: v, from_lower: v, from_upper: length - v }).value;
        let found = settle(result, r, || magnitude(length, inner))?;
        // f may begin or end anywhere within the error of a breakpoint.
        let moved = |end: Bounded, at: f64| if end.error > 0.0 { 4.0 * end.error * self.f_prime_at(at).value.abs() } else { 0.0 };
        let ends = self.upper.filter(|u| u.value < r).map_or(0.0, |upper| moved(upper, length));
        let smear = moved(self.lower, self.lower.error) + ends;
        // What every value may lose below the smallest number.
        let lost = f64::from_bits(found.evaluations);
        Ok(Estimate { error: found.error + smear + lost, ..found })
    }

    /// Where the range is cut before any bisection, rising: what is narrow at an end shows at no node of a rule over the whole
    /// range.
    fn cuts(&self, length: f64) -> Vec<f64> {
        let from_lower = if self.singular || !length.is_normal() { &[] } else { GRADES };
        // Every second one: the first node of a part is at 4e-3 of it.
        let mut cuts: Vec<f64> = from_lower.iter().step_by(2).map(|share| share * length).collect();
        let end = self.limit.as_ref().map(|limit| limit.value).or(self.upper);
        let rest = end.map_or(0.0, |end| (end.value - self.lower.value) - length);
        if rest > 0.0 {
            let distances = std::iter::successors(Some(FACTOR * rest), |distance| Some(FACTOR * distance));
            let far: Vec<f64> = distances.map(|distance| length - (distance - rest)).take_while(|cut| *cut > 0.5 * length).collect();
            cuts.extend(far.iter().rev());
        }
        cuts
    }
}
