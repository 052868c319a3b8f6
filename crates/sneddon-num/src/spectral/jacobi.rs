//! Sums of Jacobi polynomials by their three-term recurrence, with the size of what was added.

/// The recurrence of P_k^{(α,β)}: P_{k+1} = (a_k t + b_k) P_k − c_k P_{k−1}.
///
/// Accuracy: the forward recurrence is stable on [−1, 1]; every coefficient has a few ulps.
///
/// Source: DLMF 18.9.1.
#[derive(Clone, Debug)]
pub struct Basis {
    first: (f64, f64),
    steps: Vec<[f64; 3]>,
}

impl Basis {
    /// For sums of up to `count` terms; α + β > −1.
    pub fn new(alpha: f64, beta: f64, count: usize) -> Self {
        let sum = alpha + beta;
        let steps = (1..count.max(1)).map(|k| {
            let k = k as f64;
            let s = 2.0 * k + sum;
            let below = 2.0 * (k + 1.0) * (k + sum + 1.0);
            let a = (s + 1.0) * (s + 2.0) / below;
            let b = (alpha - beta) * sum * (s + 1.0) / (below * s);
            let c = 2.0 * (k + alpha) * (k + beta) * (s + 2.0) / (below * s);
            [a, b, c]
        });
        Self { first: (0.5 * (sum + 2.0), 0.5 * (alpha - beta)), steps: steps.collect() }
    }

    /// Σ c_k P_k(t), and Σ |c_k P_k(t)|.
    pub fn sum(&self, coefficients: &[f64], t: f64) -> (f64, f64) {
        let (mut total, mut size) = (0.0, 0.0);
        self.walk(t, coefficients.len(), |k, p| {
            let own = coefficients.get(k).copied().unwrap_or(0.0) * p;
            total += own;
            size += own.abs();
        });
        (total, size)
    }

    /// Visits P_0(t) … P_{count−1}(t).
    pub fn walk(&self, t: f64, count: usize, mut visit: impl FnMut(usize, f64)) {
        if count == 0 {
            return;
        }
        let (mut before, mut current) = (1.0, self.first.0 * t + self.first.1);
        visit(0, 1.0);
        if count > 1 {
            visit(1, current);
        }
        for (k, [a, b, c]) in self.steps.iter().enumerate().take(count.saturating_sub(2)) {
            let next = (a * t + b) * current - c * before;
            before = current;
            current = next;
            visit(k + 2, next);
        }
    }
}

/// The coefficients over P_k^{(0,β+1)} of a sum over P_k^{(0,β)}: the same function, expanded for another weight.
///
/// Source: DLMF 18.9.5, (2k+β+1) P_k^{(0,β)} = (k+β+1) P_k^{(0,β+1)} + k P_{k−1}^{(0,β+1)}.
pub(crate) fn next_weight(coefficients: &[f64], beta: f64) -> Vec<f64> {
    let mut out = vec![0.0; coefficients.len()];
    for (k, c) in coefficients.iter().enumerate() {
        let index = k;
        let k = k as f64;
        let own = c / (2.0 * k + beta + 1.0);
        if let Some(slot) = out.get_mut(index) {
            *slot += own * (k + beta + 1.0);
        }
        if let Some(slot) = index.checked_sub(1).and_then(|i| out.get_mut(i)) {
            *slot += own * k;
        }
    }
    out
}

/// Truncates an expansion whose tail has reached the plateau of rounding, and bounds the tail's half-order integral.
///
/// `scale` is the largest value of the function, not the largest coefficient. Rounding of the values gives coefficient k a noise
/// of about √((2k+1)/n) ulps. `None` if the tail still carries digits; a half-order integral divides coefficient k by k + 1.
pub fn chop(coefficients: &mut Vec<f64>, scale: f64, plateau: f64) -> Option<f64> {
    let count = coefficients.len();
    let unit = plateau * scale / (count as f64).sqrt();
    let significant =
        coefficients.iter().enumerate().rposition(|(k, c)| c.abs() > unit * (2.0 * k as f64 + 1.0).sqrt()).map_or(0, |last| last + 1);
    // A quarter of the coefficients must lie on the plateau: a single small one may be a zero of the expansion.
    if significant + count / 4 > count {
        return None;
    }
    let dropped: f64 = coefficients.iter().enumerate().skip(significant).map(|(k, c)| c.abs() / (k as f64 + 1.0)).sum();
    coefficients.truncate(significant.max(1));
    Some(dropped)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectral::rule;

    #[test]
    fn sums_agree_with_explicit_polynomials() {
        // P_2^{(−1/2,1)}(t) at t = 0.3, 30 digits.
        let basis = Basis::new(-0.5, 1.0, 4);
        let mut found = [0.0; 3];
        basis.walk(0.3, 3, |k, p| found[k] = p);
        assert!((found[1] + 0.375).abs() < 1e-16, "{found:?}");
        assert!((found[2] - P2).abs() < 1e-15, "{found:?}");
    }
    const P2: f64 = -0.497_812_5;

    #[test]
    fn another_weight_is_the_same_function() {
        let beta = 0.35;
        let coefficients = [0.7, -0.3, 0.2, 0.05];
        let (old, new) = (Basis::new(0.0, beta, 4), Basis::new(0.0, beta + 1.0, 4));
        let changed = next_weight(&coefficients, beta);
        for node in rule(16, 0.0).nodes() {
            let t = node.t;
            assert!((old.sum(&coefficients, t).0 - new.sum(&changed, t).0).abs() < 1e-15);
        }
    }
}
