//! The order of reading: factors of a product, terms of a sum.

use super::layout::{Factor, layout};
use crate::expr::{Expr, Function, Node};
use crate::num::work;
use crate::print::notations::latex_symbol;
use std::cell::RefCell;
use std::cmp::{Ordering, Reverse};
use std::collections::HashMap;

/// The kinds of factor in the order in which they are printed.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Rank {
    Number,
    NumberPower,
    Constant,
    Modulus,
    Parameter,
    Variable,
    Sum,
    Root,
    Exponential,
    Function,
}

/// Variables of every formula; other symbols are parameters.
const VARIABLES: [&str; 4] = ["a", "d", "r", "x"];

impl Rank {
    pub(super) fn of(factor: &Factor) -> Self {
        match factor.base.node() {
            Node::Number(_) if factor.exponent.is_one() => Self::Number,
            Node::Number(_) => Self::NumberPower,
            Node::Constant(_) => Self::Constant,
            Node::Symbol(symbol) if symbol.name() == "E" => Self::Modulus,
            Node::Symbol(symbol) if VARIABLES.contains(&symbol.name()) => Self::Variable,
            Node::Symbol(_) => Self::Parameter,
            // Γ(7/4) stands with the numbers, while w ln 2 is customary.
            Node::Function(function, _) if function.name() == "gamma" && factor.base.symbols().is_empty() => Self::Constant,
            Node::Function(function, _) if function.name() == "exp" => Self::Exponential,
            Node::Function(..) => Self::Function,
            Node::Sum(_) if factor.whole().is_some() => Self::Sum,
            // √(2R) is sorted like R.
            Node::Product(inner) if factor.root().is_some() => {
                let ranks = inner.iter().map(|base| Self::of(&Factor { base: base.clone(), exponent: Expr::one() }));
                ranks.max().filter(|rank| *rank <= Self::Variable).unwrap_or(Self::Root)
            }
            Node::Sum(_) | Node::Product(_) | Node::Power(..) => Self::Root,
        }
    }
}

/// The order of factors: by kind, symbols and functions by name, all others by content.
pub(super) fn factors(left: &Factor, right: &Factor) -> Ordering {
    let by_rank = Rank::of(left).cmp(&Rank::of(right));
    let by_name = || name(&left.base).cmp(&name(&right.base));
    let by_content = || (&left.base, &left.exponent).cmp(&(&right.base, &right.exponent));
    // h √(2R), d √(d/C).
    let is_joint_root = |factor: &Factor| matches!(factor.base.node(), Node::Product(_));
    let by_root = || is_joint_root(left).cmp(&is_joint_root(right));
    by_rank.then_with(by_root).then_with(by_name).then_with(by_content)
}

/// Latin letters before Greek ones, regardless of case first.
fn name(base: &Expr) -> (bool, String, &str) {
    let name = match base.node() {
        Node::Symbol(symbol) => symbol.name(),
        Node::Function(function, _) => function.name(),
        _ => "",
    };
    let letter = name.split('_').next().unwrap_or(name);
    (latex_symbol::is_greek(letter), name.to_lowercase(), name)
}

/// The arguments of a function in their customary order: |r − b| instead of |b − r|, cos(kr − φ) instead of cos(φ − kr).
pub(super) fn arguments(function: Function, arguments: &[Expr]) -> Vec<Expr> {
    match arguments {
        [argument] if EVEN.contains(&function.name()) && natural(argument).first().is_some_and(is_negative) => vec![-argument],
        _ => arguments.to_vec(),
    }
}

/// Even functions, whose argument may be negated.
const EVEN: [&str; 3] = ["abs", "cos", "cosh"];

fn is_negative(term: &Expr) -> bool {
    term.split_coefficient().0.is_negative()
}

/// The terms of a sum in the order of reading.
///
/// Polynomial terms by decreasing powers of the variables, then terms with functions or roots of them;
/// a positive term, if any, is moved to the front.
pub(super) fn terms(expr: &Expr) -> Vec<Expr> {
    let mut terms = natural(expr);
    if let [first, last] = terms.as_slice()
        && last.as_number().is_some_and(|number| number.is_positive())
        && leads_after_number(first)
    {
        terms.rotate_right(1);
    }
    if let Some(positive) = terms.iter().position(|term| !is_negative(term)) {
        let front = terms.remove(positive);
        terms.insert(0, front);
    }
    terms
}

