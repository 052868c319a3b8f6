//! Gauss–Jacobi rules for the weight (1 + t)^β on [−1, 1], and the expansions that they give.

use super::jacobi::Basis;
use crate::double_double::{DoubleDouble, two_prod, two_sum};
use std::sync::{Arc, Mutex, OnceLock};

/// A rule of n nodes; it integrates (1 + t)^β times a polynomial of degree 2n − 1.
#[derive(Debug)]
pub struct Rule {
    beta: f64,
    nodes: Vec<Node>,
    /// P_k(t_j)·λ_j·(2k+β+1), row by row over j: the transform from values to coefficients.
    transform: Vec<f64>,
}

/// A node t and its share λ of the weight: ∫ (1+t)^β f dt = 2^(β+1) Σ λ_j f(t_j).
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// t, in (−1, 1).
    pub t: f64,
    /// (1 + t)/2, the position in [0, 1].
    pub unit: f64,
    /// λ.
    pub share: f64,
}

/// The Gauss–Jacobi rule of `count` nodes for the weight (1+t)^β; the rules that were computed first are cached.
pub fn rule(count: usize, beta: f64) -> Arc<Rule> {
    static KEPT: OnceLock<Mutex<Vec<Arc<Rule>>>> = OnceLock::new();
    let kept = KEPT.get_or_init(|| Mutex::new(Vec::new()));
    let same = |own: &&Arc<Rule>| own.nodes.len() == count && own.beta == beta;
    if let Ok(list) = kept.lock()
        && let Some(found) = list.iter().find(same)
    {
        return Arc::clone(found);
    }
    let built = Arc::new(Rule::new(count, beta));
    if let Ok(mut list) = kept.lock()
        && list.len() < MOST_KEPT
    {
        list.push(Arc::clone(&built));
    }
    built
}

/// Rules that are kept for the next curve.
const MOST_KEPT: usize = 64;

impl Rule {
    fn new(count: usize, beta: f64) -> Self {
        let steps = Steps::new(count, beta);
        let mut nodes = Vec::with_capacity(count);
        let mut transform = Vec::with_capacity(count * count);
        let mut row = vec![DoubleDouble::ONE; count + 1];
        for index in (0..count).rev() {
            let t = steps.zero(index, &mut row);
            // Christoffel: 1/λ = Σ (2k+β+1) P_k².
            let square = |(k, p): (usize, &DoubleDouble)| p.mul(*p).mul(steps.norm(k));
            let total = row.iter().take(count).enumerate().map(square).fold(DoubleDouble::from(0.0), DoubleDouble::add);
            let unit = DoubleDouble::ONE.add(t).scale(0.5).value();
            nodes.push(Node { t: t.value(), unit, share: DoubleDouble::ONE.div(total).value() });
            transform.extend(row.iter().take(count).enumerate().map(|(k, p)| p.mul(steps.norm(k)).div(total).value()));
        }
        Self { beta, nodes, transform }
    }

    /// The nodes, rising.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// c_k with f = Σ c_k P_k^{(0,β)} from the values of f at the nodes.
    ///
    /// Accuracy: a few ulps of the largest value of f per coefficient.
    pub fn coefficients(&self, values: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; self.nodes.len()];
        for (row, value) in self.transform.chunks_exact(self.nodes.len().max(1)).zip(values) {
            for (slot, factor) in out.iter_mut().zip(row) {
                *slot += factor * value;
            }
        }
        out
    }

    /// The weight of one value in Σ c_k w_k.
    pub fn share_of(&self, node: usize, weights: &[f64]) -> f64 {
        let count = self.nodes.len();
        let row = self.transform.get(node * count..(node + 1) * count).unwrap_or_default();
        row.iter().zip(weights).map(|(factor, weight)| factor * weight).sum()
    }
}

/// The recurrence of P_k^{(0,β)} with 30 digits: next to t = −1 the rounding of t would be amplified by the square of the degree.
struct Steps {
    beta: f64,
    count: usize,
    rows: Vec<[DoubleDouble; 3]>,
}

impl Steps {
    fn new(count: usize, beta: f64) -> Self {
        let rows = (1..count.max(1)).map(|k| {
            let k = k as f64;
            let plus = |whole: f64| two_sum(whole, beta);
            let below = plus(k + 1.0).mul((2.0 * (k + 1.0)).into());
            let a = plus(2.0 * k + 1.0).mul(plus(2.0 * k + 2.0)).div(below);
            let full = below.mul(plus(2.0 * k));
            let square = two_prod(beta, beta);
            let b = square.mul(plus(2.0 * k + 1.0)).div(full).neg();
            let c = plus(k).mul(plus(2.0 * k + 2.0)).mul((2.0 * k).into()).div(full);
            [a, b, c]
        });
        Self { beta, count, rows: rows.collect() }
    }

