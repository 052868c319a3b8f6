//! Errors to first order: what the rounding of every operation adds to a result, with the signs with which it comes back.

use crate::code::tree::Operator;
use crate::num::Bounded;
use std::collections::HashMap;

/// Relative errors up to here are propagated by derivatives, which neglect their squares.
const SMALL: f64 = 1e-4;

/// The operations of one or more runs; equal operations on equal operands are recorded once, because they round in the same way.
///
/// A running bound takes the error of every operation as independent. Here an argument k·a that is rounded once, and occurs in
/// two terms that depend on it with opposite signs, counts with their difference.
#[derive(Default)]
pub(super) struct Record<'a> {
    nodes: Vec<Node>,
    places: HashMap<Key<'a>, usize>,
}

struct Node {
    /// Bound on the error that begins here.
    own: f64,
    /// The places of operands, with the derivatives by them.
    operands: Vec<(usize, f64)>,
}

/// The most operands of operations that are recognized when they occur again.
const FEW: usize = 2;

#[derive(PartialEq, Eq, Hash)]
enum Key<'a> {
    /// The bits of the value and of its error.
    Leaf(u64, u64),
    Operation(Operation<'a>, [usize; FEW]),
}

/// What is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Operation<'a> {
    Binary(Operator),
    /// A function of the language or its library.
    Call(&'a str),
}

impl<'a> Record<'a> {
    /// The place of a number that has no operands.
    pub(super) fn leaf(&mut self, own: Bounded) -> usize {
        self.place(Key::Leaf(own.value.to_bits(), own.error.to_bits()), || Node { own: own.error, operands: Vec::new() })
    }

    /// The place of a result with its running bound; `compute` gives the result of operands.
    pub(super) fn operation(
        &mut self,
        operation: Operation<'a>,
        operands: &[(usize, Bounded)],
        result: Bounded,
        compute: impl Fn(&[Bounded]) -> Bounded,
    ) -> usize {
        let node = || {
            let is_linear = matches!(operation, Operation::Binary(Operator::Add | Operator::Subtract));
            let mut close = operands.iter().map(|(_, own)| own.error <= SMALL * extent(operation, own.value));
            let is_close = match operation {
                // The rest of second order is small if one factor has a small error, or the divisor.
                Operation::Binary(Operator::Multiply) => close.any(|own| own),
                Operation::Binary(Operator::Divide) => close.nth(1).unwrap_or(false),
                _ => close.all(|own| own),
            };
            let slopes = if is_linear || is_close { derivatives(operation, operands, result.value) } else { None };
            match slopes.filter(|list| list.iter().all(|own| own.is_finite())) {
                Some(slopes) => {
                    let exact: Vec<Bounded> = operands.iter().map(|(_, own)| Bounded::exact(own.value)).collect();
                    Node { own: compute(&exact).error, operands: operands.iter().map(|own| own.0).zip(slopes).collect() }
                }
                // The running bound contains the errors of the operands.
                None => Node { own: result.error, operands: Vec::new() },
            }
        };
        let mut places = [usize::MAX; FEW];
        if operands.len() > FEW {
            self.nodes.push(node());
            return self.nodes.len() - 1;
        }
        places.iter_mut().zip(operands).for_each(|(place, own)| *place = own.0);
        if matches!(operation, Operation::Binary(Operator::Add | Operator::Multiply)) {
            places.sort_unstable();
        }
        self.place(Key::Operation(operation, places), node)
    }

    fn place(&mut self, key: Key<'a>, node: impl FnOnce() -> Node) -> usize {
        let next = self.nodes.len();
        let place = *self.places.entry(key).or_insert(next);
        if place == next {
            self.nodes.push(node());
        }
        place
    }

    /// A bound on the error of a sum of results times factors; `None` if it overflows.
    pub(super) fn error(&self, sum: &[(usize, f64)]) -> Option<f64> {
        let mut share = vec![0.0; self.nodes.len()];
        for (place, factor) in sum {
            *share.get_mut(*place)? += factor;
        }
        let mut total = 0.0;
        for (place, node) in self.nodes.iter().enumerate().rev() {
            let own = *share.get(place)?;
            if own == 0.0 {
                continue;
            }
            total += node.own * f64::abs(own);
            for (operand, slope) in &node.operands {
                *share.get_mut(*operand)? += own * slope;
            }
        }
        total.is_finite().then_some(total * (1.0 + 8.0 * SMALL))
    }
}

/// The distance over which an operation is far from linear: that to a singularity, or over which the result grows several times.
fn extent(operation: Operation<'_>, value: f64) -> f64 {
    let size = value.abs();
    match operation {
        Operation::Call("sin" | "cos" | "tan" | "exp" | "expm1" | "sinh" | "cosh" | "tanh") => size.min(1.0),
        Operation::Call("asin" | "acos" | "atanh") => size.min(1.0 - size),
        Operation::Call("log1p") => size.min(1.0 + value),
        _ => size,
    }
}

/// The derivatives by the operands; `None` for functions whose derivative is not known here.
fn derivatives(operation: Operation<'_>, operands: &[(usize, Bounded)], result: f64) -> Option<Vec<f64>> {
    let values: Vec<f64> = operands.iter().map(|own| own.1.value).collect();
    Some(match (operation, values.as_slice()) {
        (Operation::Binary(operator), [a, b]) => match operator {
            Operator::Add => vec![1.0, 1.0],
            Operator::Subtract => vec![1.0, -1.0],
            Operator::Multiply => vec![*b, *a],
            Operator::Divide => vec![1.0 / b, -result / b],
        },
        (Operation::Call("pow"), [a, b]) => {
            let is_exact = operands.get(1).is_some_and(|own| own.1.error == 0.0);
            vec![b * result / a, if is_exact { 0.0 } else { result * a.ln() }]
        }
        (Operation::Call("atan2"), [a, b]) => {
            let size = a.hypot(*b);
            vec![b / size / size, -a / size / size]
        }
        (Operation::Call(name), [a]) => vec![match name {
            "exp" => result,
            "expm1" => result + 1.0,
            "log" => 1.0 / a,
            "log1p" => 1.0 / (1.0 + a),
            "sin" => a.cos(),
            "cos" => -a.sin(),
            "tan" => 1.0 + result * result,
            "asin" => 1.0 / ((1.0 - a) * (1.0 + a)).sqrt(),
            "acos" => -1.0 / ((1.0 - a) * (1.0 + a)).sqrt(),
            "atan" => 1.0 / (1.0 + a * a),
            "sinh" => a.cosh(),
            "cosh" => a.sinh(),
            "tanh" => 1.0 / a.cosh() / a.cosh(),
            "asinh" => 1.0 / a.hypot(1.0),
            "atanh" => 1.0 / ((1.0 - a) * (1.0 + a)),
            "sqrt" => 0.5 / result,
            "abs" => a.signum(),
            _ => return None,
        }],
        _ => return None,
    })
}
