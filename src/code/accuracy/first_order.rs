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
pub(super) struct Record {
    /// Node 0 represents every exact number.
    nodes: Vec<Node>,
    /// The places of numbers without operands and of results.
    places: HashMap<(u64, u64, u64), usize, BuildHasherDefault<Folded>>,
}

/// The index of the node of exact numbers.
const EXACT: usize = 0;

impl Default for Record {
    fn default() -> Self {
        Self { nodes: vec![Node::alone(0.0)], places: HashMap::default() }
    }
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
        for byte in bytes {
            self.write_u64(u64::from(*byte));
        }
    }

    #[inline]
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

/// What is computed.
#[derive(Clone, Copy, Debug)]
pub(super) enum Operation<'a> {
    Binary(Operator),
    /// A function of the language or its library, with a number for its name.
    Call(&'a str, u64),
}

impl<'a> Operation<'a> {
    /// The function of this name.
    pub(super) fn call(name: &'a str) -> Self {
        let mut number = Folded::default();
        number.write(name.as_bytes());
        Self::Call(name, number.finish())
    }

    #[inline]
    fn number(self) -> u64 {
        match self {
            Self::Binary(operator) => operator as u64,
            Self::Call(_, number) => number,
        }
    }
}

impl Record {
    /// Forgets all operations and keeps the memory.
    pub(super) fn clear(&mut self) {
        self.nodes.truncate(EXACT + 1);
        self.places.clear();
    }

    /// The place of a number that has no operands.
    #[inline]
    pub(super) fn leaf(&mut self, own: Bounded) -> usize {
        if own.error == 0.0 {
            return EXACT;
        }
        let nodes = &mut self.nodes;
        let key = (LEAF, own.value.to_bits(), own.error.to_bits());
        *self.places.entry(key).or_insert_with(|| added(nodes, Node::alone(own.error)))
    }

    /// The place of a result with its running bound; `compute` gives the result of operands.
    pub(super) fn operation(
        &mut self,
        operation: Operation<'_>,
        operands: &[(usize, Bounded)],
        result: Bounded,
        compute: impl Fn(&[Bounded]) -> Bounded,
    ) -> usize {
        if result.error == 0.0 {
            return EXACT;
        }
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
        let (first, second) = match operands {
            [one] => (word(*one), ABSENT),
            [one, other] => (word(*one), word(*other)),
            _ => return added(&mut self.nodes, node()),
        };
        let is_symmetric = matches!(operation, Operation::Binary(Operator::Add | Operator::Multiply));
        let (first, second) = if is_symmetric && second < first { (second, first) } else { (first, second) };
        let nodes = &mut self.nodes;
        *self.places.entry((operation.number(), first, second)).or_insert_with(|| added(nodes, node()))
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

/// The first word of the key of a number without operands, and the word of an operand that does not exist.
const LEAF: u64 = u64::MAX;
const ABSENT: u64 = u64::MAX;
/// The bits of a NaN, which no operand is: they mark a place.
const PLACE: u64 = 0xfff8 << 48;

/// The word of an operand in a key: the bits of an exact number, else its place.
#[inline]
fn word((place, own): (usize, Bounded)) -> u64 {
    if place == EXACT { own.value.to_bits() } else { PLACE | place as u64 }
}

/// Adds a node and returns its place.
fn added(nodes: &mut Vec<Node>, node: Node) -> usize {
    nodes.push(node);
    nodes.len() - 1
}

/// The distance over which an operation is far from linear: that to a singularity, or over which the result grows several times.
fn extent(operation: Operation<'_>, value: f64) -> f64 {
    let size = value.abs();
    match operation {
        Operation::Call("sin" | "cos" | "tan" | "exp" | "expm1" | "sinh" | "cosh" | "tanh", _) => size.min(1.0),
        Operation::Call("asin" | "acos" | "atanh", _) => size.min(1.0 - size),
        Operation::Call("log1p", _) => size.min(1.0 + value),
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
        (Operation::Call("pow", _), Some((b, error))) => [b * result / a, if error == 0.0 { 0.0 } else { result * a.ln() }],
        (Operation::Call("atan2", _), Some((b, _))) => {
            let size = a.hypot(b);
            [b / size / size, -a / size / size]
        }
        (Operation::Call(name, _), None) => {
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
