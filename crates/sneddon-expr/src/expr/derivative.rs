//! Exact differentiation by the rules of sums, products, powers and the function table.

use super::{Expr, ExprError, Node, Symbol};
use std::collections::HashMap;

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
    Derivatives { symbol, known: HashMap::new() }.of(expr)
}

/// The derivatives of the parts of one expression, many of which occur repeatedly.
struct Derivatives<'a> {
    symbol: &'a Symbol,
    known: HashMap<Expr, Expr>,
}

impl Derivatives<'_> {
    fn of(&mut self, expr: &Expr) -> Result<Expr, ExprError> {
        if !expr.contains(self.symbol) {
            return Ok(Expr::zero());
        }
        if let Some(known) = self.known.get(expr) {
            return Ok(known.clone());
        }
        let found = match expr.node() {
            Node::Number(_) | Node::Constant(_) => Expr::zero(),
            Node::Symbol(own) => {
                if own == self.symbol {
                    Expr::one()
                } else {
                    Expr::zero()
                }
            }
            Node::Sum(terms) => Expr::sum(terms.iter().map(|term| self.of(term)).collect::<Result<Vec<_>, _>>()?),
            Node::Product(factors) => self.of_product(factors)?,
            Node::Power(base, exponent) => {
                let mut terms = Vec::new();
                if base.contains(self.symbol) {
                    terms.push(Expr::product([exponent.clone(), base.pow(&(exponent - Expr::one())), self.of(base)?]));
                }
                if exponent.contains(self.symbol) {
                    terms.push(Expr::product([expr.clone(), Expr::call("ln", [base.clone()]), self.of(exponent)?]));
                }
                Expr::sum(terms)
            }
            Node::Function(function, arguments) => {
                let mut terms = Vec::new();
                for (i, argument) in arguments.iter().enumerate() {
                    let inner = self.of(argument)?;
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
                Expr::sum(terms)
            }
        };
        self.known.insert(expr.clone(), found.clone());
        Ok(found)
    }

    fn of_product(&mut self, factors: &[Expr]) -> Result<Expr, ExprError> {
        let (dependent, free): (Vec<&Expr>, Vec<&Expr>) = factors.iter().partition(|factor| factor.contains(self.symbol));
        let outside = Expr::product(free.into_iter().cloned());
        let terms = if dependent.len() > LONG {
            let dependent: Vec<Expr> = dependent.into_iter().cloned().collect();
            let (one, other) = dependent.split_at(dependent.len() / 2);
            let (one, other) = (Expr::product(one.iter().cloned()), Expr::product(other.iter().cloned()));
            vec![self.of(&one)? * &other, one * self.of(&other)?]
        } else {
            let mut terms = Vec::new();
            for (i, factor) in dependent.iter().enumerate() {
                let rest = dependent.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, own)| (*own).clone());
                terms.push(Expr::product(rest.chain([self.of(factor)?])));
            }
            terms
        };
        Ok(Expr::sum(terms.into_iter().map(|term| &outside * term)))
    }
}

/// Longer products are halved: (AB)′ = A′B + AB′ has n log n factors, and the sum over all factors n².
const LONG: usize = 6;
