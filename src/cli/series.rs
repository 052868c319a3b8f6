//! `eval --method series`: the numbers of a quantity by its power series.

use super::Failure;
use crate::contact::{Measured, Quantity, Reason};
use crate::num::{Bounded, Estimate};
use crate::transform::{HIGHEST_ORDER, Profile, Reading, SeriesEvaluator, SeriesFailure};

/// True for quantities of which every term of the series is known.
pub(super) fn answers(quantity: Quantity) -> bool {
    use Quantity::{Depth, Equivalent, Force, Integral, Pressure, Profile, Stiffness};
    matches!(quantity, Profile | Equivalent | Depth | Force | Integral | Pressure | Stiffness)
}

/// Reads `--order N`; the default is the order of the way `series`.
pub(super) fn order(text: Option<&str>, quantity: Quantity) -> Result<usize, Failure> {
    let Some(text) = text else {
        return Ok(if quantity == Quantity::Pressure { SeriesEvaluator::PRESSURE_ORDER } else { SeriesEvaluator::ORDER });
    };
    let number = text.trim().parse::<usize>().ok().filter(|n| (1..=HIGHEST_ORDER).contains(n));
    number.ok_or_else(|| {
        let help = format!("a whole number from 1 to {HIGHEST_ORDER} would be accepted");
        Failure::new(format!("--order {} is no order of a series", text.trim())).help(help).at("--order", text, 0..text.len())
    })
}

/// The values of the quantity at every point.
pub(super) fn readings(
    quantity: Quantity,
    profile: &Profile,
    order: usize,
    at: &[f64],
    radius: Option<f64>,
    effective_modulus: f64,
) -> Result<Vec<Measured>, Failure> {
    let failed = |error: SeriesFailure| Failure::new(error.to_string());
    let series = SeriesEvaluator::new(profile, order).map_err(failed)?;
    let modulus = Bounded::exact(effective_modulus);
    let times = |reading: Reading, factor: Bounded| Reading { estimate: reading.estimate.times(factor), ..reading };
    let value = |at: f64| -> Result<Measured, SeriesFailure> {
        Ok(Ok(match quantity {
            Quantity::Profile => series.height(at)?,
            Quantity::Equivalent | Quantity::Depth => series.slope(at)?,
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
    // A point has a reason instead of a value where others have one.
    let found: Vec<Result<Measured, SeriesFailure>> = at.iter().map(|point| value(*point)).collect();
    if found.iter().any(Result::is_ok) {
        return Ok(found.into_iter().map(|own| own.unwrap_or_else(|error| Err(Reason::Refused(error.to_string())))).collect());
    }
    found.into_iter().map(|own| own.map_err(failed)).collect()
}

/// The smooth edge that a series needs.
pub(super) fn refuse_rim(depth: Option<f64>) -> Result<(), Failure> {
    match depth {
        Some(_) => Err(Failure::new("--method series answers smooth edges only").help("leave out --depth, or take another method")),
        None => Ok(()),
    }
}

/// `--order` belongs to `--method series`.
pub(super) fn refuse_order(order: Option<&str>) -> Result<(), Failure> {
    match order {
        Some(text) => {
            Err(Failure::new("--order belongs to --method series").help("add --method series").at("--order", text, 0..text.len()))
        }
        None => Ok(()),
    }
}
