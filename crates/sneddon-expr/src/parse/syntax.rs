//! What was typed, operands before operators: a tree laid flat, so that no depth of nesting needs a stack of calls.

use crate::expr::Number;
use std::ops::Range;

/// An operand, or an operator that takes the operands before it; with its place, operands included.
#[derive(Debug)]
pub(super) struct Item {
    pub(super) kind: Kind,
    pub(super) span: Range<usize>,
}

/// The kinds of item; parentheses only widen the span of an item.
#[derive(Debug)]
pub(super) enum Kind {
    Number(Number),
    Name(String),
    Negation,
    /// One entry per term; true marks one that is subtracted.
    Sum(Vec<bool>),
    /// One entry per factor; true marks a divisor.
    Product(Vec<bool>),
    /// Base before exponent.
    Power,
    /// The widened span of a parenthesised operand.
    Group,
    Call {
        name: String,
        name_span: Range<usize>,
        arguments: usize,
    },
    /// Two sides; true if the first one is the larger.
    Comparison(bool),
    /// A bracketed list with its number of entries, an argument of `hyper`.
    List(usize),
}
