//! The mean of an even function over [−1, 1] by nested rules: each rule reuses the values of the previous one.

mod expansion;
mod gauss;
mod nodes;
mod patterson;
mod rule;

pub(crate) use expansion::Expansion;
pub use gauss::Known;
pub use nodes::{Middles, Nodes};

use super::super::bounded::UNIT;
use super::super::error::NumError;
use nodes::{FIRST, First, GUARDS, STAGES, SUMS};
use rule::{Rule, Sums, dot, larger, truncation};

/// Nodes in the half of the largest rule.
const HALF_NODES: usize = 256;
/// Nodes in the half of the first rule.
const FEWEST: usize = 8;
/// Nodes in the half of the third rule.
const FEW: usize = 32;
/// The rules from 15 points on; the first is compared with the rule of 7 points.
static LEVELS: [Rule; 6] = [
    patterson::PATTERSON_15.plain(),
    patterson::PATTERSON_31.plain(),
    patterson::PATTERSON_63.plain(),
    patterson::PATTERSON_127.plain(),
    patterson::PATTERSON_255.plain(),
    patterson::PATTERSON_511.plain(),
];
/// Number of rules that are always tried.
const ALWAYS: usize = 3;
/// Smallest factor by which [`truncation`] multiplies the difference between two rules, however fast the coefficients decrease.
const LEAST: f64 = 1e-4;
/// The smallest factor for the first rule, or if the integrand is steep.
const LEAST_FIRST: f64 = 1e-2;
/// First rule from which zeros at all nodes imply a zero function.
const BLANK_LEVEL: usize = 4;
/// Coefficients above this fraction of the size have not begun to decrease: an oscillation that needs more points.
const UNRESOLVED: f64 = 3e-3;

/// A function that is even in z, evaluated at nodes z in [0, 1).
pub trait EvenIntegrand {
    /// Whether [`Self::fill`] returns error bounds of the values.
    const BOUNDED: bool;
    /// Most nodes that [`Self::fill`] is given; a power of two from 8 on.
    const BLOCK: usize;
    /// Whether the overhead of a block dominates its cost; if so, the first rule evaluates its guards together with its nodes.
    const TOGETHER: bool;

    /// Values, and bounds on their errors in addition to [`Self::relative`] and [`Self::displacement`].
    fn fill(&mut self, nodes: Nodes<'_>, values: &mut [f64], errors: &mut [f64]);

    /// A bound on the relative error of every value.
    fn relative(&self) -> f64 {
        0.0
    }

    /// Radii at the nodes in some unit, where the end z = 1 is the axis.
    fn radii<'a>(&self, _nodes: Nodes<'a>) -> Option<&'a [f64]> {
        None
    }

    /// The effect of the rounding of the nodes on the mean, from the values at all nodes in increasing order.
    fn displacement(&self, _middles: Middles<'_>, _values: &[f64]) -> f64 {
        0.0
    }
}

/// The result of the rules.
#[derive(Clone, Copy, Debug, Default)]
pub struct Mean {
    /// The mean.
    pub value: f64,
    /// Bound on the truncation error.
    pub left_out: f64,
    /// Bound on the effect of rounding.
    pub noise: f64,
    /// Number of evaluations of the integrand.
    pub evaluations: u64,
    /// Whether the tolerance was met.
    pub reached: bool,
}

/// Applies successive rules until the tolerance `accepted`(value) is met or no rule is likely to meet it.
///
/// # Errors
/// [`NumError::NotFinite`] if the integrand is not finite, with the node z.
#[inline]
pub fn mean<I: EvenIntegrand>(integrand: &mut I, most: u64, accepted: impl Fn(f64) -> f64) -> Result<Mean, NumError> {
    let (mut values, mut errors) = ([0.0; FEWEST + GUARDS], [0.0; FEWEST + GUARDS]);
    let (mean, gap) = match begin(integrand, &mut values, &mut errors, &accepted)? {
        (mean, None) => return Ok(mean),
        (mean, Some(gap)) => (mean, gap),
    };
    let mut few = State::<FEW>::new(mean, gap);
    few.values[..FEWEST].copy_from_slice(&values[..FEWEST]);
    few.errors[..FEWEST].copy_from_slice(&errors[..FEWEST]);
    climb(integrand, few, most, &accepted)
}

