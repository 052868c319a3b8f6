//! What rules read from a kernel: monomials, linear and quadratic polynomials in r, and powers of them.

use crate::expr::{Expr, Node, Symbol, normal};

fn radius() -> Symbol {
    Symbol::new("r")
}

/// k and α of k·r^α with k free of r and not zero.
pub(super) fn monomial(expr: &Expr) -> Option<(Expr, Expr)> {
    let terms = normal::normal_terms(expr, &radius()).ok()?;
    match terms.as_slice() {
        [only] if only.kernel.is_one() && !only.exponent.contains(&radius()) => Some((only.coefficient.clone(), only.exponent.clone())),
        _ => None,
    }
}

/// w and β of w + β r with neither zero.
pub(super) fn linear(expr: &Expr) -> Option<(Expr, Expr)> {
    match normal::polynomial_coefficients(expr, &radius())?.as_slice() {
        [w, beta] if !w.is_zero() => Some((w.clone(), beta.clone())),
        _ => None,
    }
}

/// α and β of α + β r² with neither zero.
pub(super) fn quadratic(expr: &Expr) -> Option<(Expr, Expr)> {
    match normal::polynomial_coefficients(expr, &radius())?.as_slice() {
        [alpha, middle, beta] if middle.is_zero() && !alpha.is_zero() => Some((alpha.clone(), beta.clone())),
        _ => None,
    }
}

/// Base and exponent of a power; an expression that is none is its own first power.
pub(super) fn power(expr: &Expr) -> (Expr, Expr) {
    match expr.node() {
        Node::Power(base, exponent) => (base.clone(), exponent.clone()),
        _ => (expr.clone(), Expr::one()),
    }
}

/// The arguments of a call of the named function.
pub(super) fn call<'a>(expr: &'a Expr, name: &str) -> Option<&'a [Expr]> {
    match expr.node() {
        Node::Function(function, arguments) if function.name() == name => Some(arguments),
        _ => None,
    }
}
