//! The double-exponential rule with 30 digits: a slow and independent reference for faster quadratures.

use super::{PI, exp};
use crate::double_double::{DoubleDouble, Precise};

/// Half the length of the range of the parameter u; beyond it both distances to the ends are below 1e-120.
const REACH: f64 = 5.2;
/// Steps per unit of u on the first level, …
const FIRST: u32 = 4;
/// … and how often they are halved.
const LEVELS: u32 = 7;
/// Relative difference of two levels that is enough: convergence is quadratic, so the finer one has all its digits.
const ENOUGH: f64 = 1e-24;

/// One node: the distances to both ends as parts of the length, and the weight.
struct Node {
    from_lower: Precise,
    from_upper: Precise,
    weight: Precise,
}

/// Nodes of the rule on (0, 1), made once for many integrals.
///
/// q = 1/(1 + e^(−π sinh u)), trapezoidal in u (Takahasi & Mori 1974).
/// The integrand receives q and 1 − q, each with all its digits, so algebraic and logarithmic ends cost nothing.
///
/// Error: what rounding does is bounded rigorously; what the rule leaves out is judged by the difference of its last two levels
/// and by the size of the outermost terms.
/// For integrands that are analytic inside the range that difference is far above the truth.
///
/// ```
/// use sneddon_num::{Precise, precise::DoubleExponential};
/// let rule = DoubleExponential::new();
/// // ∫₀¹ dq/√(1 − q) = 2
/// let two = rule.integrate(|_, rest| Precise::exact(1.0).div(rest.sqrt()));
/// assert!((two.value.hi - 2.0).abs() <= two.error && two.error < 1e-25);
/// ```
pub struct DoubleExponential {
    levels: Vec<Vec<Node>>,
}

impl DoubleExponential {
    /// Computes the nodes of every level.
    #[must_use]
    pub fn new() -> Self {
        let levels = (0..LEVELS).map(|level| {
            let steps = FIRST << level;
            let most = (REACH * f64::from(steps)) as i32;
            // Each level adds the nodes between those of the one before.
            let own = (-most..=most).filter(|k| level == 0 || k % 2 != 0);
            own.map(|k| Node::at(f64::from(k) / f64::from(steps))).collect()
        });
        Self { levels: levels.collect() }
    }

    /// ∫₀¹ f(q, 1 − q) dq.
    pub fn integrate(&self, mut f: impl FnMut(Precise, Precise) -> Precise) -> Precise {
        let (mut sum, mut before) = (Precise::exact(0.0), Precise::nan());
        let (mut result, mut tails) = (Precise::nan(), 0.0);
        for (level, nodes) in self.levels.iter().enumerate() {
            for (index, node) in nodes.iter().enumerate() {
                let value = f(node.from_lower, node.from_upper).mul(node.weight);
                sum = sum.add(value);
                if level == 0 && (index == 0 || index + 1 == nodes.len()) {
                    tails += value.value.hi.abs();
                }
            }
            let own = sum.div(Precise::exact(f64::from(FIRST << level)));
            let left_out = own.sub(before).value.hi.abs();
            result = Precise::checked(own.value, own.error + left_out + tails);
            if left_out <= ENOUGH * own.value.hi.abs() {
                break;
            }
            before = own;
        }
        result
    }
}

impl Default for DoubleExponential {
    fn default() -> Self {
        Self::new()
    }
}

impl Node {
    fn at(u: f64) -> Self {
        // Two steps of the exponential lose a few units of 2^-104 each; the far tails carry the error of the exponent.
        let grown = exp(u.into());
        let shrunk = DoubleDouble::ONE.div(grown);
        let exponent = PI.mul(grown.sub(shrunk)).scale(0.5);
        let slope = PI.mul(grown.add(shrunk)).scale(0.5);
        let units = 64.0 + 16.0 * exponent.hi.abs();
        let small = Precise::relative(exp(DoubleDouble { hi: -exponent.hi.abs(), lo: -exponent.hi.signum() * exponent.lo }), units);
        let near = Precise::exact(1.0).div(Precise::exact(1.0).add(small));
        let far = small.mul(near);
        let (from_lower, from_upper) = if u < 0.0 { (far, near) } else { (near, far) };
        Self { from_lower, from_upper, weight: Precise::relative(slope, 64.0).mul(near).mul(far) }
    }
}
