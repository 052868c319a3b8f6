//! Integrals over the angle by pieces, each with a rule that an enclosure of f′ around it proves to suffice: nothing narrow can hide.

use super::TransformError;
use super::angle::NEAR_THE_LIMIT;
use super::integral::{NumericSegment, Weight};
use super::slope_source::{Numbers, Scratch};
use crate::eval::{RegionAlgebra, Tape};
use crate::num::bounded::UNIT;
use crate::num::legendre::{Node, rule_of};
use crate::num::{Bound, Estimate, Region, forms};
use std::sync::LazyLock;

/// Nodes of the rules that pieces may have.
const COUNTS: [usize; 7] = [4, 6, 8, 12, 16, 24, 32];
const MOST_NODES: usize = COUNTS[COUNTS.len() - 1];
static RULES: LazyLock<[Vec<Node>; COUNTS.len()]> = LazyLock::new(|| COUNTS.map(rule_of));

/// Ellipses that are tried around a piece, by σ: the half-axes are cosh σ and sinh σ times the half of the piece.
const SIGMAS: [f64; 5] = [2.4, 1.7, 1.15, 0.75, 0.45];
/// Most enclosures before something else answers.
const MOST_ENCLOSURES: usize = 24_000;
/// Most values of f′.
const MOST_VALUES: u64 = 60_000;
/// The share of the tolerance that rules may leave out altogether.
const SHARE: f64 = 0.02;
/// No less than this share of the integral of the magnitude is asked for: rounding makes more.
const LEAST: f64 = 0.02 * f64::EPSILON;
/// How often the measure of what may be left out is chosen anew.
const TRIALS: usize = 5;
/// A proven error of this share is better than an estimated one.
const ROUGH: f64 = 1e-3;
/// Samples of this share of the length see nothing.
const FAINT: f64 = 1e-200;
/// Places at which the size of the integrand is looked at first.
const PLACES: usize = 16;

/// One piece of the range: from `from` to `to`, counted as an angle from one of the ends of the range.
#[derive(Clone, Copy, Debug)]
struct Piece {
    from: f64,
    to: f64,
    /// True where angles count from the upper end of the range.
    from_above: bool,
}

/// What was done for a piece.
enum Proof {
    /// The rule of this number leaves out no more than this.
    Rule(usize, f64),
    /// The whole piece is no more than this.
    Nothing(f64),
}

/// The range of one integral: r = x cos τ from the lower end of the segment to its end or to x.
struct Range<'a> {
    segment: &'a NumericSegment,
    tape: &'a Tape,
    x: f64,
    weight: Weight,
    /// The angle between both ends, and that from the upper end to the one at which r = x.
    width: f64,
    beyond: f64,
    slots: Vec<Region>,
    enclosures: usize,
}

/// What a set of pieces adds up to.
#[derive(Clone, Copy, Default)]
struct Sum {
    value: f64,
    size: f64,
    left_out: f64,
    noise: f64,
    evaluations: u64,
}

