//! Differences from a constant that a value approaches: k - k sqrt(1 - u), k exp(u) - k, k - k/(1 + u), k - k cos(u).

use super::{Recorder, Step};
use crate::code::tree::Operator;
use crate::eval::{Algebra, PreciseAlgebra};
use crate::num::Precise;

/// The largest relative difference of constants that are equal up to the rounding of 30 digits.
const SAME: f64 = 1e-28;

/// A value and whether it is subtracted.
type Term = (u32, bool);

/// The sum of `a` and `b`, or `a` less `b`, without cancellation, if a term of one is a constant and a term of the other differs from
/// the opposite constant by a product.
pub(super) fn sum(recorder: &mut Recorder, a: u32, b: u32, is_subtracted: bool) -> Option<u32> {
    let (one, other) = (terms(recorder, a, false), terms(recorder, b, is_subtracted));
    let (i, j, pair) = one.iter().enumerate().find_map(|(i, own)| {
        other.iter().enumerate().find_map(|(j, more)| Some((i, j, pair(recorder, *own, *more).or_else(|| pair(recorder, *more, *own))?)))
    })?;
    let without = |list: Vec<Term>, at: usize| list.into_iter().enumerate().filter(move |own| own.0 != at).map(|own| own.1);
    let mut total = pair;
    for term in without(one, i).chain(without(other, j)) {
        total = joined(recorder, total, term);
    }
    let (place, is_negative) = total;
    Some(if is_negative { recorder.negative(place) } else { place })
}

/// A constant and a value that differs from its opposite by a product, as one term.
fn pair(recorder: &mut Recorder, constant: Term, value: Term) -> Option<Term> {
    let known = recorder.known(constant.0)?;
    let limit = limit(recorder, value.0).filter(|_| recorder.known(value.0).is_none())?;
    let rest = if constant.1 == value.1 { PreciseAlgebra.add(known, limit) } else { PreciseAlgebra.subtract(known, limit) };
    if rest.value.hi.abs() > SAME * known.value.hi.abs() {
        return None;
    }
    let (place, is_negative) = below(recorder, value.0)?;
    // The value is the limit less this.
    Some((place, is_negative == value.1))
}

/// The terms of a sum; the value itself if it is none.
fn terms(recorder: &Recorder, place: u32, is_negative: bool) -> Vec<Term> {
    match recorder.steps.get(place as usize) {
        Some(Step::Binary(Operator::Add, one, other)) => {
            [terms(recorder, *one, is_negative), terms(recorder, *other, is_negative)].concat()
        }
        Some(Step::Binary(Operator::Subtract, one, other)) => {
            [terms(recorder, *one, is_negative), terms(recorder, *other, !is_negative)].concat()
        }
        _ => vec![(place, is_negative)],
    }
}

fn joined(recorder: &mut Recorder, one: Term, other: Term) -> Term {
    match (one.1, other.1) {
        (is_negative, same) if is_negative == same => (recorder.add(one.0, other.0), is_negative),
        (false, _) => (recorder.subtract(one.0, other.0), false),
        (true, _) => (recorder.subtract(other.0, one.0), false),
    }
}

/// The constant that [`below`] takes as the limit of a value.
fn limit(recorder: &Recorder, place: u32) -> Option<Precise> {
    if let Some(known) = recorder.known(place) {
        return Some(known);
    }
    let at = |own: &u32| limit(recorder, *own);
    match recorder.steps.get(place as usize)? {
        Step::Binary(Operator::Add, one, other) => match (recorder.known(*one), recorder.known(*other)) {
            (Some(known), None) | (None, Some(known)) => Some(known),
            _ => at(one),
        },
        Step::Binary(Operator::Subtract, one, _) => at(one),
        Step::Binary(Operator::Multiply, one, other) => Some(PreciseAlgebra.multiply(at(one)?, at(other)?)),
        Step::Binary(Operator::Divide, one, other) => Some(PreciseAlgebra.divide(recorder.known(*one)?, at(other)?)),
        Step::Call("sqrt", arguments) => Some(PreciseAlgebra.square_root(at(arguments.first()?)?)),
        Step::Call("exp" | "cos" | "cosh", _) => Some(Precise::exact(1.0)),
        _ => None,
    }
    .filter(|own| own.is_finite() && own.value.hi != 0.0)
}

