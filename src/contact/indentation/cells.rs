//! Enclosures of the bend (r f′)′ of a profile from the axis outward, which miss no narrow feature between radii.

use super::curvature::{Curvature, Kink};
use crate::num::stable::leg;
use crate::num::work;
use std::f64::consts::FRAC_PI_2;
use std::sync::OnceLock;

/// Radii from `lower` to `upper`, between which (r f′)′ lies between `low` and `high`; infinite if unknown.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    pub(super) lower: f64,
    pub(super) upper: f64,
    pub(super) low: f64,
    pub(super) high: f64,
}

/// The cells of a profile, in order.
pub(in crate::contact) struct Cells {
    list: Vec<Cell>,
    kinks: Vec<Kink>,
    /// A lower bound on g′ in every cell, computed when first needed.
    rises: OnceLock<Vec<f64>>,
}

/// Maximum number of enclosures for the sign of the bend.
const MOST_LOOKS: usize = 3000;
/// Maximum number of cells of a profile whose bend is negative somewhere.
const MOST_CELLS: usize = 768;
/// An uncertainty below this fraction of the slope hardly affects g′.
const KNOWN: f64 = 1e-8;
/// Number of cells from the axis outward for which bounds on g′ are computed.
const MOST_RISES: usize = 2048;
/// Smallest width of a cell with undecided sign in the first pass, relative to its radius.
const NARROW: f64 = 1e-6;
/// Smallest width of a cell without an enclosure, relative to its radius.
const NARROWEST: f64 = 1e-9;
/// Relative distance to the end of a profile below which one value decides.
const LAST: f64 = 1e-8;
/// A negative bend below this fraction of the slope counts as rounding.
const ROUNDING: f64 = 1e-12;

impl Cells {
    /// Encloses the bend from the axis to `far`, finely up to `fine` where its sign is undecided. `None` without enclosures.
    pub(super) fn new(curvature: &Curvature<'_>, kinks: &[Kink], floor: f64, fine: f64, far: f64) -> Option<Self> {
        let mut own = Self::signs(curvature, kinks, floor, far)?;
        if !own.bends_up() {
            own.refine(curvature, fine);
        }
        Some(own)
    }

    /// Encloses the bend from the axis to `far`, beyond `floor` as narrowly as its sign requires. `None` without enclosures.
    pub(in crate::contact) fn signs(curvature: &Curvature<'_>, kinks: &[Kink], floor: f64, far: f64) -> Option<Self> {
        let mut ends = vec![0.0, floor];
        ends.extend(curvature.breakpoints().into_iter().chain(kinks.iter().map(|kink| kink.at)).filter(|b| *b > floor && *b < far));
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        ends.push(far);
        let mut list = Vec::new();
        let mut looks = 0;
        let mut known = false;
        for pair in ends.windows(2) {
            let [from, to] = *pair else { continue };
            let mut open = vec![(from, to)];
            while let Some((lower, upper)) = open.pop() {
                looks += 1;
                let mut cell = enclosed(curvature, lower, upper);
                // The end of a profile is not accurate enough to decide whether a root is real there.
                if upper == far && upper - lower <= LAST * upper && cell.low < 0.0 && presses(curvature, lower) {
                    cell.low = 0.0;
                }
                known |= cell.high < f64::INFINITY;
                let least = if cell.low.is_finite() { NARROW } else { NARROWEST };
                // Where g decreases, g′/x must not change much within a cell.
                let settled = cell.low >= 0.0 || (cell.high < 0.0 && upper <= 2.0 * lower) || lower == 0.0;
                match halved(lower, upper)
                    .filter(|_| !settled && upper - lower > least * upper && looks < MOST_LOOKS && !work::is_exhausted())
                {
                    Some(middle) => open.extend([(middle, upper), (lower, middle)]),
                    _ => list.push(cell),
                }
            }
            // Give up if none of many cells has an enclosure.
            if !known && looks > 200 {
                return None;
            }
        }
        Some(Self { list, kinks: kinks.to_vec(), rises: OnceLock::new() })
    }

    /// True if (r f′)′ ≥ 0 is proven everywhere, and every jump of f′ is positive, so that g increases.
    pub(super) fn bends_up(&self) -> bool {
        self.list.iter().all(|cell| cell.low >= 0.0) && self.kinks.iter().all(|kink| kink.jump > 0.0)
    }

