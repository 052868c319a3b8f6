//! Quotients of growing exponentials, rewritten so that numerator and denominator do not overflow together.

use super::{Expr, Node, Sign, Symbol, rewritten, sign};

/// An equal expression in which exponential growth e^u of a numerator is moved into a denominator that grows as well:
/// e^u/(1 + e^u)² becomes 1/(4 cosh²(u/2)), and sinh u/cosh² u becomes tanh u/cosh u. If a denominator then overflows, the
/// quotient is 0.
///
/// ```
/// use sneddon_expr::expr::{Expr, balanced};
/// let u = Expr::symbol("r");
/// let slope = Expr::call("sinh", [u.clone()]) / Expr::call("cosh", [u.clone()]).power(2);
/// assert_eq!(balanced(&slope), Expr::call("tanh", [u.clone()]) / Expr::call("cosh", [u]));
/// ```
pub fn balanced(expr: &Expr) -> Expr {
    if !divides_by_growth(expr) {
        return expr.clone();
    }
    rewritten(expr, &|own, again| match own.node() {
        Node::Power(base, exponent) => Some(again(base).pow(exponent)),
        Node::Product(factors) => Some(quotient(factors.iter().map(again).collect())),
        _ => None,
    })
}

/// True if a denominator grows exponentially.
fn divides_by_growth(expr: &Expr) -> bool {
    expr.parts().any(|own| match own.node() {
        Node::Power(base, exponent) => exponent.as_number().is_some_and(|own| own.is_negative()) && grows(base),
        _ => false,
    })
}

fn grows(expr: &Expr) -> bool {
    expr.parts().any(|own| match own.node() {
        Node::Function(function, arguments) => {
            matches!(function.name(), "exp" | "cosh") && arguments.iter().any(|argument| argument.contains(&Symbol::new("r")))
        }
        _ => false,
    })
}

/// The product with its exponentials moved into the denominators that grow with them.
fn quotient(factors: Vec<Expr>) -> Expr {
    let mut factors = hyperbolic(factors);
    let growing = factors.iter().position(|factor| argument(factor, "exp").is_some_and(|own| own.contains(&Symbol::new("r"))));
    let Some((place, w)) = growing.and_then(|place| Some((place, argument(factors.get(place)?, "exp")?))) else {
        return Expr::product(factors);
    };
    for factor in &mut factors {
        let (base, exponent) = factor.split_power();
        let Some(n) = exponent.as_integer().filter(|n| *n < 0) else { continue };
        let Node::Sum(terms) = base.node() else { continue };
        if !terms.iter().any(|term| grows_like(term, &w)) {
            continue;
        }
        let share = Expr::call("exp", [&w * Expr::ratio(1, n)]);
        *factor = folded(&Expr::sum(terms.iter().map(|term| term * &share))).pow(&exponent);
        factors.remove(place);
        break;
    }
    Expr::product(factors)
}

/// a e^u + b e^(−u) with positive a and b as 2√(ab) cosh(u + ½ ln(a/b)), whose derivatives are balanced in their turn.
fn folded(sum: &Expr) -> Expr {
    let radius = Symbol::new("r");
    let part = |term: &Expr| {
        let (exponentials, rest): (Vec<Expr>, Vec<Expr>) = term.factors().into_iter().partition(|factor| argument(factor, "exp").is_some());
        let [exponential] = exponentials.as_slice() else { return None };
        let (u, coefficient) = (argument(exponential, "exp")?, Expr::product(rest));
        (sign(&coefficient) == Sign::Positive && !coefficient.contains(&radius)).then_some((u, coefficient))
    };
    let parts: Option<Vec<(Expr, Expr)>> = sum.terms().iter().map(part).collect();
    match parts.as_deref() {
        Some([(u, a), (v, b)]) if (u + v).is_zero() => {
            let shift = if a == b { Expr::zero() } else { Expr::call("ln", [a / b]) / Expr::integer(2) };
            Expr::integer(2) * (a * b).pow(&Expr::ratio(1, 2)) * Expr::call("cosh", [u + shift])
        }
        _ => sum.clone(),
    }
}

/// True if the term has e to a positive multiple of `w` as a factor.
fn grows_like(term: &Expr, w: &Expr) -> bool {
    term.factors().iter().filter_map(|factor| argument(factor, "exp")).any(|own| (own / w).as_number().is_some_and(|k| k.is_positive()))
}

/// sinhᵐ u/coshⁿ u as a power of tanh u and one of cosh u.
fn hyperbolic(mut factors: Vec<Expr>) -> Vec<Expr> {
    for index in 0..factors.len() {
        let Some(factor) = factors.get(index) else { continue };
        let (base, m) = factor.split_power();
        let (Some(u), Some(m)) = (argument(&base, "sinh"), m.as_integer().filter(|m| *m > 0)) else { continue };
        let below = factors.iter().position(|own| {
            let (base, n) = own.split_power();
            argument(&base, "cosh").as_ref() == Some(&u) && n.as_integer().is_some_and(|n| n <= -m)
        });
        let Some(below) = below else { continue };
        if let Some(own) = factors.get_mut(below) {
            *own = own.clone() * Expr::call("cosh", [u.clone()]).power(m);
        }
        if let Some(own) = factors.get_mut(index) {
            *own = Expr::call("tanh", [u]).power(m);
        }
    }
    factors
}

/// The argument of a call of this function.
fn argument(expr: &Expr, name: &str) -> Option<Expr> {
    match expr.node() {
        Node::Function(function, arguments) if function.name() == name => arguments.first().cloned(),
        _ => None,
    }
}
