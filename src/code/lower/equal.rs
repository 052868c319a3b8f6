//! Values that are equal though they are computed in different ways.

use super::{Recorder, Step};
use crate::code::tree::Operator;

/// The largest relative difference of equal values.
pub(super) const CLOSE: f64 = 1e-10;
/// The number of sets of inputs.
const SETS: usize = 3;

/// Whether two values are the same function of the inputs, judged at a few of them.
pub(super) fn equal(recorder: &Recorder, one: u32, other: u32) -> bool {
    let pairs = samples(recorder, one).zip(samples(recorder, other));
    pairs.is_some_and(|(one, other)| one.iter().zip(&other).all(|(one, other)| (one - other).abs() <= CLOSE * one.abs()))
}

/// Finite values for a few sets of inputs; `None` for other functions than powers and logarithms.
pub(super) fn samples(recorder: &Recorder, place: u32) -> Option<Vec<f64>> {
    (0..SETS).map(|set| value(recorder, place, set).filter(|own| own.is_finite())).collect()
}

/// A value for inputs without a relation to one another; `None` for other functions than powers and logarithms.
fn value(recorder: &Recorder, place: u32, set: usize) -> Option<f64> {
    let input = |index: usize| 0.3 + (2.399_963 * (index + 5 * set) as f64).sin().powi(2);
    Some(match recorder.steps.get(place as usize)? {
        Step::Constant(hi, ..) => f64::from_bits(*hi),
        Step::Input(index) => input(*index),
        Step::Binary(operator, one, other) => {
            let (one, other) = (value(recorder, *one, set)?, value(recorder, *other, set)?);
            match operator {
                Operator::Add => one + other,
                Operator::Subtract => one - other,
                Operator::Multiply => one * other,
                Operator::Divide => one / other,
            }
        }
        Step::Call(name, arguments) => {
            let arguments = arguments.iter().map(|own| value(recorder, *own, set)).collect::<Option<Vec<_>>>()?;
            match (*name, arguments.as_slice()) {
                ("sqrt", [own]) => own.sqrt(),
                ("log", [own]) => own.ln(),
                ("pow", [base, exponent]) => base.powf(*exponent),
                _ => return None,
            }
        }
    })
}
