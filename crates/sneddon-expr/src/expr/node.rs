//! The expression tree: seven kinds of node behind a shared pointer.

use super::{Function, Number, build};
use crate::num::work;
use std::collections::{BTreeSet, HashSet};
use std::fmt;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::Arc;

/// An immutable expression; cloning shares the tree.
///
/// Build it with the operators and the named constructors: they keep the canonical form.
/// Equality and order are by content, so equal trees are equal wherever they were built.
///
/// ```
/// use sneddon_expr::expr::Expr;
/// let r = Expr::symbol("r");
/// assert_eq!(&r * &r, r.power(2));
/// assert_eq!(&r + &r - Expr::integer(2) * &r, Expr::zero());
/// ```
#[derive(Clone)]
pub struct Expr(Arc<Tree>);

/// A node with what is known of the whole tree below it.
struct Tree {
    node: Node,
    /// The number of levels down to the deepest leaf.
    levels: u32,
    /// A hash of the content.
    hash: u64,
    /// The symbols that occur, sorted by name; shared with an operand that has the same.
    symbols: Option<Arc<[Symbol]>>,
}

/// Equal trees hash equally: the hash is one of the content alone.
impl Hash for Expr {
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write_u64(self.0.hash);
    }
}

/// The kinds of node; obtained by matching on [`Expr::node`], never built directly.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Node {
    /// An exact rational number.
    Number(Number),
    /// π or e.
    Constant(Constant),
    /// A positive real parameter or variable.
    Symbol(Symbol),
    /// A power, base and exponent.
    Power(Expr, Expr),
    /// A function of the table with its arguments.
    Function(Function, Vec<Expr>),
    /// A product: at most one number, and that first; no nested products.
    Product(Vec<Expr>),
    /// A sum of collected terms; no nested sums.
    Sum(Vec<Expr>),
}

/// The named constants, and what is no number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Constant {
    /// π = 3.14159…
    Pi,
    /// Euler's number e = 2.71828…
    Euler,
    /// What constructors return beyond the work limit.
    ///
    /// It has neither a value nor a sign, no tape is compiled from it, the mark that stands for it in a printed formula is not read back,
    /// and no sum, product, power or function of it is anything else, so that it never cancels.
    Cut,
}

/// The name of a parameter or variable.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symbol(Arc<str>);

impl Symbol {
    /// A symbol of the given name.
    pub fn new(name: &str) -> Self {
        Self(Arc::from(name))
    }

    /// A symbol that is printed with the given name but differs from the symbol of that name, as no name that is read can end in an
    /// apostrophe: a constant beside a variable that the field calls the same.
    ///
    /// ```
    /// use sneddon_expr::{expr::{Bindings, Expr, Symbol}, print::text_expr};
    /// let rim = Expr::from(Symbol::homonym("a"));
    /// let quotient = Expr::symbol("a") / &rim;
    /// assert_eq!(text_expr(&quotient), "a/a");
    /// assert_eq!(Bindings::one("a", Expr::integer(2)).apply(&quotient), Expr::integer(2) / rim);
    /// ```
    pub fn homonym(name: &str) -> Self {
        Self(Arc::from(format!("{name}'")))
    }

    /// Its name, by which it is compared.
    pub fn name(&self) -> &str {
        &self.0
    }

    /// The name under which it is printed.
    pub fn shown(&self) -> &str {
        self.0.trim_end_matches('\'')
    }
}

impl fmt::Display for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.shown())
    }
}

/// Steps of work that one node costs, from its construction to its end …
const NODE: u64 = 22;
/// … and each of its operands, which is sorted and compared.
const CHILD: u64 = 5;

impl Expr {
    pub(super) fn raw(node: Node) -> Self {
        let mut hasher = DefaultHasher::new();
        node.hash(&mut hasher);
        let (children, levels, symbols) = match &node {
            Node::Number(_) | Node::Constant(_) => (0, 0, None),
            Node::Symbol(symbol) => (0, 0, Some(Arc::from([symbol.clone()]))),
            Node::Power(base, exponent) => (0, base.levels().max(exponent.levels()), symbols_of([base, exponent].into_iter())),
            Node::Function(_, list) | Node::Product(list) | Node::Sum(list) => {
                (list.len(), list.iter().map(Self::levels).max().unwrap_or_default(), symbols_of(list.iter()))
            }
        };
        work::spend(NODE + CHILD * children as u64);
        Self(Arc::new(Tree { hash: hasher.finish(), symbols, levels: levels.saturating_add(1), node }))
    }

    /// The hash of the content.
    pub(super) fn content_hash(&self) -> u64 {
        self.0.hash
    }

    /// The number of levels of the tree.
    pub(super) fn levels(&self) -> u32 {
        self.0.levels
    }

