//! Integrals by pieces, each with a rule proven sufficient by an enclosure of the integrand, so that no narrow feature is missed.

use crate::integrate::error::TransformError;
use crate::integrate::source::f_prime::Scratch;
use crate::num::bounded::UNIT;
use crate::num::double_double::DoubleDouble;
use crate::num::legendre::{Node, rule_of};
use crate::num::work::{self, Exhausted};
use crate::num::{Bound, Bounded, Estimate};
use std::sync::LazyLock;

/// Numbers of nodes of the rules for pieces.
const COUNTS: [usize; 7] = [4, 6, 8, 12, 16, 24, 32];
/// The most nodes of a rule.
pub(crate) const MOST_NODES: usize = COUNTS[COUNTS.len() - 1];
static RULES: LazyLock<[Vec<Node>; COUNTS.len()]> = LazyLock::new(|| COUNTS.map(rule_of));

/// Ellipses to try around a piece, by σ: the half-axes are cosh σ and sinh σ times half the length of the piece.
const SIGMAS: [f64; 5] = [2.4, 1.7, 1.15, 0.75, SMALLEST];
const SMALLEST: f64 = 0.45;
/// Maximum number of enclosures. Over 200 typed profiles, 24000 gave the same number of proven values.
const MOST_ENCLOSURES: usize = 4_000;
/// Maximum number of enclosures in the first trial, because the samples may have found only the tail of a narrow feature.
const FIRST_ENCLOSURES: usize = 1_000;
/// Most values of the integrand.
const MOST_VALUES: u64 = 60_000;
/// An end is assumed to be unbounded if the integrand has no bound on this fraction of the range next to it.
const HAIR: f64 = 5e-20;
/// Ends are tested for it once a piece without a bound next to them is shorter than this fraction of the range.
const SHORT: f64 = 1e-3;
/// The fraction of the tolerance for the total truncation error of the rules.
const SHARE: f64 = 0.02;
/// Smallest truncation error to request, relative to the integral of the magnitude; rounding errors are larger.
const LEAST: f64 = 0.02 * f64::EPSILON;
/// Samples below this fraction of the bound on the integrand may belong to the tail of a narrow feature.
const TAIL: f64 = 1e-6;
/// Number of times the scale of the truncation error is chosen anew.
const TRIALS: u32 = 5;
/// A scale below this fraction of the last one does not count as a trial, because the next sum is certainly better.
const FAR_BELOW: f64 = 1e-3;
/// Largest relative error for which a proven bound is preferred to an estimate.
const ROUGH: f64 = 1e-3;
/// Samples below this fraction of the length count as zero.
const FAINT: f64 = 1e-200;
/// Number of points for the first estimate of the size of the integrand.
const PLACES: usize = 16;
/// Number of equal parts of all ranges together for an upper bound on the integral, …
const CUTS: usize = 64;
/// … and the fewest parts of each of many ranges.
const FEWEST_CUTS: usize = 4;
/// Smallest fraction of the target assigned to a piece, however short it is.
const LEAST_SHARE: f64 = 1e-4;

/// One piece of a range: from `from` to `to`, measured from one of its ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// True if the variable is measured from the upper end of the range.
    pub(crate) from_above: bool,
}

impl Piece {
    fn half(self) -> f64 {
        0.5 * (self.to - self.from)
    }

    /// The rectangle around the ellipse of σ: from, to, and the largest imaginary part, with their rounding errors. For σ = 0, the
    /// lower bound of a piece that starts at an end of the range is exactly 0.
    pub(crate) fn around(self, sigma: f64) -> (f64, f64, f64) {
        let hair = 4.0 * UNIT * self.to;
        let (middle, half) = (0.5 * (self.from + self.to), self.half());
        let (long, short) = (half * sigma.cosh() * (1.0 + 1e-12), half * sigma.sinh() * (1.0 + 1e-12));
        let low = if sigma == 0.0 && self.from == 0.0 { 0.0 } else { middle - long - hair };
        (low, middle + long + hair, short)
    }
}

