//! Proofs that g stays below a depth at every radius, from enclosures of f′.

use super::{FARTHEST, NoRadius};
use crate::contact::indentation::cells::halved;
use crate::num::{Bound, stable::leg, work};
use crate::transform::Quantities;
use std::f64::consts::FRAC_PI_2;

/// Maximum number of steps of one proof.
const PROVING: u64 = 50_000_000;
/// Maximum number of steps of a value of g within a proof.
const CHEAP: u64 = 500_000;
/// Maximum number of ranges of radii.
const MOST_CELLS: usize = 2000;
/// Smallest width of a range, relative to its radius.
const NARROWEST: f64 = 1e-9;
/// Maximum number of times that one of the first ranges is halved where f′ has no bounds.
const HALVINGS: u32 = 5;
/// Ratio of the ends of the first ranges.
const DECADE: f64 = 10.0;
/// Smallest radius from which a proof starts.
const LEAST: f64 = 1e-290;
/// Up to the first radius, g is below this fraction of the depth.
const AT_AXIS: f64 = 1e-4;
/// Relative distance from the end of a bounded profile at which a proof ends.
const LAST: f64 = 8.0 * f64::EPSILON;
/// Relative distances from the end between which f′ may grow by at most the factor [`GROWTH`].
const NEAR_END: [f64; 2] = [1e-6, 1e-9];
/// The largest growth of f′ between the distances [`NEAR_END`] from the end.
const GROWTH: f64 = 4.0;
/// Ratio of x to the smallest radius from which on the bounds on f′ are summed by parts.
const NEAR: f64 = 8.0;
/// Upper bounds on f′ below minus this number are raised to it.
const LARGEST: f64 = 1e100;
/// Bound on the rounding error of a sum, relative to the sum of the magnitudes.
const ROUNDING: f64 = 1e-12;

/// Returns the reason why no contact radius belongs to `depth` if enclosures prove that g(x) < `depth`, from the axis to the end of a
/// bounded profile, or to 1e150. Where f′ has no bound at the end, g may grow without limit there, and the proof, which ends 8 ulp before
/// it, does not exclude a radius.
///
/// Where f′ lies between L and H from r = l to u, ∫ f′/√(1 − r²/x²) dr over that range lies between L and H times
/// x (arcsin(u/x) − arcsin(l/x)), and, if f′ does not change its sign, between f(u) − f(l) times the factors 1/√(1 − r²/x²) at both ends.
/// Ranges whose bounds do not suffice are halved.
pub(in crate::contact) fn stays_below<P: Quantities + ?Sized>(shape: &P, depth: f64) -> Option<NoRadius> {
    let limit = shape.limit();
    // Within a few ulps of the end, rounding may take a radius out of the domain of f′.
    let last = limit * (1.0 - LAST);
    let prove = || Cells::new(shape, depth, last.min(FARTHEST)).is_some_and(|mut cells| cells.prove(shape, depth));
    work::share(PROVING, prove).filter(|proven| *proven)?;
    Some(if limit.is_infinite() {
        NoRadius::Proven("g stays below it up to x = 1e150")
    } else if is_flat_at(shape, limit, last) {
        NoRadius::Proven("g stays below it up to the end of the profile")
    } else {
        NoRadius::Unproven("g stays below it up to 8 ulps before the end of the profile, next to which f' has no bound")
    })
}

/// A bound on |g| up to a radius that no breakpoint precedes; `None` if unknown.
///
/// Where |f′| ≤ M r^s, |g| ≤ (π/2) M x^(s+1) max(1, 1/(s + 1)), because sin t ≥ 2t/π.
pub(super) fn bound_at_axis<P: Quantities + ?Sized>(shape: &P, radius: f64) -> Option<f64> {
    let bound = |(s, most): (f64, f64)| FRAC_PI_2 * most * radius.powf(s + 1.0) * (1.0 / (s + 1.0)).max(1.0) * (1.0 + ROUNDING);
    shape.power_at_axis(radius).map(bound)
}

/// Whether f′ no longer grows toward the end: g, which is infinite where f′ grows like 1/√δ, then changes by rounding in the last ulps.
fn is_flat_at<P: Quantities + ?Sized>(shape: &P, limit: f64, last: f64) -> bool {
    let [far, near] = NEAR_END.map(|distance| limit * (1.0 - distance));
    let largest = |lower, upper| shape.f_prime_over(lower, upper).map_or(f64::INFINITY, |(low, high)| low.abs().max(high.abs()));
    largest(near, last) <= GROWTH * largest(far, near) && largest(near, last).is_finite()
}