/// The rules after the first.
#[inline(never)]
fn climb<I: EvenIntegrand>(integrand: &mut I, mut few: State<FEW>, most: u64, accepted: &impl Fn(f64) -> f64) -> Result<Mean, NumError> {
    if few.climb(integrand, 1..3, most, accepted)? {
        return Ok(few.mean);
    }
    let mut many = State::<HALF_NODES>::after(&few);
    many.climb(integrand, 3..LEVELS.len(), most, accepted)?;
    Ok(many.mean)
}

/// The first rule: its result, and the difference to the embedded rule if the next rules may help.
#[inline(always)]
fn begin<I: EvenIntegrand>(
    integrand: &mut I,
    values: &mut [f64; FEWEST + GUARDS],
    errors: &mut [f64; FEWEST + GUARDS],
    accepted: &impl Fn(f64) -> f64,
) -> Result<(Mean, Option<f64>), NumError> {
    let first: &First = &FIRST;
    if I::TOGETHER {
        integrand.fill(first.together.all(), values, errors);
    } else {
        integrand.fill(first.nodes.all(), &mut values[..FEWEST], &mut errors[..FEWEST]);
    }
    let mut all = [0.0; SUMS];
    let (mut size, mut noise, mut largest, mut doubt) = (0.0, 0.0, 0.0f64, 0.0f64);
    for i in 0..FEWEST {
        let value = values[i];
        for (sum, share) in all.iter_mut().zip(first.shares[i]) {
            *sum += share * value;
        }
        // Weights are positive.
        size += first.weights[i] * value.abs();
        largest = larger(value.abs(), largest);
        if I::BOUNDED {
            noise += first.weights[i] * errors[i];
            doubt = larger(errors[i], doubt);
        }
    }
    let [value, a, b, c, predicted @ ..] = all;
    let [one, two, three, four] = first.seven;
    let seven = (one * values[0] + two * values[2]) + (three * values[4] + four * values[6]);
    // If the verdict is likely to be good, evaluate the guards first so that the processor need not wait.
    let at_once = I::TOGETHER || LEAST_FIRST * (value - seven).abs() <= accepted(value);
    if at_once && !I::TOGETHER {
        integrand.fill(first.guards.all(), &mut values[FEWEST..], &mut errors[FEWEST..]);
    }
    let before = Mean { value: seven, evaluations: if at_once { FEWEST + GUARDS } else { FEWEST } as u64, ..Mean::default() };
    let sums = Sums { value, size, levels: [f64::INFINITY, a.abs(), b.abs(), c.abs()], noise, largest };
    let own: &[f64; FEWEST] = values.first_chunk().unwrap_or(&[0.0; FEWEST]);
    let (verdict, mut mean) = judge(integrand, 0, &sums, first.middles(), own, (before, f64::INFINITY), accepted)?;
    match verdict {
        Verdict::Climb => return Ok((mean, Some((value - seven).abs()))),
        Verdict::Stop => return Ok((mean, None)),
        Verdict::Enough => {}
    }
    if !at_once {
        integrand.fill(first.guards.all(), &mut values[FEWEST..], &mut errors[FEWEST..]);
        mean.evaluations += GUARDS as u64;
    }
    let seen = Seen { nodes: first.guards.all(), values: &values[FEWEST..], errors: &errors[FEWEST..] };
    let doubt = (integrand.relative() + 4.0 * UNIT) * largest + doubt;
    mean.left_out += beyond_the_last_node(integrand, &seen, &predicted, &first.gain, doubt) * first.beyond;
    let next = (!mean.meets(accepted)).then(|| (value - seven).abs());
    Ok((mean, next))
}

impl Mean {
    /// Whether the tolerance is met.
    #[inline(always)]
    fn meets(&mut self, accepted: &impl Fn(f64) -> f64) -> bool {
        self.reached = self.left_out + self.noise <= accepted(self.value);
        self.reached
    }
}

/// Values so far, from the centre outwards.
struct State<const N: usize> {
    values: [f64; N],
    errors: [f64; N],
    mean: Mean,
    /// The difference between the last two rules.
    gap: f64,
}

/// Steepness limit for the value at the last node relative to its distance to the end. The ratio is π/2 for a linear function and
/// above the limit if the other end is a few times larger; smaller ratios indicate a steeper decrease.
const STEEP: f64 = 0.3;

/// The conclusion from one rule.
enum Verdict {
    /// The tolerance is met, subject to the guards.
    Enough,
    /// The next rule may help.
    Climb,
    /// The next rule will not help.
    Stop,
}

impl<const N: usize> State<N> {
    #[inline(always)]
    fn new(mean: Mean, gap: f64) -> Self {
        Self { values: [0.0; N], errors: [0.0; N], mean, gap }
    }

