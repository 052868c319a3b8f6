//! What is computed: one quantity of one profile at a list of points.

use super::TradeoffError;
use crate::contact::Quantity;
use crate::num::Estimate;
use crate::transform::{Evaluator, Profile, Reading, Sampler, Solution, Superposed, TransformError, reach};

/// One quantity of one profile, without free parameters, at its points.
pub struct Problem<'a> {
    /// The profile with numbers for its parameters.
    pub profile: &'a Profile,
    /// Its formulas.
    pub solution: &'a Solution,
    /// g, F or p, for E* = 1 and a smooth edge.
    pub quantity: Quantity,
    /// The contact radius, for the pressure.
    pub radius: Option<f64>,
    /// The coordinates.
    pub points: Vec<f64>,
}

/// Points where none are given.
const POINTS: u32 = 32;
/// The seed of the points and of the order of the measurements.
pub(super) const SEED: u64 = 2026;
/// The contact radius of a pressure as a part of the reach, where none is given.
const SHARE: f64 = 0.75;

impl<'a> Problem<'a> {
    /// The quantities that can be studied; the others follow from them.
    pub const QUANTITIES: [Quantity; 3] = [Quantity::Equivalent, Quantity::Force, Quantity::Pressure];

    /// The problem at the given points, or at 32 seeded ones within the profile's reach.
    ///
    /// # Errors
    /// [`TradeoffError::Transform`] for points outside the domain of the profile, [`TradeoffError::Quantity`] for another quantity.
    pub fn new(
        solution: &'a Solution,
        evaluator: &Evaluator<'_>,
        quantity: Quantity,
        radius: Option<f64>,
        points: Option<Vec<f64>>,
    ) -> Result<Self, TradeoffError> {
        if !Self::QUANTITIES.contains(&quantity) {
            return Err(TradeoffError::Quantity { key: quantity.key() });
        }
        let profile = &solution.profile;
        let far = reach(evaluator);
        let radius = (quantity == Quantity::Pressure).then(|| radius.unwrap_or(SHARE * far));
        let points = points.unwrap_or_else(|| {
            let seeded = Sampler::new(SEED).points(radius.unwrap_or(far), POINTS);
            // Inside a flat tip everything is 0, and no method has anything to do.
            let telling: Vec<f64> =
                seeded.iter().copied().filter(|x| evaluator.equivalent(*x).map_or(true, |g| g.estimate.value != 0.0)).collect();
            if quantity == Quantity::Pressure || telling.is_empty() { seeded } else { telling }
        });
        let outermost = radius.into_iter().chain(points.iter().copied()).fold(0.0, f64::max);
        evaluator.check_domain(if radius.is_some() { "a" } else { quantity.coordinate() }, outermost)?;
        Ok(Self { profile, solution, quantity, radius, points })
    }

    /// The corresponding quantity of the transform.
    pub(super) fn superposed(&self) -> Superposed {
        match self.quantity {
            Quantity::Equivalent => Superposed::Equivalent,
            Quantity::Force => Superposed::Force,
            _ => Superposed::Pressure,
        }
    }

    /// The factor of the transform's value: 1, 2 for F/(2E*), 1/π for p π/E*.
    pub fn factor(&self) -> f64 {
        match self.quantity {
            Quantity::Equivalent => 1.0,
            Quantity::Force => 2.0,
            _ => std::f64::consts::FRAC_1_PI,
        }
    }

    /// Where the transform's quantity is evaluated for one coordinate.
    pub(super) fn inputs(&self, at: f64) -> Vec<f64> {
        std::iter::once(at).chain(self.radius).collect()
    }

    /// The transform's own value by an evaluator.
    pub(super) fn read(&self, evaluator: &Evaluator<'_>, at: f64) -> Result<Estimate, String> {
        let reading = match (self.quantity, self.radius) {
            (Quantity::Equivalent, _) => evaluator.equivalent(at).map(Some),
            (Quantity::Force, _) => evaluator.force(at).map(Some),
            (_, radius) => evaluator.pressure(at, radius.unwrap_or(at)),
        };
        estimate(reading)
    }

    /// The farthest place that any point needs.
    pub(super) fn outermost(&self) -> f64 {
        self.radius.into_iter().chain(self.points.iter().copied()).fold(0.0, f64::max)
    }
}

fn estimate(reading: Result<Option<Reading>, TransformError>) -> Result<Estimate, String> {
    match reading {
        Ok(Some(reading)) => Ok(reading.estimate),
        Ok(None) => Err("the value is infinite by theory".to_owned()),
        Err(error) => Err(error.to_string()),
    }
}