/// A node of a rule on a piece: the distances to both ends of the range.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct PieceNode {
    pub(crate) from_lower: f64,
    pub(crate) from_upper: f64,
    pub(crate) from_above: bool,
}

/// The integrand on one range.
pub(crate) trait Range {
    /// The length of the range in the variable of integration.
    fn width(&self) -> f64;

    /// The approximate size of the integrand at a point.
    fn size_at(&self, place: PieceNode) -> f64;

    /// A bound on the magnitude of the integrand on the rectangle around the ellipse of σ around a piece, in which it must be
    /// analytic; for σ = 0 on the piece alone. Infinite if unknown.
    fn largest(&mut self, piece: Piece, sigma: f64) -> f64;

    /// A bound on the integral of the magnitude over a piece that begins at an end, where the integrand may be infinite.
    fn tail(&mut self, _piece: Piece) -> f64 {
        f64::INFINITY
    }

    /// Values and bounds on their errors.
    fn fill(&self, places: &[PieceNode], values: &mut [f64], errors: &mut [f64], scratch: &mut Scratch);
}

/// The proof for a piece.
enum Proof {
    /// The index of the rule, and a bound on its truncation error.
    Rule(usize, f64),
    /// A bound on the integral over the whole piece, which is negligible.
    Nothing(f64),
    /// None, with the index of the largest ellipse around which the integrand has a bound.
    Open(usize),
}

/// The sum over a set of pieces.
#[derive(Clone, Default)]
struct Sum {
    value: DoubleDouble,
    size: f64,
    left_out: f64,
    noise: f64,
    evaluations: u64,
    enclosures: usize,
    /// The pieces that have a rule.
    pieces: Vec<Piece>,
}

/// The reason that [`sum_of`] returns no sum.
enum Miss {
    /// It takes too many enclosures or values.
    Costly,
    /// The integrand has no bound next to an end of a range, not even on a very short piece.
    Unbounded,
    /// The budget is used up, or the integrand has no value at a node.
    Failed(TransformError),
}

impl From<Exhausted> for Miss {
    fn from(error: Exhausted) -> Self {
        Self::Failed(error.into())
    }
}

/// The sum of the integrals over all ranges and of `more`, with a proven bound; `None` if the enclosures do not become small in
/// time, or the bound exceeds the tolerance and the rounding error.
///
/// # Errors
/// [`TransformError::NotComputable`] if the integrand is not finite at a node.
pub(crate) fn proven_sum<R: Range>(ranges: &mut [R], more: Bounded, tolerance: f64, at: f64) -> Result<Option<Estimate>, TransformError> {
    if !ranges.iter_mut().all(has_enclosures) {
        return Ok(None);
    }
    let sampled: f64 = ranges.iter().map(size).sum::<f64>() + more.value.abs();
    let seen = sampled > FAINT * ranges.iter().map(R::width).sum::<f64>();
    let (mut scale, mut widest) = (seen.then_some(sampled), None);
    let (mut best, mut spent): (Option<Estimate>, u64) = (None, 0);
    let mut trials = 0;
    while trials < TRIALS {
        let most = if best.is_none() && widest.is_none() { FIRST_ENCLOSURES } else { MOST_ENCLOSURES };
        let found = scale.map_or(Err(Miss::Costly), |scale| sum_of(ranges, (SHARE * tolerance).max(LEAST) * scale, most, at));
        let found = match found {
            Ok(found) => Some(found),
            Err(Miss::Costly) => None,
            Err(Miss::Unbounded) => break,
            Err(Miss::Failed(error)) => return Err(error),
        };
        let Some(found) = found else {
            if best.is_some() || (widest.is_some() && scale == widest) {
                break;
            }
            // The samples may belong to the tail of a narrow feature; in that case use the bound on the integrand as the scale.
            let largest = match widest {
                Some(_) => widest,
                None => {
                    let cuts = (CUTS / ranges.len().max(1)).max(FEWEST_CUTS);
                    Some(ranges.iter_mut().map(|range| upper(range, cuts)).sum::<f64>())
                }
            };
            let tail = widest.is_some() || scale.zip(largest).is_none_or(|(seen, largest)| seen < TAIL * largest);
            widest = largest;
            scale = if tail { largest } else { scale };
            continue;
        };
        spent += found.evaluations;
        let noise = found.noise + 8.0 * UNIT * found.size;
        let total = Bounded { value: found.value.hi, error: (found.left_out + noise) * (1.0 + 8.0 * UNIT) } + more;
        let own = Estimate { evaluations: spent, ..Estimate::from_bounded(total, 0) };
        debug_assert_eq!(own.bound, Bound::Proven);
        if own.error <= tolerance * own.value.abs() || found.left_out <= 0.1 * own.error {
            return Ok(Some(own));
        }
        best = Some(own);
        // This bound on the integral may be far below the first scale, because enclosures of overflowing terms are wide.
        let size = (own.value.abs() + found.left_out).max(LEAST * found.size);
        let Some(last) = scale else { break };
        trials += u32::from(size > FAR_BELOW * last);
        scale = Some(if size < 0.5 * last { size } else { 0.1 * last }).filter(|scale| scale.is_normal());
    }
    // Accept a value of 0 if its bound contains only underflow.
    let nothing = MOST_ENCLOSURES as f64 * Bounded::VANISHED;
    Ok(best.filter(|own| own.error <= ROUGH * own.value.abs() || (own.value == 0.0 && own.error < nothing)))
}

