//! Algebraic behaviour at the axis: one half of the double-exponential rule in the angle.

use super::Radii;
use super::forms::Extent;
use crate::bounded::UNIT;
use crate::{Estimate, NumError};
use std::f64::consts::PI;
use std::sync::LazyLock;

/// Nodes of the finest rule; the last one lies at a relative distance of 10⁻²⁷⁰ from the axis.
const NODES: usize = 96;
/// Steps of the finest rule per unit of the double-exponential variable.
const FINEST: usize = 16;
/// Nodes of the finest rule that are always used, up to v = 2.
const LEAST_NODES: usize = 2 * FINEST + 1;
/// Nodes evaluated at a time.
const CHUNK: usize = 8;

/// Strides of the rules among the nodes of the finest rule, coarsest first.
const STRIDES: [usize; 4] = [8, 4, 2, 1];

/// The nodes that one rule adds, from x down to the axis: index k in the finest rule, sin of the angle from the axis, 1 − cos
/// of the angle from x, and dτ/dv, halved at x.
#[derive(Default)]
struct Rung {
    index: Vec<usize>,
    sine: Vec<f64>,
    versine: Vec<f64>,
    weight: Vec<f64>,
}

struct Ladder {
    rungs: [Rung; STRIDES.len()],
    /// For every node of the finest rule, tan of its angle from the axis and its weight.
    tangent: Vec<f64>,
    weight: Vec<f64>,
}

/// cos(π i j/16) for the four frequencies i at which the spectrum of the terms j is taken.
static COSINES: LazyLock<[[f64; 4]; NODES]> =
    LazyLock::new(|| std::array::from_fn(|j| [7usize, 9, 13, 15].map(|i| (PI * ((i * j) % 32) as f64 / 16.0).cos())));

/// τ = (π/2) tanh((π/2) sinh v): the integrand is even in τ, so v ≥ 0 suffices, and the only end is the axis.
static LADDER: LazyLock<Ladder> = LazyLock::new(|| {
    let mut ladder = Ladder { rungs: Default::default(), tangent: Vec::new(), weight: Vec::new() };
    for k in 0..NODES {
        let v = k as f64 / FINEST as f64;
        let q = (-PI * v.sinh()).exp();
        // The angles from the axis and from x.
        let (t, tau) = (PI * q / (1.0 + q), 0.5 * PI * (1.0 - q) / (1.0 + q));
        let half = (0.5 * tau).sin();
        let whole = PI * PI * v.cosh() * q / ((1.0 + q) * (1.0 + q));
        let weight = if k == 0 { 0.5 * whole } else { whole };
        ladder.tangent.push(t.tan().min(1e3));
        ladder.weight.push(weight);
        // The coarsest rule that contains the node.
        let Some(rung) = STRIDES.iter().position(|step| k % step == 0).and_then(|level| ladder.rungs.get_mut(level)) else { continue };
        rung.index.push(k);
        rung.sine.push(t.sin());
        rung.versine.push(2.0 * half * half);
        rung.weight.push(weight);
    }
    ladder
});

/// The first rule that may be accepted; it requires two earlier rules.
const EARLIEST: usize = 2;

/// The accuracy required of the rule.
pub struct Wish<F> {
    /// The absolute tolerance as a function of the value.
    pub accepted: F,
    /// Whether to include the rounding of r, estimated from differences between nodes.
    pub charge_r: bool,
}

