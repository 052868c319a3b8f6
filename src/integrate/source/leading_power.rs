//! The power with which a function begins at the lower end of a segment, and a bound on what it multiplies.

use crate::eval::{RegionAlgebra, Tape};
use crate::expr::{Bindings, Expr, Node, Number, Symbol, leading_term, normal};
use crate::num::Region;
use num_integer::Integer;
use num_traits::ToPrimitive;

/// δ^s h(δ) at the lower end, δ the distance to it and s > −1.
///
/// h is enclosed as a function of w = δ^(1/N), in which fractional powers of δ are whole, so that it is analytic at w = 0.
/// A logarithm of δ is written as δ^(−1/4) λ with the bounded λ = δ^(1/4) ln δ, which reduces s by 1/4.
/// If other factors vanish at the end, as sin δ does, then h = w^m k(w).
#[derive(Debug)]
pub struct LeadingPower {
    /// s.
    pub exponent: f64,
    /// N.
    root: u32,
    /// m, or 0 where it is not known.
    zeros: i32,
    /// h over w and λ for enclosures.
    rest: Tape,
    /// The least multiple of N for which s is whole; `None` if h contains λ, or if it is too large.
    whole: Option<i32>,
}

/// Closer to −1 the range of doubles is too short for what lies next to the end.
const LEAST: (i64, i64) = (-94, 100);
/// The share of the power that goes with each logarithm.
const QUARTER: f64 = 0.25;
/// The largest N: exponents with two decimals.
const MOST_ROOT: i64 = 100;
/// The largest m.
const MOST_ZEROS: i64 = 400;
/// The ratio of successive radii at which a bound on k is sought, and their number.
const STEP: f64 = 8.0;
const RADII: i32 = 12;
/// A relative error of roots, powers and logarithms of the platform, with room.
const HAIR: f64 = 1e-12;

impl LeadingPower {
    /// Of a function of `delta`; `None` if it does not begin so.
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
        let rest = Expr::sum(rest);
        let root = common_root(&rest, delta, 1).unwrap_or(1);
        let rest = Bindings::one(delta.name(), variable.power(root)).apply(&rest);
        let is_analytic = !rest.contains(&bounded);
        let zeros = if is_analytic { zeros_of(&rest, delta) } else { 0 };
        let whole = least.value().denom().to_i64().filter(|denominator| is_analytic && *denominator <= MOST_ROOT);
        let whole = whole.and_then(|denominator| i32::try_from(denominator.lcm(&root)).ok());
        let rest = Tape::for_enclosures(&[rest], &[delta.clone(), bounded]).ok()?;
        let root = u32::try_from(root).ok()?;
        Some(Self { exponent: least.to_f64(), root, zeros, rest, whole })
    }

    /// Returns the least N for which the function is u^k h, with u = δ^(1/N) and an h that may be analytic at u = 0, and k.
    pub(crate) fn whole_root(&self) -> Option<(i32, i32)> {
        self.whole.map(|root| (root, (self.exponent * f64::from(root)).round() as i32))
    }

    /// Returns a bound on |h| for u in a part of the complex plane where it is analytic; else infinite.
    pub(crate) fn rest_at(&self, u: Region, slots: &mut Vec<Region>) -> f64 {
        let root = i32::try_from(self.root).ok();
        let Some(factor) = self.whole.zip(root).and_then(|(whole, root)| whole.checked_div(root)) else { return f64::INFINITY };
        self.rest.run(&mut RegionAlgebra, &[u.powi(factor), Region::real(0.0)], slots).map_or(f64::INFINITY, Region::largest)
    }

    /// Returns a bound on |h| for δ on the straight lines from 0 to every point of the region; infinite if no bound is known, or
    /// if h is not known to be analytic there.
    pub fn rest_over(&self, end: Region, slots: &mut Vec<Region>) -> f64 {
        let Some(angle) = end.largest_angle() else { return f64::INFINITY };
        let (most, share) = (end.largest(), 1.0 / f64::from(self.root));
        let w = if self.root == 1 {
            end.with_zero().above_zero()
        } else {
            let (most, angle) = (most.powf(share) * (1.0 + HAIR), share * angle);
            Region::new((0.0, most), (-most * angle, most * angle))
        };
        let quarter = most.powf(QUARTER);
        let last = quarter * most.ln();
        // λ falls to −4/e at δ = e^−4 and rises from there, for real δ; an angle α adds i α δ^(1/4), and turns all by α/4.
        let low = if most < (-4.0_f64).exp() { last } else { -4.0 / std::f64::consts::E };
        let turned = angle * (0.25 * low.abs().max(last.abs()) + quarter) * (1.0 + HAIR);
        let bounded = Region::new((low * (1.0 + HAIR) - turned, last.max(0.0) * (1.0 + HAIR) + turned), (-turned, turned));
        self.rest.run(&mut RegionAlgebra, &[w, bounded], slots).map_or(f64::INFINITY, Region::largest)
    }

    /// Returns s + m/N and a bound on |k| for real δ from 0 to the largest in the region, or s and a bound on |h| if no bound on
    /// |k| is found.
    ///
    /// By the maximum principle, |k| ≤ max |h|/R^m holds for |w| ≤ R on every disc |w| ≤ R on which h is analytic.
    pub fn beyond_zeros(&self, delta: Region, slots: &mut Vec<Region>) -> (f64, f64) {
        if self.zeros == 0 {
            return (self.exponent, self.rest_over(delta, slots));
        }
        let share = 1.0 / f64::from(self.root);
        let least = delta.largest().powf(share) * (1.0 + HAIR);
        let mut on = |radius: f64| {
            let square = Region::new((-radius, radius), (-radius, radius));
            let found = self.rest.run(&mut RegionAlgebra, &[square, Region::real(0.0)], slots);
            let power = radius.powi(-self.zeros);
            let bound = found.map_or(f64::INFINITY, Region::largest) * power * (1.0 + HAIR);
            // A power that underflows bounds nothing.
            if bound.is_nan() || !power.is_normal() { f64::INFINITY } else { bound }
        };
        let mut best = f64::INFINITY;
        for step in 0..RADII {
            let own = on(least * STEP.powi(step));
            // Beyond the first singularity all are infinite.
            if own.is_infinite() && best.is_finite() {
                break;
            }
            best = best.min(own);
        }
        if best.is_finite() { (self.exponent + share * f64::from(self.zeros), best) } else { (self.exponent, self.rest_over(delta, slots)) }
    }
}

