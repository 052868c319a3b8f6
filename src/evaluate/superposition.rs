//! Superposition of profiles: formulas, tables and closures at the same contact radius.

use crate::derive::profile::Profile;
use crate::evaluate::curve::PressureCurve;
use crate::evaluate::evaluator::Reading;
use crate::evaluate::quantities::Quantities;
use crate::integrate::error::TransformError;
use crate::integrate::source::enclosures::{sum_of_powers, sum_of_ranges};
use crate::num::legendre::rule_of;
use crate::num::{Bounded, Estimate};
use std::sync::Arc;

/// The sum of several profiles; at the same contact radius all quantities except the energy add up (Popov & Heß (3.25)–(3.26)).
///
/// ```
/// use sneddon::transform::{Interpolation, Profile, Quantities, Superposition};
/// use std::sync::Arc;
/// let r: Vec<f64> = (0..=40).map(|i| 0.05 * f64::from(i)).collect();
/// let z: Vec<f64> = r.iter().map(|r| r * r / 4.0).collect();
/// let tip = Arc::new(Profile::from_points(&r, &z, Interpolation::MonotoneCubic).unwrap());
/// let both = Superposition::new(vec![tip.clone(), tip]);
/// // r²/2 has g = x²
/// assert!((both.equivalent(1.0).unwrap().estimate.value - 1.0).abs() < 1e-14);
/// ```
#[derive(Clone)]
pub struct Superposition<'a> {
    parts: Vec<Arc<dyn Quantities + 'a>>,
    end: f64,
}

/// Nodes between two breakpoints for the energy; a rule with fewer nodes gives the error estimate.
const ENERGY_NODES: usize = 8;
const FEWER_NODES: usize = 6;
const FEW_BREAKPOINTS: usize = 8;

impl<'a> Superposition<'a> {
    /// The sum of these profiles; an empty sum is flat.
    pub fn new(parts: Vec<Arc<dyn Quantities + 'a>>) -> Self {
        Self { parts, end: f64::INFINITY }
    }

    /// Limits the sum to a radius, the end of a body that is not one of the summed profiles.
    #[must_use]
    pub fn ending_at(self, end: f64) -> Self {
        Self { end: self.end.min(end), ..self }
    }

    fn refuse_beyond_end(&self, symbol: &'static str, at: f64) -> Result<(), TransformError> {
        if at < self.end {
            Ok(())
        } else {
            Err(TransformError::OutOfDomain { symbol, at, limit: format!(", which ends at r = {}", self.end) })
        }
    }

    /// The sum over all parts; a single part is read directly.
    fn added(&self, read: impl Fn(&dyn Quantities) -> Result<Reading, TransformError>) -> Result<Reading, TransformError> {
        match self.parts.as_slice() {
            [only] => read(only.as_ref()),
            parts => sum(parts.iter().map(|part| read(part.as_ref()))),
        }
    }
}

fn sum(parts: impl Iterator<Item = Result<Reading, TransformError>>) -> Result<Reading, TransformError> {
    let (mut total, mut method) = (Estimate::exact(0.0), None);
    for part in parts {
        let Reading { estimate, method: own } = part?;
        total = total + estimate;
        method = Some(method.map_or(own, |known| if known == own { own } else { "mixed" }));
    }
    Ok(Reading { estimate: total, method: method.unwrap_or("exact") })
}