    /// Copies the state into one with room for more values.
    fn after<const FEWER: usize>(few: &State<FEWER>) -> Self {
        let mut own = Self::new(few.mean, few.gap);
        own.values[..FEWER].copy_from_slice(&few.values);
        own.errors[..FEWER].copy_from_slice(&few.errors);
        own
    }

    /// True where the end is reached; false where the next rules may help.
    fn climb<I: EvenIntegrand>(
        &mut self,
        integrand: &mut I,
        levels: std::ops::Range<usize>,
        most: u64,
        accepted: &impl Fn(f64) -> f64,
    ) -> Result<bool, NumError> {
        for level in levels {
            let (Some(rule), Some(stage)) = (LEVELS.get(level), STAGES.get(level)) else { return Ok(true) };
            let stage: &nodes::Stage = stage;
            let count = rule.weights.len();
            if self.mean.evaluations + (count / 2 + GUARDS) as u64 > most {
                return Ok(true);
            }
            self.ask(integrand, stage, count);
            if level + 1 < ALWAYS && self.mean.evaluations + (count + GUARDS) as u64 <= most {
                let value = dot(rule.weights, &self.values[..count]);
                let gap = (value - self.mean.value).abs();
                // The difference to the previous rule is too large for any decay of the coefficients.
                if LEAST * gap > accepted(value) && gap.is_finite() {
                    (self.mean.value, self.gap) = (value, gap);
                    continue;
                }
            }
            let sums = rule.apply(&self.values[..count], I::BOUNDED.then_some(&self.errors[..count]));
            let own = &self.values[..count];
            let gap = (sums.value - self.mean.value).abs();
            let (verdict, mean) = judge(integrand, level, &sums, stage.middles(), own, (self.mean, self.gap), accepted)?;
            (self.mean, self.gap) = (mean, gap);
            match verdict {
                Verdict::Stop => return Ok(true),
                Verdict::Climb => {}
                Verdict::Enough => {
                    let (mut values, mut errors) = ([0.0; GUARDS], [0.0; GUARDS]);
                    integrand.fill(stage.guards.all(), &mut values, &mut errors);
                    self.mean.evaluations += GUARDS as u64;
                    let seen = Seen { nodes: stage.guards.all(), values: &values, errors: &errors };
                    let mut predicted = [0.0; GUARDS];
                    for (own_value, row) in predicted.iter_mut().zip(&stage.predict) {
                        *own_value = dot(row, own);
                    }
                    let known = if I::BOUNDED { self.errors[..count].iter().fold(0.0, |most, own| larger(*own, most)) } else { 0.0 };
                    let doubt = (integrand.relative() + 4.0 * UNIT) * sums.largest + known;
                    self.mean.left_out += beyond_the_last_node(integrand, &seen, &predicted, &stage.gain, doubt) * stage.beyond;
                    if self.mean.meets(accepted) {
                        return Ok(true);
                    }
                }
            }
        }
        Ok(false)
    }

    /// Fills in the values at the nodes that the previous rule does not have.
    fn ask<I: EvenIntegrand>(&mut self, integrand: &mut I, stage: &nodes::Stage, count: usize) {
        let fresh = stage.fresh.all();
        let half = count / 2;
        let (mut values, mut errors) = ([0.0; N], [0.0; N]);
        let mut from = 0;
        while from < half {
            let to = (from + I::BLOCK).min(half);
            let Some(nodes) = fresh.part(from, to) else { break };
            integrand.fill(nodes, &mut values[from..to], &mut errors[from..to]);
            from = to;
        }
        let merge = |own: &mut [f64; N], new: &[f64; N]| {
            for i in (0..half).rev() {
                own[2 * i] = own[i];
                own[2 * i + 1] = new[i];
            }
        };
        merge(&mut self.values, &values);
        if I::BOUNDED {
            merge(&mut self.errors, &errors);
        }
        self.mean.evaluations += half as u64;
    }
}

