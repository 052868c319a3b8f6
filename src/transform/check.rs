//! The program's own check: closed forms against quadrature of the profile as typed, at 64 points.

use super::evaluator::{Evaluator, Method, Reading};
use super::sample::{Sampler, reach};
use super::{Solution, TransformError};
use crate::expr::Bindings;
use crate::num::{Bounded, Estimate};

/// The outcome of a check.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Check {
    /// Points compared.
    pub points: u32,
    /// The largest |closed − quadrature| relative to the size of the quantity.
    pub max_relative_difference: f64,
    /// True where every difference stays within the sum of both error estimates.
    pub passed: bool,
}

/// Points of a check.
const POINTS: u32 = 64;
/// Draws of the parameters among which the points are shared.
const DRAWS: u32 = 8;
/// More terms than this make a profile long.
const MANY_TERMS: usize = 40;
/// The relative tolerance that the quadratures of a check are asked for.
const TOLERANCE: f64 = 1e-12;

/// Compares g at 64 points, F and p at up to 16 of them, at the set values or at seeded random admissible ones.
///
/// What is closed is compared with quadrature; what is integrated anyway is held against the law x g = G + F/(2E*).
///
/// ```
/// use sneddon::{parse, transform::{Profile, check, derive}};
/// let profile = Profile::new(&parse::profile("R - sqrt(R^2 - r^2)").unwrap()).unwrap();
/// let outcome = check(&derive(&profile).unwrap()).unwrap();
/// assert!(outcome.passed && outcome.points == 64);
/// ```
///
/// # Errors
/// [`TransformError`] where the profile cannot be evaluated at any admissible value of its parameters.
pub fn check(solution: &Solution) -> Result<Check, TransformError> {
    let mut sampler = Sampler::new(0x0c4e_c4ed);
    let draws = if solution.profile.parameters().is_empty() { 1 } else { DRAWS };
    // A long profile is as well tested by fewer of the dear pressures.
    let every = if solution.terms().count() > MANY_TERMS { 32 } else { 4 };
    let mut outcome = Check { points: 0, max_relative_difference: 0.0, passed: true };
    let mut trouble = None;
    // Some draws may fail: there are twice as many as are needed.
    for _ in 0..2 * draws {
        let Some(bindings) = sampler.parameters(solution) else { break };
        let mut own = outcome;
        match compare(solution, &bindings, POINTS / draws, every, &mut sampler, &mut own) {
            Ok(()) => outcome = own,
            Err(error) => trouble = Some(error),
        }
        if outcome.points >= POINTS {
            break;
        }
    }
    match trouble {
        Some(error) if outcome.points == 0 => Err(error),
        _ => Ok(Check { passed: outcome.passed && outcome.points > 0, ..outcome }),
    }
}

fn compare(
    solution: &Solution,
    bindings: &Bindings,
    points: u32,
    every: usize,
    sampler: &mut Sampler,
    outcome: &mut Check,
) -> Result<(), TransformError> {
    let closed = Evaluator::new(solution, bindings, Method::Auto, TOLERANCE)?;
    let plain = Evaluator::new(solution, bindings, Method::Quadrature, TOLERANCE)?;
    let closed_pressure = solution.terms().any(|term| !term.has_open_pressure());
    // Where integrals stand beside closed terms of the pressure, both sides are dear.
    let every_pressure = if solution.terms().any(|term| term.has_open_pressure()) { 4 * every } else { every };
    for (index, x) in sampler.points(reach(&closed), points).into_iter().enumerate() {
        let share = sampler.fraction();
        outcome.take_other(closed.slope(x)?, || plain.slope(x))?;
        if index % every == 0 {
            outcome.take_other(closed.force(x)?, || plain.force(x))?;
            if closed_pressure && index % every_pressure == 0 {
                let r = x * share;
                if let (Some(one), Some(other)) = (closed.pressure(r, x)?, plain.pressure(r, x)?) {
                    outcome.take(one.estimate, other.estimate);
                }
            }
            if !solution.is_closed() {
                // Where f′ is integrated anyway, its three integrals must agree: x g(x) = G(x) + F(x)/(2E*).
                let product = Bounded::exact(x) * plain.slope(x)?.estimate.bounded();
                let sum = plain.integral(x)?.estimate.bounded() + plain.force(x)?.estimate.bounded();
                outcome.take(Estimate::from_bounded(product, 0), Estimate::from_bounded(sum, 0));
            }
        }
        outcome.points += 1;
    }
    Ok(())
}

impl Check {
    /// Compares with the other path, unless the value came by that very path.
    fn take_other(&mut self, own: Reading, other: impl FnOnce() -> Result<Reading, TransformError>) -> Result<(), TransformError> {
        if own.method != "quadrature" {
            self.take(own.estimate, other()?.estimate);
        }
        Ok(())
    }

    fn take(&mut self, own: Estimate, other: Estimate) {
        let difference = (own.value - other.value).abs();
        let size = own.value.abs().max(other.value.abs());
        if size > 0.0 {
            self.max_relative_difference = self.max_relative_difference.max(difference / size);
        }
        // Written so that a NaN fails.
        let within = difference <= own.error + other.error;
        self.passed &= within;
    }
}
