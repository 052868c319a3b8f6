//! One Gauss–Legendre rule on [0, 1] with correctly rounded nodes and weights, for smooth positive integrands.

use std::sync::OnceLock;

use super::double_double::DoubleDouble;

/// How many nodes the rule has: it integrates polynomials up to degree 95.
pub(crate) const NODES: usize = 48;

/// One node `t` of the rule, its mirror image `1 - t`, and its weight.
#[derive(Clone, Copy)]
pub(crate) struct Node {
    /// Position in (0, 1).
    pub(crate) t: f64,
    /// `1 - t`, accurate also near `t = 1`.
    pub(crate) rest: f64,
    /// Weight; all are positive and sum to 1.
    pub(crate) weight: f64,
}

/// The nodes in increasing order.
///
/// Published tables and common libraries carry weight errors up to 1e-12, so the rule is made here: Newton's method
/// on the Legendre recurrence in double-double, rounded once. Computed at first use (a millisecond or two), then cached.
pub(crate) fn rule() -> &'static [Node; NODES] {
    static RULE: OnceLock<[Node; NODES]> = OnceLock::new();
    RULE.get_or_init(|| std::array::from_fn(node))
}

/// The integral of `f` over [0, 1]: `f` receives `t` and `1 - t`.
pub(crate) fn integrate(mut f: impl FnMut(f64, f64) -> f64) -> f64 {
    let mut total = super::stable::Total::default();
    for node in rule() {
        total.add(node.weight * f(node.t, node.rest));
    }
    total.value()
}

/// The rule with `count` nodes in increasing order; it integrates polynomials up to degree `2 count - 1`.
pub(crate) fn rule_of(count: usize) -> Vec<Node> {
    (0..count).map(|index| node_of(count, index)).collect()
}

/// `P_n(x)` and `P_{n-1}(x)`.
fn legendre(count: usize, x: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let (mut previous, mut current) = (DoubleDouble::ONE, x);
    for degree in 2..=count {
        let k = degree as f64;
        let next = x.mul(current).mul((2.0 * k - 1.0).into()).sub(previous.mul((k - 1.0).into())).div(k.into());
        previous = current;
        current = next;
    }
    (current, previous)
}

fn node(index: usize) -> Node {
    node_of(NODES, index)
}

/// The node number `index`, counted from `t = 0`.
fn node_of(count: usize, index: usize) -> Node {
    let n = count as f64;
    // x = 1 - 2t decreases from 1 as t grows; Tricomi's guess is good to three digits, Newton doubles them.
    let mut x = DoubleDouble::from((std::f64::consts::PI * (index as f64 + 0.75) / (n + 0.5)).cos());
    for _ in 0..6 {
        let (value, previous) = legendre(count, x);
        let one_minus_square = DoubleDouble::ONE.sub(x.mul(x));
        let slope = previous.sub(x.mul(value)).mul(n.into()).div(one_minus_square);
        x = x.sub(value.div(slope));
    }
    let (_, previous) = legendre(count, x);
    let one_minus_square = DoubleDouble::ONE.sub(x.mul(x));
    let scaled = previous.mul(n.into());
    Node {
        t: DoubleDouble::ONE.sub(x).scale(0.5).value(),
        rest: DoubleDouble::ONE.add(x).scale(0.5).value(),
        weight: one_minus_square.div(scaled.mul(scaled)).value(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rule_is_symmetric_and_integrates_powers() {
        let nodes = rule();
        for (a, b) in nodes.iter().zip(nodes.iter().rev()) {
            assert_eq!((a.t, a.weight), (b.rest, b.weight));
        }
        for degree in [0, 1, 7, 40, 94] {
            let integral = integrate(|t, _| t.powi(degree));
            assert!((integral * f64::from(degree + 1) - 1.0).abs() < 4e-15, "degree {degree}: {integral}");
        }
    }

    /// The outermost node and weight of the 48-point rule, 50-digit values mapped to [0, 1].
    #[test]
    fn outermost_node_matches_high_precision() {
        let first = rule()[0];
        assert_eq!(first.t, OUTER_NODE);
        assert_eq!(first.weight, OUTER_WEIGHT);
    }
    const OUTER_NODE: f64 = 0.000_614_496_373_786_940_7;
    const OUTER_WEIGHT: f64 = 0.001_576_673_026_152_919_2;
}
