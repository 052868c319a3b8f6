//! Common factors of sums and lists.

use super::polynomial::{Monomial, Polynomial};
use super::{is_sum, sparse};
use crate::expr::{Expr, ExprError, Node, Number};
use std::collections::BTreeMap;

/// The common factor of the expressions, and the cofactor of each; the cofactor of zero is zero.
///
/// ```
/// use sneddon_expr::expr::{Expr, normal::common_content};
/// let (h, b) = (Expr::symbol("h"), Expr::symbol("b"));
/// let (content, rest) = common_content(&[Expr::integer(-2) * &h * &b, Expr::integer(4) * &h]);
/// assert_eq!(content, Expr::integer(2) * &h);
/// assert_eq!(rest, [-b, Expr::integer(2)]);
/// ```
pub fn common_content(list: &[Expr]) -> (Expr, Vec<Expr>) {
    let present: Vec<&Expr> = list.iter().filter(|own| !own.is_zero()).collect();
    let (first, others) = match present.as_slice() {
        [] => return (Expr::one(), list.to_vec()),
        [only] => {
            let left = |own: &Expr| if own.is_zero() { Expr::zero() } else { Expr::one() };
            return ((*only).clone(), list.iter().map(left).collect());
        }
        [first, others @ ..] => (first, others),
    };
    let everywhere = |factor: &Expr| others.iter().all(|own| own.terms().iter().all(|term| term.factors().contains(factor)));
    let own = |factor: &Expr| first.terms().iter().all(|term| term.factors().contains(factor));
    let candidates = first.terms().first().map(Expr::factors).unwrap_or_default();
    let mut content: Vec<Expr> = candidates.into_iter().filter(|f| f.as_number().is_none() && own(f) && everywhere(f)).collect();
    let numbers = present.iter().flat_map(|own| own.terms()).map(|term| term.split_coefficient().0);
    content.push(Expr::number(numbers.reduce(|a, b| a.common_factor(&b)).unwrap_or_else(|| Number::integer(1))));
    let content = Expr::product(content);
    let reduced = list.iter().map(|own| Expr::sum(own.terms().iter().map(|term| term / &content))).collect();
    (content, reduced)
}

/// A sum with its common factor taken out: C n − C m is C (n − m).
pub(super) fn factored(expr: &Expr) -> Expr {
    match expr.node() {
        Node::Sum(terms) => {
            let (content, rest) = common_content(terms);
            content * Expr::sum(rest)
        }
        _ => expr.clone(),
    }
}

/// Numerator and denominators of a sum of fractions: the sum times the denominators, and the denominators.
pub(super) fn over_one_denominator(sum: &Polynomial) -> Result<(Polynomial, Monomial), ExprError> {
    let mut denominators: BTreeMap<Expr, Expr> = BTreeMap::new();
    for (monomial, _) in sum.terms() {
        for (atom, power) in monomial.iter().filter(|(atom, _)| is_sum(atom)) {
            if let Some(n) = power.as_integer().filter(|n| *n < 0) {
                let deepest = denominators.get(atom).and_then(Expr::as_integer).unwrap_or(0).max(-n);
                denominators.insert(atom.clone(), Expr::integer(deepest));
            }
        }
    }
    if denominators.is_empty() {
        return Ok((sum.clone(), Monomial::new()));
    }
    let denominators = Monomial::from_iter(denominators);
    let numerator = sum.times(&Polynomial::single(denominators.clone(), Number::integer(1), sum.frame()))?;
    Ok((numerator, denominators))
}

/// A sum of fractions in which common factors of numerator and denominator are cancelled.
pub(super) fn cancelled(sum: Polynomial) -> Result<Polynomial, ExprError> {
    let (mut numerator, denominators) = over_one_denominator(&sum)?;
    if denominators.is_empty() {
        return Ok(sum);
    }
    let mut left = Monomial::new();
    for (atom, power) in denominators {
        let divisor = Polynomial::expand(&atom, sum.frame())?;
        let mut n = power.as_integer().unwrap_or(0);
        while n > 0 && !numerator.is_zero() {
            let Some(quotient) = sparse::quotient(&numerator, &divisor) else { break };
            numerator = quotient;
            n -= 1;
        }
        if n > 0 {
            left.multiply(atom, Expr::integer(-n));
        }
    }
    numerator.times(&Polynomial::single(left, Number::integer(1), sum.frame()))
}