    /// The node at the top of the tree.
    pub fn node(&self) -> &Node {
        &self.0.node
    }

    /// The address of the shared node, for tables that recognise shared subtrees within one run.
    pub fn address(&self) -> usize {
        Arc::as_ptr(&self.0).addr()
    }

    /// A number.
    pub fn number(number: Number) -> Self {
        Self::raw(Node::Number(number))
    }

    /// A whole number.
    pub fn integer(n: i64) -> Self {
        Self::number(Number::integer(n))
    }

    /// The fraction p/q, `q` ≠ 0.
    pub fn ratio(p: i64, q: i64) -> Self {
        Self::number(Number::ratio(p, q))
    }

    /// 0.
    pub fn zero() -> Self {
        Self::integer(0)
    }

    /// 1.
    pub fn one() -> Self {
        Self::integer(1)
    }

    /// π.
    pub fn pi() -> Self {
        Self::raw(Node::Constant(Constant::Pi))
    }

    /// Euler's number.
    pub fn euler() -> Self {
        Self::raw(Node::Constant(Constant::Euler))
    }

    /// The symbol of the given name.
    pub fn symbol(name: &str) -> Self {
        Self::raw(Node::Symbol(Symbol::new(name)))
    }

    /// The sum of the terms.
    pub fn sum(terms: impl IntoIterator<Item = Expr>) -> Self {
        build::sum(terms)
    }

    /// The product of the factors.
    pub fn product(factors: impl IntoIterator<Item = Expr>) -> Self {
        build::product(factors)
    }

    /// The power `self`^`exponent`.
    pub fn pow(&self, exponent: &Expr) -> Self {
        build::power(self, exponent)
    }

    /// The whole power `self`^n.
    pub fn power(&self, n: i64) -> Self {
        build::power(self, &Self::integer(n))
    }

    /// The square root.
    pub fn sqrt(&self) -> Self {
        build::power(self, &Self::ratio(1, 2))
    }

    /// The reciprocal.
    pub fn recip(&self) -> Self {
        self.power(-1)
    }

    /// The function `function` of the arguments.
    pub fn function(function: Function, arguments: Vec<Expr>) -> Self {
        build::function(function, arguments)
    }

    /// The function of the table called `name`, for names that are written in the source.
    ///
    /// A name that the table lacks gives a plain symbol; `tests/symbols/functions.rs` reads the sources and finds every such call.
    pub fn call(name: &'static str, arguments: impl IntoIterator<Item = Expr>) -> Self {
        match Function::named(name) {
            Some(function) => build::function(function, arguments.into_iter().collect()),
            None => Self::symbol(name),
        }
    }

    /// The number, where the expression is one.
    pub fn as_number(&self) -> Option<&Number> {
        match self.node() {
            Node::Number(number) => Some(number),
            _ => None,
        }
    }

    /// The whole number, where the expression is one that fits.
    pub fn as_integer(&self) -> Option<i64> {
        self.as_number().and_then(Number::to_i64)
    }

    /// The symbol, where the expression is one.
    pub fn as_symbol(&self) -> Option<&Symbol> {
        match self.node() {
            Node::Symbol(symbol) => Some(symbol),
            _ => None,
        }
    }

    /// True for the number 0.
    pub fn is_zero(&self) -> bool {
        self.as_number().is_some_and(Number::is_zero)
    }

    /// True if the work limit ended the construction; see [`Constant::Cut`].
    pub fn is_cut(&self) -> bool {
        matches!(self.node(), Node::Constant(Constant::Cut))
    }

    /// True for the number 1.
    pub fn is_one(&self) -> bool {
        self.as_number().is_some_and(Number::is_one)
    }

    /// The direct subexpressions.
    pub fn children(&self) -> Vec<&Expr> {
        match self.node() {
            Node::Number(_) | Node::Constant(_) | Node::Symbol(_) => Vec::new(),
            Node::Power(base, exponent) => vec![base, exponent],
            Node::Function(_, arguments) | Node::Product(arguments) | Node::Sum(arguments) => arguments.iter().collect(),
        }
    }

    /// The expression and all expressions in it, each shared one once, from the outside in.
    ///
    /// ```
    /// use sneddon_expr::expr::Expr;
    /// let x = Expr::symbol("x");
    /// let twice = Expr::call("sin", [x.clone()]) + Expr::call("cos", [x.clone()]);
    /// assert_eq!(twice.parts().filter(|own| **own == x).count(), 1);
    /// ```
    pub fn parts(&self) -> impl Iterator<Item = &Self> {
        let (mut pending, mut seen) = (vec![self], HashSet::new());
        std::iter::from_fn(move || {
            loop {
                let own = pending.pop()?;
                if seen.insert(own.address()) {
                    pending.extend(own.children().into_iter().rev());
                    return Some(own);
                }
            }
        })
    }

