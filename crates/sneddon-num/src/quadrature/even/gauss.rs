//! Gauss's rules for even functions whose continuation is bounded: how many nodes suffice is known beforehand.

use super::super::super::bounded::UNIT;
use super::super::super::error::NumError;
use super::super::super::legendre;
use super::nodes::{Lists, Middles, between};
use super::{EvenIntegrand, Mean};
use std::sync::LazyLock;

/// Nodes in the half of each rule.
const HALVES: [usize; 24] = [2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16, 18, 20, 22, 24, 28, 32, 40, 48, 56, 64, 80, 96];
/// The largest of them.
const MOST_HALF_NODES: usize = HALVES[HALVES.len() - 1];
/// Sums that are added at the end.
const LANES: usize = 4;
/// As many nodes are enough often …
const FEW: usize = 8;
/// … and so many nearly always.
const MORE: usize = 24;
/// Each is made when it is first needed.
static RULES: [LazyLock<GaussRule>; HALVES.len()] = [
    LazyLock::new(|| GaussRule::new(0)),
    LazyLock::new(|| GaussRule::new(1)),
    LazyLock::new(|| GaussRule::new(2)),
    LazyLock::new(|| GaussRule::new(3)),
    LazyLock::new(|| GaussRule::new(4)),
    LazyLock::new(|| GaussRule::new(5)),
    LazyLock::new(|| GaussRule::new(6)),
    LazyLock::new(|| GaussRule::new(7)),
    LazyLock::new(|| GaussRule::new(8)),
    LazyLock::new(|| GaussRule::new(9)),
    LazyLock::new(|| GaussRule::new(10)),
    LazyLock::new(|| GaussRule::new(11)),
    LazyLock::new(|| GaussRule::new(12)),
    LazyLock::new(|| GaussRule::new(13)),
    LazyLock::new(|| GaussRule::new(14)),
    LazyLock::new(|| GaussRule::new(15)),
    LazyLock::new(|| GaussRule::new(16)),
    LazyLock::new(|| GaussRule::new(17)),
    LazyLock::new(|| GaussRule::new(18)),
    LazyLock::new(|| GaussRule::new(19)),
    LazyLock::new(|| GaussRule::new(20)),
    LazyLock::new(|| GaussRule::new(21)),
    LazyLock::new(|| GaussRule::new(22)),
    LazyLock::new(|| GaussRule::new(23)),
];

/// The positive nodes of a rule of twice as many.
struct GaussRule {
    nodes: Lists,
    /// With sum 1: the mean of an even function; zeros fill the lanes.
    weights: Vec<f64>,
    middles: [Vec<f64>; 3],
}

impl GaussRule {
    fn new(rule: usize) -> Self {
        let half = HALVES[rule];
        let mut nodes = Lists::default();
        let mut weights = Vec::with_capacity(half);
        for node in legendre::positive_half_of(2 * half) {
            let cosine = node.cosine.value();
            nodes.push_precise(node.z.value(), cosine, node.cosine.sub(cosine.into()).value());
            weights.push(node.weight);
        }
        let z = nodes.all().z;
        let mut middles = between(z.iter().copied());
        if let [first, second, ..] = z {
            // What an even function does from the centre to the first node follows from what it does from there to the second
            // one.
            let share = first * first / ((second - first) * (second + first));
            for (list, more) in middles.iter_mut().zip(between([0.0, *first].into_iter())) {
                if let (Some(to), Some(more)) = (list.first_mut(), more.first()) {
                    *to += share * more;
                }
            }
        }
        weights.resize(half.next_multiple_of(LANES), 0.0);
        Self { nodes, weights, middles }
    }
}

/// A rule, and a bound on what it leaves of the mean.
#[derive(Clone, Copy, Debug)]
pub struct Known {
    /// Its number.
    pub rule: usize,
    /// Bound on what the rule leaves out.
    pub left_out: f64,
}

impl Known {
    /// How many rules there are.
    pub const RULES: usize = HALVES.len();

    /// The smallest rule that leaves out no more than `wanted` of an even function that is analytic and at most `largest` on the
    /// ellipse with foci ±1 and half-axes cosh σ and sinh σ; `None` if that takes too many nodes.
    ///
    /// Chebyshev coefficients are at most 2M e^(−kσ); the rule of N nodes is exact below k = 2N and wrong by at most 2 + 2/(k² −
    /// 1) on T_k from there on, k even: Trefethen, Approximation Theory and Approximation Practice, theorems 8.1 and 19.3.
    pub fn fewest(sigma: f64, largest: f64, wanted: f64) -> Option<Self> {
        let front = 32.0 / 15.0 * largest / (1.0 - (-2.0 * sigma).exp()) * (1.0 + 1e-9);
        // front·e^(−4 half σ) ≤ wanted.
        let least = (front / wanted).ln() / (4.0 * sigma);
        let left_out = |half: usize| front * (-4.0 * half as f64 * sigma).exp() * (1.0 + 1e-9);
        Self::smallest(|half| (half as f64 >= least).then(|| left_out(half)))
    }

    /// The smallest rule of which `suffices`(nodes in its half) says what it leaves out.
    pub(super) fn smallest(suffices: impl Fn(usize) -> Option<f64>) -> Option<Self> {
        let (rule, left_out) = HALVES.iter().enumerate().find_map(|(rule, half)| Some((rule, suffices(*half)?)))?;
        left_out.is_finite().then_some(Self { rule, left_out: left_out.max(f64::MIN_POSITIVE) })
    }

