//! What is provable about signs when every symbol is a positive real number.

use super::{Expr, Node};

/// The sign of an expression; `Unknown` is never a silent yes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// Proven greater than 0.
    Positive,
    /// Proven less than 0.
    Negative,
    /// The number 0.
    Zero,
    /// Not proven either way.
    Unknown,
}

impl Sign {
    /// The sign of the negated expression.
    pub fn negated(self) -> Self {
        match self {
            Self::Positive => Self::Negative,
            Self::Negative => Self::Positive,
            other => other,
        }
    }

    /// The sign of a product.
    pub fn times(self, other: Self) -> Self {
        match (self, other) {
            (Self::Zero, _) | (_, Self::Zero) => Self::Zero,
            (Self::Unknown, _) | (_, Self::Unknown) => Self::Unknown,
            (a, b) if a == b => Self::Positive,
            _ => Self::Negative,
        }
    }
}

/// The sign of `expr`, wherever it is defined.
pub fn sign(expr: &Expr) -> Sign {
    match expr.node() {
        Node::Number(number) if number.is_zero() => Sign::Zero,
        Node::Number(number) if number.is_negative() => Sign::Negative,
        Node::Number(_) | Node::Constant(_) | Node::Symbol(_) => Sign::Positive,
        Node::Sum(terms) => terms.iter().map(sign).reduce(|a, b| if a == b { a } else { Sign::Unknown }).unwrap_or(Sign::Zero),
        Node::Product(factors) => factors.iter().map(sign).fold(Sign::Positive, Sign::times),
        Node::Power(base, exponent) => match (sign(base), exponent.as_integer()) {
            (Sign::Positive, _) => Sign::Positive,
            (Sign::Negative, Some(n)) if n % 2 == 0 => Sign::Positive,
            (Sign::Negative, Some(_)) => Sign::Negative,
            _ => Sign::Unknown,
        },
        Node::Function(function, arguments) => function.row().sign.map_or(Sign::Unknown, |rule| rule(arguments)),
    }
}
