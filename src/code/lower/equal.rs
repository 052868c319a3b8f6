//! Values that are equal though they are computed in different ways.

use super::{Recorder, Step};
use crate::code::tree::Operator;

/// The largest relative difference of equal values.
pub(super) const CLOSE: f64 = 1e-10;
/// The number of sets of inputs.
pub(super) const SETS: usize = 3;

/// Whether two values are the same function of the inputs, judged at a few of them.
pub(super) fn equal(recorder: &Recorder, one: u32, other: u32) -> bool {
    let all = samples(recorder);
    let at = |place: u32| all.get(place as usize).and_then(Option::as_ref);
    at(one).zip(at(other)).is_some_and(|(one, other)| one.iter().zip(other).all(|(one, other)| (one - other).abs() <= CLOSE * one.abs()))
}

/// The values of every step for a few sets of inputs without a relation to one another; `None` where one of them is not finite, and for
/// other functions than powers and logarithms.
pub(super) fn samples(recorder: &Recorder) -> Vec<Option<[f64; SETS]>> {
    let mut all: Vec<Option<[f64; SETS]>> = Vec::with_capacity(recorder.steps.len());
    for step in &recorder.steps {
        let get = |place: &u32| all.get(*place as usize).copied().flatten();
        let own = match step {
            Step::Constant(hi, ..) => Some([f64::from_bits(*hi); SETS]),
            Step::Input(index) => Some(std::array::from_fn(|set| 0.3 + (2.399_963 * (index + 5 * set) as f64).sin().powi(2))),
            Step::Binary(operator, one, other) => get(one).zip(get(other)).map(|(one, other)| {
                std::array::from_fn(|set| match operator {
                    Operator::Add => one[set] + other[set],
                    Operator::Subtract => one[set] - other[set],
                    Operator::Multiply => one[set] * other[set],
                    Operator::Divide => one[set] / other[set],
                })
            }),
            Step::Call(name, arguments) => match (*name, arguments.as_slice()) {
                ("sqrt", [own]) => get(own).map(|own| own.map(f64::sqrt)),
                ("log", [own]) => get(own).map(|own| own.map(f64::ln)),
                ("pow", [base, exponent]) => {
                    get(base).zip(get(exponent)).map(|(base, exponent)| std::array::from_fn(|set| base[set].powf(exponent[set])))
                }
                _ => None,
            },
        };
        all.push(own.filter(|own| own.iter().all(|own| own.is_finite())));
    }
    all
}