/// The terms sorted by their keys.
fn natural(expr: &Expr) -> Vec<Expr> {
    let mut terms: Vec<(Key, Expr)> = expr.terms().into_iter().map(|term| (Key::of(&term), term)).collect();
    terms.sort_by(|(left, _), (right, _)| left.cmp(right));
    terms.into_iter().map(|(_, term)| term).collect()
}

/// True if a number reads better in front: 1 + r²/w², 1 + eˣ, but n + 1.
fn leads_after_number(term: &Expr) -> bool {
    let layout = layout(term);
    let simple = |factor: &Factor| Rank::of(factor) <= Rank::Parameter;
    !(layout.upper.iter().all(simple)
        && layout.lower.iter().all(|factor| Rank::of(factor) <= Rank::Constant)
        && layout.behind.iter().all(simple))
}

/// The sort key of a term in a sum.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Key {
    depends_through_function: bool,
    degree: Reverse<Degree>,
    has_function: bool,
    degree_of_parameters: Reverse<Degree>,
    /// Polynomials in two variables by falling powers of the contact radius.
    degree_of_radius: Reverse<Degree>,
    names: Vec<(Rank, String, Expr)>,
    term: Expr,
}

#[derive(PartialEq)]
struct Degree(f64);

impl Eq for Degree {}

impl PartialOrd for Degree {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Degree {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }
}

impl Key {
    fn of(term: &Expr) -> Self {
        let [in_variables, in_parameters] = degrees(term);
        let layout = layout(term);
        let all: Vec<&Factor> = layout.upper.iter().chain(&layout.lower).chain(&layout.behind).collect();
        let function = |factor: &&&Factor| Rank::of(factor) > Rank::Variable;
        let depends =
            |factor: &Factor| factor.base.symbols().iter().chain(&factor.exponent.symbols()).any(|s| VARIABLES.contains(&s.name()));
        Self {
            depends_through_function: all.iter().filter(function).any(|factor| depends(factor)),
            degree: Reverse(Degree(in_variables)),
            has_function: all.iter().any(|factor| function(&factor)),
            degree_of_parameters: Reverse(Degree(in_parameters)),
            degree_of_radius: Reverse(Degree(power_of_radius(term))),
            names: all
                .iter()
                .map(|factor| (Rank::of(factor), name(&factor.base).1, factor.exponent.clone()))
                .filter(|key| key.0 > Rank::Number)
                .collect(),
            term: term.split_coefficient().1,
        }
    }
}

/// The power of the contact radius in a product.
fn power_of_radius(term: &Expr) -> f64 {
    let power = |factor: &Expr| {
        let (base, exponent) = factor.split_power();
        let is_radius = base.as_symbol().is_some_and(|own| own.name() == "a");
        exponent.as_number().filter(|_| is_radius).map_or(0.0, |own| own.to_f64())
    };
    term.factors().iter().map(power).sum()
}

thread_local! {
    /// The degrees of sums, products and powers by address. The expression is kept, so that no other one gets its address.
    static KNOWN: RefCell<HashMap<usize, (Expr, [f64; 2])>> = RefCell::default();
}

/// Number of known degrees above which all are forgotten.
const MOST_KNOWN: usize = 20_000;
/// Steps of work for the degrees of a sum, product or power.
const DEGREES: u64 = 10;

/// The degrees of an expression in the variables and in all other symbols.
fn degrees(expr: &Expr) -> [f64; 2] {
    work::spend(1);
    match expr.node() {
        Node::Symbol(symbol) if VARIABLES.contains(&symbol.name()) => return [1.0, 0.0],
        Node::Symbol(_) => return [0.0, 1.0],
        Node::Number(_) | Node::Constant(_) | Node::Function(..) => return [0.0; 2],
        _ => {}
    }
    if let Some(known) = KNOWN.with_borrow(|known| known.get(&expr.address()).map(|(_, own)| *own)) {
        return known;
    }
    work::spend(DEGREES);
    let found = match expr.node() {
        Node::Power(base, exponent) => {
            let by = exponent.as_number().map_or(0.0, |number| number.to_f64());
            degrees(base).map(|own| by * own)
        }
        Node::Product(factors) => factors.iter().map(degrees).fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d]),
        Node::Sum(terms) => terms.iter().map(degrees).fold([f64::NEG_INFINITY; 2], |[a, b], [c, d]| [a.max(c), b.max(d)]),
        _ => [0.0; 2],
    };
    KNOWN.with_borrow_mut(|known| {
        if known.len() >= MOST_KNOWN {
            known.clear();
        }
        known.insert(expr.address(), (expr.clone(), found));
    });
    found
}
