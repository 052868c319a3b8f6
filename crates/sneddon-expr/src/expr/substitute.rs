//! Replacing symbols and other parts of an expression, each shared part once.

use super::{Expr, Node, Symbol};
use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};

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
        rewritten(expr, &|own, _| match own.as_symbol() {
            Some(symbol) => self.0.get(symbol).cloned(),
            None if self.0.keys().any(|symbol| own.contains(symbol)) => None,
            None => Some(own.clone()),
        })
    }
}

impl<'a> FromIterator<(&'a str, Expr)> for Bindings {
    fn from_iter<I: IntoIterator<Item = (&'a str, Expr)>>(pairs: I) -> Self {
        Self(pairs.into_iter().map(|(name, value)| (Symbol::new(name), value)).collect())
    }
}

/// What a part becomes, given how its own parts are rewritten; `None` if only its operands change.
pub type RewritingRule<'a> = dyn Fn(&Expr, &dyn Fn(&Expr) -> Expr) -> Option<Expr> + 'a;

/// The expression with every part rewritten by the rule, each shared part once.
///
/// ```
/// use sneddon_expr::expr::{Expr, Node, rewritten};
/// let (a, b) = (Expr::symbol("a"), Expr::symbol("b"));
/// let sum = Expr::call("sin", [a.clone()]) + a.power(2);
/// let renamed = rewritten(&sum, &|own, _| (*own == a).then(|| b.clone()));
/// assert_eq!(renamed, Expr::call("sin", [b.clone()]) + b.power(2));
/// // The exponents stay as they are.
/// let bases = rewritten(&a.pow(&a), &|own, again| match own.node() {
///     Node::Power(base, exponent) => Some(again(base).pow(exponent)),
///     _ => (*own == a).then(|| b.clone()),
/// });
/// assert_eq!(bases, b.pow(&a));
/// ```
pub fn rewritten(expr: &Expr, rule: &RewritingRule<'_>) -> Expr {
    Rewriting::new(rule).of(expr)
}

/// A rule and what it made of the parts of several expressions.
pub struct Rewriting<'a> {
    rule: &'a RewritingRule<'a>,
    /// By address, because 0.5 equals 1/2 and is printed in another way; each part is kept, so that its address is not reused.
    known: RefCell<HashMap<usize, (Expr, Expr)>>,
}

impl<'a> Rewriting<'a> {
    /// The rule before it has rewritten anything.
    pub fn new(rule: &'a RewritingRule<'a>) -> Self {
        Self { rule, known: RefCell::default() }
    }

    /// The expression with every part rewritten by the rule, each shared part once.
    pub fn of(&self, expr: &Expr) -> Expr {
        if let Some((_, found)) = self.known.borrow().get(&expr.address()) {
            return found.clone();
        }
        let again = |own: &Expr| self.of(own);
        let found = (self.rule)(expr, &again).unwrap_or_else(|| with_operands(expr, &again));
        self.known.borrow_mut().insert(expr.address(), (expr.clone(), found.clone()));
        found
    }
}

/// The same node over other operands; the expression itself where none of them changes.
fn with_operands(expr: &Expr, of: &dyn Fn(&Expr) -> Expr) -> Expr {
    let old = expr.children();
    let new: Vec<Expr> = old.iter().map(|own| of(own)).collect();
    if old.iter().zip(&new).all(|(old, new)| old.address() == new.address()) {
        return expr.clone();
    }
    match (expr.node(), new.as_slice()) {
        (Node::Power(..), [base, exponent]) => base.pow(exponent),
        (Node::Function(function, _), _) => Expr::function(*function, new),
        (Node::Product(_), _) => Expr::product(new),
        (Node::Sum(_), _) => Expr::sum(new),
        _ => expr.clone(),
    }
}
