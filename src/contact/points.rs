//! Evaluation of a list of points, in which a failure at one point does not affect the others.

use super::{Contact, ContactError, Measured, Reason};
use crate::num::{Bounded, work};
use crate::transform::{PressureCurve, Quantities, Reading, TransformError};
use std::sync::Arc;

/// Divisor of the budget: one part of this many is reserved for writing the answer.
const FOR_THE_ANSWER: u64 = 16;
/// Divisor of the remaining budget: a single point may use one part of this many.
const FOR_ONE: u64 = 2;
/// Factor between the budget of a block and its expected cost.
const HEADROOM: u64 = 4;
/// Steps above which a list of pressures under one contact is answered by one expansion.
const EXPENSIVE: u64 = 100_000_000;
/// Fewest pressures for which an expansion is considered.
const MANY: usize = 20;
/// Parts of the contact radius at which the cost of a pressure is measured.
const TYPICAL: [f64; 2] = [0.37, 0.61];
/// Relative error above which a pressure of the expansion is computed anew.
const FINE: f64 = 1e-10;

impl<'a, P: Quantities + ?Sized> Contact<'a, P> {
    /// Returns whether `count` pressures under the radius `a` cost too much one by one.
    ///
    /// The decision depends on counted steps and not on the budget, so that a budget changes no answer.
    pub fn are_expensive(&self, a: f64, count: usize) -> bool {
        if count < MANY || a.is_nan() || a <= 0.0 {
            return false;
        }
        let cost = |part: f64| {
            let (_, spent, _) = work::apart(EXPENSIVE, || self.evaluator().pressure(part * a, a).is_ok());
            work::spend(spent);
            spent
        };
        // What the first call prepares for all others is not part of the cost of one.
        TYPICAL.into_iter().map(cost).min().unwrap_or(0).saturating_mul(count as u64) > EXPENSIVE
    }

    /// Returns a contact whose pressures under the radius of an expansion, see [`Quantities::pressure_curve`], come from it.
    ///
    /// The errors of the expansion are estimated; where one exceeds 1e-10 of the value, without an expansion, and for every other
    /// quantity, the profile is asked as before.
    pub fn with_pressures(&self, curve: Option<Arc<PressureCurve<'static>>>) -> Contact<'a, Expanded<P>> {
        let evaluator = Expanded { profile: self.shared_evaluator(), curve };
        Contact::new(evaluator, self.effective_modulus(), self.depth_of_rim(), self.tolerance())
    }
}

/// A profile whose pressures under one contact radius come from one expansion; see [`Contact::with_pressures`].
pub struct Expanded<P: ?Sized> {
    profile: Arc<P>,
    curve: Option<Arc<PressureCurve<'static>>>,
}

impl<P: Quantities + ?Sized> Quantities for Expanded<P> {
    fn equivalent(&self, x: f64) -> Result<Reading, TransformError> {
        self.profile.equivalent(x)
    }

    fn force(&self, a: f64) -> Result<Reading, TransformError> {
        self.profile.force(a)
    }

    fn integral(&self, a: f64) -> Result<Reading, TransformError> {
        self.profile.integral(a)
    }

    fn pressure(&self, r: f64, a: f64) -> Result<Option<Reading>, TransformError> {
        let Some(curve) = self.curve.as_ref().filter(|own| own.radius() == a) else { return self.profile.pressure(r, a) };
        match curve.at(r)? {
            Some(own) if own.error <= FINE * own.value.abs() => Ok(Some(Reading { estimate: own, method: "curve" })),
            Some(_) => self.profile.pressure(r, a),
            None => Ok(None),
        }
    }

    fn axial(&self, z: f64, a: f64) -> Result<Reading, TransformError> {
        self.profile.axial(z, a)
    }

    fn displacement(&self, r: f64, a: f64) -> Result<Reading, TransformError> {
        self.profile.displacement(r, a)
    }