/// Radii from `lower` to `upper`, with bounds on f′ and, if f′ does not change its sign, on f(upper) − f(lower).
#[derive(Clone, Copy)]
struct Cell {
    lower: f64,
    upper: f64,
    f_prime: (f64, f64),
    rise: Option<(f64, f64)>,
    /// A bound on |∫ f′/√(1 − r²/x²) dr| for every larger x, which only the cell at the axis has.
    most: Option<f64>,
    /// Whether g is proven to stay below the depth within the cell.
    proven: bool,
}

struct Cells(Vec<Cell>);

impl Cell {
    /// `None` if f′ has no bounds.
    fn new<P: Quantities + ?Sized>(shape: &P, lower: f64, upper: f64) -> Option<Self> {
        let (low, high) = shape.f_prime_over(lower, upper)?;
        // A weaker upper bound keeps the products with radii finite.
        let f_prime = (low, high.max(-LARGEST));
        let height = |r: f64| {
            let own = shape.height(r).ok()?.estimate;
            (own.bound == Bound::Proven).then_some((own.value - own.error, own.value + own.error))
        };
        let rise = || {
            let (below, above) = (height(lower)?, height(upper)?);
            Some(((above.0 - below.1).next_down(), (above.1 - below.0).next_up()))
        };
        // In a wide range the difference of f is sharper than the bounds on f′.
        let has_sign = f_prime.0 >= 0.0 || f_prime.1 <= 0.0;
        let rise = if has_sign && upper > 1.5 * lower { rise() } else { None };
        Some(Self { lower, upper, f_prime, rise, most: None, proven: false })
    }

    /// Bounds on ∫ f′/√(1 − r²/x²) dr over the cell, for every x between two radii beyond it.
    fn share(&self, from: f64, to: f64) -> (f64, f64) {
        if let Some(most) = self.most {
            return (-most, most);
        }
        let Self { lower, upper, f_prime: (low, high), .. } = *self;
        // The width decreases with x.
        let (most, least) = (self.width(from) * (1.0 + ROUNDING), self.width(to) * (1.0 - ROUNDING));
        let mut share = (low * if low < 0.0 { most } else { least }, high * if high > 0.0 { most } else { least });
        if let Some((fall, rise)) = self.rise {
            let factor = |r: f64, x: f64| x / leg(x, r);
            let (most, least) = (factor(upper, from) * (1.0 + ROUNDING), factor(lower, to) * (1.0 - ROUNDING));
            let (fall, rise) = if low >= 0.0 { (fall.max(0.0) * least, rise * most) } else { (fall * most, rise.min(0.0) * least) };
            share = (share.0.max(fall), share.1.min(rise));
        }
        share
    }

    /// x (arcsin(upper/x) − arcsin(lower/x)).
    fn width(&self, x: f64) -> f64 {
        let (one, other) = (self.lower / x, (self.upper / x).min(1.0));
        // The sine of the difference is (u √(x² − l²) − l √(x² − u²))/x², where √(x² − l²)² − √(x² − u²)² = u² − l².
        let (far, near) = (leg(x, self.lower) / x, leg(x, self.upper.min(x)) / x);
        let difference = (other - one) * near + other * ((other - one) * (other + one) / (far + near));
        x * if difference < 0.5 { difference.asin() } else { other.asin() - one.asin() }
    }
}

impl Cells {
    /// Ranges from the axis to this end; `None` if f′ has no bounds in one of them.
    fn new<P: Quantities + ?Sized>(shape: &P, depth: f64, end: f64) -> Option<Self> {
        let kinks = shape.breakpoints_below(end);
        // Multiples of the depth divide an endless profile in the same way in every unit of length.
        let farthest = Some(depth * DECADE.powf((end / depth).log10().floor()));
        let farthest = farthest.filter(|own| own.is_normal() && *own <= end && shape.limit().is_infinite());
        let mut first = kinks.first().copied().or(farthest).unwrap_or(end);
        let most = loop {
            if let Some(most) = bound_at_axis(shape, first).filter(|most| *most < AT_AXIS * depth) {
                break most;
            }
            first /= DECADE;
            if first < LEAST || work::is_exhausted() {
                return None;
            }
        };
        let mut ends = vec![first];
        ends.extend(std::iter::successors(Some(first), |r| Some(r * DECADE)).skip(1).take_while(|r| *r < end));
        ends.extend(kinks.into_iter().filter(|r| *r > first));
        ends.push(end);
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        let mut list = vec![Cell {
            lower: 0.0,
            upper: first,
            f_prime: (f64::NEG_INFINITY, f64::INFINITY),
            rise: None,
            most: Some(most),
            proven: true,
        }];
        for pair in ends.windows(2) {
            let [lower, upper] = *pair else { continue };
            list.extend(enclosed(shape, lower, upper, HALVINGS)?);
        }
        Some(Self(list))
    }