/// Returns the order of the zero that the expression has at 0, or 0 if it is unknown.
fn zeros_of(expr: &Expr, symbol: &Symbol) -> i32 {
    let in_r = Bindings::one(symbol.name(), Expr::symbol("r")).apply(expr);
    let exponent = leading_term(&in_r).and_then(|first| first.exponent.to_i64());
    exponent.filter(|m| (1..=MOST_ZEROS).contains(m)).map_or(0, |m| m as i32)
}

/// Returns the least common multiple of `root` and the denominators of all exponents of `symbol`, or `None` if it exceeds
/// [`MOST_ROOT`] or an exponent is not rational.
fn common_root(expr: &Expr, symbol: &Symbol, root: i64) -> Option<i64> {
    match expr.node() {
        Node::Power(base, exponent) if base.as_symbol() == Some(symbol) => {
            let own = exponent.as_number()?.value().denom().to_i64()?;
            (own <= MOST_ROOT).then(|| root.lcm(&own)).filter(|root| *root <= MOST_ROOT)
        }
        Node::Power(base, exponent) => common_root(exponent, symbol, common_root(base, symbol, root)?),
        Node::Function(_, list) | Node::Product(list) | Node::Sum(list) => {
            list.iter().try_fold(root, |root, own| common_root(own, symbol, root))
        }
        Node::Number(_) | Node::Constant(_) | Node::Symbol(_) => Some(root),
    }
}

/// Splits ln(u), where u = δ^k v and v does not vanish at δ = 0, into ln(v) and k; `None` if k = 0 or u has no such form.
///
/// If v is not positive, the enclosure of ln(v) is unknown.
fn logarithm(expr: &Expr, delta: &Symbol) -> Option<(Expr, Expr)> {
    let Node::Function(function, arguments) = expr.node() else { return None };
    let ("ln", [argument]) = (function.name(), arguments.as_slice()) else { return None };
    let terms = normal::normal_terms(argument, delta).ok()?;
    let least = terms.iter().map(|term| term.exponent.as_number()).collect::<Option<Vec<_>>>()?.into_iter().min()?.clone();
    if least.is_zero() {
        return None;
    }
    let (variable, k) = (Expr::from(delta.clone()), Expr::number(least));
    let rest = terms.iter().map(|term| &term.coefficient * term.kernel.clone() * variable.pow(&(&term.exponent - &k)));
    let rest = Expr::sum(rest);
    Some((if rest.is_one() { Expr::zero() } else { Expr::call("ln", [rest]) }, k))
}