    fn height(&self, r: f64) -> Result<Reading, TransformError> {
        self.profile.height(r)
    }

    fn limit(&self) -> f64 {
        self.profile.limit()
    }

    fn breakpoints_below(&self, end: f64) -> Vec<f64> {
        self.profile.breakpoints_below(end)
    }

    fn check_domain(&self, symbol: &'static str, at: f64) -> Result<(), TransformError> {
        self.profile.check_domain(symbol, at)
    }

    fn flat_radius(&self) -> Result<f64, TransformError> {
        self.profile.flat_radius()
    }

    fn f_prime_over(&self, lower: f64, upper: f64) -> Option<(f64, f64)> {
        self.profile.f_prime_over(lower, upper)
    }

    fn power_at_axis(&self, radius: f64) -> Option<(f64, f64)> {
        self.profile.power_at_axis(radius)
    }

    fn squared_gap(&self, a: f64, depth: Bounded) -> Option<Result<Reading, TransformError>> {
        self.profile.squared_gap(a, depth)
    }
}

/// Evaluates a list of points with `read`, in blocks, within the open budget.
///
/// The block size doubles after each success. A block that fails or exceeds its budget is evaluated point by point. A point without
/// a value is returned as `Err` with its [`Reason`], which is [`Reason::Unfinished`] if the budget was exhausted.
///
/// # Errors
/// If no point has a value: the first error, or the exhausted budget.
///
/// ```
/// use sneddon::contact::{Contact, each_point};
/// use sneddon::{expr::Bindings, parse, transform::{Evaluator, Method, Profile, derive}};
/// let solution = derive(&Profile::new(&parse::profile("2-sqrt(4-r^2)").unwrap()).unwrap()).unwrap();
/// let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
/// let contact = Contact::new(evaluator, 1.0, None, 1e-13);
/// // The sphere ends at r = 2.
/// let forces = each_point(&[0.5, 1.5, 2.5], |a| contact.forces(a)).unwrap();
/// assert!(forces[0].is_ok() && forces[1].is_ok() && forces[2].is_err());
/// ```
pub fn each_point(at: &[f64], mut read: impl FnMut(&[f64]) -> Result<Vec<Measured>, ContactError>) -> Result<Vec<Measured>, ContactError> {
    if at.len() == 1 {
        // A single point returns its error unchanged.
        return read(at);
    }
    let reserve = work::left() / FOR_THE_ANSWER;
    let (mut readings, mut first): (Vec<Measured>, Option<ContactError>) = (Vec::with_capacity(at.len()), None);
    let (mut size, mut dearest) = (1, 0);
    while let Some(rest) = at.get(readings.len()..).filter(|rest| !rest.is_empty()) {
        let left = work::left().saturating_sub(reserve);
        let affordable = usize::try_from(left / (2 * HEADROOM * dearest).max(1)).unwrap_or(usize::MAX);
        let block = rest.get(..size.min(affordable).max(1)).unwrap_or(rest);
        let count = block.len() as u64;
        let most = if count == 1 { left / FOR_ONE } else { HEADROOM * dearest.max(1) * count };
        let before = work::left();
        match (work::until_deadline(|| work::share(most, || read(block))), block) {
            (Some(Ok(found)), _) => {
                dearest = dearest.max((before - work::left()) / count);
                readings.extend(found);
                size = 2 * block.len();
            }
            (Some(Err(ContactError::Transform(TransformError::Exhausted(_)))), [_]) => readings.push(Err(Reason::Unfinished)),
            (Some(Err(error)), [_]) => {
                readings.push(Err(Reason::Refused(error.to_string())));
                first.get_or_insert(error);
            }
            (None, [_]) => readings.push(Err(Reason::Unfinished)),
            _ => size = 1,
        }
    }
    if readings.iter().any(|own| !matches!(own, Err(Reason::Refused(_) | Reason::Unfinished))) {
        return Ok(readings);
    }
    Err(first.unwrap_or_else(|| work::exhausted().into()))
}
