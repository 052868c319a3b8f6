//! Proofs that a pressure or a gap is nowhere negative, by enclosures; if they fail, the radii to examine.

use super::Indentation;
use super::cells::{Cell, Cells};
use super::landscape::{affordable, rounded};
use crate::num::stable::leg;
use crate::num::{Bound, Estimate, work};
use crate::transform::Quantities;
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};

/// The sign of a quantity from enclosures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Sign {
    /// Nowhere negative.
    Proven,
    /// Negative from this radius on, and nowhere below it.
    Negative(f64),
    /// Negative at this radius, and undecided below it.
    NegativeAt(f64),
    /// Undecided after evaluating this number of radii.
    Open(u64),
}

/// Maximum number of ranges examined for one load.
const MOST_RANGES: u64 = 1500;
/// Maximum number of radii at which a value is computed for one load.
const MOST_VALUES: u64 = 300;
/// Maximum number of steps for these values.
const PROVING: u64 = 40_000_000;
/// Smallest width of a range, relative to its radius.
const NARROWEST: f64 = 1e-12;
/// Smallest relative width of a range with a negative end, where values closer to the change of sign are more expensive.
const PLACED: f64 = 1e-9;

/// Halves ranges until each is proven nowhere negative or a negative radius is found; the last range in the list has the smallest
/// radii.
fn sign_over(
    mut open: Vec<(f64, f64)>,
    proven: impl Fn(f64, f64) -> bool,
    negative: impl Fn(f64) -> bool,
    narrow: impl Fn(f64, f64) -> bool,
) -> Sign {
    let (mut ranges, mut values) = (0, 0);
    let begin = work::left();
    let mut found = None;
    while let Some((from, to)) = open.pop() {
        ranges += 1;
        if (found == Some(to) && to - from <= PLACED * to) || proven(from, to) {
            continue;
        }
        let middle = if from > 0.0 && to > 4.0 * from { (from * to).sqrt() } else { 0.5 * (from + to) };
        if ranges > MOST_RANGES
            || values > MOST_VALUES
            || begin.saturating_sub(work::left()) > PROVING
            || work::is_exhausted()
            || narrow(from, to)
            || !(middle > from && middle < to)
        {
            return found.map_or(Sign::Open(values), |at| Sign::NegativeAt(bisected(negative, from, at)));
        }
        values += 1;
        if negative(middle) {
            // Larger radii are irrelevant from here on.
            found = Some(middle);
            open.clear();
        } else {
            open.push((middle, to));
        }
        open.push((from, middle));
    }
    found.map_or(Sign::Proven, |at| Sign::Negative(rounded(at, 8)))
}

/// The point between `from` and `to` at which a function that is nonnegative at `from` becomes negative.
fn bisected(negative: impl Fn(f64) -> bool, mut from: f64, mut to: f64) -> f64 {
    let near = PLACED * to;
    while to - from > near && !work::is_exhausted() {
        let middle = 0.5 * (from + to);
        if negative(middle) { to = middle } else { from = middle }
    }
    to
}

impl Cells {
    /// A lower bound on ∫_r^a g′/√(x² − r²) dx, which is π p/E*, for every r between two radii; −∞ if unknown.
    pub(super) fn least_pressure(&self, (from, to): (f64, f64), a: f64) -> f64 {
        // With x² = r² + y² it is ∫ (g′/x) dy.
        let root = |x: f64, r: f64| if x > r { leg(x, r) } else { 0.0 };
        let (mut sum, mut size) = (0.0, 0.0);
        // Cells that may contain r or lie below it: their total weight is bounded by the upper end of the last one.
        let mut within: Option<(f64, f64)> = None;
        for (cell, rise) in self.rises().filter(|(cell, _)| cell.upper > from && cell.lower < a) {
            let (low, high) = (cell.lower, cell.upper.min(a));
            // At the axis, use g′/x at the upper end: the first cell is only a trillionth of the contact.
            let share = rise / if rise < 0.0 && low > 0.0 { low } else { high };
            if low < to {
                within = Some((within.map_or(share, |own| own.0.min(share)), high));
                continue;
            }
            let width = |r: f64| (high - low) * (high + low) / (root(high, r) + root(low, r));
            let share = share * if share >= 0.0 { width(from) } else { width(to) };
            sum += share;
            size += share.abs();
        }
        if let Some((least, end)) = within {
            let share = if least >= 0.0 { least * root(end, to) } else { least * root(end, from) };
            sum += share;
            size += share.abs();
        }
        let low = sum - 16.0 * f64::EPSILON * size;
        if low.is_nan() { f64::NEG_INFINITY } else { low }
    }