    /// Halves the cells with the largest uncertainty of the bend, relative to the slope so far.
    fn refine(&mut self, curvature: &Curvature<'_>, fine: f64) {
        let mut steepest = f64::MIN_POSITIVE;
        let mut ranked = Vec::new();
        for (index, cell) in self.list.iter().enumerate().filter(|(_, cell)| cell.lower < fine) {
            steepest = steepest.max(curvature.f_prime(cell.upper).value.abs());
            ranked.push((doubt(cell, steepest), steepest, index));
        }
        let mut heap: std::collections::BinaryHeap<Ranked> = ranked
            .into_iter()
            .filter_map(|(doubt, steepest, index)| Some(Ranked { doubt, steepest, cell: *self.list.get(index)? }))
            .collect();
        let mut done: Vec<Cell> = self.list.iter().copied().filter(|cell| cell.lower >= fine).collect();
        for _ in 0..2 * MOST_CELLS {
            // Stop if the cell with the largest uncertainty is accurate enough.
            if heap.len() >= MOST_CELLS || work::is_exhausted() || heap.peek().is_none_or(|own| own.doubt <= KNOWN) {
                break;
            }
            let Some(Ranked { steepest, cell, .. }) = heap.pop() else { break };
            let Some(middle) = halved(cell.lower, cell.upper).filter(|_| cell.lower > 0.0) else {
                done.push(cell);
                continue;
            };
            for (lower, upper) in [(cell.lower, middle), (middle, cell.upper)] {
                let half = enclosed(curvature, lower, upper);
                // Bounds on a cell are valid for its halves.
                let mut half = Cell { low: half.low.max(cell.low), high: half.high.min(cell.high), ..half };
                if is_rounding(curvature, &half) {
                    half.low = 0.0;
                }
                heap.push(Ranked { doubt: doubt(&half, steepest), steepest, cell: half });
            }
        }
        done.extend(heap.into_iter().map(|own| own.cell));
        done.sort_by(|one, other| one.lower.total_cmp(&other.lower));
        self.list = done;
    }

    /// The cells with a lower bound on g′ in each: g′(x) = ∫₀^{π/2} (r f′)′|_{r = x sin t} dt plus the contributions of kinks.
    pub(super) fn rises(&self) -> impl DoubleEndedIterator<Item = (Cell, f64)> + ExactSizeIterator + '_ {
        let rises = self.rises.get_or_init(|| {
            let least = |index| if index < MOST_RISES { self.least_rise(index) } else { f64::NEG_INFINITY };
            (0..self.list.len()).map(least).collect()
        });
        self.list.iter().copied().zip(rises.iter().copied())
    }

    /// The longest ranges in which g is proven to increase, in order.
    pub(super) fn rising_ranges(&self) -> Vec<(f64, f64)> {
        let mut ranges: Vec<(f64, f64)> = Vec::new();
        for (cell, _) in self.rises().filter(|(_, rise)| *rise >= 0.0) {
            match ranges.last_mut() {
                Some((_, end)) if *end == cell.lower => *end = cell.upper,
                _ => ranges.push((cell.lower, cell.upper)),
            }
        }
        ranges
    }

    /// Radii in and around the runs of cells where the bend is certainly negative and which contain fewer than three of `places`.
    pub(super) fn dents(&self, places: &[f64], most: usize) -> Vec<f64> {
        let seen = |from: f64, to: f64| places.partition_point(|r| *r < to).saturating_sub(places.partition_point(|r| *r <= from));
        let hidden = self.falling_runs().into_iter().filter(|(from, to)| seen(*from, *to) < 3);
        hidden.flat_map(around).filter(|r| *r > 0.0).take(most).collect()
    }

    /// The longest ranges in which the bend is certainly negative, in order.
    pub(in crate::contact) fn falling_runs(&self) -> Vec<(f64, f64)> {
        let mut runs: Vec<(f64, f64)> = Vec::new();
        for cell in self.list.iter().filter(|cell| cell.high < 0.0) {
            match runs.last_mut() {
                Some((_, end)) if *end == cell.lower => *end = cell.upper,
                _ => runs.push((cell.lower, cell.upper)),
            }
        }
        runs
    }

    /// A lower bound on g′ within a cell; −∞ if unknown.
    fn least_rise(&self, index: usize) -> f64 {
        let Some(own) = self.list.get(index) else { return f64::NEG_INFINITY };
        let (from, to) = (own.lower, own.upper);
        if own.lower == 0.0 {
            return if own.low.is_finite() { FRAC_PI_2 * own.low } else { own.low };
        }
        // ∫ B dθ with θ = asin(s/x), by parts: θ decreases with x, so that every step of B occurs at one of two angles.
        let angle = |s: f64, x: f64| (s / x).min(1.0).asin();
        let mut sum = FRAC_PI_2 * own.low;
        let mut size = sum.abs();
        let mut before: Option<f64> = None;
        for cell in self.list.get(..=index).unwrap_or_default() {
            if let Some(before) = before {
                let step = cell.low - before;
                let share = step * angle(cell.lower, if step > 0.0 { from } else { to });
                sum -= share;
                size += share.abs();
            }
            before = Some(cell.low);
        }
        for kink in self.kinks.iter().filter(|kink| kink.at <= from) {
            let x = if kink.jump > 0.0 { to } else { from };
            let root = leg(x, kink.at);
            let share = kink.jump * kink.at / root;
            sum += share;
            size += if share.is_finite() { share.abs() } else { 0.0 };
        }
        // A sum with infinite bounds proves nothing; a sum within its rounding error is 0.
        if !sum.is_finite() {
            f64::NEG_INFINITY
        } else if sum.abs() <= ROUNDING * size {
            0.0
        } else {
            sum
        }
    }
}

