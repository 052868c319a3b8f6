//! One Gauss–Legendre rule on [0, 1] with correctly rounded nodes and weights, for smooth positive integrands.

use std::sync::OnceLock;

use super::double_double::DoubleDouble;

/// How many nodes the rule has: it integrates polynomials up to degree 95.
pub const NODES: usize = 48;

/// One node `t` of the rule, its mirror image `1 - t`, and its weight.
#[derive(Clone, Copy)]
pub struct Node {
    /// Position in (0, 1).
    pub t: f64,
    /// `1 - t`, accurate also near `t = 1`.
    pub rest: f64,
    /// Weight; all are positive and sum to 1.
    pub weight: f64,
}

/// The nodes in increasing order.
///
/// Published tables and common libraries carry weight errors up to 1e-12, so the rule is made here: Newton's method
/// on the Legendre recurrence in double-double, rounded once. Computed at first use (a millisecond or two), then cached.
pub fn rule() -> &'static [Node; NODES] {
    static RULE: OnceLock<[Node; NODES]> = OnceLock::new();
    RULE.get_or_init(|| std::array::from_fn(node))
}

/// The integral of `f` over [0, 1]: `f` receives `t` and `1 - t`.
pub fn integrate(mut f: impl FnMut(f64, f64) -> f64) -> f64 {
    let mut total = super::stable::Total::default();
    for node in rule() {
        total.add(node.weight * f(node.t, node.rest));
    }
    total.value()
}

/// The rule with `count` nodes in increasing order; it integrates polynomials up to degree `2 count - 1`.
pub fn rule_of(count: usize) -> Vec<Node> {
    (0..count).map(|index| node_of(count, index)).collect()
}

/// A positive node z of a rule on [−1, 1], √(1 − z²), and its weight in the mean of an even function.
pub struct EvenNode {
    /// z, in (0, 1).
    pub z: DoubleDouble,
    /// √(1 − z²).
    pub cosine: DoubleDouble,
    /// Its weight in the mean over [−1, 1].
    pub weight: f64,
}

/// The positive nodes of the rule with an even number of nodes, in increasing order.
pub fn positive_half_of(count: usize) -> impl Iterator<Item = EvenNode> {
    (0..count / 2).rev().map(move |index| {
        let (z, one_minus_square, weight) = root_of(count, index);
        EvenNode { z, cosine: one_minus_square.sqrt(), weight: weight.scale(2.0).value() }
    })
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

/// The same in doubles.
fn legendre_double(count: usize, x: f64) -> (f64, f64) {
    (2..=count).fold((x, 1.0), |(current, previous), degree| {
        let k = degree as f64;
        (((2.0 * k - 1.0) * x * current - (k - 1.0) * previous) / k, current)
    })
}

fn node(index: usize) -> Node {
    node_of(NODES, index)
}

/// The node number `index`, counted from `t = 0`.
fn node_of(count: usize, index: usize) -> Node {
    let (x, _, weight) = root_of(count, index);
    Node { t: DoubleDouble::ONE.sub(x).scale(0.5).value(), rest: DoubleDouble::ONE.add(x).scale(0.5).value(), weight: weight.value() }
}

/// A root x of `P_n`, falling from 1, with 1 − x² and its weight.
fn root_of(count: usize, index: usize) -> (DoubleDouble, DoubleDouble, DoubleDouble) {
    let n = count as f64;
    // x = 1 - 2t decreases from 1 as t grows; Tricomi's guess is good to three digits, Newton doubles them: to those of a double first.
    let mut guess = (std::f64::consts::PI * (index as f64 + 0.75) / (n + 0.5)).cos();
    for _ in 0..4 {
        let (value, previous) = legendre_double(count, guess);
        guess -= value * (1.0 - guess) * (1.0 + guess) / (n * (previous - guess * value));
    }
    let mut x = DoubleDouble::from(guess);
    for _ in 0..2 {
        let (value, previous) = legendre(count, x);
        let one_minus_square = DoubleDouble::ONE.sub(x.mul(x));
        let slope = previous.sub(x.mul(value)).mul(n.into()).div(one_minus_square);
        x = x.sub(value.div(slope));
    }
    let (_, previous) = legendre(count, x);
    let one_minus_square = DoubleDouble::ONE.sub(x.mul(x));
    let scaled = previous.mul(n.into());
    (x, one_minus_square, one_minus_square.div(scaled.mul(scaled)))
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
