//! Whether an expression continues to an even or an odd function of r: read from its tree.

use crate::eval::{RegionAlgebra, Tape};
use crate::expr::{Expr, Node, Symbol};
use crate::num::Region;
use std::collections::HashMap;

/// The behaviour of a function when r changes its sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parity {
    /// Nothing.
    Even,
    /// Its sign changes.
    Odd,
}

/// Functions of one argument that are odd in it, …
const ODD: [&str; 11] = ["sin", "tan", "asin", "atan", "sinh", "tanh", "asinh", "atanh", "erf", "erfi", "dawson"];
/// even in it, …
const EVEN: [&str; 2] = ["cos", "cosh"];
/// without a branch point or a pole, …
const ENTIRE: [&str; 7] = ["exp", "sin", "cos", "sinh", "cosh", "erf", "erfi"];
/// … and functions of an order and an argument that are as odd in it as the order is.
const BESSEL: [&str; 2] = ["besselj", "besseli"];

/// The parity in `radius`; `None` if it is neither, or not seen.
pub fn parity(expr: &Expr, radius: &Symbol) -> Option<Parity> {
    let mut parities = Parities { radius, known: HashMap::new(), branched: Vec::new() };
    let found = parities.of(expr)?;
    (parities.branched.is_empty() || are_analytic(&parities.branched, radius)).then_some(found)
}

/// The parities of the parts of an expression if those that may have a branch point are analytic around the axis.
struct Parities<'a> {
    radius: &'a Symbol,
    known: HashMap<Expr, Option<Parity>>,
    /// The parts that may have a branch point.
    branched: Vec<Expr>,
}

impl Parities<'_> {
    fn of(&mut self, expr: &Expr) -> Option<Parity> {
        if !expr.contains(self.radius) {
            return Some(Parity::Even);
        }
        if let Some(known) = self.known.get(expr) {
            return *known;
        }
        let found = self.of_node(expr);
        self.known.insert(expr.clone(), found);
        found
    }

    fn of_node(&mut self, expr: &Expr) -> Option<Parity> {
        match expr.node() {
            Node::Number(_) | Node::Constant(_) => Some(Parity::Even),
            Node::Symbol(_) => Some(Parity::Odd),
            Node::Sum(terms) => {
                let mut all = terms.iter().map(|term| self.of(term));
                let first = all.next()??;
                all.all(|own| own == Some(first)).then_some(first)
            }
            Node::Product(factors) => factors.iter().try_fold(Parity::Even, |so_far, factor| {
                let own = self.of(factor)?;
                Some(if own == so_far { Parity::Even } else { Parity::Odd })
            }),
            Node::Power(base, exponent) => match (self.of(base)?, exponent.as_number()) {
                (Parity::Even, Some(power)) if power.is_integer() => Some(Parity::Even),
                // √(r² + r⁴) is an even expression and continues to r√(1 + r²).
                (Parity::Even, _) => {
                    self.branched.push(expr.clone());
                    self.of(exponent).filter(|own| *own == Parity::Even)
                }
                (Parity::Odd, Some(power)) if power.is_integer() => {
                    Some(if (power.to_f64() / 2.0).fract() == 0.0 { Parity::Even } else { Parity::Odd })
                }
                (Parity::Odd, _) => None,
            },
            Node::Function(function, arguments) => {
                let own: Vec<Parity> = arguments.iter().map(|a| self.of(a)).collect::<Option<_>>()?;
                match own.as_slice() {
                    [Parity::Odd] if ODD.contains(&function.name()) => Some(Parity::Odd),
                    [Parity::Odd] if EVEN.contains(&function.name()) => Some(Parity::Even),
                    // J_n(−z) = (−1)ⁿ J_n(z), and I_n the same.
                    [Parity::Even, Parity::Odd] if BESSEL.contains(&function.name()) => {
                        let order = arguments.first()?.as_number().filter(|order| order.is_integer())?;
                        Some(if (order.to_f64() / 2.0).fract() == 0.0 { Parity::Even } else { Parity::Odd })
                    }
                    all => {
                        if !ENTIRE.contains(&function.name()) {
                            self.branched.push(expr.clone());
                        }
                        all.iter().all(|p| *p == Parity::Even).then_some(Parity::Even)
                    }
                }
            }
        }
    }
}

/// Returns true if enclosures show that expressions in r alone are analytic around r = 0, where a function may have a branch point.
/// One tape computes what they share once.
fn are_analytic(expressions: &[Expr], radius: &Symbol) -> bool {
    const NEAR: f64 = 1e-30;
    let around = Region::new((-NEAR, NEAR), (-NEAR, NEAR));
    let tape = Tape::compile(expressions, std::slice::from_ref(radius));
    let found = tape.ok().and_then(|tape| tape.run_all(&mut RegionAlgebra, &[around], &mut Vec::new()));
    found.is_some_and(|all| all.iter().all(|own| own.largest().is_finite()))
}