impl NumericSegment {
    /// The integral with a proven bound; `None` where f′ is no expression, where its enclosures do not become small in time, or where
    /// they leave more open than the tolerance and the rounding.
    ///
    /// # Errors
    /// [`TransformError::NotComputable`] where f′ is not finite.
    pub(super) fn by_pieces(&self, x: f64, weight: Weight, tolerance: f64) -> Result<Option<Estimate>, TransformError> {
        let Numbers::Tape(tape) = &self.slope else { return Ok(None) };
        if matches!(weight, Weight::Outside(_)) || !(x.is_normal() && self.lower.value < x) {
            return Ok(None);
        }
        // Next to the end of f′ its distance to that end has the digits, and from a fractional power on no polynomial rule is good:
        // rules that know these places answer there.
        let near_the_end = self.limit.as_ref().is_some_and(|limit| x > NEAR_THE_LIMIT * limit.value.value);
        if self.singular || near_the_end {
            return Ok(None);
        }
        let end = self.upper.map_or(f64::INFINITY, |upper| upper.value);
        let width = forms::angle_between(self.lower.value, end, x);
        let beyond = if end < x { ((x - end) * (x + end)).sqrt().atan2(end) } else { 0.0 };
        let mut range = Range { segment: self, tape, x, weight, width, beyond, slots: Vec::new(), enclosures: 0 };
        if !range.has_enclosures() {
            return Ok(None);
        }
        let (mut scale, mut widest) = (range.scale(), None);
        let (mut best, mut spent): (Option<Estimate>, u64) = (None, 0);
        for _ in 0..TRIALS {
            let found = match scale {
                Some(scale) => range.sum((SHARE * tolerance).max(LEAST) * scale)?,
                None => None,
            };
            let Some(found) = found else {
                // What samples see may be the tail of something narrow: then the largest value that f′ can have is the measure.
                if best.is_some() || widest.is_some() {
                    break;
                }
                widest = Some(range.upper());
                scale = widest;
                continue;
            };
            spent += found.evaluations;
            let error = (found.left_out + found.noise + 8.0 * UNIT * found.size) * (1.0 + 8.0 * UNIT);
            let own = Estimate { value: found.value, error, evaluations: spent, bound: Bound::Proven };
            if error <= tolerance * found.value.abs() || found.left_out <= 0.1 * error {
                return Ok(Some(own));
            }
            best = Some(own);
            let size = if found.value == 0.0 { LEAST * found.size } else { found.value.abs() };
            scale = scale.map(|scale| if size < 0.5 * scale { size } else { 0.1 * scale }).filter(|scale| scale.is_normal());
        }
        Ok(best.filter(|own| own.error <= ROUGH * own.value.abs()))
    }
}