    /// The end of the cells from `from` on in which g is proven to increase.
    fn rises_from(&self, from: f64) -> f64 {
        let beyond = self.rises().filter(|(cell, _)| cell.upper > from);
        beyond.take_while(|(_, rise)| *rise >= 0.0).last().map_or(from, |(cell, _)| cell.upper)
    }

    /// The cells beyond a contact radius: their ends, with a lower bound on g − d within each.
    fn climb(&self, a: f64) -> Vec<(f64, f64, f64)> {
        let mut height = 0.0;
        let beyond = self.rises().filter(|(cell, _)| cell.upper > a);
        let known = beyond.take_while(|(_, rise)| *rise > f64::NEG_INFINITY);
        let step = |(cell, rise): (Cell, f64)| {
            let lower = cell.lower.max(a);
            let next = height + rise * (cell.upper - lower);
            let least = next.min(height);
            height = next;
            (lower, cell.upper, least)
        };
        known.map(step).collect()
    }

    /// The width of the cell at a radius.
    fn width_at(&self, r: f64) -> f64 {
        let cells = self.rises().map(|own| own.0);
        cells.into_iter().find(|cell: &Cell| cell.upper >= r).map_or(0.0, |cell| cell.upper - cell.lower)
    }

    /// The end of the part around the axis in which g is proven to increase.
    pub(super) fn risen(&self) -> f64 {
        self.rises_from(0.0)
    }
}

impl Indentation<'_> {
    /// Whether π p/E* of a smooth contact plus the contribution of a rim, `excess`/√(a² − r²), is nowhere below −`noise` inside.
    pub(super) fn pressure_sign(&self, cells: &Cells, a: f64, excess: f64, noise: f64) -> Sign {
        let shape = self.contact.evaluator();
        let edge = |r: f64| leg(a, r.min(a));
        let proven = |from: f64, to: f64| {
            let least = cells.least_pressure((from, to), a);
            // Multiplied by the root, which is positive inside.
            let least = if least >= 0.0 { excess + least * edge(to) } else { excess + least * edge(from) };
            least >= -noise * if excess == 0.0 { edge(to) } else { 1.0 }
        };
        let negative = |r: f64| {
            let p = shape.pressure(r, a).ok().flatten();
            p.is_some_and(|p| excess + (p.estimate.value + p.estimate.error + noise) * edge(r) < 0.0)
        };
        let narrow = |from: f64, to: f64| to - from < 0.25 * cells.width_at(0.5 * (from + to)).max(NARROWEST * a);
        sign_over(vec![(0.0, a)], proven, negative, narrow)
    }

    /// Whether the gap outside a contact with nonnegative pressure is nowhere below −`noise`, within the examined range.
    ///
    /// The gap equals (2/π)∫_a^r (g − d)/√(r² − x²) dx, which the cells bound, and f − d + u, where u ≥ F/(π E* r).
    pub(super) fn gap_sign(&self, cells: &Cells, a: f64, depth: f64, noise: f64) -> Sign {
        let (shape, reach) = (self.contact.evaluator(), self.landscape.reach);
        let start = cells.rises_from(a);
        if start >= reach {
            return Sign::Proven;
        }
        let climb = cells.climb(a);
        let lift = OutsideDisplacement::new(shape, a, depth, a <= self.landscape.risen);
        let mut ends = vec![start.max(a)];
        ends.extend(self.landscape.curvature.breakpoints().into_iter().filter(|b| *b > start && *b < reach));
        ends.push(reach);
        let open: Vec<(f64, f64)> = ends.windows(2).rev().filter_map(|pair| Some((*pair.first()?, *pair.last()?))).collect();
        let proven = |from: f64, to: f64| {
            least_gap(&climb, (from, to)) >= -noise || self.lowest_between(from, to) - depth + lift.least(to) >= -noise
        };
        let negative = |r: f64| {
            let Ok(f) = shape.height(r) else { return false };
            let u = shape.displacement(r, a).map_or(f64::INFINITY, |u| u.estimate.value + u.estimate.error);
            f.estimate.value + f.estimate.error - depth + u.min(lift.most(r)) < -noise
        };
        sign_over(open, proven, negative, |from, to| to - from <= NARROWEST * to)
    }

    /// A lower bound on f between two radii; −∞ if unknown.
    fn lowest_between(&self, from: f64, to: f64) -> f64 {
        let (curvature, shape) = (&self.landscape.curvature, self.contact.evaluator());
        let plain = curvature.height_over(from, to).map_or(f64::NEG_INFINITY, |own| own.0);
        let height = |r: f64| {
            let own = shape.height(r).ok().map(|own| own.estimate).filter(|own| own.bound == Bound::Proven);
            own.map_or(f64::NEG_INFINITY, |own| own.value - own.error)
        };
        let from_f_prime = curvature.f_prime_over(from, to).map_or(f64::NEG_INFINITY, |(low, high)| {
            let width = (to - from) * (1.0 + 4.0 * f64::EPSILON);
            let (falls, rises) = (width * low.min(0.0), width * high.max(0.0));
            if falls == 0.0 { height(from) } else { (height(from) + falls).max(height(to) - rises) }
        });
        if from_f_prime.is_nan() { plain } else { plain.max(from_f_prime) }
    }
}

