//! Values that are equal though they are computed in different ways.

use super::{Recorder, Step};
use crate::code::tree::Operator;

/// Whether two values are the same function of the inputs, judged at a few of them.
pub(super) fn equal(recorder: &Recorder, one: u32, other: u32) -> bool {
    (0..3).all(|set| match (value(recorder, one, set), value(recorder, other, set)) {
        (Some(one), Some(other)) => one.is_finite() && (one - other).abs() <= 1e-10 * one.abs(),
        _ => false,
    })
}

/// A value for inputs without a relation to one another; `None` for other functions than the square root.
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
        Step::Call("sqrt", arguments) => value(recorder, *arguments.first()?, set)?.sqrt(),
        Step::Call(..) => return None,
    })
}
