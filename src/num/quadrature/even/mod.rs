//! The mean of an even function over [−1, 1] by nested rules: each keeps the values of the one before.

mod nodes;
mod patterson;
mod rule;

pub(crate) use nodes::{Nodes, Stage};

use super::super::bounded::UNIT;
use super::super::error::NumError;
use nodes::{GUARDS, STAGES};
use rule::{Rule, dot, truncation};

/// Nodes in the half of the largest rule.
const MOST: usize = 256;
/// Nodes in the half that are kept without further ado.
const FEW: usize = 16;
/// The rules from 15 points on; the first is compared with that of 7 points.
static LEVELS: [Rule; 6] = [
    patterson::PATTERSON_15.plain(),
    patterson::PATTERSON_31.plain(),
    patterson::PATTERSON_63.plain(),
    patterson::PATTERSON_127.plain(),
    patterson::PATTERSON_255.plain(),
    patterson::PATTERSON_511.plain(),
];
/// Rules that are tried whatever the ones before have shown.
const ALWAYS: usize = 3;
/// A function that is zero everywhere is believed from this rule on.
const BLANK_LEVEL: usize = 4;
/// Coefficients of this share of the size have not begun to fall: an oscillation that more points resolve.
const UNRESOLVED: f64 = 3e-3;

/// A function that is even in z, asked at nodes z in [0, 1).
pub(crate) trait EvenIntegrand {
    /// Whether [`Self::fill`] gives bounds of its own on the errors of values.
    const BOUNDED: bool;

    /// Values, and bounds on their errors beside [`Self::relative`] and [`Self::displacement`].
    fn fill(&mut self, nodes: &Nodes, values: &mut [f64], errors: &mut [f64]);

    /// A bound on the relative error of every value.
    fn relative(&self) -> f64 {
        0.0
    }

    /// Radii at the nodes in some unit, where the end z = 1 is the axis.
    fn radii<'a>(&self, _nodes: &'a Nodes) -> Option<&'a [f64]> {
        None
    }

    /// What the rounding of the nodes does to the mean, from the values at all nodes in rising order.
    fn displacement(&self, _stage: &Stage, _values: &[f64]) -> f64 {
        0.0
    }
}

/// What the rules found.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Mean {
    pub(crate) value: f64,
    /// Bound on what the rule leaves out.
    pub(crate) left_out: f64,
    /// Bound on the effect of rounding.
    pub(crate) noise: f64,
    pub(crate) evaluations: u64,
    /// Whether the accepted error was reached.
    pub(crate) reached: bool,
}

/// Climbs the rules until `accepted`(value) is met or no rule is likely to meet it.
///
/// # Errors
/// [`NumError::NotFinite`] where the integrand is not; its place is z.
pub(crate) fn mean<I: EvenIntegrand>(integrand: &mut I, most: u64, accepted: impl Fn(f64) -> f64) -> Result<Mean, NumError> {
    let mut few = State::<FEW>::new();
    if few.begin(integrand, &accepted)? || few.climb(integrand, 1..2, most, &accepted)? {
        return Ok(few.mean);
    }
    let mut many = State::<MOST>::new();
    many.values[..FEW].copy_from_slice(&few.values);
    many.errors[..FEW].copy_from_slice(&few.errors);
    (many.mean, many.gap) = (few.mean, few.gap);
    many.climb(integrand, 2..LEVELS.len(), most, &accepted)?;
    Ok(many.mean)
}

/// Values so far, from the centre outwards.
struct State<const N: usize> {
    values: [f64; N],
    errors: [f64; N],
    mean: Mean,
    /// The difference between the last two rules.
    gap: f64,
}

/// What one rule has shown.
enum Verdict {
    /// The tolerance is met, but for what the guards say.
    Enough,
    /// The next rule may help.
    Climb,
    /// It will not.
    Stop,
}

impl<const N: usize> State<N> {
    fn new() -> Self {
        Self { values: [0.0; N], errors: [0.0; N], mean: Mean::default(), gap: f64::INFINITY }
    }