/// Radii in and around a range in which the bend is negative.
pub(in crate::contact) fn around((from, to): (f64, f64)) -> impl Iterator<Item = f64> {
    [-1.0, -0.25, 0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 2.0].into_iter().map(move |share| from + share * (to - from))
}

/// The point at which a range is split: the logarithmic middle of a wide range.
pub(in crate::contact) fn halved(lower: f64, upper: f64) -> Option<f64> {
    let middle = if lower > 0.0 && upper > 4.0 * lower { (lower.ln() * 0.5 + upper.ln() * 0.5).exp() } else { 0.5 * (lower + upper) };
    (middle > lower && middle < upper).then_some(middle)
}

fn enclosed(curvature: &Curvature<'_>, lower: f64, upper: f64) -> Cell {
    let (low, high) = curvature.bend_over(lower, upper).unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
    let mut cell = Cell { lower, upper, low, high };
    // Near the axis a few values decide; where values overflow, the bodies are far apart.
    let at_the_axis = lower == 0.0 && [1.0, 1e-1, 1e-3, 1e-6].iter().all(|share| presses(curvature, share * upper));
    let overflows = |r: f64| !curvature.bend(r).value.is_finite();
    let too_far = overflows(upper) && (overflows(lower) || upper - lower <= LAST * upper);
    if is_rounding(curvature, &cell) || (cell.low < 0.0 && (at_the_axis || too_far)) {
        cell.low = 0.0;
    }
    cell
}

/// Whether the bend at a radius is certainly nonnegative.
fn presses(curvature: &Curvature<'_>, r: f64) -> bool {
    let bend = curvature.bend(r);
    bend.value >= bend.error
}

/// Whether a negative bend is within rounding error.
fn is_rounding(curvature: &Curvature<'_>, cell: &Cell) -> bool {
    cell.low < 0.0 && cell.low.is_finite() && {
        let f_prime = curvature.f_prime(cell.upper);
        -cell.low <= ROUNDING * (f_prime.value - f_prime.error) || -cell.low <= 4.0 * f64::MIN_POSITIVE
    }
}

/// The effect of the uncertainty of the bend on g′, relative to the slope.
fn doubt(cell: &Cell, steepest: f64) -> f64 {
    (cell.high - cell.low) * (cell.upper - cell.lower) / (cell.upper * steepest)
}

struct Ranked {
    doubt: f64,
    steepest: f64,
    cell: Cell,
}

impl PartialEq for Ranked {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Ranked {}

impl PartialOrd for Ranked {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Ranked {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.doubt.total_cmp(&other.doubt).then(other.cell.lower.total_cmp(&self.cell.lower))
    }
}
