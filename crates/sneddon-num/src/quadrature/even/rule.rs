//! A rule for even integrands, and its error estimate.

/// A symmetric rule on [−1, 1] of 2·H − 1 points for even integrands: only the half from the centre outwards is kept.
pub(super) struct EvenRule<const H: usize> {
    /// Weights over the half, with sum 1: the mean of an even function.
    pub(super) weights: [f64; H],
    /// Coefficients of the four highest even degrees that the points can tell apart, lowest first.
    pub(super) decay: [[f64; H]; 4],
}

/// The same without its length in the type.
#[derive(Clone, Copy)]
pub(super) struct Rule {
    pub(super) weights: &'static [f64],
    pub(super) decay: [&'static [f64]; 4],
}

impl<const H: usize> EvenRule<H> {
    pub(super) const fn plain(&'static self) -> Rule {
        let [first, second, third, fourth] = &self.decay;
        Rule { weights: &self.weights, decay: [first, second, third, fourth] }
    }
}

/// The result of one rule.
#[derive(Clone, Copy, Default)]
pub(super) struct Sums {
    pub(super) value: f64,
    /// The mean of |f|.
    pub(super) size: f64,
    /// Sizes of the four highest coefficients, lowest degree first.
    pub(super) levels: [f64; 4],
    /// The mean of the error bounds.
    pub(super) noise: f64,
    /// The largest |f|.
    pub(super) largest: f64,
}

impl Rule {
    /// Every sum over the values in one pass.
    #[inline]
    pub(super) fn apply(&self, values: &[f64], errors: Option<&[f64]>) -> Sums {
        // Two lanes: seven sums of four would not stay in registers.
        const LANES: usize = 2;
        let (mut lanes, mut largest) = ([[0.0; LANES]; 6], [0.0; LANES]);
        let [first, second, third, fourth] = self.decay.map(|row| row.as_chunks::<LANES>().0);
        let chunks = values.as_chunks::<LANES>().0.iter().zip(self.weights.as_chunks::<LANES>().0);
        for ((v, w), (((a, b), c), d)) in chunks.zip(first.iter().zip(second).zip(third).zip(fourth)) {
            for i in 0..LANES {
                let weighted = w[i] * v[i];
                lanes[0][i] += weighted;
                // Weights are positive.
                lanes[1][i] += weighted.abs();
                lanes[2][i] += a[i] * v[i];
                lanes[3][i] += b[i] * v[i];
                lanes[4][i] += c[i] * v[i];
                lanes[5][i] += d[i] * v[i];
                largest[i] = larger(v[i].abs(), largest[i]);
            }
        }
        let [value, size, first, second, third, fourth] = lanes.map(|l| l[0] + l[1]);
        let noise = errors.map_or(0.0, |errors| dot(self.weights, errors));
        let largest = larger(largest[0], largest[1]);
        Sums { value, size, levels: [first.abs(), second.abs(), third.abs(), fourth.abs()], noise, largest }
    }
}

/// One instruction, unlike `f64::max`; b where a is not a number.
#[inline(always)]
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Σ a·b in four lanes, for lengths that are multiples of four.
#[inline(always)]
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut lanes = [0.0; 4];
    for (a, b) in a.chunks_exact(4).zip(b.chunks_exact(4)) {
        for i in 0..4 {
            lanes[i] += a[i] * b[i];
        }
    }
    (lanes[0] + lanes[1]) + (lanes[2] + lanes[3])
}

/// However fast the coefficients fall, no more than this is made of it: a narrow feature beside a steep power shows in the
/// last coefficients only, and those fall slowly from there on.
const LEAST_FALL: f64 = 0.1;

/// The truncation error of the rule, and the rate of decay of the coefficients over two degrees.
///
/// The rule is exact to degrees that are steps of two beyond its highest coefficient: three times 2^`doublings` of them. Ten
/// times that coefficient is left over where the fall is not seen, and less by the fall over one step where it is; over a third
/// of all steps where the last one is as steep as the one before, so that nothing slow has come to light, and no less than
/// `least`. `gap` is the difference to the rule before, which says how wrong that one was, and `last_gap` what that rule's own
/// was.
#[inline(always)]
pub(super) fn truncation(levels: [f64; 4], (gap, last_gap): (f64, f64), floor: f64, size: f64, doublings: usize, least: f64) -> (f64, f64) {
    let [zeroth, first, second, third] = levels;
    let fall = |now: f64, before: f64| {
        if now <= floor { 0.0 } else { now / if before > floor { before } else { floor } }
    };
    let (one, two) = (fall(second, first), fall(third, second));
    let before = fall(first, zeroth);
    let rate = if one > two { one } else { two };
    let rate = if before > rate { before } else { rate };
    // A rule of twice the points has the square of the error where the integrand is resolved.
    let squares = || {
        // The first rule has none before it.
        if gap <= floor || last_gap == f64::INFINITY {
            return true;
        }
        let last = last_gap / size;
        gap / size <= last * last.sqrt()
    };
    // By chance an oscillation that is not resolved may seem to fall, but not to be small.
    let steady = two <= 2.0 * one && rate < 0.5 && gap.max(first) <= 1e-3 * size && squares();
    let counted = if steady { (0..doublings).fold(rate, |power, _| power * power).clamp(least, 1.0) } else { rate.clamp(LEAST_FALL, 1.0) };
    let passed = gap * rate.clamp(LEAST_FALL, 1.0);
    let seen = if third > passed { third } else { passed };
    // A slow fall leaves a long tail: all of its terms add up where the integrand is almost singular.
    let tail = if rate < 0.5 { 1.0 } else { 0.5 / (1.0 - rate).max(0.005) };
    let mut left_out = 10.0 * seen * counted * tail;
    // The first rule may see an oscillation by its last coefficients alone, which are small by chance; the rule within it saw
    // others.
    if !steady && doublings == 1 && gap > left_out {
        left_out = gap;
    }
    // Coefficients in the rounding noise cannot fall further.
    (if seen <= floor && seen < left_out { seen } else { left_out }, rate)
}
