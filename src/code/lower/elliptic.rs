//! Differences of Legendre's elliptic integrals, which cancel, as one of Carlson's.
//!
//! With the parameter m, F - E is m times the integral of sin(t)^2/sqrt(1 - m sin(t)^2), and (1 - m) F - E is -m times that of
//! cos(t)^2/sqrt(1 - m sin(t)^2).

use super::equal::equal;
use super::{Recorder, Step};
use crate::code::tree::Operator;
use crate::eval::Algebra;

/// The integrals of the first and of the second kind, F - E, and the integral with the squared cosine.
const KINDS: [[&str; 4]; 2] = [
    ["ellipk", "ellipe", "ellipk_less_ellipe", "ellipk_of_cosine"],
    ["ellipf", "ellipe_incomplete", "ellipf_less_ellipe", "ellipf_of_cosine"],
];

/// A function, its arguments and the factor in front of it.
type Multiple = (&'static str, Vec<u32>, u32);

/// The sum `a` less `b` without cancellation, if both have an integral with the same arguments and with factors that fit.
pub(super) fn difference(recorder: &mut Recorder, a: u32, b: u32) -> Option<u32> {
    let (name, arguments, factor) = multiple(recorder, b)?;
    let [first, second, sine, cosine] = *KINDS.iter().find(|own| own.iter().take(2).any(|own| *own == name))?;
    let wanted = if name == first { second } else { first };
    let terms = terms(recorder, a);
    let (place, other) = terms.iter().enumerate().find_map(|(place, own)| {
        let (called, list, other) = multiple(recorder, *own)?;
        (called == wanted && list == arguments).then_some((place, other))
    })?;
    let (of_first, of_second) = if name == first { (factor, other) } else { (other, factor) };
    let parameter = *arguments.last()?;
    let one = recorder.number(1.0);
    let rest = recorder.subtract(one, parameter);
    let scaled = product(recorder, of_second, rest);
    // The value of the first kind less that of the second one, up to a sign.
    let (factor, written, is_negative) = if equal(recorder, of_first, of_second) {
        (of_second, sine, false)
    } else if equal(recorder, of_first, scaled) {
        (product(recorder, of_second, parameter), cosine, true)
    } else {
        return None;
    };
    let integral = recorder.named(written, &arguments);
    let own = product(recorder, factor, integral);
    let mut others: Option<u32> = None;
    for term in terms.iter().enumerate().filter(|(index, _)| *index != place).map(|(_, own)| *own) {
        others = Some(others.map_or(term, |sum| recorder.add(sum, term)));
    }
    let is_added = is_negative == (name == first);
    Some(match (others, is_added) {
        (None, true) => own,
        (None, false) => {
            let zero = recorder.number(0.0);
            recorder.push(Step::Binary(Operator::Subtract, zero, own))
        }
        (Some(others), true) => recorder.add(others, own),
        (Some(others), false) => recorder.binary(Operator::Subtract, others, own),
    })
}

/// A value as the multiple of an elliptic integral.
fn multiple(recorder: &mut Recorder, place: u32) -> Option<Multiple> {
    match recorder.steps.get(place as usize)?.clone() {
        Step::Call(name, arguments) if KINDS.iter().any(|own| own.contains(&name)) => Some((name, arguments, recorder.number(1.0))),
        Step::Binary(Operator::Multiply, one, other) => {
            let (found, more) = match multiple(recorder, one) {
                Some(found) => (found, other),
                None => (multiple(recorder, other)?, one),
            };
            let (name, arguments, factor) = found;
            Some((name, arguments, product(recorder, factor, more)))
        }
        Step::Binary(Operator::Divide, one, other) => {
            let (name, arguments, factor) = multiple(recorder, one)?;
            Some((name, arguments, recorder.divide(factor, other)))
        }
        _ => None,
    }
}

/// A product; a factor of 1 is left out.
fn product(recorder: &mut Recorder, factor: u32, other: u32) -> u32 {
    if recorder.is(factor, 1.0) { other } else { recorder.multiply(factor, other) }
}

/// The terms of a sum; the value itself if it is none.
fn terms(recorder: &Recorder, place: u32) -> Vec<u32> {
    match recorder.steps.get(place as usize) {
        Some(Step::Binary(Operator::Add, one, other)) => [terms(recorder, *one), terms(recorder, *other)].concat(),
        _ => vec![place],
    }
}