/// Judges the sums over the values of a rule, given the result of the previous rule and its difference to the one before it.
#[inline(always)]
fn judge<I: EvenIntegrand>(
    integrand: &I,
    level: usize,
    sums: &Sums,
    middles: Middles<'_>,
    values: &[f64],
    (before, last_gap): (Mean, f64),
    accepted: &impl Fn(f64) -> f64,
) -> Result<(Verdict, Mean), NumError> {
    if !(sums.value.is_finite() && sums.size.is_finite()) {
        let bad = values.iter().position(|v| !v.is_finite()).unwrap_or(0);
        return Err(NumError::NotFinite { at: patterson::NODES[bad * (HALF_NODES / values.len())] });
    }
    let relative = 8.0 * UNIT + integrand.relative();
    let floor = sums.noise + relative * sums.size + integrand.displacement(middles, values);
    // Treat an unknown error as unbounded.
    let floor = if floor.is_nan() { f64::INFINITY } else { floor };
    let least = if level == 0 || is_steep(values, sums.largest) { LEAST_FIRST } else { LEAST };
    let gap = (sums.value - before.value).abs();
    let (left_out, rate) = truncation(sums.levels, (gap, last_gap), floor, sums.size, level + 1, least);
    let mean = Mean { value: sums.value, left_out, noise: floor, evaluations: before.evaluations, reached: false };
    let target = accepted(sums.value);
    let blank = sums.size == 0.0 && level < BLANK_LEVEL;
    if !blank && left_out + floor <= target {
        return Ok((Verdict::Enough, mean));
    }
    if !blank && floor > 0.99 * target && left_out <= floor {
        return Ok((Verdict::Stop, mean));
    }
    if level + 1 < ALWAYS || blank || sums.levels[3] > UNRESOLVED * sums.size {
        return Ok((Verdict::Climb, mean));
    }
    let predicted = left_out * rate.powi(values.len() as i32 / 4);
    Ok((if predicted <= target { Verdict::Climb } else { Verdict::Stop }, mean))
}

/// Whether the integrand decreases faster than linearly towards the end: a narrow or oscillating feature where the integrand is
/// small affects only coefficients smaller than the last one of this rule.
#[inline(always)]
fn is_steep(values: &[f64], largest: f64) -> bool {
    let distance = 1.0 - patterson::NODES[(values.len() - 1) * (HALF_NODES / values.len())];
    values.last().is_some_and(|last| last.abs() < STEEP * distance * largest)
}

/// The values at the guards of a rule.
struct Seen<'a> {
    nodes: Nodes<'a>,
    values: &'a [f64],
    errors: &'a [f64],
}

/// The height of a narrow feature between the last node and the end: the deviation of the values there from the polynomial
/// through all nodes, whose values are accurate to `doubt`.
#[inline(always)]
fn beyond_the_last_node<I: EvenIntegrand>(
    integrand: &I,
    seen: &Seen<'_>,
    predicted: &[f64; GUARDS],
    gain: &[f64; GUARDS],
    doubt: f64,
) -> f64 {
    let relative = integrand.relative() + 4.0 * UNIT;
    let mut worst = 0.0f64;
    for (((seen, error), predicted), gain) in seen.values.iter().zip(seen.errors).zip(predicted).zip(gain) {
        let off = (seen - predicted).abs() - error - relative * seen.abs() - gain * doubt;
        // Treat NaN as an infinite deviation.
        worst = if off <= worst {
            worst
        } else if off.is_nan() {
            f64::INFINITY
        } else {
            off
        };
    }
    let hidden = match integrand.radii(seen.nodes) {
        Some([.., first, second, third]) => hidden(&[*first, *second, *third], seen.values, seen.errors, relative),
        _ => 0.0,
    };
    worst + hidden
}

/// The height of a feature hidden between the last two guards, where a function smooth at the axis is an integer power of r.
///
/// Across a narrow step the exponent changes, so the exponents on both sides of the middle guard differ.
#[inline]
fn hidden(radii: &[f64; 3], seen: &[f64], errors: &[f64], relative: f64) -> f64 {
    let ([.., before, middle, last], [.., doubt, last_doubt]) = (seen, errors) else { return 0.0 };
    let [first, second, third] = *radii;
    let noise = doubt + relative * middle.abs();
    // Constant, or proportional to r: the common cases, without a logarithm.
    let near = |a: f64, b: f64| (a - b).abs() <= 0.02 * b.abs() + noise + last_doubt;
    if near(*last, *middle) || near(last * (second / third), *middle) {
        return 0.0;
    }
    if middle.abs() <= noise {
        return 0.0;
    }
    let exponent = |from: f64, to: f64, r: f64, s: f64| ((to / from).abs().ln()) / (s / r).ln();
    let (outside, inside) = (exponent(*before, *middle, first, second), exponent(*middle, *last, second, third));
    let apart = (outside - inside).abs();
    if apart <= 0.05 { 0.0 } else { middle.abs() }
}
