//! The truth that errors are measured against: the closed form with 30 digits, else a slow integral with 30 digits, else
//! the sharpest quadrature in doubles.

use super::TradeoffError;
use super::problem::Problem;
use crate::contact::Quantity;
use crate::expr::Bindings;
use crate::num::{DoubleDouble, Estimate, Precise};
use crate::transform::{Evaluator, Method, PreciseProfile};
use std::time::Instant;

/// How many times better than an error its reference must be; a smaller error is given as a bound.
pub const MARGIN: f64 = 1e3;
/// The relative tolerance of the quadrature that is the reference where nothing has 30 digits.
const SHARPEST: f64 = 1e-15;
/// Relative error above which a 30-digit value is not used.
const POOR: f64 = 1e-20;

/// The reference at one point.
#[derive(Clone, Copy, Debug)]
pub struct Truth {
    /// The value.
    pub value: Precise,
    /// Where it comes from.
    pub source: &'static str,
}

const CLOSED: &str = "closed form with 30 digits";
const INTEGRAL: &str = "double-exponential rule with 30 digits";
const DOUBLES: &str = "quadrature in doubles at a tolerance of 1e-15";

impl Truth {
    /// |value − truth|, an upper bound of it, and the scale that makes it relative.
    pub(super) fn distance(&self, value: f64) -> f64 {
        Precise { value: DoubleDouble::from(value).sub(self.value.value), error: 0.0 }.value.hi.abs()
    }

    /// The relative error below which a difference is inconclusive.
    pub(super) fn resolution(&self) -> f64 {
        if self.value.error == 0.0 { 0.0 } else { MARGIN * self.value.error / self.value.value.hi.abs() }
    }
}

/// The truth at every point; points without one are dropped, and so are those where the value is 0.
pub(super) fn find(problem: &mut Problem<'_>, deadline: Instant) -> Result<Vec<Truth>, TradeoffError> {
    let quantity = problem.superposed();
    let exact = Evaluator::new(problem.solution, &Bindings::default(), Method::Auto, SHARPEST)?;
    let sharp = Evaluator::new(problem.solution, &Bindings::default(), Method::Quadrature, SHARPEST)?;
    let slow = PreciseProfile::new(problem.profile)?;
    let (mut points, mut truths) = (Vec::new(), Vec::new());
    let mut reason = "every value is 0".to_owned();
    for at in &problem.points {
        if !truths.is_empty() && Instant::now() > deadline {
            break;
        }
        if problem.quantity == Quantity::Pressure && problem.radius.is_some_and(|a| *at >= a) {
            continue;
        }
        let inputs = problem.inputs(*at);
        let closed = exact.with_30_digits(quantity, &inputs)?.filter(sharp_enough).map(|value| Truth { value, source: CLOSED });
        let integral = || slow.value(quantity, &inputs).filter(sharp_enough).map(|value| Truth { value, source: INTEGRAL });
        let doubles = || problem.read(&sharp, *at).map(|own| Truth { value: in_doubles(own), source: DOUBLES });
        match closed.or_else(integral).map_or_else(doubles, Ok) {
            Ok(truth) if truth.value.value.hi == 0.0 => {}
            Ok(truth) if truth.value.is_finite() => {
                points.push(*at);
                truths.push(truth);
            }
            Ok(_) => reason = "the reference has no digits".to_owned(),
            Err(why) => reason = why,
        }
    }
    if truths.is_empty() {
        return Err(TradeoffError::NoReference { reason });
    }
    problem.points = points;
    Ok(truths)
}

fn sharp_enough(value: &Precise) -> bool {
    value.is_finite() && value.error <= POOR * value.value.hi.abs()
}

fn in_doubles(own: Estimate) -> Precise {
    Precise { value: own.value.into(), error: own.error }
}