    /// True if the symbol occurs.
    pub fn contains(&self, symbol: &Symbol) -> bool {
        self.0.symbols.as_ref().is_some_and(|own| own.binary_search(symbol).is_ok())
    }

    /// Every symbol that occurs, sorted by name.
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        self.0.symbols.iter().flat_map(|own| own.iter()).cloned().collect()
    }

    /// The number of nodes, counted up to `limit`.
    pub fn size_up_to(&self, limit: usize) -> usize {
        let mut count = 1;
        for child in self.children() {
            if count >= limit {
                return limit;
            }
            count += child.size_up_to(limit - count);
        }
        count.min(limit)
    }

    /// Numeric factor and the rest: `3 x y` is (3, `x y`).
    pub fn split_coefficient(&self) -> (Number, Expr) {
        build::split_coefficient(self)
    }

    /// Base and exponent: `x^2` is (`x`, 2), `x` is (`x`, 1), `exp(u)` is (`e`, `u`).
    pub fn split_power(&self) -> (Expr, Expr) {
        build::split_power(self)
    }

    /// The factors of a product; the expression itself otherwise.
    pub fn factors(&self) -> Vec<Expr> {
        match self.node() {
            Node::Product(factors) => factors.clone(),
            _ => vec![self.clone()],
        }
    }

    /// The terms of a sum; the expression itself otherwise.
    pub fn terms(&self) -> Vec<Expr> {
        match self.node() {
            Node::Sum(terms) => terms.clone(),
            _ => vec![self.clone()],
        }
    }
}

/// The symbols of all operands.
fn symbols_of<'a>(operands: impl Iterator<Item = &'a Expr> + Clone) -> Option<Arc<[Symbol]>> {
    let sets = operands.filter_map(|own| own.0.symbols.as_ref());
    let most = sets.clone().max_by_key(|own| own.len())?;
    let is_part = |own: &Arc<[Symbol]>| Arc::ptr_eq(own, most) || own.iter().all(|symbol| most.binary_search(symbol).is_ok());
    if sets.clone().all(is_part) {
        return Some(Arc::clone(most));
    }
    Some(sets.flat_map(|own| own.iter()).collect::<BTreeSet<_>>().into_iter().cloned().collect())
}

impl fmt::Debug for Expr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.node() {
            Node::Number(n) => write!(f, "{}", n.value()),
            Node::Constant(c) => write!(f, "{c:?}"),
            Node::Symbol(s) => write!(f, "{s}"),
            Node::Power(base, exponent) => write!(f, "({base:?})^({exponent:?})"),
            Node::Function(function, arguments) => write!(f, "{}{arguments:?}", function.name()),
            Node::Product(factors) => write!(f, "prod{factors:?}"),
            Node::Sum(terms) => write!(f, "sum{terms:?}"),
        }
    }
}

impl From<Number> for Expr {
    fn from(number: Number) -> Self {
        Self::number(number)
    }
}

impl From<i64> for Expr {
    fn from(n: i64) -> Self {
        Self::integer(n)
    }
}

impl From<Symbol> for Expr {
    fn from(symbol: Symbol) -> Self {
        Self::raw(Node::Symbol(symbol))
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $left:ident, $right:ident, $body:expr) => {
        impl $trait<&Expr> for &Expr {
            type Output = Expr;
            fn $method(self, other: &Expr) -> Expr {
                let ($left, $right) = (self, other);
                $body
            }
        }
        impl $trait<Expr> for Expr {
            type Output = Expr;
            fn $method(self, other: Expr) -> Expr {
                (&self).$method(&other)
            }
        }
        impl $trait<&Expr> for Expr {
            type Output = Expr;
            fn $method(self, other: &Expr) -> Expr {
                (&self).$method(other)
            }
        }
        impl $trait<Expr> for &Expr {
            type Output = Expr;
            fn $method(self, other: Expr) -> Expr {
                self.$method(&other)
            }
        }
    };
}

operator!(Add, add, left, right, build::sum([left.clone(), right.clone()]));
operator!(Sub, sub, left, right, build::sum([left.clone(), -right]));
operator!(Mul, mul, left, right, build::product([left.clone(), right.clone()]));
operator!(Div, div, left, right, build::product([left.clone(), right.recip()]));

impl Neg for &Expr {
    type Output = Expr;
    fn neg(self) -> Expr {
        build::product([Expr::integer(-1), self.clone()])
    }
}

impl Neg for Expr {
    type Output = Expr;
    fn neg(self) -> Expr {
        -&self
    }
}
