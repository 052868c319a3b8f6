//! Exact differentiation by the rules of sums, products, powers and the function table.

use super::{Expr, ExprError, Node, Symbol};

/// d(`expr`)/d(`symbol`).
///
/// # Errors
/// [`ExprError::NoDerivative`] if a function row states no derivative for an argument that depends on the symbol.
///
/// ```
/// use sneddon_expr::expr::{derivative, Expr, Symbol};
/// let r = Expr::symbol("r");
/// let slope = derivative(&r.power(3), &Symbol::new("r")).unwrap();
/// assert_eq!(slope, Expr::integer(3) * r.power(2));
/// let slope = derivative(&Expr::call("ln", [Expr::call("cosh", [r.clone()])]), &Symbol::new("r")).unwrap();
/// assert_eq!(slope, Expr::call("tanh", [r]));
/// ```
pub fn derivative(expr: &Expr, symbol: &Symbol) -> Result<Expr, ExprError> {
    if !expr.contains(symbol) {
        return Ok(Expr::zero());
    }
    match expr.node() {
        Node::Number(_) | Node::Constant(_) => Ok(Expr::zero()),
        Node::Symbol(own) => Ok(if own == symbol { Expr::one() } else { Expr::zero() }),
        Node::Sum(terms) => Ok(Expr::sum(terms.iter().map(|t| derivative(t, symbol)).collect::<Result<Vec<_>, _>>()?)),
        Node::Product(factors) => of_product(factors, symbol),
        Node::Power(base, exponent) => {
            let mut terms = Vec::new();
            if base.contains(symbol) {
                terms.push(Expr::product([exponent.clone(), base.pow(&(exponent - Expr::one())), derivative(base, symbol)?]));
            }
            if exponent.contains(symbol) {
                terms.push(Expr::product([expr.clone(), Expr::call("ln", [base.clone()]), derivative(exponent, symbol)?]));
            }
            Ok(Expr::sum(terms))
        }
        Node::Function(function, arguments) => {
            let mut terms = Vec::new();
            for (i, argument) in arguments.iter().enumerate() {
                let inner = derivative(argument, symbol)?;
                if inner.is_zero() {
                    continue;
                }
                let row = function.row();
                let outer = row
                    .derivative
                    .and_then(|rule| rule(arguments, i))
                    .ok_or(ExprError::NoDerivative { function: row.name, argument: i + 1 })?;
                terms.push(outer * inner);
            }
            Ok(Expr::sum(terms))
        }
    }
}

/// Longer products are halved: (AB)′ = A′B + AB′ has n log n factors, and the sum over all factors n².
const LONG: usize = 6;

fn of_product(factors: &[Expr], symbol: &Symbol) -> Result<Expr, ExprError> {
    let (dependent, free): (Vec<&Expr>, Vec<&Expr>) = factors.iter().partition(|factor| factor.contains(symbol));
    let outside = Expr::product(free.into_iter().cloned());
    let terms = if dependent.len() > LONG {
        let dependent: Vec<Expr> = dependent.into_iter().cloned().collect();
        let (one, other) = dependent.split_at(dependent.len() / 2);
        let (one, other) = (Expr::product(one.iter().cloned()), Expr::product(other.iter().cloned()));
        vec![derivative(&one, symbol)? * &other, one * derivative(&other, symbol)?]
    } else {
        let mut terms = Vec::new();
        for (i, factor) in dependent.iter().enumerate() {
            let rest = dependent.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, own)| (*own).clone());
            terms.push(Expr::product(rest.chain([derivative(factor, symbol)?])));
        }
        terms
    };
    Ok(Expr::sum(terms.into_iter().map(|term| &outside * term)))
}