/// The ends of the pieces, each of which one rule resolves; empty if the enclosures do not become small in time.
///
/// Another integral over the same range with a smooth weight misses no narrow feature if it is split there.
pub(crate) fn resolved<R: Range>(range: &mut R, tolerance: f64, at: f64) -> Vec<PieceNode> {
    let (scale, width) = (size(range), range.width());
    if !has_enclosures(range) || scale <= FAINT * width {
        return Vec::new();
    }
    let found = sum_of(std::slice::from_mut(range), (SHARE * tolerance).max(LEAST) * scale, MOST_ENCLOSURES, at);
    let pieces = found.map(|sum| sum.pieces).unwrap_or_default();
    let place = |from_above: bool, at: f64| {
        let (from_lower, from_upper) = if from_above { (width - at, at) } else { (at, width - at) };
        PieceNode { from_lower, from_upper, from_above }
    };
    pieces.iter().flat_map(|own| [place(own.from_above, own.from), place(own.from_above, own.to)]).collect()
}

/// False if the integrand has no enclosure even around single points, for example because of a function without enclosures.
fn has_enclosures<R: Range>(range: &mut R) -> bool {
    const SHARES: [f64; 3] = [0.29, 0.53, 0.71];
    let width = range.width();
    SHARES.iter().any(|share| range.largest(Piece { from: share * width, to: share * width, from_above: false }, 0.0).is_finite())
}

/// An estimate of the integral of the magnitude, from samples.
fn size<R: Range>(range: &R) -> f64 {
    let width = range.width();
    let sizes = (0..PLACES).map(|i| {
        let from_lower = width * (i as f64 + 0.5) / PLACES as f64;
        range.size_at(PieceNode { from_lower, from_upper: width - from_lower, from_above: false }).abs()
    });
    width / PLACES as f64 * sizes.filter(|size| size.is_finite()).sum::<f64>()
}

