//! The end of f′, as the equator of a sphere: f′ over the distance to it, and whether something narrow may hide before it.

use crate::eval::{RegionAlgebra, Tape};
use crate::expr::{Expr, Symbol};
use crate::integrate::error::TransformError;
use crate::integrate::source::f_prime::Numbers;
use crate::num::{Bounded, Region, work};
use std::sync::OnceLock;

/// The end of f′.
pub struct Limit {
    pub(crate) value: Bounded,
    /// f′ over the distance δ to the limit.
    pub(crate) f_prime: Numbers,
    /// The same as an expression.
    source: Expr,
    enclosing: OnceLock<Option<Tape>>,
    featureless: OnceLock<bool>,
}

/// The shortest distance to the end that is looked at, as a share of the limit: rounding of r itself is larger.
const NEAREST: f64 = 1e-15;
/// The half-axes of the ellipse around a piece, as shares of half the piece: those of σ = 0.45.
const AXES: (f64, f64) = (1.103, 0.4654);
/// On the ellipse f′ is at most this many times as large as on the piece, or something narrow may be in it.
const LARGEST_RATIO: f64 = 30.0;
/// The shortest piece, as a share of its distance from the end.
const SHORTEST: f64 = 0.05;

impl Limit {
    /// The end at `value`, where f′ is `source` over δ.
    ///
    /// # Errors
    /// [`TransformError::Evaluation`] if a parameter has no value.
    pub fn new(value: Bounded, source: Expr) -> Result<Self, TransformError> {
        let f_prime = Numbers::Tape(Tape::compile(std::slice::from_ref(&source), &[Symbol::new("δ")])?);
        Ok(Self { value, f_prime, source, enclosing: OnceLock::new(), featureless: OnceLock::new() })
    }

    /// f′ over the distance to the limit for enclosures.
    pub(crate) fn enclosing(&self) -> Option<&Tape> {
        let compile = || Tape::for_enclosures(std::slice::from_ref(&self.source), &[Symbol::new("δ")]).ok();
        self.enclosing.get_or_init(|| work::prepared(compile)).as_ref()
    }

    /// Whether f′ changes over lengths of the size of the distance to the end only, from `lower` on: it is analytic around every
    /// piece between two powers of two of the distance, or around parts of the piece, and not much larger there than on it.
    pub fn is_featureless(&self, lower: f64) -> bool {
        *self.featureless.get_or_init(|| work::prepared(|| self.has_no_feature(self.value.value - lower)))
    }

    fn has_no_feature(&self, reach: f64) -> bool {
        let Some(tape) = self.enclosing() else { return false };
        let mut slots = Vec::new();
        let mut far = reach;
        while far > NEAREST * self.value.value {
            let mut open = vec![(0.5 * far, far)];
            while let Some((from, to)) = open.pop() {
                let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
                let around = Region::new((middle - AXES.0 * half, middle + AXES.0 * half), (-AXES.1 * half, AXES.1 * half));
                let largest = tape.run(&mut RegionAlgebra, &[around], &mut slots).map_or(f64::INFINITY, Region::largest);
                let size = [from, middle, to].map(|delta| self.f_prime.plain(delta).abs()).into_iter().fold(0.0, f64::max);
                let plain = largest <= LARGEST_RATIO * size;
                if !plain {
                    if half < SHORTEST * middle {
                        return false;
                    }
                    open.extend([(from, middle), (middle, to)]);
                }
            }
            far *= 0.5;
        }
        true
    }
}
