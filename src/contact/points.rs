//! Evaluation of a list of points, in which a failure at one point does not affect the others.

use super::{ContactError, Measured, Reason};
use crate::num::work;
use crate::transform::TransformError;

/// Divisor of the budget: one part of this many is reserved for writing the answer.
const FOR_THE_ANSWER: u64 = 16;
/// Divisor of the remaining budget: a single point may use one part of this many.
const FOR_ONE: u64 = 3;
/// Factor between the budget of a block and its expected cost.
const HEADROOM: u64 = 4;

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
        match (work::share(most, || read(block)), block) {
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