impl Quantities for Superposition<'_> {
    fn equivalent(&self, x: f64) -> Result<Reading, TransformError> {
        self.refuse_beyond_end("x", x)?;
        self.added(|part| part.equivalent(x))
    }

    fn force(&self, a: f64) -> Result<Reading, TransformError> {
        self.refuse_beyond_end("a", a)?;
        self.added(|part| part.force(a))
    }

    fn integral(&self, a: f64) -> Result<Reading, TransformError> {
        self.added(|part| part.integral(a))
    }

    fn pressure(&self, r: f64, a: f64) -> Result<Option<Reading>, TransformError> {
        let mut finite = Vec::with_capacity(self.parts.len());
        for part in &self.parts {
            match part.pressure(r, a)? {
                Some(own) => finite.push(own),
                None => return Ok(None),
            }
        }
        match finite.as_slice() {
            [only] => Ok(Some(*only)),
            _ => sum(finite.into_iter().map(Ok)).map(Some),
        }
    }

    fn shortest_wave(&self, r: f64) -> f64 {
        self.parts.iter().map(|part| part.shortest_wave(r)).fold(f64::INFINITY, f64::min)
    }

    fn has_pressure_curve(&self) -> bool {
        matches!(self.parts.as_slice(), [only] if only.has_pressure_curve())
    }

    fn pressure_curve(&self, a: f64) -> Option<PressureCurve<'static>> {
        match self.parts.as_slice() {
            [only] => only.pressure_curve(a),
            _ => None,
        }
    }

    fn axial(&self, z: f64, a: f64) -> Result<Reading, TransformError> {
        self.added(|part| part.axial(z, a))
    }

    fn displacement(&self, r: f64, a: f64) -> Result<Reading, TransformError> {
        self.added(|part| part.displacement(r, a))
    }

    fn height(&self, r: f64) -> Result<Reading, TransformError> {
        self.refuse_beyond_end("r", r)?;
        self.added(|part| part.height(r))
    }

    fn limit(&self) -> f64 {
        self.parts.iter().map(|part| part.limit()).fold(self.end, f64::min)
    }

    fn breakpoints_below(&self, end: f64) -> Vec<f64> {
        let mut list: Vec<f64> = self.parts.iter().flat_map(|part| part.breakpoints_below(end)).collect();
        if self.parts.len() > 1 {
            list.sort_by(f64::total_cmp);
            list.dedup();
        }
        list
    }

    fn check_domain(&self, symbol: &'static str, at: f64) -> Result<(), TransformError> {
        self.refuse_beyond_end(symbol, at)?;
        self.parts.iter().try_for_each(|part| part.check_domain(symbol, at))
    }

    fn flat_radius(&self) -> Result<f64, TransformError> {
        self.parts.iter().try_fold(f64::INFINITY, |least, part| Ok(part.flat_radius()?.min(least)))
    }

    fn f_prime_over(&self, lower: f64, upper: f64) -> Option<(f64, f64)> {
        sum_of_ranges(self.parts.iter().map(|part| part.f_prime_over(lower, upper)))
    }

    fn formulas(&self) -> Option<Vec<Profile>> {
        self.parts.iter().map(|part| part.formulas()).collect::<Option<Vec<_>>>().map(|parts| parts.concat())
    }

    fn power_at_axis(&self, radius: f64) -> Option<(f64, f64)> {
        sum_of_powers(self.parts.iter().map(|part| part.power_at_axis(radius)), radius)
    }

    /// A Gauss rule between consecutive breakpoints, in √(x − b), in which g is smooth except for roots at earlier breakpoints.
    fn squared_gap(&self, a: f64, depth: Bounded) -> Option<Result<Reading, TransformError>> {
        if let [only] = self.parts.as_slice() {
            return only.squared_gap(a, depth);
        }
        // Quadrature is more accurate for few breakpoints.
        (self.breakpoints_below(a).len() > FEW_BREAKPOINTS).then(|| self.squared_gap_by_pieces(a, depth))
    }
}

impl Superposition<'_> {
    fn squared_gap_by_pieces(&self, a: f64, depth: Bounded) -> Result<Reading, TransformError> {
        let rules = [rule_of(ENERGY_NODES), rule_of(FEWER_NODES)];
        let mut ends = vec![0.0];
        ends.extend(self.breakpoints_below(a));
        ends.push(a);
        let (mut total, mut doubt, mut evaluations) = (Bounded::exact(0.0), 0.0, 0);
        for pair in ends.windows(2) {
            let [lower, upper] = *pair else { continue };
            let mut sums = [Bounded::exact(0.0); 2];
            for (sum, rule) in sums.iter_mut().zip(&rules) {
                for node in rule {
                    let x = (lower + (upper - lower) * node.t * node.t).min(a);
                    let gap = depth - self.equivalent(x)?.estimate.bounded();
                    let weight = 2.0 * (upper - lower) * node.t * node.weight;
                    *sum = *sum + gap * gap * Bounded { value: weight, error: 4.0 * f64::EPSILON * weight };
                    evaluations += 1;
                }
            }
            let [own, fewer] = sums;
            doubt += (own.value - fewer.value).abs();
            total = total + own;
        }
        total.error += doubt;
        Ok(Reading { estimate: Estimate::estimated(total.value, total.error, evaluations), method: "quadrature" })
    }
}