    /// 2k + β + 1.
    fn norm(&self, k: usize) -> DoubleDouble {
        two_sum(2.0 * k as f64 + 1.0, self.beta)
    }

    /// P_0 … P_n at t.
    fn fill(&self, t: DoubleDouble, row: &mut [DoubleDouble]) {
        let (mut before, mut current) = (DoubleDouble::ONE, two_sum(2.0, self.beta).mul(t).sub(self.beta.into()).scale(0.5));
        for (slot, value) in row.iter_mut().zip([before, current]) {
            *slot = value;
        }
        for (slot, [a, b, c]) in row.iter_mut().skip(2).zip(&self.rows) {
            let next = a.mul(t).add(*b).mul(current).sub(c.mul(before));
            before = current;
            current = next;
            *slot = next;
        }
    }

    /// The zero number `index` of P_n from the right, with P_0 … P_n at it.
    fn zero(&self, index: usize, row: &mut [DoubleDouble]) -> DoubleDouble {
        let n = self.count as f64;
        let basis = Basis::new(0.0, self.beta, self.count + 1);
        // The asymptotic zeros; Newton in θ keeps them apart.
        let mut theta = std::f64::consts::PI * (index as f64 + 0.75) / (n + 0.5 * (self.beta + 1.0));
        for _ in 0..ROUNDS {
            let (t, sine) = (theta.cos(), theta.sin());
            let (mut value, mut before) = (0.0, 0.0);
            basis.walk(t, self.count + 1, |k, p| {
                before = if k + 1 == self.count { p } else { before };
                value = p;
            });
            // dP/dθ = −sin θ P′.
            let step = value * sine / self.slope(t, value, before);
            theta += step;
            if step.abs() < 1e-12 {
                break;
            }
        }
        // Two steps of Newton's method with 30 digits; the first one doubles the digits of θ.
        let mut t = DoubleDouble::from(theta.cos());
        for _ in 0..2 {
            self.fill(t, row);
            let (value, before) = match row {
                [.., before, value] => (*value, *before),
                _ => break,
            };
            let square = DoubleDouble::ONE.sub(t.mul(t));
            let slope = self.slope(t.value(), value.value(), before.value());
            t = t.sub(square.mul(value).div(slope.into()));
        }
        self.fill(t, row);
        t
    }

    /// (1 − t²) P_n′ = (n(−β − (2n+β) t) P_n + 2n(n+β) P_{n−1})/(2n+β) (DLMF 18.9.17 at α = 0).
    fn slope(&self, t: f64, value: f64, before: f64) -> f64 {
        let (n, beta) = (self.count as f64, self.beta);
        let s = 2.0 * n + beta;
        (n * (-beta - s * t) * value + 2.0 * n * (n + beta) * before) / s
    }
}

/// Newton doubles the digits of the asymptotic zeros.
const ROUNDS: usize = 12;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_those_of_the_weight() {
        for beta in [-0.5, 0.0, 0.35, 1.0, 3.0] {
            for count in [8, 16, 32, 64] {
                let rule = Rule::new(count, beta);
                assert!(rule.nodes.windows(2).all(|pair| pair[0].t < pair[1].t));
                for degree in [0_i32, 1, 5, 14] {
                    let own: f64 = rule.nodes.iter().map(|node| node.share * node.unit.powi(degree)).sum();
                    let exact = 1.0 / (f64::from(degree) + beta + 1.0);
                    assert!(
                        (own / exact - 1.0).abs() < 4e-16 * f64::from(degree + 2),
                        "β = {beta}, n = {count}, degree {degree}: {own} {exact}"
                    );
                }
            }
        }
    }

    #[test]
    fn expansions_give_polynomials_back() {
        let rule = Rule::new(16, -0.5);
        let values: Vec<f64> = rule.nodes.iter().map(|node| node.t.powi(5) - 0.3).collect();
        let coefficients = rule.coefficients(&values);
        let basis = Basis::new(0.0, -0.5, 16);
        for t in [-1.0, -0.4, 0.0, 0.77, 1.0_f64] {
            let own = basis.sum(&coefficients, t).0;
            assert!((own - (t.powi(5) - 0.3)).abs() < 1e-14, "{t}: {own} {coefficients:?}");
        }
        assert!(coefficients[6..].iter().all(|c| c.abs() < 1e-15));
    }
}
