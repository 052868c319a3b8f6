//! Algebraic behaviour at the axis: the double-exponential rule in the angle, of which half suffices.

use super::Radii;
use super::forms::Extent;
use crate::num::bounded::UNIT;
use crate::num::{Estimate, NumError};
use std::f64::consts::PI;
use std::sync::LazyLock;

/// Nodes of the finest rule up to the deepest, at a distance of 10⁻²⁷⁰ of the axis.
const NODES: usize = 96;
/// Steps per unit of the double-exponential variable, the finest.
const FINEST: usize = 16;
/// Nodes that are asked at a time.
const CHUNK: usize = 8;

/// sin of the angle from the axis at node k of the finest rule, tan of it, and dτ/dv there.
struct Ladder {
    sine: Vec<f64>,
    versine: Vec<f64>,
    tangent: Vec<f64>,
    weight: Vec<f64>,
}

/// cos(π i/16).
static COSINES: LazyLock<[f64; 32]> = LazyLock::new(|| std::array::from_fn(|i| (PI * i as f64 / 16.0).cos()));

/// τ = (π/2) tanh((π/2) sinh v): the integrand is even in τ, so v ≥ 0 suffices, and the only end is the axis.
static LADDER: LazyLock<Ladder> = LazyLock::new(|| {
    let mut ladder = Ladder { sine: Vec::new(), versine: Vec::new(), tangent: Vec::new(), weight: Vec::new() };
    for k in 0..NODES {
        let v = k as f64 / FINEST as f64;
        let q = (-PI * v.sinh()).exp();
        // The angle from the axis, and that from x.
        let (t, tau) = (PI * q / (1.0 + q), 0.5 * PI * (1.0 - q) / (1.0 + q));
        let half = (0.5 * tau).sin();
        ladder.sine.push(t.sin());
        ladder.versine.push(2.0 * half * half);
        ladder.tangent.push(t.tan().min(1e3));
        ladder.weight.push(PI * PI * v.cosh() * q / ((1.0 + q) * (1.0 + q)));
    }
    ladder
});

/// What the rule is asked for.
pub(crate) struct Wish<F> {
    /// The error that is accepted beside a value.
    pub(crate) accepted: F,
    /// Whether the rounding of r is to be charged, from differences between nodes.
    pub(crate) charge_r: bool,
}

/// ∫ f′ dτ from the axis to x, f′ asked in blocks for values and error bounds; `None` where the finest rule does not reach
/// what is accepted, with the evaluations spent.
pub(crate) fn from_the_axis(
    ask: &mut impl FnMut(Radii<'_>, &mut [f64], &mut [f64]),
    extent: &Extent,
    wish: &Wish<impl Fn(f64) -> f64>,
) -> Result<(Option<Estimate>, u64), NumError> {
    let ladder = &*LADDER;
    let mut work = Trapezium { sum: 0.0, size: 0.0, noise: 0.0, tail: 0.0, evaluations: 0, values: [0.0; NODES], deepest: NODES };
    let mut before = [f64::INFINITY; 2];
    for (level, step) in [8usize, 4, 2, 1].into_iter().enumerate() {
        // At first every node of the coarsest rule from x down to where nothing is left, then those between.
        let (first, every) = if level == 0 { (0, step) } else { (step, 2 * step) };
        work.add(ask, extent, ladder, first, every)?;
        let h = step as f64 / FINEST as f64;
        let (value, size) = (h * work.sum, h * work.size);
        let moved = if wish.charge_r { 2.0 * work.moved(ladder, step) } else { 0.0 };
        let noise = h * work.noise + UNIT * (8.0 * size + moved) + h * work.tail;
        let gap = (value - before[0]).abs();
        let last = (before[0] - before[1]).abs() / size;
        let seen = if gap <= noise { gap } else { 10.0 * gap * squared(gap / size, last) };
        let left_out = seen.max(10.0 * size * last.powf(2.5));
        let accepted = (wish.accepted)(value);
        let seems_enough = level > 1 && left_out + noise <= accepted;
        // Rules may agree by chance, as on an oscillation that none of them resolves.
        let left_out = if seems_enough { left_out.max(10.0 * size * work.unresolved(ladder, step, h / size)) } else { left_out };
        if seems_enough && left_out + noise <= accepted {
            let least = if left_out > noise { 0.999 * accepted } else { 0.0 };
            let found = Estimate { value, error: least.max(left_out + noise), evaluations: work.evaluations };
            return Ok((Some(found), work.evaluations));
        }
        before = [value, before[0]];
    }
    Ok((None, work.evaluations))
}

/// By how much a rule is better than the one of twice its step, from the last two relative differences between rules.
///
/// The error of half the step is the square of that of the step. Where that is seen to happen the root of the difference is
/// counted, and no more than 1e−4.
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
    /// The node beyond which nothing is left.
    deepest: usize,
}

