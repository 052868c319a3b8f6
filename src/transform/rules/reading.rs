//! What rules read from a term: monomials, linear and quadratic polynomials in r, powers of them, calls, and what must be positive.

use crate::expr::{Condition, Expr, Node, Sign, Symbol, normal, sign};

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
pub(crate) fn quadratic(expr: &Expr) -> Option<(Expr, Expr)> {
    match normal::polynomial_coefficients(expr, &radius())?.as_slice() {
        [alpha, middle, beta] if middle.is_zero() && !alpha.is_zero() => Some((alpha.clone(), beta.clone())),
        _ => None,
    }
}

/// Base and exponent of a power; an expression that is none is its own first power.
pub(crate) fn power(expr: &Expr) -> (Expr, Expr) {
    match expr.node() {
        Node::Power(base, exponent) => (base.clone(), exponent.clone()),
        _ => (expr.clone(), Expr::one()),
    }
}

/// The two factors of a product.
pub(super) fn pair(expr: &Expr) -> Option<(&Expr, &Expr)> {
    match expr.node() {
        Node::Product(factors) => match factors.as_slice() {
            [first, second] => Some((first, second)),
            _ => None,
        },
        _ => None,
    }
}

/// The exponential and the other one of two factors, whose order is that of their contents.
pub(super) fn exponential_pair(expr: &Expr) -> Option<(&Expr, &Expr)> {
    let (first, second) = pair(expr)?;
    Some(if call(first, "exp").is_some() { (first, second) } else { (second, first) })
}

/// What must hold for an expression to be positive; `None` where it is not.
pub(crate) fn positive(expr: &Expr) -> Option<Vec<Condition>> {
    above(expr, 0)
}

/// What must hold for an expression to exceed a whole number; `None` where it does not.
pub(super) fn above(expr: &Expr, bound: i64) -> Option<Vec<Condition>> {
    match sign(&(expr - Expr::integer(bound))) {
        Sign::Positive => Some(Vec::new()),
        Sign::Unknown => Some(vec![Condition::less(Expr::integer(bound), expr.clone())]),
        Sign::Zero | Sign::Negative => None,
    }
}

/// The arguments of a call of the named function.
pub(super) fn call<'a>(expr: &'a Expr, name: &str) -> Option<&'a [Expr]> {
    match expr.node() {
        Node::Function(function, arguments) if function.name() == name => Some(arguments),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kernels_are_read_by_their_content() {
        let (r, w) = (Expr::symbol("r"), Expr::symbol("w"));
        let two = Expr::integer(2);
        assert_eq!(monomial(&(&r * &two / &w)), Some((&two / &w, Expr::one())));
        assert_eq!(linear(&(&w + &two * &r)), Some((w.clone(), two.clone())));
        assert_eq!(quadratic(&(w.power(2) - r.power(2))), Some((w.power(2), Expr::integer(-1))));
        for declined in [&r + &w, r.power(2), r.clone() + r.power(2)] {
            assert_eq!(quadratic(&declined), None, "{declined:?}");
        }
        assert_eq!(power(&r.power(3)), (r.clone(), Expr::integer(3)));
        assert_eq!(power(&w), (w.clone(), Expr::one()));
        let [exponential, error] = ["exp", "erf"].map(|name| Expr::call(name, [r.clone()]));
        let product = &exponential * &error;
        assert_eq!(exponential_pair(&product), Some((&exponential, &error)));
        assert_eq!(pair(&exponential), None);
    }

    #[test]
    fn what_is_not_known_to_be_positive_becomes_a_condition() {
        let (n, zero) = (Expr::symbol("n"), Expr::zero());
        assert_eq!(positive(&n), Some(Vec::new()));
        assert_eq!(positive(&-&n), None);
        assert_eq!(positive(&zero), None);
        assert_eq!(above(&zero, -1), Some(Vec::new()));
        let open = &n - Expr::one();
        assert_eq!(positive(&open), Some(vec![Condition::less(zero, open.clone())]));
        assert_eq!(above(&open, -1), Some(Vec::new()));
        assert_eq!(above(&(&n - Expr::integer(3)), -1), Some(vec![Condition::less(Expr::integer(-1), n - Expr::integer(3))]));
    }
}
