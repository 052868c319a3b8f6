//! The power with which a function begins at the lower end of a segment, and a bound on what it multiplies.

use crate::eval::{RegionAlgebra, Tape};
use crate::expr::{Expr, Node, Number, Sign, Symbol, normal, sign};
use crate::num::Region;

/// δ^s h(δ) at the lower end, δ the distance to it and s > −1.
///
/// Every logarithm of δ is δ^(−1/4) λ with λ = δ^(1/4) ln δ, which is bounded: it takes a quarter from s.
#[derive(Debug)]
pub struct LeadingPower {
    /// s.
    pub exponent: f64,
    /// h over δ and λ for enclosures.
    rest: Tape,
}

/// Closer to −1 the range of doubles is too short for what lies next to the end.
const LEAST: (i64, i64) = (-94, 100);
/// The share of the power that goes with each logarithm.
const QUARTER: f64 = 0.25;

impl LeadingPower {
    /// Of a function of `delta`; `None` where it does not begin so.
    pub fn of(function: &Expr, delta: &Symbol) -> Option<Self> {
        let (variable, bounded) = (Expr::from(delta.clone()), Symbol::new("λ"));
        let mut parts = Vec::new();
        for term in normal::normal_terms(function, delta).ok()? {
            let (mut exponent, mut kernel) = (term.exponent.as_number().cloned()?, Vec::new());
            for factor in term.kernel.factors() {
                let (base, power) = factor.split_power();
                match (logarithm(&base, delta), power.as_integer()) {
                    (Some((constant, k)), Some(n)) if n > 0 => {
                        let root = variable.pow(&Expr::ratio(1, 4));
                        kernel.push((constant * root + k * Expr::from(bounded.clone())).pow(&power));
                        exponent = &exponent + &Number::ratio(-n, 4);
                    }
                    _ => kernel.push(factor),
                }
            }
            parts.push((exponent, term.coefficient * Expr::product(kernel)));
        }
        let least = parts.iter().map(|(exponent, _)| exponent.clone()).min().filter(|least| *least > Number::ratio(LEAST.0, LEAST.1))?;
        let rest =
            parts.iter().map(|(exponent, part)| part * variable.pow(&(Expr::number(exponent.clone()) - Expr::number(least.clone()))));
        let rest = Tape::for_enclosures(&[Expr::sum(rest)], &[delta.clone(), bounded]).ok()?;
        Some(Self { exponent: least.to_f64(), rest })
    }

    /// A bound on |h| for real δ from 0 to the largest in a region; infinite where none is known.
    pub fn rest_over(&self, delta: Region, slots: &mut Vec<Region>) -> f64 {
        let most = delta.largest();
        let end = most.powf(QUARTER) * most.ln();
        // λ falls to −4/e at δ = e^−4 and rises from there.
        let low = if most < (-4.0_f64).exp() { end } else { -4.0 / std::f64::consts::E };
        let bounded = Region::interval(low * (1.0 + 1e-12), end.max(0.0) * (1.0 + 1e-12));
        self.rest.run(&mut RegionAlgebra, &[delta, bounded], slots).map_or(f64::INFINITY, Region::largest)
    }
}

/// ln(c δ^k) with positive c as ln c and k.
fn logarithm(expr: &Expr, delta: &Symbol) -> Option<(Expr, Expr)> {
    let Node::Function(function, arguments) = expr.node() else { return None };
    let ("ln", [argument]) = (function.name(), arguments.as_slice()) else { return None };
    let (powers, constants): (Vec<Expr>, Vec<Expr>) = argument.factors().into_iter().partition(|factor| factor.contains(delta));
    let [power] = powers.as_slice() else { return None };
    let (base, k) = power.split_power();
    let constant = Expr::product(constants);
    (base.as_symbol() == Some(delta) && !k.contains(delta) && sign(&constant) == Sign::Positive)
        .then(|| (if constant.is_one() { Expr::zero() } else { Expr::call("ln", [constant]) }, k))
}