/// An approximate upper bound on the integral of the magnitude, from finite enclosures over equal parts.
fn upper<R: Range>(range: &mut R, cuts: usize) -> f64 {
    let width = range.width();
    let whole = |i: usize| width * i as f64 / cuts as f64;
    let mut open: Vec<Piece> = (0..cuts).map(|i| Piece { from: whole(i), to: whole(i + 1), from_above: false }).collect();
    let (mut total, mut left) = (f64::MIN_POSITIVE / f64::EPSILON, 4 * cuts);
    while let Some(piece) = open.pop() {
        let size = (piece.to - piece.from) * range.largest(piece, 0.0);
        if size.is_finite() {
            total += size;
        } else if left > 0 {
            // If the enclosure of the whole is unbounded, the halves may have bounds.
            left -= 1;
            let cut = 0.5 * (piece.from + piece.to);
            open.extend([Piece { to: cut, ..piece }, Piece { from: cut, ..piece }]);
        }
    }
    total
}

/// The sum over pieces with a total truncation error of about `target`.
fn sum_of<R: Range>(ranges: &mut [R], target: f64, most: usize, at: f64) -> Result<Sum, Miss> {
    let mut sum = Sum::default();
    let mut scratch = Scratch::take();
    let share = target / ranges.len().max(1) as f64;
    for range in ranges {
        let width = range.width();
        let middle = 0.5 * width;
        // True once the end of that side is known to have a bound.
        let mut bounded = [false; 2];
        // Each piece with the index of the ellipse to try first.
        let mut open =
            vec![(Piece { from: 0.0, to: middle, from_above: true }, 0), (Piece { from: 0.0, to: middle, from_above: false }, 0)];
        // The two halves meet to within the rounding of the width.
        let gap = 8.0 * UNIT * width;
        sum.left_out += gap * range.largest(Piece { from: middle - gap, to: middle + gap, from_above: false }, 0.0);
        while let Some((piece, first)) = open.pop() {
            work::check()?;
            match proof(range, piece, share, first, &mut sum.enclosures) {
                Proof::Nothing(bound) => sum.left_out += bound,
                Proof::Rule(rule, left_out) => {
                    sum.left_out += left_out;
                    sum.pieces.push(piece);
                    add(range, piece, rule, &mut sum, &mut scratch).ok_or(Miss::Failed(TransformError::NotComputable { at }))?;
                }
                Proof::Open(finite) => {
                    let cut = 0.5 * (piece.from + piece.to);
                    if !(cut > piece.from && cut < piece.to) {
                        return Err(Miss::Costly);
                    }
                    let known = &mut bounded[usize::from(piece.from_above)];
                    if piece.from == 0.0 && piece.to < SHORT * width && !*known {
                        *known = bound_at_end(range, Piece { to: HAIR * width, ..piece }).is_finite();
                        if !*known {
                            return Err(Miss::Unbounded);
                        }
                    }
                    // An ellipse around half of the piece has twice the half-axes, relative to that half: the next larger σ, or the one
                    // after it in the half that is farther from a singularity.
                    let first = if finite == SIGMAS.len() { finite } else { finite.saturating_sub(2) };
                    open.push((Piece { from: cut, ..piece }, first));
                    open.push((Piece { to: cut, ..piece }, first));
                }
            }
            if sum.enclosures > most || sum.evaluations > MOST_VALUES {
                return Err(Miss::Costly);
            }
        }
    }
    Ok(sum)
}

