//! Errors to first order: what the rounding of every operation adds to a result, with the signs with which it comes back.

use crate::code::tree::Operator;
use crate::num::Bounded;
use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

/// Relative errors up to here are propagated by derivatives, which neglect their squares.
const SMALL: f64 = 1e-4;

/// The operations of one or more runs; equal operations on equal operands are recorded once, because they round in the same way.
///
/// A running bound takes the error of every operation as independent. Here an argument k·a that is rounded once, and occurs in
/// two terms that depend on it with opposite signs, counts with their difference.
#[derive(Default)]
pub(super) struct Record<'a> {
    nodes: Vec<Node>,
    places: HashMap<Key<'a>, usize, BuildHasherDefault<Folded>>,
}

/// A hash of a few words, which takes less time than the operation that is looked up.
#[derive(Default)]
struct Folded(u64);

impl Hasher for Folded {
    fn finish(&self) -> u64 {
        // The table uses the highest and the lowest bits.
        self.0 ^ (self.0 >> 32)
    }

    fn write(&mut self, bytes: &[u8]) {
        for part in bytes.chunks(8) {
            let word = part.iter().rev().fold(0, |word, byte| (word << 8) | u64::from(*byte));
            self.write_u64(word);
        }
    }

    fn write_u64(&mut self, word: u64) {
        self.0 = (self.0.rotate_left(5) ^ word).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    }

    fn write_usize(&mut self, word: usize) {
        self.write_u64(word as u64);
    }
}

struct Node {
    /// Bound on the error that begins here.
    own: f64,
    /// The places of operands, with the derivatives by them; 0 for one that does not exist.
    operands: [(usize, f64); FEW],
}

impl Node {
    /// A result whose error begins here.
    fn alone(own: f64) -> Self {
        Self { own, operands: [(0, 0.0); FEW] }
    }
}

/// The most operands of operations whose derivatives are known, and that are recognized when they occur again.
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
        self.place(Key::Leaf(own.value.to_bits(), own.error.to_bits()), || Node::alone(own.error))
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
            match (slopes.filter(|list| list.iter().all(|own| own.is_finite())), operands) {
                (Some([slope, _]), [one]) => {
                    Node { own: compute(&[Bounded::exact(one.1.value)]).error, operands: [(one.0, slope), (0, 0.0)] }
                }
                (Some([first, second]), [one, other]) => {
                    let exact = [one, other].map(|own| Bounded::exact(own.1.value));
                    Node { own: compute(&exact).error, operands: [(one.0, first), (other.0, second)] }
                }
                // The running bound contains the errors of the operands.
                _ => Node::alone(result.error),
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
            for (operand, slope) in node.operands.iter().filter(|operand| operand.1 != 0.0) {
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

/// The derivatives by one or two operands; `None` for functions whose derivative is not known here.
fn derivatives(operation: Operation<'_>, operands: &[(usize, Bounded)], result: f64) -> Option<[f64; FEW]> {
    let (a, b) = match operands {
        [(_, a)] => (a.value, None),
        [(_, a), (_, b)] => (a.value, Some((b.value, b.error))),
        _ => return None,
    };
    Some(match (operation, b) {
        (Operation::Binary(operator), Some((b, _))) => match operator {
            Operator::Add => [1.0, 1.0],
            Operator::Subtract => [1.0, -1.0],
            Operator::Multiply => [b, a],
            Operator::Divide => [1.0 / b, -result / b],
        },
        (Operation::Call("pow"), Some((b, error))) => [b * result / a, if error == 0.0 { 0.0 } else { result * a.ln() }],
        (Operation::Call("atan2"), Some((b, _))) => {
            let size = a.hypot(b);
            [b / size / size, -a / size / size]
        }
        (Operation::Call(name), None) => {
            let slope = match name {
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
            };
            [slope, 0.0]
        }
        _ => return None,
    })
}