    /// The first rule, its guards asked in the same block; true where the end is reached.
    #[inline]
    fn begin<I: EvenIntegrand>(&mut self, integrand: &mut I, accepted: &impl Fn(f64) -> f64) -> Result<bool, NumError> {
        const FIRST: usize = 8;
        let (rule, stage): (&Rule, &Stage) = (&LEVELS[0], &STAGES[0]);
        let (mut values, mut errors) = ([0.0; FIRST + GUARDS], [0.0; FIRST + GUARDS]);
        integrand.fill(&stage.fresh, &mut values, &mut errors);
        self.mean.evaluations = (FIRST + GUARDS) as u64;
        self.values[..FIRST].copy_from_slice(&values[..FIRST]);
        self.errors[..FIRST].copy_from_slice(&errors[..FIRST]);
        let coarse = &patterson::PATTERSON_7.weights;
        self.mean.value = (values[0] * coarse[0] + values[2] * coarse[1]) + (values[4] * coarse[2] + values[6] * coarse[3]);
        let verdict = self.judge(integrand, 0, rule, stage, FIRST, accepted)?;
        if let Verdict::Enough = verdict {
            let beyond = self.beyond_the_last_node(integrand, stage, FIRST, &values[FIRST..], &errors[FIRST..]);
            return Ok(self.is_enough(beyond, accepted));
        }
        Ok(matches!(verdict, Verdict::Stop))
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
            let stage: &Stage = stage;
            let count = rule.weights.len();
            if self.mean.evaluations + (count / 2 + GUARDS) as u64 > most {
                return Ok(true);
            }
            self.ask(integrand, stage, count);
            match self.judge(integrand, level, rule, stage, count, accepted)? {
                Verdict::Stop => return Ok(true),
                Verdict::Climb => {}
                Verdict::Enough => {
                    let (mut seen, mut errors) = ([0.0; GUARDS], [0.0; GUARDS]);
                    integrand.fill(&stage.guards, &mut seen, &mut errors);
                    self.mean.evaluations += GUARDS as u64;
                    let beyond = self.beyond_the_last_node(integrand, stage, count, &seen, &errors);
                    if self.is_enough(beyond, accepted) {
                        return Ok(true);
                    }
                }
            }
        }
        Ok(false)
    }

    fn is_enough(&mut self, beyond: f64, accepted: &impl Fn(f64) -> f64) -> bool {
        self.mean.left_out += beyond;
        self.mean.reached = self.mean.left_out + self.mean.noise <= accepted(self.mean.value);
        self.mean.reached
    }

    /// Sums up the values at the nodes of a rule; `mean.value` is that of the rule before.
    #[inline(always)]
    fn judge<I: EvenIntegrand>(
        &mut self,
        integrand: &I,
        level: usize,
        rule: &Rule,
        stage: &Stage,
        count: usize,
        accepted: &impl Fn(f64) -> f64,
    ) -> Result<Verdict, NumError> {
        let (values, errors) = (&self.values[..count], &self.errors[..count]);
        let sums = rule.apply(values, I::BOUNDED.then_some(errors));
        if !(sums.value.is_finite() && sums.size.is_finite()) {
            let bad = values.iter().position(|v| !v.is_finite()).unwrap_or(0);
            return Err(NumError::NotFinite { at: patterson::NODES[bad * (MOST / count)] });
        }
        let relative = 8.0 * UNIT + integrand.relative();
        let floor = sums.noise + relative * sums.size + integrand.displacement(stage, values);
        // An unknown error is an unbounded one.
        let floor = if floor.is_nan() { f64::INFINITY } else { floor };
        // Steps of two degrees from the highest coefficient to the degree of exactness; and the least that is made of them.
        let (ahead, least) = if level == 0 { (6, 1e-2) } else { (3 * count as i32 / 4, 1e-4) };
        let gap = (sums.value - self.mean.value).abs();
        let (left_out, rate) = truncation(sums.levels, (gap, self.gap), floor, sums.size, ahead, least);
        self.gap = gap;
        let evaluations = self.mean.evaluations;
        self.mean = Mean { value: sums.value, left_out, noise: floor, evaluations, reached: false };
        let target = accepted(sums.value);
        let blank = sums.size == 0.0 && level < BLANK_LEVEL;
        if !blank && left_out + floor <= target {
            return Ok(Verdict::Enough);
        }
        if !blank && floor > 0.99 * target && left_out <= floor {
            return Ok(Verdict::Stop);
        }
        if level + 1 < ALWAYS || blank || sums.levels[2] > UNRESOLVED * sums.size {
            return Ok(Verdict::Climb);
        }
        let predicted = left_out * rate.powi(count as i32 / 4);
        Ok(if predicted <= target { Verdict::Climb } else { Verdict::Stop })
    }

    /// Fills in the values at the nodes that the rule before does not have.
    fn ask<I: EvenIntegrand>(&mut self, integrand: &mut I, stage: &Stage, count: usize) {
        let fresh = &stage.fresh;
        let half = count / 2;
        let (mut values, mut errors) = ([0.0; N], [0.0; N]);
        integrand.fill(fresh, &mut values[..half], &mut errors[..half]);
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

    /// What a narrow feature between the last node and the end would add: the values there against the polynomial through
    /// all nodes.
    #[inline]
    fn beyond_the_last_node<I: EvenIntegrand>(&self, integrand: &I, stage: &Stage, count: usize, seen: &[f64], errors: &[f64]) -> f64 {
        let values = &self.values[..count];
        let largest = |list: &[f64]| list.iter().fold(0.0, |most: f64, v| if v.abs() > most { v.abs() } else { most });
        let relative = integrand.relative() + 4.0 * UNIT;
        let doubt = relative * largest(values) + if I::BOUNDED { largest(&self.errors[..count]) } else { 0.0 };
        let mut worst = 0.0f64;
        for (((seen, error), row), gain) in seen.iter().zip(errors).zip(&stage.predict).zip(&stage.gain) {
            let off = (seen - dot(row, values)).abs() - error - relative * seen.abs() - gain * doubt;
            worst = if off.is_nan() { f64::INFINITY } else { worst.max(off) };
        }
        let hidden = match integrand.radii(&stage.guards) {
            Some([.., first, second, third]) => hidden(&[*first, *second, *third], seen, errors, relative),
            _ => 0.0,
        };
        (worst + hidden) * stage.beyond
    }
}

/// What may be hidden between the last two guards, where a function that is smooth at the axis is a whole power of r.
///
/// Below a narrow step rᵏ becomes another power: the exponents on both sides of the middle guard differ.
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