/// ∫ f′ dτ from the axis to x, with f′ evaluated in blocks with error bounds, and the number of evaluations; `None` if the
/// finest rule does not reach the tolerance.
pub fn from_the_axis(
    ask: &mut impl FnMut(Radii<'_>, &mut [f64], &mut [f64]),
    extent: &Extent,
    wish: &Wish<impl Fn(f64) -> f64>,
) -> Result<(Option<Estimate>, u64), NumError> {
    let ladder = &*LADDER;
    let mut work = Trapezium { sum: 0.0, size: 0.0, noise: 0.0, tail: 0.0, evaluations: 0, values: [0.0; NODES], deepest: NODES };
    let mut before = [f64::INFINITY; 2];
    for (level, (step, rung)) in STRIDES.into_iter().zip(&ladder.rungs).enumerate() {
        // Add every node of the coarsest rule from x until the terms are negligible, then the nodes between.
        work.add(ask, extent, rung, level == 0)?;
        let h = step as f64 / FINEST as f64;
        let (value, size) = (h * work.sum, h * work.size);
        if level < EARLIEST {
            before = [value, before[0]];
            continue;
        }
        let moved = if wish.charge_r { 2.0 * work.moved(ladder, step) } else { 0.0 };
        let noise = h * work.noise + UNIT * (8.0 * size + moved) + h * work.tail;
        let gap = (value - before[0]).abs();
        let last = (before[0] - before[1]).abs() / size;
        let seen = if gap <= noise { gap } else { 10.0 * gap * squared(gap / size, last) };
        let left_out = seen.max(10.0 * size * last.powf(2.5));
        let accepted = (wish.accepted)(value);
        let seems_enough = left_out + noise <= accepted;
        // Rules may agree by chance, for example on an unresolved oscillation.
        let left_out = if seems_enough { left_out.max(10.0 * size * work.unresolved(ladder, step, h / size)) } else { left_out };
        if seems_enough && left_out + noise <= accepted {
            let least = if left_out > noise { 0.999 * accepted } else { 0.0 };
            let found = Estimate::estimated(value, least.max(left_out + noise), work.evaluations);
            return Ok((Some(found), work.evaluations));
        }
        before = [value, before[0]];
    }
    Ok((None, work.evaluations))
}

/// Returns a bound on |f′(r)/f′(r₀)| − 1 for r = x·share below the smallest normal number r₀, or 0 if r is not below it.
///
/// At such radii f′ has too few digits, so it is evaluated at r₀ instead.
/// It may be 0 there, or larger: by less than r₀/r, because an f′ that grows like 1/r has no integral.
#[inline]
#[must_use]
pub fn growth_below_normal(x: f64, share: f64) -> f64 {
    if x * share < f64::MIN_POSITIVE { (f64::MIN_POSITIVE / x / share).min(f64::MAX) } else { 0.0 }
}

/// The ratio of the errors of a rule and of the rule with twice its step, from the last two relative differences between rules.
///
/// Halving the step squares the relative error. If the differences confirm this, the ratio is the root of the difference, at
/// least 1e−4.
fn squared(gap: f64, last: f64) -> f64 {
    if !last.is_finite() {
        return 1.0;
    }
    if gap <= last.powf(1.5) { gap.sqrt().clamp(1e-4, 1.0) } else { (gap / last).clamp(0.1, 1.0) }
}

/// The running sum of all rules.
struct Trapezium {
    sum: f64,
    size: f64,
    noise: f64,
    /// The last terms, beyond which the rule is cut.
    tail: f64,
    evaluations: u64,
    values: [f64; NODES],
    /// The node beyond which terms are negligible.
    deepest: usize,
}

impl Trapezium {
    /// Adds the nodes of one rung; the first rung determines where terms become negligible.
    #[inline(always)]
    fn add(
        &mut self,
        ask: &mut impl FnMut(Radii<'_>, &mut [f64], &mut [f64]),
        extent: &Extent,
        rung: &Rung,
        first: bool,
    ) -> Result<(), NumError> {
        let chunks = rung.index.chunks(CHUNK).zip(rung.sine.chunks(CHUNK)).zip(rung.versine.chunks(CHUNK)).zip(rung.weight.chunks(CHUNK));
        for (((index, sine), versine), weight) in chunks {
            // Nodes beyond the deepest node have negligible weight.
            let count = index.iter().take_while(|k| **k < self.deepest).count();
            if count == 0 {
                break;
            }
            let (mut r, mut below, mut out, mut errors) = ([0.0; CHUNK], [0.0; CHUNK], [0.0; CHUNK], [0.0; CHUNK]);
            for (((r, below), sine), versine) in r.iter_mut().zip(&mut below).zip(sine).zip(versine) {
                // See `growth_below_normal`.
                *r = (extent.x * sine).max(f64::MIN_POSITIVE);
                *below = extent.rest + extent.x * versine;
            }
            if count == CHUNK {
                ask(Radii { r: &r, past_start: &r, below_limit: &below }, &mut out, &mut errors);
            } else {
                let at = Radii { r: &r[..count], past_start: &r[..count], below_limit: &below[..count] };
                ask(at, &mut out[..count], &mut errors[..count]);
            }
            self.evaluations += count as u64;
            // Sines decrease: most rules do not come near underflow.
            if sine.get(count - 1).is_some_and(|least| extent.x * least < f64::MIN_POSITIVE) {
                for ((error, out), sine) in errors.iter_mut().zip(&out).zip(sine).take(count) {
                    *error += out.abs() * growth_below_normal(extent.x, *sine);
                }
            }
            let (mut sum, mut size, mut noise) = (0.0, 0.0, 0.0);
            let mut last = [0.0; 2];
            for (((out, error), weight), k) in out.iter().zip(&errors).zip(weight).zip(index).take(count) {
                if let Some(slot) = self.values.get_mut(*k) {
                    *slot = *out;
                }
                let term = weight * out;
                sum += term;
                size += term.abs();
                noise += weight * error;
                last = [term.abs(), last[0]];
            }
            if !(sum.is_finite() && size.is_finite()) {
                let bad = out.iter().position(|v| !v.is_finite()).unwrap_or(0);
                return Err(NumError::NotFinite { at: r[bad] });
            }
            self.sum += sum;
            self.size += size;
            // Treat an unknown error as unbounded.
            self.noise += if noise.is_nan() { f64::INFINITY } else { noise };
            if first {
                // Terms decrease at an increasing rate: after two small terms all further terms are small too.
                let nothing = 1e-18 * self.size;
                let size = |place: usize| weight[place] * out[place].abs();
                let mut small = count;
                while small > 0 && size(small - 1) <= nothing {
                    small -= 1;
                }
                // A sum of zeros is continued to the end, and any other sum at least down to 3e-5 of x.
                if count == CHUNK && small + 2 <= count && self.size > 0.0 {
                    self.tail = 16.0 * (size(small) + size(small + 1));
                    self.deepest = (index[small] + 1).max(LEAST_NODES);
                    break;
                }
                self.tail = 4.0 * (last[0] + last[1]);
            }
        }
        Ok(())
    }

    /// The relative error that the terms' spectrum foretells: twice the highest frequency that the step can tell is what the rule
    /// mistakes for the mean, and resolved terms fall like an exponential of the frequency.
    fn unresolved(&self, ladder: &Ladder, step: usize, unit: f64) -> f64 {
        let mut content = [0.0; 4];
        let terms = self.values[..self.deepest].iter().zip(&ladder.weight).step_by(step);
        for ((value, weight), cosines) in terms.zip(COSINES.iter()) {
            let term = value * weight;
            for (sum, cosine) in content.iter_mut().zip(cosines) {
                *sum += term * cosine;
            }
        }
        let [a, b, c, d] = content.map(|sum| (sum * unit).abs());
        let (low, high) = (a.max(b), c.max(d));
        // From 7/8 of that frequency to twice it there are three times as many steps as from 1/2 to 7/8.
        if high >= low { high } else { high * (high / low).powi(3) }
    }

    /// ∫ |r df′/dr| dτ = ∫ tan t |df′|, t from the axis.
    fn moved(&self, ladder: &Ladder, step: usize) -> f64 {
        let mut nodes = self.values[..self.deepest].iter().zip(&ladder.tangent).step_by(step);
        let Some((mut before, mut tangent)) = nodes.next() else { return 0.0 };
        let mut total = 0.0;
        for (value, own) in nodes {
            total += (before - value).abs() * tangent;
            (before, tangent) = (value, own);
        }
        total
    }
}
