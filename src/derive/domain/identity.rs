//! Expressions that vanish identically, as tan θ − 2 tan(θ/2)/(1 − tan²(θ/2)) does: exact values at random rational points.

use crate::derive::stream::Stream;
use crate::expr::{Expr, Node, Number};
use crate::num::work;
use num_rational::BigRational;
use num_traits::{One, Zero};
use std::collections::HashMap;

/// Points at which the expression must vanish.
const POINTS: u64 = 3;
/// Steps of work for a part.
const STEPS_PER_PART: u64 = 20;
/// Larger expressions are not examined.
const MOST_PARTS: usize = 200;
/// Larger powers, and numbers of more bits, are not computed.
const LARGEST_POWER: i64 = 64;
const MOST_BITS: u64 = 20_000;

/// True if a rational expression in its symbols vanishes at random rational points; false proves nothing.
///
/// Hyperbolic functions are rational in an exponential; every other function and every root counts as a symbol.
/// A rational function of degree n that is not zero vanishes at all points with a probability below (n/2³⁰)³.
pub(crate) fn vanishes_identically(expr: &Expr) -> bool {
    expr.parts().take(MOST_PARTS + 1).count() <= MOST_PARTS
        && (0..POINTS).all(|seed| Point { stream: Stream::new(seed), known: HashMap::new() }.value(expr).is_some_and(|own| own.is_zero()))
}

/// Random values of the symbols, and of what counts as a symbol.
struct Point {
    stream: Stream,
    known: HashMap<Expr, BigRational>,
}

impl Point {
    fn value(&mut self, expr: &Expr) -> Option<BigRational> {
        work::spend(STEPS_PER_PART);
        if let Some(known) = self.known.get(expr) {
            return Some(known.clone());
        }
        let found = match expr.node() {
            Node::Number(number) => number.value().clone(),
            Node::Sum(terms) => terms.iter().try_fold(BigRational::zero(), |sum, term| Some(sum + self.value(term)?))?,
            Node::Product(factors) => factors.iter().try_fold(BigRational::one(), |product, own| Some(product * self.value(own)?))?,
            Node::Power(base, exponent) => match exponent.as_integer().filter(|n| n.abs() <= LARGEST_POWER) {
                Some(n) => {
                    let base = self.value(base)?;
                    (n > 0 || !base.is_zero()).then(|| base.pow(n as i32))?
                }
                None => self.random(),
            },
            Node::Function(function, arguments) if matches!(function.name(), "cosh" | "sinh" | "tanh") => {
                let growth = Expr::call("exp", arguments.clone());
                let growth = self.value(&growth)?;
                let (rising, falling) = (growth.clone(), growth.recip());
                let (cosh, sinh) = ((&rising + &falling) / Number::integer(2).value(), (rising - falling) / Number::integer(2).value());
                match function.name() {
                    "cosh" => cosh,
                    "sinh" => sinh,
                    _ => sinh / cosh,
                }
            }
            Node::Constant(_) | Node::Symbol(_) | Node::Function(..) => self.random(),
        };
        if Number::from(found.clone()).bits() > MOST_BITS {
            return None;
        }
        self.known.insert(expr.clone(), found.clone());
        Some(found)
    }

    /// A positive number of some thirty random bits.
    fn random(&mut self) -> BigRational {
        let [numerator, denominator] = [(); 2].map(|()| (self.stream.uniform() * f64::from(1_u32 << 30)) as i64 + 1);
        Number::ratio(numerator, denominator).value().clone()
    }
}