impl Trapezium {
    /// Adds nodes `first`, `first` + `every`, …
    fn add(
        &mut self,
        ask: &mut impl FnMut(Radii<'_>, &mut [f64], &mut [f64]),
        extent: &Extent,
        ladder: &Ladder,
        first: usize,
        every: usize,
    ) -> Result<(), NumError> {
        let mut node = first;
        while node < self.deepest {
            let count = (self.deepest - node).div_ceil(every).min(CHUNK);
            let (mut r, mut below, mut out, mut errors) = ([0.0; CHUNK], [0.0; CHUNK], [0.0; CHUNK], [0.0; CHUNK]);
            for i in 0..count {
                let k = node + i * every;
                // Below the smallest normal number f′ has no digits.
                r[i] = (extent.x * ladder.sine[k]).max(f64::MIN_POSITIVE);
                below[i] = extent.rest + extent.x * ladder.versine[k];
            }
            let at = Radii { r: &r[..count], past_start: &r[..count], below_limit: &below[..count] };
            ask(at, &mut out[..count], &mut errors[..count]);
            self.evaluations += count as u64;
            let mut last = [0.0; 2];
            for i in 0..count {
                let k = node + i * every;
                if !out[i].is_finite() {
                    return Err(NumError::NotFinite { at: r[i] });
                }
                self.values[k] = out[i];
                let weight = if k == 0 { 0.5 } else { 1.0 } * ladder.weight[k];
                self.sum += weight * out[i];
                self.size += weight * out[i].abs();
                // An unknown error is an unbounded one.
                self.noise += if errors[i].is_nan() { f64::INFINITY } else { weight * errors[i] };
                last = [weight * out[i].abs(), last[0]];
            }
            node += count * every;
            if first == 0 {
                // Terms fall ever faster: two small ones end the sum.
                self.tail = 4.0 * (last[0] + last[1]);
                if count == CHUNK && last[0] + last[1] <= 1e-18 * self.size {
                    self.deepest = node;
                }
            }
        }
        Ok(())
    }

    /// The relative error that the terms' spectrum foretells: twice the highest frequency that the step can tell is what the rule
    /// mistakes for the mean, and resolved terms fall like an exponential of the frequency.
    fn unresolved(&self, ladder: &Ladder, step: usize, unit: f64) -> f64 {
        let mut terms = [0.0; NODES];
        let mut count = 0;
        for (slot, k) in terms.iter_mut().zip((0..self.deepest).step_by(step)) {
            *slot = if k == 0 { 0.5 } else { 1.0 } * ladder.weight[k] * self.values[k];
            count += 1;
        }
        let cosines = &*COSINES;
        let content = |sixteenth: usize| {
            let sum: f64 = terms[..count].iter().enumerate().map(|(j, term)| term * cosines[(sixteenth * j) & 31]).sum();
            (sum * unit).abs()
        };
        let (low, high) = (content(7).max(content(9)), content(13).max(content(15)));
        // From 7/8 of that frequency to twice it there are three times as many steps as from 1/2 to 7/8.
        if high >= low { high } else { high * (high / low).powi(3) }
    }

    /// ∫ |r df′/dr| dτ = ∫ tan t |df′|, t from the axis.
    fn moved(&self, ladder: &Ladder, step: usize) -> f64 {
        let nodes = (0..self.deepest).step_by(step);
        nodes.clone().zip(nodes.skip(1)).map(|(k, next)| (self.values[k] - self.values[next]).abs() * ladder.tangent[k]).sum()
    }
}
