//! How many nodes suffice for an f′ that is analytic around the contact: known from its expression, before f′ is asked.

use super::TransformError;
use super::angle::NEAR_THE_LIMIT;
use super::integral::{NumericSegment, Weight};
use super::slope_source::Numbers;
use crate::eval::{FloatAlgebra, RegionAlgebra, Tape};
use crate::num::bounded::UNIT;
use crate::num::quadrature::{Extent, Form, Known};
use crate::num::{Estimate, Region};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};

/// Rules by the upper end x, for the slope and for what has a weight: one per sixteenth of a power of two from 2⁻³² to 2³², found when they
/// are first needed.
#[derive(Default)]
pub(super) struct Continued([OnceLock<Box<[AtomicU64]>>; 2]);

const COUNT: usize = 1024;
/// Bits of a double below the exponent and the first four of the mantissa.
const BELOW: u32 = 48;
/// These bits at the lowest x.
const LOWEST: u64 = (1023 - 32) << 4;
/// The low bits of an entry are the number of the rule and 1, the others those of what the rule leaves out.
const RULE: u64 = 31;
const _: () = assert!(Known::RULES < RULE as usize);
/// There is no rule.
const NONE: u64 = u64::MAX;

/// Ellipses are tried from this σ on …
const FIRST: f64 = 0.1;
/// … in these steps …
const STEP: f64 = 1.3;
/// … as often as this, …
const STEPS: usize = 18;
/// … and as often as this between the last one that f′ is analytic in and the first one that it is not.
const REFINED: usize = 4;
/// A rule may leave out this share of the mean of |f′|, half a rounding.
const NOTHING: f64 = 0.25 * f64::EPSILON;
/// Less than this share hardly counts.
const SMALL: f64 = 0.01;

impl NumericSegment {
    /// The integral by the one rule that is known to suffice, where this segment reaches up to x and f′ is analytic around it.
    ///
    /// # Errors
    /// [`TransformError::NotComputable`] where f′ is not finite.
    #[inline]
    pub(super) fn by_known_rule(&self, x: f64, weight: Weight, tolerance: f64) -> Result<Option<Estimate>, TransformError> {
        if self.singular || matches!(weight, Weight::Outside(_)) || self.upper.is_some_and(|upper| upper.value < x) {
            return Ok(None);
        }
        let weighted = !matches!(weight, Weight::Slope);
        let Some(known) = self.known(x, weighted) else { return Ok(None) };
        let extent = Extent::new(self.lower.value, x, None);
        let form = Form::choose(&extent, self.odd, None);
        let scale = form.scale(&extent);
        let mut integrand = self.integrand(x, weight, form, extent);
        let found = known.mean(&mut integrand).map_err(|_| TransformError::NotComputable { at: x })?;
        let left_out = if matches!(weight, Weight::Force) { x * x * found.left_out } else { found.left_out };
        let value = scale * found.value;
        let error = scale * (left_out + found.noise) + 8.0 * UNIT * value.abs();
        // Of rounding alone no other rule makes less.
        let enough = error <= tolerance * value.abs() || (left_out <= SMALL * found.noise && error <= SMALL * value.abs());
        Ok(enough.then_some(Estimate { value, error, evaluations: found.evaluations }))
    }

    /// The rule for x.
    #[inline]
    fn known(&self, x: f64, weighted: bool) -> Option<Known> {
        let place = usize::try_from((x.to_bits() >> BELOW).checked_sub(LOWEST)?).ok()?;
        let list = self.continued.0.get(usize::from(weighted))?.get_or_init(|| (0..COUNT).map(|_| AtomicU64::new(0)).collect());
        let cell = list.get(place)?;
        // Whoever finds the entry finds the same one.
        let mut entry = cell.load(Ordering::Relaxed);
        if entry == 0 {
            entry = self.entry(place as u64 + LOWEST, weighted);
            cell.store(entry, Ordering::Relaxed);
        }
        if entry == NONE {
            return None;
        }
        Some(Known { rule: (entry & RULE) as usize - 1, left_out: f64::from_bits(entry & !RULE) })
    }

    /// Whether an expression says that no rule of a reasonable size is known to suffice, away from the end of f′.
    pub(super) fn is_intricate(&self, x: f64, weight: Weight) -> bool {
        let near_the_end = self.limit.as_ref().is_some_and(|limit| x > 0.9 * NEAR_THE_LIMIT * limit.value.value);
        let is_tape = matches!(self.slope, Numbers::Tape(_));
        is_tape && !self.singular && !near_the_end && self.known(x, !matches!(weight, Weight::Slope)).is_none()
    }

