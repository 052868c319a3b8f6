//! `eval --method series`: computes a quantity from its power series.

use super::Failure;
use crate::contact::{Contact, Measured, Quantity, Reason};
use crate::num::{Bounded, Estimate};
use crate::transform::{HIGHEST_ORDER, Profile, Reading, SeriesEvaluator, SeriesFailure, TransformError};

/// Returns true for quantities whose series terms are all known.
pub(super) fn answers(quantity: Quantity) -> bool {
    use Quantity::{Depth, Equivalent, Force, Integral, Pressure, Profile, Stiffness};
    matches!(quantity, Profile | Equivalent | Depth | Force | Integral | Pressure | Stiffness)
}

/// Parses `--order N`; the default is the order used by the method `series`.
pub(super) fn order(text: Option<&str>, quantity: Quantity) -> Result<usize, Failure> {
    let Some(text) = text else {
        return Ok(if quantity == Quantity::Pressure { SeriesEvaluator::PRESSURE_ORDER } else { SeriesEvaluator::ORDER });
    };
    let number = text.trim().parse::<usize>().ok().filter(|n| (1..=HIGHEST_ORDER).contains(n));
    number.ok_or_else(|| {
        let help = format!("expected a whole number from 1 to {HIGHEST_ORDER}");
        Failure::new(format!("--order {} is not a valid order of a series", text.trim())).help(help).at("--order", text, 0..text.len())
    })
}

/// Returns the values of the quantity at all points.
pub(super) fn readings(
    quantity: Quantity,
    profile: &Profile,
    order: usize,
    at: &[f64],
    radius: Option<f64>,
    contact: &Contact<'_>,
) -> Result<Vec<Measured>, Failure> {
    let failed = |error: SeriesFailure| Failure::new(error.to_string());
    let series = SeriesEvaluator::new(profile, order).map_err(failed)?;
    let modulus = Bounded::exact(contact.effective_modulus());
    let times = |reading: Reading, factor: Bounded| Reading { estimate: reading.estimate.times(factor), ..reading };
    let value = |at: f64| -> Result<Measured, SeriesFailure> {
        if !quantity.needs_radius() {
            contact.evaluator().check_domain(quantity.coordinate(), at)?;
        }
        Ok(Ok(match quantity {
            Quantity::Profile => series.height(at)?,
            Quantity::Equivalent | Quantity::Depth => series.equivalent(at)?,
            Quantity::Force => times(series.force(at)?, Bounded::exact(2.0) * modulus),
            Quantity::Integral => series.integral(at)?,
            Quantity::Pressure => {
                let a = radius.unwrap_or(at);
                let over_pi = modulus / Bounded::rounded(std::f64::consts::PI);
                let outside = Reading { estimate: Estimate::exact(0.0), method: "series" };
                if at >= a { outside } else { times(series.pressure(at, a)?, over_pi) }
            }
            Quantity::Stiffness => {
                let value = Bounded::exact(2.0 * at) * modulus;
                Reading { estimate: Estimate::from_bounded(value, 0), method: "exact" }
            }
            other => return Err(SeriesFailure::Quantity { quantity: other.key() }),
        }))
    };
    // A point without a value has a reason instead.
    let found: Vec<Result<Measured, SeriesFailure>> = at.iter().map(|point| value(*point)).collect();
    if found.iter().any(Result::is_ok) {
        let reason = |error| match error {
            SeriesFailure::Transform(TransformError::Exhausted(_)) => Reason::Unfinished,
            error => Reason::Refused(error.to_string()),
        };
        return Ok(found.into_iter().map(|own| own.unwrap_or_else(|error| Err(reason(error)))).collect());
    }
    found.into_iter().map(|own| own.map_err(failed)).collect()
}

/// Requires a smooth edge, since the series does not cover a rim.
pub(super) fn refuse_rim(depth: Option<f64>) -> Result<(), Failure> {
    match depth {
        Some(_) => Err(Failure::new("--method series supports only smooth edges").help("omit --depth, or use another method")),
        None => Ok(()),
    }
}

/// Returns an error unless `--order` is used with `--method series`.
pub(super) fn refuse_order(order: Option<&str>) -> Result<(), Failure> {
    match order {
        Some(text) => Err(Failure::new("--order requires --method series").help("add --method series").at("--order", text, 0..text.len())),
        None => Ok(()),
    }
}