    /// Halves ranges until g is proven to stay below the depth in all of them; false if that takes too many.
    fn prove<P: Quantities + ?Sized>(&mut self, shape: &P, depth: f64) -> bool {
        loop {
            let mut split = vec![false; self.0.len()];
            let mut open = Vec::new();
            for index in 0..self.0.len() {
                if self.0.get(index).is_some_and(|own| !own.proven) {
                    let proven = self.is_below(index, depth, &mut split);
                    self.0.iter_mut().skip(index).take(1).for_each(|own| own.proven = proven);
                    if !proven {
                        open.push(index);
                    }
                }
            }
            let Some(place) = open.get(open.len() / 2).and_then(|index| self.0.get(*index)) else { return true };
            // A single value of g, if it is cheap, may show that g reaches the depth.
            let reaches = || shape.equivalent(place.upper).is_ok_and(|g| g.estimate.value >= depth);
            if work::share(CHEAP, reaches) == Some(true) {
                return false;
            }
            let before = self.0.len();
            let mut list = Vec::with_capacity(2 * before);
            for (own, split) in self.0.iter().zip(split) {
                match middle(own.lower, own.upper).filter(|_| split) {
                    Some(middle) => {
                        for (lower, upper) in [(own.lower, middle), (middle, own.upper)] {
                            let Some(half) = Cell::new(shape, lower, upper) else { return false };
                            list.push(Cell { proven: own.proven, ..half });
                        }
                    }
                    None => list.push(*own),
                }
            }
            if list.len() == before || list.len() > MOST_CELLS || work::is_exhausted() {
                return false;
            }
            self.0 = list;
        }
    }

    /// Whether g is proven to stay below the depth within a cell; otherwise marks the cells with the widest bounds to be halved.
    fn is_below(&self, index: usize, depth: f64, split: &mut [bool]) -> bool {
        let Some(own) = self.0.get(index) else { return true };
        let (from, to) = (own.lower, own.upper);
        let below = self.0.get(..index).unwrap_or_default();
        work::spend(8 * below.len() as u64);
        let near = below.partition_point(|cell| cell.lower < from / NEAR);
        let (far, near) = below.split_at_checked(near).unwrap_or_default();
        // f′ ≤ H_i in cell i gives, by parts, ∫ ≤ x (π/2) H − Σ (H_i − H_{i−1}) x arcsin(l_i/x), in which x arcsin(l/x) decreases.
        let arc = |l: f64, x: f64| x * (l / x).min(1.0).asin();
        let end = |high: f64| FRAC_PI_2 * high * if high > 0.0 { to } else { from };
        let (mut most, mut size, mut range) = (end(own.f_prime.1), 0.0, 0.0);
        let mut before = 0.0;
        let mut doubts = Vec::with_capacity(below.len());
        for cell in near.iter().chain([own]) {
            let step = cell.f_prime.1 - before;
            let (most_arc, least_arc) = (arc(cell.lower, from), arc(cell.lower, to));
            let term = step * if step > 0.0 { least_arc } else { most_arc };
            range += step.abs() * (most_arc - least_arc);
            most -= term;
            size += term.abs();
            before = cell.f_prime.1;
        }
        size += most.abs();
        for cell in far {
            let share = cell.share(from, to);
            most += share.1;
            size += share.1.abs();
            doubts.push(share.1 - share.0);
        }
        if most + ROUNDING * size < depth {
            return true;
        }
        doubts.extend(near.iter().map(|cell| (cell.f_prime.1 - cell.f_prime.0) * cell.width(from)));
        // Within the cell itself, the bound also varies with x.
        doubts.push((own.f_prime.1.max(0.0) - own.f_prime.0.min(0.0)) * own.width(to) + range);
        let total: f64 = doubts.iter().sum();
        let half = 0.5 * total / doubts.len() as f64;
        for (mark, _) in split.iter_mut().zip(&doubts).filter(|(_, doubt)| **doubt > half || !doubt.is_finite()) {
            *mark = true;
        }
        false
    }
}

/// Cells that cover a range, which is halved where f′ has no bounds, for example because an intermediate value overflows.
fn enclosed<P: Quantities + ?Sized>(shape: &P, lower: f64, upper: f64, halvings: u32) -> Option<Vec<Cell>> {
    if let Some(own) = Cell::new(shape, lower, upper) {
        return Some(vec![own]);
    }
    let middle = middle(lower, upper).filter(|_| halvings > 0)?;
    let mut list = enclosed(shape, lower, middle, halvings - 1)?;
    list.extend(enclosed(shape, middle, upper, halvings - 1)?);
    Some(list)
}

/// The radius at which a range is halved; `None` for the range at the axis and for ranges that are too narrow.
fn middle(lower: f64, upper: f64) -> Option<f64> {
    halved(lower, upper).filter(|_| lower > 0.0 && upper - lower > NARROWEST * upper)
}
