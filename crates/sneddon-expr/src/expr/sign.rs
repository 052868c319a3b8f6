//! Signs that are proven for positive symbols, and signs of constants from their values.

use super::{Constant, Expr, Node};

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
        Node::Constant(Constant::Cut) => Sign::Unknown,
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

/// The sign of an expression, from its numeric value if necessary, as for 1 − π.
pub(crate) fn known_sign(expr: &Expr) -> Sign {
    match sign(expr) {
        Sign::Unknown => match value(expr) {
            Some(value) if value > 0.0 => Sign::Positive,
            Some(value) if value < 0.0 => Sign::Negative,
            _ => Sign::Unknown,
        },
        known => known,
    }
}

/// True if `left` < `right` is known.
pub(crate) fn is_known_below(left: &Expr, right: &Expr) -> bool {
    known_sign(&(right - left)) == Sign::Positive
}

/// The value of a closed constant of moderate size, where rounding cannot have changed its sign.
fn value(expr: &Expr) -> Option<f64> {
    const LARGEST: f64 = 1e6;
    const CANCELLED: f64 = 1e-9;
    let value = match expr.node() {
        Node::Number(number) => number.to_f64(),
        Node::Constant(Constant::Pi) => std::f64::consts::PI,
        Node::Constant(Constant::Euler) => std::f64::consts::E,
        Node::Symbol(_) | Node::Constant(Constant::Cut) => return None,
        Node::Power(base, exponent) => value(base)?.powf(value(exponent)?),
        Node::Function(function, arguments) => {
            let arguments = arguments.iter().map(value).collect::<Option<Vec<f64>>>()?;
            (function.row().value)(&arguments)
        }
        Node::Product(factors) => factors.iter().map(value).product::<Option<f64>>()?,
        Node::Sum(terms) => {
            let terms = terms.iter().map(value).collect::<Option<Vec<f64>>>()?;
            let (sum, size) = terms.iter().fold((0.0, 0.0), |(sum, size), term| (sum + term, size + term.abs()));
            if sum.abs() < CANCELLED * size {
                return None;
            }
            sum
        }
    };
    (CANCELLED..LARGEST).contains(&value.abs()).then_some(value)
}
