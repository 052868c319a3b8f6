//! Chebyshev pieces of f′: each as long as 64 coefficients allow, otherwise halved in r².

use super::piece::Piece;
use super::source::{Parity, Source};
use crate::integrate::error::TransformError;
use crate::num::spectral::{chop, rule};
use crate::num::work;

/// Degrees to try, in increasing order.
const COUNTS: [usize; 3] = [16, 32, 64];
/// Maximum number of halvings of a piece.
const DEEPEST: u32 = 56;
/// Maximum number of pieces of a curve.
const MOST_PIECES: usize = 600;
/// Error allowed for the halves of a parity split, relative to the whole; e^r and e^(−r) exceed it on a long piece.
const CANCELLING: f64 = 2e-14;
/// The larger error allowed on a short piece, where further halving does not reduce the cancellation.
const SHORT: u32 = 8;
/// Coefficients below this many ulps of the function count as rounding.
const PLATEAU: f64 = 2.0 * f64::EPSILON;

/// The pieces of one source over [0, end], by increasing radius.
///
/// # Errors
/// [`TransformError::NotComputable`] if f′ is not finite or not smooth enough.
pub(super) fn pieces(source: &Source<'_>, end: f64, budget: &mut Budget) -> Result<Vec<Piece>, TransformError> {
    let upper = source.upper.map_or(end, |u| u.min(end));
    let mut list = Vec::new();
    if source.lower < upper {
        let mut work = Work { source, end, list: &mut list, budget };
        work.cover(source.lower, upper, 0)?;
    }
    Ok(list)
}

/// Evaluations of f′ so far, over all sources.
#[derive(Default)]
pub(super) struct Budget {
    pub(super) evaluations: u64,
    pub(super) pieces: usize,
}

struct Work<'a, 's> {
    source: &'s Source<'a>,
    end: f64,
    list: &'s mut Vec<Piece>,
    budget: &'s mut Budget,
}

/// Coefficients, the error of their sum, and whether the tail reached its plateau.
struct Expansion {
    coefficients: Vec<f64>,
    noise: f64,
    /// The largest value.
    scale: f64,
    converged: bool,
}

impl Work<'_, '_> {
    fn cover(&mut self, lower: f64, upper: f64, depth: u32) -> Result<(), TransformError> {
        work::check()?;
        if self.list.len() + self.budget.pieces > MOST_PIECES {
            return Err(TransformError::NotComputable { at: self.end });
        }
        let first = lower == self.source.lower;
        let exponent = if first { self.source.exponent } else { 0.0 };
        let last = depth >= DEEPEST;
        let whole = self.expand(lower, upper, exponent, Parity::Whole)?;
        if whole.converged {
            self.push(lower, upper, exponent, whole);
            return Ok(());
        }
        if first && self.source.has_mirror() {
            let halves = (self.expand(lower, upper, exponent, Parity::Even), self.expand(lower, upper, exponent + 0.5, Parity::Odd));
            if let (Ok(even), Ok(odd)) = halves
                && even.converged
                && odd.converged
                && (even.noise + odd.noise * upper <= CANCELLING * whole.scale || depth > SHORT)
            {
                self.push(lower, upper, exponent, even);
                self.push(lower, upper, exponent + 0.5, odd);
                return Ok(());
            }
        }
        if last {
            self.push(lower, upper, exponent, whole);
            return Ok(());
        }
        // Halved in s = r².
        let middle = (0.5 * (lower * lower + upper * upper)).sqrt();
        if !(middle > lower && middle < upper) {
            return Err(TransformError::NotComputable { at: upper });
        }
        self.cover(lower, middle, depth + 1)?;
        self.cover(middle, upper, depth + 1)
    }

    fn push(&mut self, lower: f64, upper: f64, exponent: f64, found: Expansion) {
        self.list.push(Piece::new(lower, upper, exponent, found.coefficients, found.noise, upper < self.end));
    }

    fn expand(&mut self, lower: f64, upper: f64, exponent: f64, parity: Parity) -> Result<Expansion, TransformError> {
        let length = (upper - lower) * (upper + lower);
        let mut best = None;
        for count in COUNTS {
            let rule = rule(count, exponent);
            let (mut values, mut noise, mut scale) = (Vec::with_capacity(count), 0.0_f64, 0.0_f64);
            for node in rule.nodes() {
                let u = length * node.unit;
                // Above the lower end of the source, u is measured from that end.
                let offset = (lower - self.source.lower) * (lower + self.source.lower);
                let own = self.source.psi(offset + u, exponent, parity);
                if !own.value.is_finite() {
                    return Err(TransformError::NotComputable { at: upper });
                }
                // The error of an odd half is largest near the axis, where its weight vanishes.
                let weight = if parity == Parity::Odd { node.unit.sqrt() } else { 1.0 };
                noise = noise.max(own.error * weight);
                scale = scale.max(own.value.abs());
                values.push(own.value);
            }
            self.budget.evaluations += count as u64;
            let mut coefficients = rule.coefficients(&values);
            // The plateau includes the error bounds of the values.
            let plateau = PLATEAU.max(if scale > 0.0 { noise / scale } else { 0.0 });
            if scale == 0.0 {
                return Ok(Expansion { coefficients: vec![0.0], noise, scale, converged: true });
            }
            if let Some(dropped) = chop(&mut coefficients, scale, plateau) {
                let rounding = 4.0 * f64::EPSILON * scale;
                return Ok(Expansion { coefficients, noise: 1.5 * noise + 2.0 * dropped + rounding, scale, converged: true });
            }
            let tail: f64 = coefficients.iter().skip(count / 2).map(|c| c.abs()).sum();
            best = Some(Expansion { coefficients, noise: 1.5 * noise + 16.0 * tail, scale, converged: false });
        }
        best.ok_or(TransformError::NotComputable { at: upper })
    }
}
