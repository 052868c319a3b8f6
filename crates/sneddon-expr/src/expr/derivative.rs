//! Exact differentiation by the rules of sums, products, powers and the function table.

use super::{Expr, ExprError, Function, Node, Symbol};
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
    /// By address, because 0.5 equals 1/2 and is printed in another way; each part is kept, so that its address is not reused.
    known: HashMap<usize, (Expr, Expr)>,
}

impl Derivatives<'_> {
    fn of(&mut self, expr: &Expr) -> Result<Expr, ExprError> {
        if !expr.contains(self.symbol) {
            return Ok(Expr::zero());
        }
        if let Some((_, known)) = self.known.get(&expr.address()) {
            return Ok(known.clone());
        }
        let (mut factors, inner) = self.chain(expr)?;
        let found = if inner == *expr {
            self.of_node(expr)?
        } else {
            factors.push(self.of(&inner)?);
            Expr::product(factors)
        };
        self.known.insert(expr.address(), (expr.clone(), found.clone()));
        Ok(found)
    }

    /// The factors of the chain rule down to the first part that depends on the symbol in several operands, and that part.
    ///
    /// Multiplied level by level, they would be sorted again for each level.
    fn chain(&self, expr: &Expr) -> Result<(Vec<Expr>, Expr), ExprError> {
        let (mut factors, mut own) = (Vec::new(), expr.clone());
        loop {
            let children = own.children();
            let mut dependent = children.iter().enumerate().filter(|(_, child)| child.contains(self.symbol));
            let (Some((i, inner)), None) = (dependent.next(), dependent.next()) else { return Ok((factors, own)) };
            match own.node() {
                Node::Power(base, exponent) if i == 0 => factors.extend([exponent.clone(), base.pow(&(exponent - Expr::one()))]),
                Node::Power(base, _) => factors.extend([own.clone(), Expr::call("ln", [base.clone()])]),
                Node::Function(function, arguments) => factors.push(outer(*function, arguments, i)?),
                Node::Product(list) => factors.extend(list.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, other)| other.clone())),
                Node::Sum(_) => {}
                Node::Number(_) | Node::Constant(_) | Node::Symbol(_) => return Ok((factors, own)),
            }
            own = (*inner).clone();
        }
    }

    fn of_node(&mut self, expr: &Expr) -> Result<Expr, ExprError> {
        match expr.node() {
            // It contains the symbol.
            Node::Number(_) | Node::Constant(_) | Node::Symbol(_) => Ok(Expr::one()),
            Node::Sum(terms) => Ok(Expr::sum(terms.iter().map(|term| self.of(term)).collect::<Result<Vec<_>, _>>()?)),
            Node::Product(factors) => self.of_product(factors),
            Node::Power(base, exponent) => {
                let of_base = Expr::product([exponent.clone(), base.pow(&(exponent - Expr::one())), self.of(base)?]);
                let of_exponent = Expr::product([expr.clone(), Expr::call("ln", [base.clone()]), self.of(exponent)?]);
                Ok(of_base + of_exponent)
            }
            Node::Function(function, arguments) => {
                let mut terms = Vec::new();
                for (i, argument) in arguments.iter().enumerate() {
                    let inner = self.of(argument)?;
                    if !inner.is_zero() {
                        terms.push(outer(*function, arguments, i)? * inner);
                    }
                }
                Ok(Expr::sum(terms))
            }
        }
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

/// The derivative of a function with respect to its i-th argument.
fn outer(function: Function, arguments: &[Expr], i: usize) -> Result<Expr, ExprError> {
    let row = function.row();
    let found = row.derivative.and_then(|rule| rule(arguments, i));
    found.ok_or(ExprError::NoDerivative { function: row.name, argument: i + 1 })
}

/// Longer products are halved: (AB)′ = A′B + AB′ has n log n factors, and the sum over all factors n².
const LONG: usize = 6;