    /// The mean of the integrand.
    ///
    /// # Errors
    /// [`NumError::NotFinite`] if the integrand is not.
    #[inline]
    pub fn mean<I: EvenIntegrand>(self, integrand: &mut I) -> Result<Mean, NumError> {
        let rule: &GaussRule = RULES.get(self.rule).unwrap_or(&RULES[0]);
        match rule.nodes.all().z.len() {
            count if count <= FEW => self.sum::<I, FEW>(integrand, rule),
            count if count <= MORE => self.sum::<I, MORE>(integrand, rule),
            _ => self.sum::<I, MOST_HALF_NODES>(integrand, rule),
        }
    }

    #[inline(always)]
    fn sum<I: EvenIntegrand, const N: usize>(self, integrand: &mut I, own: &GaussRule) -> Result<Mean, NumError> {
        let (mut values, mut errors) = ([0.0; N], [0.0; N]);
        let all = own.nodes.all();
        let count = all.z.len();
        let mut from = 0;
        while from < count {
            let to = (from + I::BLOCK).min(count);
            let Some(nodes) = all.part(from, to) else { break };
            integrand.fill(nodes, &mut values[from..to], &mut errors[from..to]);
            from = to;
        }
        let (mut value, mut size, mut noise) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        let chunks = values.as_chunks::<LANES>().0.iter().zip(errors.as_chunks::<LANES>().0);
        for (weights, (values, errors)) in own.weights.as_chunks::<LANES>().0.iter().zip(chunks) {
            for i in 0..LANES {
                let weighted = weights[i] * values[i];
                value[i] += weighted;
                // Weights are positive.
                size[i] += weighted.abs();
                noise[i] += weights[i] * errors[i];
            }
        }
        let [value, size, noise] = [value, size, noise].map(|[a, b, c, d]| (a + b) + (c + d));
        if !size.is_finite() {
            let bad = values.iter().position(|v| !v.is_finite()).unwrap_or(0);
            return Err(NumError::NotFinite { at: all.z.get(bad).copied().unwrap_or(0.0) });
        }
        let [cotangents, quarter_cotangents, reciprocals] = &own.middles;
        let middles = Middles { cotangents, quarter_cotangents, reciprocals };
        let displacement = integrand.displacement(middles, values.get(..count).unwrap_or_default());
        let noise = noise + (8.0 * UNIT + integrand.relative()) * size + displacement;
        let noise = if noise.is_nan() { f64::INFINITY } else { noise };
        Ok(Mean { value, left_out: self.left_out, noise, evaluations: count as u64, reached: true })
    }
}

#[cfg(test)]
mod tests {
    use super::super::Nodes;
    use super::*;

    struct Even<F>(F);

    impl<F: Fn(f64) -> f64> EvenIntegrand for Even<F> {
        const BOUNDED: bool = false;
        const BLOCK: usize = 8;
        const TOGETHER: bool = false;

        fn fill(&mut self, nodes: Nodes<'_>, values: &mut [f64], _errors: &mut [f64]) {
            values.iter_mut().zip(nodes.z).for_each(|(value, z)| *value = (self.0)(*z));
        }
    }

    /// Ellipses of every size within what the functions allow, and what is wanted from 1e−1 to 1e−16.
    #[test]
    fn what_is_left_out_is_bounded_and_no_smaller_rule_would_do() {
        let mut seen = 0;
        let mut check = |name: &str, truth: f64, sigma: f64, largest: f64, f: &dyn Fn(f64) -> f64| {
            for digits in 1..17 {
                let wanted = 10f64.powi(-digits);
                let Some(known) = Known::fewest(sigma, largest, wanted) else { continue };
                let found = known.mean(&mut Even(f)).unwrap();
                let off = (found.value - truth).abs();
                assert!(known.left_out <= wanted, "{name} {sigma}: {known:?}");
                // The argument of a wave is rounded.
                assert!(off <= found.left_out + found.noise + 1e-15, "{name}, σ {sigma}, {wanted:e}: off {off:e}, {found:?}");
                let smaller = known.rule.checked_sub(1).map(|rule| HALVES[rule] as f64);
                let front = 32.0 / 15.0 * largest / (1.0 - (-2.0 * sigma).exp());
                assert!(smaller.is_none_or(|half| front * (-4.0 * half * sigma).exp() > 0.999 * wanted), "{name} {sigma}: {known:?}");
                seen += 1;
            }
        };
        for step in 0..40 {
            let sigma = 0.05 * 1.12f64.powi(step);
            for c in [1e-3, 0.1, 1.0, 9.0, 100.0] {
                let below = 1.0 - c * sigma.sinh().powi(2);
                if below > 0.0 {
                    let root = f64::sqrt(c);
                    check("1/(1 + c z²)", root.atan() / root, sigma, 1.0 / below, &|z| 1.0 / (1.0 + c * z * z));
                }
            }
            for k in [0.5, 5.0, 40.0] {
                let largest = f64::cosh(k * sigma.sinh());
                if largest < 1e30 {
                    check("cos kz", f64::sin(k) / k, sigma, largest, &|z| (k * z).cos());
                }
            }
        }
        assert!(seen > 1000, "{seen}");
    }

    #[test]
    fn what_is_not_finite_is_refused() {
        let known = Known::fewest(1.0, 1.0, 1e-10).unwrap();
        assert!(matches!(known.mean(&mut Even(|z| 1.0 / (z - z))), Err(NumError::NotFinite { .. })));
        assert!(Known::fewest(1e-3, 1.0, 1e-10).is_none() && Known::fewest(1.0, f64::INFINITY, 1e-10).is_none());
        assert!(Known::fewest(1.0, 1.0, 0.0).is_none() && Known::fewest(1.0, f64::NAN, 1e-10).is_none());
    }
}