    /// The entry for all x between two neighbours in the list.
    #[cold]
    fn entry(&self, place: u64, weighted: bool) -> u64 {
        let ends = (f64::from_bits(place << BELOW), f64::from_bits((place + 1) << BELOW));
        self.fewest(ends.0.max(self.lower.value), ends.1, weighted).map_or(NONE, |known| {
            // Rounded up to what is left of the bits.
            let left_out = (known.left_out.to_bits() & !RULE) + RULE + 1;
            left_out | (known.rule as u64 + 1)
        })
    }

    /// The smallest rule for all x from `low` to `high`.
    fn fewest(&self, low: f64, high: f64, weighted: bool) -> Option<Known> {
        let Numbers::Tape(tape) = &self.slope else { return None };
        if self.limit.as_ref().is_some_and(|limit| high > NEAR_THE_LIMIT * limit.value.value) || high <= self.lower.value {
            return None;
        }
        let extent = Extent::new(self.lower.value, high, None);
        let size = self.size(0.5 * (low + high), tape)?;
        let mut best: Option<Known> = None;
        let mut slots = Vec::new();
        let mut bound = |sigma: f64| {
            let (region, factor) = self.around(low, &extent, sigma, weighted)?;
            let largest = tape.run(&mut RegionAlgebra, &[region], &mut slots)?.largest() * factor;
            largest.is_finite().then_some(largest)
        };
        let (mut sigma, mut step, mut refined) = (FIRST, STEP, 0);
        for _ in 0..STEPS + REFINED {
            match bound(sigma) {
                Some(largest) => match (best, Known::fewest(sigma, largest, NOTHING * size)) {
                    // Further out the bound grows faster than the ellipse helps.
                    (Some(best), Some(own)) if own.rule > best.rule => break,
                    (Some(_), None) => break,
                    (None, None) => {}
                    (_, own) => best = own,
                },
                None => {
                    sigma /= step;
                    refined = refined.max(1);
                }
            }
            if refined > 0 {
                (step, refined) = (step.sqrt(), refined + 1);
            }
            if refined > REFINED + 1 {
                break;
            }
            sigma *= step;
        }
        best
    }

    /// The mean of |f′| over the angle, roughly.
    fn size(&self, x: f64, tape: &Tape) -> Option<f64> {
        const PLACES: usize = 8;
        let extent = Extent::new(self.lower.value, x, None);
        let angle = extent.angle();
        let mut total = 0.0;
        for i in 0..PLACES {
            let r = x * (angle * (i as f64 + 0.5) / PLACES as f64).cos();
            total += tape.run(&mut FloatAlgebra, &[r - self.lower.value], &mut Vec::new())?.abs();
        }
        let size = total / PLACES as f64;
        (size.is_normal()).then_some(size)
    }

    /// Where r − lower is while the variable z is on the ellipse of σ, for every x from `low` to the end of the extent; and by how much the
    /// integrand with its weight may exceed |f′|.
    ///
    /// Half or a quarter of it is enough: f′ is real on the axis, and odd where that is said.
    fn around(&self, low: f64, extent: &Extent, sigma: f64, weighted: bool) -> Option<(Region, f64)> {
        let x = extent.x;
        let widen = 1.0 + 1e-9;
        let (angle, turn) = if self.odd { (sigma, 0.0) } else { (extent.angle() * sigma.sinh(), extent.angle() * sigma.cosh()) };
        let (wide, high) = (x * angle.cosh() * widen, x * angle.sinh() * widen);
        // r = x cos τ with |Im τ| ≤ angle and |Re τ| ≤ turn.
        let least = if self.odd {
            0.0
        } else {
            let cosine = turn.min(std::f64::consts::PI).cos();
            let least = if cosine > 0.0 { low * cosine } else { wide * cosine };
            // More than the rounding of the angle.
            least - 1e-9 * wide
        };
        let lower = Region::new((self.lower.value - self.lower.error, self.lower.value + self.lower.error), (0.0, 0.0));
        let region = Region::new((least, wide), (0.0, high)) - lower;
        // |cos τ|² ≤ cosh² of the angle in the weights; f′/cos τ in the sine, where |cos τ| ≥ sinh σ on the ellipse itself.
        let weight = if weighted { angle.cosh() * angle.cosh() * widen } else { 1.0 };
        let factor = if self.odd { weight * widen / sigma.sinh() } else { weight };
        (wide.is_finite() && factor.is_finite()).then_some((region, factor))
    }
}
