//! `eval --method curve`: one expansion of f′ for all points.

use super::Failure;
use crate::contact::{Contact, ContactError, Measured, Quantity, Reason, each_point, with_reasons};
use crate::num::{Bounded, Estimate};
use crate::transform::{Curve, PressureCurve, Reading, TransformError};

/// Default tolerance of the curve; the output contains the error of every value.
const TOLERANCE: f64 = 1e-9;

/// The arguments of a call with `--method curve`.
pub(super) struct Asked<'a> {
    pub(super) quantity: Quantity,
    pub(super) at: &'a [f64],
    pub(super) radius: Option<f64>,
    pub(super) depth: Option<f64>,
    pub(super) effective_modulus: f64,
    pub(super) tolerance: Option<f64>,
}

/// Returns the values of the quantity at all points.
pub(super) fn readings(
    contact: &Contact<'_>,
    asked: &Asked<'_>,
    failed: impl Fn(ContactError) -> Failure,
) -> Result<Vec<Measured>, Failure> {
    use Quantity::{Depth, Equivalent, Force, Integral, Pressure, Stiffness};
    if !matches!(asked.quantity, Equivalent | Depth | Force | Integral | Pressure | Stiffness) {
        let message = format!("--method curve does not compute {}", asked.quantity.key());
        return Err(Failure::new(message).help("expected g, d, F, G, p or k; other quantities need another --method"));
    }
    let refused = |error: TransformError| failed(error.into());
    let inside = |at: f64| match asked.radius {
        Some(_) => Ok(()),
        None => contact.evaluator().check_domain(asked.quantity.coordinate(), at),
    };
    let furthest = asked.radius.unwrap_or_else(|| asked.at.iter().copied().filter(|at| inside(*at).is_ok()).fold(0.0, f64::max));
    // The expansion needs an interval of positive length, even if only the axis is requested.
    let limit = contact.evaluator().limit();
    let reach = if furthest > 0.0 { furthest } else { (0.5 * limit).min(1.0) };
    let profile = contact.evaluator().typed().map_err(refused)?;
    let curve = Curve::new(profile, reach, asked.tolerance.unwrap_or(TOLERANCE)).map_err(refused)?;
    let pressures = match asked.radius {
        Some(a) => Some(curve.pressures(a).map_err(refused)?),
        None => None,
    };
    let read = |at: f64| {
        inside(at)?;
        Ok(reading(&curve, pressures.as_ref(), asked, at)?)
    };
    let found = each_point(asked.at, usize::MAX, |block: &[f64]| block.iter().map(|at| read(*at)).collect());
    with_reasons(found).map_err(failed)
}

fn reading(curve: &Curve<'_>, pressures: Option<&PressureCurve<'_>>, asked: &Asked<'_>, at: f64) -> Result<Measured, TransformError> {
    let modulus = Bounded::exact(asked.effective_modulus);
    let twice = Bounded::exact(2.0) * modulus;
    let place = Bounded::exact(at);
    // Additional depth of a punch with a rim compared with a smooth edge.
    let excess = |a: f64| -> Result<Bounded, TransformError> {
        Ok(match asked.depth {
            Some(depth) => Bounded::exact(depth) - curve.equivalent(a)?.bounded(),
            None => Bounded::exact(0.0),
        })
    };
    let value = match (asked.quantity, pressures) {
        (Quantity::Equivalent, _) => curve.equivalent(at)?.bounded(),
        (Quantity::Depth, _) => {
            asked.depth.map_or_else(|| curve.equivalent(at).map(Estimate::bounded), |depth| Ok(Bounded::exact(depth)))?
        }
        (Quantity::Integral, _) => curve.integral(at)?.bounded(),
        (Quantity::Force, _) => curve.force(at)?.bounded() * twice + excess(at)? * place * twice,
        (Quantity::Pressure, Some(pressures)) => {
            let a = pressures.radius();
            let excess = excess(a)?;
            if at == a && excess.value != 0.0 {
                return Ok(Err(Reason::Rim));
            }
            let Some(smooth) = pressures.at(at)? else {
                return Ok(Err(Reason::at_singularity(at, a, |r| Some(pressures.at(r).ok()??.value))));
            };
            let edge = Bounded::exact(a);
            let root = ((edge - place) * (edge + place)).sqrt();
            let rim = if excess.value == 0.0 || at >= a { Bounded::exact(0.0) } else { excess / root };
            (smooth.bounded() + rim) * modulus / Bounded::rounded(std::f64::consts::PI)
        }
        _ => twice * place,
    };
    Ok(Ok(Reading { estimate: Estimate::estimated(value.value, value.error, 0), method: "curve" }))
}
