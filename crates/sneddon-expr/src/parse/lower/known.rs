//! Signs that are known: proven ones, and those of closed constants by their value.

use crate::expr::{Constant, Expr, Node, Sign, sign};

/// The sign of an expression, from its numeric value if necessary, as for 1 − π.
pub(super) fn known_sign(expr: &Expr) -> Sign {
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
pub(super) fn below(left: &Expr, right: &Expr) -> bool {
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
        Node::Symbol(_) => return None,
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