/// A rule for a piece, or the proof that the piece is negligible. `first` is the index of the ellipse to try first; it lies beyond the
/// smallest one if no ellipse around twice the piece has a bound.
fn proof<R: Range>(range: &mut R, piece: Piece, target: f64, mut first: usize, enclosures: &mut usize) -> Proof {
    let half = piece.half();
    let share = target * (2.0 * half / range.width()).max(LEAST_SHARE);
    let mut best: Option<(usize, f64)> = None;
    let mut finite = SIGMAS.len();
    if first == SIGMAS.len() {
        // Larger ellipses contain the smallest one. Next to a singularity none has a bound; half a length away from it the second has.
        *enclosures += 1;
        first = if range.largest(piece, SMALLEST).is_finite() { 1 } else { first };
    }
    for (i, sigma) in SIGMAS.into_iter().enumerate().skip(first) {
        *enclosures += 1;
        let largest = range.largest(piece, sigma);
        if !largest.is_finite() {
            continue;
        }
        finite = finite.min(i);
        // Trefethen, theorems 8.1 and 19.3: coefficients 2M e^(−kσ); the error per even coefficient from 2N on is at most 32/15.
        let front = half * 64.0 / 15.0 * largest / (1.0 - (-2.0 * sigma).exp()) * (1.0 + 1e-9);
        if half * 2.0 * largest <= 0.01 * share {
            return Proof::Nothing(2.0 * half * largest * (1.0 + 1e-9));
        }
        let rule = COUNTS.iter().position(|count| front * (-2.0 * *count as f64 * sigma).exp() <= share);
        match (rule, best) {
            (Some(rule), Some((least, _))) if rule >= least => break,
            (Some(rule), _) => best = Some((rule, front * (-2.0 * COUNTS[rule] as f64 * sigma).exp() * (1.0 + 1e-9))),
            (None, Some(_)) => break,
            (None, None) => {}
        }
    }
    if let Some((rule, left_out)) = best {
        return Proof::Rule(rule, left_out);
    }
    // NaN fails the comparison too.
    let within = |whole: &f64| *whole <= share;
    // A piece that is not negligible at its middle has no bound within its share.
    let middle = 0.5 * (piece.from + piece.to);
    let (from_lower, from_upper) = if piece.from_above { (range.width() - middle, middle) } else { (middle, range.width() - middle) };
    let sampled = 2.0 * half * range.size_at(PieceNode { from_lower, from_upper, from_above: piece.from_above }).abs();
    let whole = if sampled > 2.0 * share {
        None
    } else {
        *enclosures += 1;
        Some(2.0 * half * range.largest(piece, 0.0) * (1.0 + 1e-9)).filter(within)
    };
    let tail = || Some(piece).filter(|piece| piece.from == 0.0).map(|piece| range.tail(piece)).filter(within);
    whole.or_else(tail).map_or(Proof::Open(finite), Proof::Nothing)
}

/// A bound on the integral over a piece next to an end of the range.
fn bound_at_end<R: Range>(range: &mut R, piece: Piece) -> f64 {
    let whole = (piece.to - piece.from) * range.largest(piece, 0.0);
    if whole.is_finite() { whole } else { range.tail(piece) }
}

/// Adds a piece by its rule; `None` if a value is not finite.
fn add<R: Range>(range: &R, piece: Piece, rule: usize, sum: &mut Sum, scratch: &mut Scratch) -> Option<()> {
    let nodes = RULES.get(rule)?;
    let count = nodes.len().min(MOST_NODES);
    let (mut places, mut values, mut errors) = ([PieceNode::default(); MOST_NODES], [0.0; MOST_NODES], [0.0; MOST_NODES]);
    let (length, width) = (piece.to - piece.from, range.width());
    for (node, place) in nodes.iter().zip(&mut places) {
        let near = if node.t < node.rest { piece.from + length * node.t } else { piece.to - length * node.rest };
        let (from_lower, from_upper) = if piece.from_above { (width - near, near) } else { (near, width - near) };
        *place = PieceNode { from_lower, from_upper, from_above: piece.from_above };
    }
    range.fill(&places[..count], &mut values[..count], &mut errors[..count], scratch);
    let (mut total, mut size, mut noise) = (0.0, 0.0, 0.0);
    for ((node, value), error) in nodes.iter().zip(&values[..count]).zip(&errors[..count]) {
        if !value.is_finite() || error.is_nan() {
            return None;
        }
        total += node.weight * value;
        size += node.weight * value.abs();
        noise += node.weight * error;
    }
    // Rounding of the sum, of the weights, and of the length of the piece, which is the difference of two rounded numbers.
    let rounding = (count as f64 + 16.0) * UNIT * size;
    // There may be ten thousand pieces; sum them in double-double arithmetic.
    sum.value = sum.value.add((length * total).into());
    sum.size += length * size;
    sum.noise += length * (noise + rounding);
    sum.evaluations += count as u64;
    Some(())
}
