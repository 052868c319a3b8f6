//! What rules read from a term: monomials, linear and quadratic polynomials in r, powers of them, calls, and what must be
//! positive.

use crate::expr::normal::{self, NormalTerm};
use crate::expr::{Condition, Expr, Node, Sign, Symbol, sign};
use sneddon_num::work;
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

type Terms = Option<Rc<[NormalTerm]>>;

thread_local! {
    static KNOWN: RefCell<Option<HashMap<Expr, Terms>>> = const { RefCell::new(None) };
}

/// Runs work with a cache, so that each expression is brought to its recognition form only once for all rules.
///
/// Nothing is kept longer, so that the steps of a call do not depend on earlier calls.
pub(crate) fn remembered<T>(work: impl FnOnce() -> T) -> T {
    struct Restored(Option<HashMap<Expr, Terms>>);
    impl Drop for Restored {
        fn drop(&mut self) {
            KNOWN.set(self.0.take());
        }
    }
    let _restored = Restored(KNOWN.replace(Some(HashMap::new())));
    work()
}

/// The recognition form in r; `None` if it would be too large.
fn normal_terms(expr: &Expr) -> Terms {
    if let Some(terms) = KNOWN.with_borrow(|known| known.as_ref()?.get(expr).cloned()) {
        return terms;
    }
    let terms: Terms = normal::normal_terms(expr, &Symbol::new("r")).ok().map(Rc::from);
    KNOWN.with_borrow_mut(|known| known.as_mut().filter(|_| !work::is_exhausted()).map(|known| known.insert(expr.clone(), terms.clone())));
    terms
}

/// k and α of k·r^α with k free of r and not zero.
pub fn monomial(expr: &Expr) -> Option<(Expr, Expr)> {
    match normal_terms(expr)?.as_ref() {
        [only] if only.kernel.is_one() && !only.exponent.contains(&Symbol::new("r")) => {
            Some((only.coefficient.clone(), only.exponent.clone()))
        }
        _ => None,
    }
}

/// w and β of w + β r with neither zero.
pub fn linear(expr: &Expr) -> Option<(Expr, Expr)> {
    match normal::coefficients(&normal_terms(expr)?)?.as_slice() {
        [w, beta] if !w.is_zero() => Some((w.clone(), beta.clone())),
        _ => None,
    }
}

/// α and β of α + β r² with neither zero.
pub fn quadratic(expr: &Expr) -> Option<(Expr, Expr)> {
    match normal::coefficients(&normal_terms(expr)?)?.as_slice() {
        [alpha, middle, beta] if middle.is_zero() && !alpha.is_zero() => Some((alpha.clone(), beta.clone())),
        _ => None,
    }
}

/// Base and exponent of a power; any other expression has the exponent 1.
pub fn power(expr: &Expr) -> (Expr, Expr) {
    match expr.node() {
        Node::Power(base, exponent) => (base.clone(), exponent.clone()),
        _ => (expr.clone(), Expr::one()),
    }
}

/// The two factors of a product.
pub fn pair(expr: &Expr) -> Option<(&Expr, &Expr)> {
    match expr.node() {
        Node::Product(factors) => match factors.as_slice() {
            [first, second] => Some((first, second)),
            _ => None,
        },
        _ => None,
    }
}

/// The exponential and the other one of two factors, whose order is that of their contents.
pub fn exponential_pair(expr: &Expr) -> Option<(&Expr, &Expr)> {
    let (first, second) = pair(expr)?;
    Some(if call(first, "exp").is_some() { (first, second) } else { (second, first) })
}

/// The conditions for an expression to be positive; `None` if it is not positive.
pub fn positive(expr: &Expr) -> Option<Vec<Condition>> {
    above(expr, 0)
}

/// The conditions for an expression to exceed a whole number; `None` if it does not.
pub fn above(expr: &Expr, bound: i64) -> Option<Vec<Condition>> {
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