/// The limit less the value, as a product or a sum of terms of one sign.
fn below(recorder: &mut Recorder, place: u32) -> Option<Term> {
    let step = recorder.steps.get(place as usize)?.clone();
    Some(match step {
        Step::Binary(Operator::Add, one, other) => match (recorder.known(one), recorder.known(other)) {
            (Some(_), None) => (other, true),
            (None, Some(_)) => (one, true),
            _ => {
                let (rest, _) = below(recorder, one).filter(|own| own.1)?;
                (recorder.add(rest, other), true)
            }
        },
        Step::Binary(Operator::Subtract, one, other) => match recorder.known(one) {
            Some(_) => (other, false),
            None => {
                let (rest, _) = below(recorder, one).filter(|own| !own.1)?;
                (recorder.add(rest, other), false)
            }
        },
        Step::Binary(Operator::Multiply, one, other) => {
            if let Some(square) = square(recorder, one, other).or_else(|| square(recorder, other, one)) {
                return Some((square, false));
            }
            let of_one = if recorder.known(one).is_some() { None } else { below(recorder, one) };
            let of_other = if recorder.known(other).is_some() { None } else { below(recorder, other) };
            let scaled = |recorder: &mut Recorder, factor: u32, own: Term| (recorder.multiply(factor, own.0), own.1);
            let constant = |recorder: &mut Recorder, own: u32| limit(recorder, own).map(|own| recorder.constant(own));
            match (of_one, of_other) {
                (Some(own), None) => scaled(recorder, other, own),
                (None, Some(own)) => scaled(recorder, one, own),
                // l m - x y = l (m - y) + y (l - x)
                (Some(first), Some(second)) if first.1 == second.1 => {
                    let factor = constant(recorder, one)?;
                    let (left, right) = (scaled(recorder, factor, second), scaled(recorder, other, first));
                    joined(recorder, left, right)
                }
                _ => return None,
            }
        }
        // n/l - n/s = -(n/l) (l - s)/s
        Step::Binary(Operator::Divide, one, other) => {
            let factor = limit(recorder, place).map(|own| recorder.constant(own))?;
            recorder.known(one)?;
            let (rest, is_negative) = below(recorder, other)?;
            let part = recorder.divide(rest, other);
            (recorder.multiply(factor, part), !is_negative)
        }
        Step::Call("sqrt", arguments) => {
            let (rest, is_negative) = below(recorder, *arguments.first()?)?;
            let root = limit(recorder, place).map(|own| recorder.constant(own))?;
            let both = recorder.add(root, place);
            (recorder.divide(rest, both), is_negative)
        }
        Step::Call("exp", arguments) => (recorder.named("expm1", &arguments), true),
        // 1 - cos(u) = 2 sin(u/2)^2
        Step::Call(name @ ("cos" | "cosh"), arguments) => {
            let (two, half) = (recorder.number(2.0), recorder.number(0.5));
            let argument = recorder.multiply(half, *arguments.first()?);
            let wave = recorder.named(if name == "cos" { "sin" } else { "sinh" }, &[argument]);
            let square = recorder.multiply(wave, wave);
            (recorder.multiply(two, square), name == "cosh")
        }
        _ => return None,
    })
}

/// The square of t if the factors are c - t and c + t.
fn square(recorder: &mut Recorder, one: u32, other: u32) -> Option<u32> {
    let Step::Binary(Operator::Subtract, c, t) = *recorder.steps.get(one as usize)? else { return None };
    let Step::Binary(Operator::Add, left, right) = *recorder.steps.get(other as usize)? else { return None };
    let is_same = recorder.known(c).is_some() && ((left, right) == (c, t) || (left, right) == (t, c));
    is_same.then(|| recorder.multiply(t, t))
}