/// Bounds on the displacement outside a contact.
struct OutsideDisplacement {
    a: f64,
    depth: f64,
    /// F/(π E*).
    force: f64,
    /// Radii inside the contact with lower and upper bounds on d − g, which decreases between them.
    steps: Vec<(f64, f64, f64)>,
}

/// Maximum number of radii inside at which g is evaluated; fewer if g is expensive.
const MOST_RADII: u32 = 96;

impl OutsideDisplacement {
    fn new(shape: &impl Quantities, a: f64, depth: f64, rises: bool) -> Self {
        let proven = |own: Estimate| (own.bound == Bound::Proven).then_some(own);
        let least = |own: Estimate| FRAC_2_PI * (own.value - own.error) * (1.0 - 4.0 * f64::EPSILON);
        let force = shape.force(a).ok().and_then(|own| proven(own.estimate)).map_or(0.0, least);
        let count = if rises { affordable(MOST_RADII, || shape.equivalent(0.5 * a)) } else { 0 };
        let places = (1..=count).map(|step| a * (FRAC_PI_2 * f64::from(step) / f64::from(count)).sin());
        let gap = |x: f64| {
            let g = proven(shape.equivalent(x).ok()?.estimate)?;
            Some((x, (depth - g.value - g.error).max(0.0), depth - g.value + g.error))
        };
        // Skip radii at which g has no proven bound, which widens the step.
        Self { a, depth, force: force.max(0.0), steps: places.filter_map(gap).collect() }
    }

    /// A lower bound on (2/π)∫₀^a (d − g)/√(r² − x²) dx.
    fn least(&self, r: f64) -> f64 {
        let (mut sum, mut before) = (0.0, 0.0);
        for (x, gap, _) in &self.steps {
            let angle = (x / r).min(1.0).asin();
            sum += gap * (angle - before);
            before = angle;
        }
        (self.force / r).max(FRAC_2_PI * sum) * (1.0 - 1e-13)
    }

    /// An upper bound on the same integral; infinite if unknown.
    fn most(&self, r: f64) -> f64 {
        let (mut sum, mut before, mut gap) = (0.0, 0.0, self.depth);
        for (x, _, next) in &self.steps {
            let angle = (x / r).min(1.0).asin();
            sum += gap * (angle - before);
            (before, gap) = (angle, *next);
        }
        sum += gap.max(0.0) * ((self.a / r).min(1.0).asin() - before).max(0.0);
        if self.steps.is_empty() { f64::INFINITY } else { FRAC_2_PI * sum * (1.0 + 1e-13) }
    }
}

/// A lower bound on the gap between two radii beyond the edge, from bounds on g − d in cells.
fn least_gap(climb: &[(f64, f64, f64)], (from, to): (f64, f64)) -> f64 {
    let angle = |x: f64, r: f64| (x / r).min(1.0).asin();
    let mut sum = 0.0;
    for (lower, upper, least) in climb.iter().filter(|own| own.0 < to) {
        sum += if *least >= 0.0 {
            if *upper <= from { least * (angle(*upper, to) - angle(*lower, to)) } else { 0.0 }
        } else {
            least * (angle(*upper, from) - angle(*lower, to))
        };
    }
    // Beyond the last cell the gap is unbounded from below.
    if climb.last().is_some_and(|own| own.1 >= to) { sum } else { f64::NEG_INFINITY }
}
