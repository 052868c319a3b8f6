//! Lists of points: each keeps its value whatever becomes of the others, and finished work is never thrown away.

use super::{ContactError, Measured, Reason};
use crate::num::work;

/// This part of the budget is left for writing the answer.
const FOR_THE_ANSWER: u64 = 16;
/// A single point may use this part of what is left.
const FOR_ONE: u64 = 3;
/// A block may use this many times what its points are expected to cost.
const HEADROOM: u64 = 4;

/// The readings of a list of points, `read` block by block within the open budget.
///
/// Blocks double while all goes well. A block that fails, or costs much more than those before it, is read point by point: a point
/// without a value is `Err` with its reason, [`Reason::Unfinished`] where the budget did not suffice for it.
///
/// # Errors
/// The error of the first point where no point has a value; the exhausted budget where it suffices for none.
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
        // One point has no part that could be given.
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