impl Range<'_> {
    /// About the integral of the magnitude, by samples; `None` where these see nothing.
    fn scale(&self) -> Option<f64> {
        let width = self.width;
        let sizes = (0..PLACES).map(|i| {
            let v = width * (i as f64 + 0.5) / PLACES as f64;
            let (delta, factor) = self.place(v, width - v);
            (self.segment.slope.plain(delta) * factor).abs()
        });
        let sampled = width / PLACES as f64 * sizes.filter(|size| size.is_finite()).sum::<f64>();
        (sampled > FAINT * self.x).then_some(sampled)
    }

    /// False where f′ has no enclosure even around single places, as where a function of it has none.
    fn has_enclosures(&mut self) -> bool {
        const PLACES: [f64; 3] = [0.29, 0.53, 0.71];
        let width = self.width;
        PLACES.iter().any(|share| {
            let v = share * width;
            self.largest(Piece { from: v, to: v, from_above: false }, 0.0).is_finite()
        })
    }

    /// A bound on the integral of the magnitude, from enclosures; infinite where these have none.
    fn upper(&mut self) -> f64 {
        let (cuts, width) = (64, self.width);
        let whole = |i: usize| width * i as f64 / cuts as f64;
        let pieces = (0..cuts).map(|i| Piece { from: whole(i), to: whole(i + 1), from_above: false });
        let bounds: Vec<f64> = pieces.map(|piece| (piece.to - piece.from) * self.largest(piece, 0.0)).collect();
        bounds.into_iter().filter(|size| size.is_finite()).sum::<f64>().max(f64::MIN_POSITIVE / f64::EPSILON)
    }

    /// δ and the weight, where the angles from both ends are these.
    fn place(&self, v: f64, w: f64) -> (f64, f64) {
        let rest = self.beyond + w;
        let delta = (2.0 * self.x * (0.5 * v).sin() * (rest + 0.5 * v).sin()).max(f64::MIN_POSITIVE);
        let factor = match self.weight {
            Weight::Force => {
                let r = self.segment.lower.value + delta;
                r * r
            }
            Weight::Integral => rest.sin() * rest.sin(),
            Weight::Slope | Weight::Outside(_) => 1.0,
        };
        (delta, factor)
    }

    /// A bound on the integrand around a piece, on the rectangle around its ellipse of σ; for σ = 0 on the piece alone, where it need
    /// not be analytic. Infinite where none is known.
    fn largest(&mut self, piece: Piece, sigma: f64) -> f64 {
        self.enclosures += 1;
        let (middle, half) = (0.5 * (piece.from + piece.to), 0.5 * (piece.to - piece.from));
        let (long, short) = (half * sigma.cosh() * (1.0 + 1e-12), half * sigma.sinh() * (1.0 + 1e-12));
        // The rounding of the ends; a piece that begins at an end does so exactly.
        let hair = 4.0 * UNIT * self.width;
        let (mut low, high) = (middle - long - hair, middle + long + hair);
        if sigma == 0.0 && piece.from == 0.0 {
            low = 0.0;
        }
        let own = Region::new((low, high), (-short, short));
        let width = Region::new((self.width - hair, self.width + hair), (0.0, 0.0));
        let beyond = Region::new((self.beyond * (1.0 - 4.0 * UNIT), self.beyond * (1.0 + 4.0 * UNIT)), (0.0, 0.0));
        let (v, rest) = if piece.from_above { (width - own, beyond + own) } else { (own, beyond + width - own) };
        let half_v = Region::real(0.5) * v;
        let x = Region::real(self.x);
        let lower = self.segment.lower;
        let lower = Region::new((lower.value - lower.error, lower.value + lower.error), (0.0, 0.0));
        // Both have all values of δ; the product keeps its digits next to the lower end, the cosine is narrow next to the upper one.
        let doubt = Region::new((-self.segment.lower.error, self.segment.lower.error), (0.0, 0.0));
        let by_product = x * Region::real(2.0) * half_v.sin() * (beyond + width - half_v).sin() + doubt;
        let r = x * rest.cos();
        let delta = by_product.and(r - lower);
        let delta = if sigma == 0.0 { delta.above_zero() } else { delta };
        let slope = self.tape.run(&mut RegionAlgebra, &[delta], &mut self.slots).map_or(f64::INFINITY, Region::largest);
        let weight = match self.weight {
            Weight::Force => r.largest() * r.largest(),
            Weight::Integral => rest.sin().largest() * rest.sin().largest(),
            Weight::Slope | Weight::Outside(_) => 1.0,
        };
        let largest = slope * weight * (1.0 + 8.0 * UNIT);
        if largest.is_nan() { f64::INFINITY } else { largest }
    }

    /// A rule for a piece, or that nothing is needed.
    fn proof(&mut self, piece: Piece, target: f64) -> Option<Proof> {
        let half = 0.5 * (piece.to - piece.from);
        let share = target * (2.0 * half / self.width).max(1e-4);
        let mut best: Option<(usize, f64)> = None;
        for sigma in SIGMAS {
            let largest = self.largest(piece, sigma);
            if !largest.is_finite() {
                continue;
            }
            // Trefethen, theorems 8.1 and 19.3: coefficients 2M e^(−kσ), each even one from 2N on wrong by at most 32/15.
            let front = half * 64.0 / 15.0 * largest / (1.0 - (-2.0 * sigma).exp()) * (1.0 + 1e-9);
            if half * 2.0 * largest <= 0.01 * share {
                return Some(Proof::Nothing(2.0 * half * largest * (1.0 + 1e-9)));
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
            return Some(Proof::Rule(rule, left_out));
        }
        let whole = 2.0 * half * self.largest(piece, 0.0) * (1.0 + 1e-9);
        (whole <= share).then_some(Proof::Nothing(whole))
    }

    /// The sum over pieces that leave out no more than about `target`; `None` beyond the budget.
    fn sum(&mut self, target: f64) -> Result<Option<Sum>, TransformError> {
        let middle = 0.5 * self.width;
        let mut open = vec![Piece { from: 0.0, to: middle, from_above: true }, Piece { from: 0.0, to: middle, from_above: false }];
        let mut sum = Sum::default();
        let mut scratch = Scratch::take();
        self.enclosures = 0;
        // Both halves meet up to the rounding of the width.
        let gap = 8.0 * UNIT * self.width;
        sum.left_out = gap * self.largest(Piece { from: middle - gap, to: middle + gap, from_above: false }, 0.0);
        while let Some(piece) = open.pop() {
            match self.proof(piece, target) {
                Some(Proof::Nothing(bound)) => sum.left_out += bound,
                Some(Proof::Rule(rule, left_out)) => {
                    sum.left_out += left_out;
                    self.add(piece, rule, &mut sum, &mut scratch)?;
                }
                None => {
                    let cut = 0.5 * (piece.from + piece.to);
                    if !(cut > piece.from && cut < piece.to) {
                        return Ok(None);
                    }
                    open.push(Piece { from: cut, ..piece });
                    open.push(Piece { to: cut, ..piece });
                }
            }
            if self.enclosures > MOST_ENCLOSURES || sum.evaluations > MOST_VALUES {
                return Ok(None);
            }
        }
        Ok(Some(sum))
    }

    /// Adds a piece by its rule.
    fn add(&self, piece: Piece, rule: usize, sum: &mut Sum, scratch: &mut Scratch) -> Result<(), TransformError> {
        let nodes = RULES.get(rule).map(Vec::as_slice).unwrap_or_default();
        let count = nodes.len().min(MOST_NODES);
        let (mut deltas, mut doubts, mut factors) = ([0.0; MOST_NODES], [0.0; MOST_NODES], [0.0; MOST_NODES]);
        let (mut values, mut errors) = ([0.0; MOST_NODES], [0.0; MOST_NODES]);
        let length = piece.to - piece.from;
        let end = self.segment.lower.error;
        for (((node, delta), doubt), factor) in nodes.iter().zip(&mut deltas).zip(&mut doubts).zip(&mut factors) {
            let own = if node.t < node.rest { piece.from + length * node.t } else { piece.to - length * node.rest };
            let (v, w) = if piece.from_above { (self.width - own, own) } else { (own, self.width - own) };
            (*delta, *factor) = self.place(v, w);
            // δ keeps its digits towards the lower end; the width is known to a rounding.
            *doubt = 16.0 * UNIT * *delta + if *delta > 2.0 * end { end } else { 0.0 };
        }
        self.segment.slope.block(&deltas[..count], &doubts[..count], &mut values[..count], &mut errors[..count], scratch);
        // What the factor is wrong by: r² as a share, the square of the sine as a number.
        let (share, flat) = match self.weight {
            Weight::Force => (40.0 * UNIT, 0.0),
            Weight::Integral => (16.0 * UNIT, 16.0 * UNIT),
            Weight::Slope | Weight::Outside(_) => (0.0, 0.0),
        };
        let mut own = Sum::default();
        for (((node, value), error), factor) in nodes.iter().zip(&values[..count]).zip(&errors[..count]).zip(&factors) {
            if !value.is_finite() || error.is_nan() {
                return Err(TransformError::NotComputable { at: self.x });
            }
            own.value += node.weight * value * factor;
            own.size += node.weight * (value * factor).abs();
            own.noise += node.weight * (error * factor + value.abs() * (share * factor + flat));
        }
        // The sum of the rule, its weights, and the length of the piece, which is the difference of two rounded places.
        let rounding = (count as f64 + 16.0) * UNIT * own.size;
        sum.value += length * own.value;
        sum.size += length * own.size;
        sum.noise += length * (own.noise + rounding) + UNIT * sum.value.abs();
        sum.evaluations += count as u64;
        Ok(())
    }
}
