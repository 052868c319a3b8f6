//! Replacing symbols by expressions, all at once.

use super::{Expr, Node, Symbol};
use std::collections::BTreeMap;

/// Symbols and what replaces them; the replacement happens in one sweep and is canonical again.
///
/// ```
/// use sneddon_expr::expr::{Bindings, Expr};
/// let f = Expr::symbol("C") * Expr::symbol("r").power(2);
/// let set = Bindings::from_iter([("C", Expr::integer(3))]);
/// assert_eq!(set.apply(&f), Expr::integer(3) * Expr::symbol("r").power(2));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Bindings(BTreeMap<Symbol, Expr>);

impl Bindings {
    /// Adds or replaces one binding.
    pub fn insert(&mut self, symbol: Symbol, value: Expr) {
        self.0.insert(symbol, value);
    }

    /// One binding alone.
    pub fn one(name: &str, value: Expr) -> Self {
        Self::from_iter([(name, value)])
    }

    /// The replacement of the symbol, if any.
    pub fn get(&self, symbol: &Symbol) -> Option<&Expr> {
        self.0.get(symbol)
    }

    /// The bound symbols and their values, by name.
    pub fn iter(&self) -> impl Iterator<Item = (&Symbol, &Expr)> {
        self.0.iter()
    }

    /// True if nothing is bound.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The expression with every bound symbol replaced.
    pub fn apply(&self, expr: &Expr) -> Expr {
        if self.0.is_empty() {
            return expr.clone();
        }
        match expr.node() {
            Node::Number(_) | Node::Constant(_) => expr.clone(),
            Node::Symbol(symbol) => self.0.get(symbol).cloned().unwrap_or_else(|| expr.clone()),
            Node::Power(base, exponent) => self.apply(base).pow(&self.apply(exponent)),
            Node::Function(function, arguments) => Expr::function(*function, arguments.iter().map(|a| self.apply(a)).collect()),
            Node::Product(factors) => Expr::product(factors.iter().map(|f| self.apply(f))),
            Node::Sum(terms) => Expr::sum(terms.iter().map(|t| self.apply(t))),
        }
    }
}

impl<'a> FromIterator<(&'a str, Expr)> for Bindings {
    fn from_iter<I: IntoIterator<Item = (&'a str, Expr)>>(pairs: I) -> Self {
        Self(pairs.into_iter().map(|(name, value)| (Symbol::new(name), value)).collect())
    }
}
