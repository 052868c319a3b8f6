//! The quantities of a profile of which f′ is known: each is an integral over its intervals, in the cheapest way or in a given
//! one.

use crate::integrate::admit::{beyond_the_edge, finite_and_not_negative};
use crate::integrate::ask::{Ask, BISECTION, By, not_this_way};
use crate::integrate::error::TransformError;
use crate::integrate::integral::{NumericProfile, Weight};
use crate::num::quadrature::Rule;
use crate::num::{Bounded, Estimate, work};

impl NumericProfile {
    /// g(x) = x ∫₀^{π/2} f′(x sin t) dt.
    ///
    /// # Errors
    /// [`TransformError`] if f′ is not finite below x, or no digits can be promised.
    pub fn equivalent(&self, x: f64, tolerance: f64) -> Result<Estimate, TransformError> {
        finite_and_not_negative("x", x)?;
        Ok(self.over_angle(x, Weight::Equivalent, tolerance, By::Cheapest)?.scaled(x))
    }

    /// F(a)/(2E*) = ∫₀^a r² f′/√(a²−r²) dr, for a smooth edge.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    pub fn force(&self, a: f64, tolerance: f64) -> Result<Estimate, TransformError> {
        finite_and_not_negative("a", a)?;
        Ok(self.over_angle(a, Weight::Force, tolerance, By::Cheapest)?.scaled(a).scaled(a))
    }

    /// g(x) by bisection with one Gauss–Kronrod rule, for those who want to know what a rule costs.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    pub fn equivalent_by(&self, x: f64, tolerance: f64, rule: Rule) -> Result<Estimate, TransformError> {
        finite_and_not_negative("x", x)?;
        Ok(self.over_angle(x, Weight::Equivalent, tolerance, By::Rule(rule))?.scaled(x))
    }

    /// F(a)/(2E*) by bisection with one Gauss–Kronrod rule.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    pub fn force_by(&self, a: f64, tolerance: f64, rule: Rule) -> Result<Estimate, TransformError> {
        finite_and_not_negative("a", a)?;
        Ok(self.over_angle(a, Weight::Force, tolerance, By::Rule(rule))?.scaled(a).scaled(a))
    }

    /// G(a) = ∫₀^a g dx = ∫₀^a f′ √(a²−r²) dr.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    pub fn integral(&self, a: f64, tolerance: f64) -> Result<Estimate, TransformError> {
        finite_and_not_negative("a", a)?;
        Ok(self.over_angle(a, Weight::Integral, tolerance, By::Cheapest)?.scaled(a).scaled(a))
    }

    /// The displacement u_z(r) outside a contact of radius a < r with a smooth edge.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    pub fn displacement(&self, r: f64, a: f64, tolerance: f64) -> Result<Estimate, TransformError> {
        finite_and_not_negative("a", a)?;
        beyond_the_edge("r", r, a)?;
        self.outside(r, a, tolerance, By::Cheapest)
    }

    fn outside(&self, r: f64, a: f64, tolerance: f64, by: By) -> Result<Estimate, TransformError> {
        let found = self.over_angle(a, Weight::Outside(r), tolerance, by)?;
        let factor = Bounded::exact(2.0) / Bounded::rounded(std::f64::consts::PI) * Bounded::exact(a);
        Ok(found.times(factor))
    }

    /// The requested number; `None` if it is theoretically infinite.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    pub(crate) fn answer(&self, ask: Ask, tolerance: f64) -> Result<Option<Estimate>, TransformError> {
        work::check()?;
        match ask {
            Ask::Equivalent(x) => self.equivalent(x, tolerance).map(Some),
            Ask::Force(a) => self.force(a, tolerance).map(Some),
            Ask::Integral(a) => self.integral(a, tolerance).map(Some),
            Ask::Pressure { r, a } => self.pressure(r, a, tolerance),
            Ask::Outside { r, a } => self.displacement(r, a, tolerance).map(Some),
            Ask::Height(r) => self.height(r, tolerance).map(Some),
            Ask::Axial { z, a } => self.axial(z, a, tolerance).map(Some),
        }
    }

    /// The same in the way of a key alone.
    ///
    /// # Errors
    /// As [`Self::equivalent`], and [`TransformError::NotThisWay`] if the way has no answer.
    pub(crate) fn in_the_way(&self, key: &'static str, ask: Ask, tolerance: f64) -> Result<Option<Estimate>, TransformError> {
        work::check()?;
        let only = By::Only(key);
        let found = match ask {
            Ask::Equivalent(x) => self.over_angle(x, Weight::Equivalent, tolerance, only)?.scaled(x),
            Ask::Force(a) => self.over_angle(a, Weight::Force, tolerance, only)?.scaled(a).scaled(a),
            Ask::Integral(a) => self.over_angle(a, Weight::Integral, tolerance, only)?.scaled(a).scaled(a),
            Ask::Outside { r, a } => self.outside(r, a, tolerance, only)?,
            Ask::Pressure { r, a } => return self.pressure_in_the_way(key, r, a, tolerance),
            Ask::Height(_) | Ask::Axial { .. } if key == BISECTION => return self.answer(ask, tolerance),
            Ask::Height(_) | Ask::Axial { .. } => return Err(not_this_way(key)),
        };
        Ok(Some(found))
    }

    /// ∫ f′(x sin t)·weight dt over all intervals below x.
    fn over_angle(&self, x: f64, weight: Weight, tolerance: f64, by: By) -> Result<Estimate, TransformError> {
        if let [segment] = self.segments.as_slice() {
            return segment.over_angle(x, weight, tolerance, by);
        }
        sum_to(tolerance, |tolerance| {
            let mut parts = self.segments.iter().map(|segment| segment.over_angle(x, weight, tolerance, by));
            parts.try_fold(Estimate::exact(0.0), |sum, part| Ok(sum + part?))
        })
    }
}

/// The smallest tolerance of a second attempt.
const SHARPEST: f64 = 1e-13;

/// A sum of integrals; once more with a smaller tolerance for each where they cancel, so that the first sum misses the tolerance.
pub(crate) fn sum_to(tolerance: f64, mut sum: impl FnMut(f64) -> Result<Estimate, TransformError>) -> Result<Estimate, TransformError> {
    let first = sum(tolerance)?;
    let asked = tolerance * first.value.abs();
    let sharper = (0.5 * asked / first.error * tolerance).max(SHARPEST);
    if first.error <= asked || sharper >= tolerance {
        return Ok(first);
    }
    let second = sum(sharper)?;
    let evaluations = first.evaluations + second.evaluations;
    Ok(Estimate { evaluations, ..if second.is_better_than(first) { second } else { first } })
}
