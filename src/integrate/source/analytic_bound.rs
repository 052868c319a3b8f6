//! The sufficient number of nodes for an f′ that is analytic around the contact, from its expression, before evaluating f′.

use crate::integrate::abel::angle_substitution::{Bounds, NEAR_THE_LIMIT};
use crate::integrate::error::TransformError;
use crate::integrate::integral::{NumericSegment, Weight};
use crate::integrate::source::f_prime::Numbers;
use crate::num::bounded::UNIT;
use crate::num::quadrature::{Extent, Form, Known};
use crate::num::{Estimate, Region, work};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};

/// Rules by the upper end x, one list for each weight: one rule per sixteenth of an octave from 2⁻³² to 2³², determined when
/// first needed.
#[derive(Default)]
pub(crate) struct AnalyticBound([OnceLock<Box<[Octave]>>; LISTS]);

/// The range between a power of two and the next.
type Octave = OnceLock<Box<[Entry; SIXTEENTHS]>>;

/// The data of one sixteenth, as bits that are set once; all threads compute the same values.
#[derive(Default)]
struct Entry {
    /// The index of the rule plus 1 in the low bits, its truncation error in the others; 0 before it is determined.
    rule: AtomicU64,
    /// [`Sufficient::noise`].
    noise: AtomicU64,
    /// [`Sufficient::share`].
    share: AtomicU64,
}

/// A rule for all x of a sixteenth.
#[derive(Clone, Copy)]
pub struct Sufficient {
    /// The rule.
    pub known: Known,
    /// A bound on the rounding error of the mean of the integrand.
    pub noise: f64,
    /// An estimate of this bound relative to the mean.
    share: f64,
}

/// The result of a rule.
struct GaussSum {
    estimate: Estimate,
    mean: f64,
    /// The factor between the mean and the integral.
    scale: f64,
    left_out: f64,
    noise: f64,
}

impl GaussSum {
    fn add_noise(&mut self, noise: f64) {
        self.noise += noise;
        self.estimate.error += self.scale * noise;
    }
}

/// The lists: by weight of f′, of (r f′)′, and of the expansion of the pressure.
const LISTS: usize = 5;
const OF_THE_BEND: usize = 3;
const OF_THE_SERIES: usize = 4;
const SIXTEENTHS: usize = 16;
const OCTAVES: usize = 64;
/// Bits of a double below the exponent and the first four of the mantissa.
const BELOW: u32 = 48;
/// The upper bits of the lowest x.
const LOWEST: u64 = (1023 - 32) << 4;
/// The bits of the rule.
const RULE: u64 = 31;
const _: () = assert!(Known::RULES < RULE as usize);
/// No rule of a reasonable size suffices.
const NONE: u64 = u64::MAX;
/// Factor by which the bounds at both ends of a sixteenth are multiplied to cover the whole sixteenth.
const WITHIN: f64 = 2.0;
/// Largest shared bound relative to the tolerance; otherwise the bound is computed for every value.
const LITTLE: f64 = 0.05;

/// Smallest σ of the ellipses to try.
const FIRST: f64 = 0.1;
/// Ratio of consecutive σ.
const STEP: f64 = 1.3;
/// Number of steps in σ.
const ELLIPSES: usize = 18;
/// Number of refinements between the last ellipse in which f′ is analytic and the first in which it is not.
const REFINED: usize = 4;
/// Largest truncation error of a rule relative to the mean of |f′|: half a rounding error.
const NOTHING: f64 = 0.25 * f64::EPSILON;
/// Smaller fractions are nearly negligible.
const SMALL: f64 = 0.01;

impl NumericSegment {
    /// The integral by a single rule proven sufficient, if this segment reaches up to x and f′ is analytic around it.
    ///
    /// # Errors
    /// [`TransformError::NotComputable`] if f′ is not finite.
    #[inline]
    pub(crate) fn by_known_rule(&self, x: f64, weight: Weight, tolerance: f64) -> Result<Option<Estimate>, TransformError> {
        if self.singular || matches!(weight, Weight::Outside(_)) || self.upper.is_some_and(|upper| upper.value < x) {
            return Ok(None);
        }
        let Some(own) = self.sufficient(x, weight) else { return Ok(None) };
        let enough = |found: &Estimate| found.error <= tolerance * found.value.abs();
        if own.share <= LITTLE * tolerance {
            let mut found = self.by(&self.f_prime, own.known, x, weight, Bounds::None)?;
            found.add_noise(own.noise);
            if enough(&found.estimate) {
                return Ok(Some(found.estimate));
            }
        }
        let found = self.by(&self.f_prime, own.known, x, weight, Bounds::Running)?;
        // No other rule reduces the rounding error.
        let rounded = found.left_out <= SMALL * found.noise && found.estimate.error <= SMALL * found.estimate.value.abs();
        Ok((rounded || enough(&found.estimate)).then_some(found.estimate))
    }

    /// ∫ (r f′)′ dτ up to x ≤ a by the single rule that suffices up to a, if this segment reaches from the axis to a and is
    /// analytic around it; `None` otherwise.
    pub(crate) fn bend_rule(&self, bend: &Numbers, a: f64) -> Option<impl Fn(f64) -> Result<Estimate, TransformError>> {
        if self.singular || self.lower.value > 0.0 || self.upper.is_some_and(|upper| upper.value - upper.error < a) {
            return None;
        }
        let (place, own) = self.cell(a, OF_THE_BEND)?;
        let rule = match own.rule.load(Ordering::Acquire) {
            0 => {
                let high = f64::from_bits((place + 1) << BELOW);
                let mut slots = Vec::new();
                let around = |region: Region| self.largest_bend(region, &mut slots);
                let known = work::finished(|| self.fewest(bend, around, (f64::from_bits(place << BELOW), high), false));
                store(own, known)
            }
            rule => rule,
        };
        // A smaller x needs f′ within the same rectangle.
        let known = known_of(rule)?;
        Some(move |x: f64| Ok(self.by(bend, known, x, Weight::Equivalent, Bounds::Running)?.estimate))
    }

    /// The sufficient number of terms of the Legendre expansion of the pressure for a contact of radius a, and a bound on their
    /// truncation error of f′/r; determined by `find` for all radii of a sixteenth of an octave.
    pub(crate) fn series_rule(&self, a: f64, find: impl FnOnce(f64, f64) -> Option<Known>) -> Option<Known> {
        let (place, own) = self.cell(a, OF_THE_SERIES)?;
        let rule = match own.rule.load(Ordering::Acquire) {
            0 => store(own, work::finished(|| find(f64::from_bits(place << BELOW), f64::from_bits((place + 1) << BELOW)))),
            rule => rule,
        };
        known_of(rule)
    }

    /// The integral by a rule.
    #[inline]
    fn by(&self, numbers: &Numbers, known: Known, x: f64, weight: Weight, bounds: Bounds) -> Result<GaussSum, TransformError> {
        let extent = Extent::new(self.lower.value, x, None);
        let form = Form::choose(&extent, self.odd, None);
        let scale = form.scale(&extent);
        let mut integrand = self.integrand(numbers, x, weight, form, extent, bounds);
        let found = known.mean(&mut integrand).map_err(|_| TransformError::NotComputable { at: x })?;
        let value = scale * found.value;
        let error = scale * (found.left_out + found.noise) + 8.0 * UNIT * value.abs();
        let estimate = Estimate { error, evaluations: found.evaluations, ..Estimate::exact(value) };
        Ok(GaussSum { estimate, mean: found.value, scale, left_out: found.left_out, noise: found.noise })
    }

    /// The rule for x.
    #[inline]
    pub fn sufficient(&self, x: f64, weight: Weight) -> Option<Sufficient> {
        let list = match weight {
            Weight::Equivalent => 0,
            Weight::Force => 1,
            Weight::Integral | Weight::Outside(_) => 2,
        };
        let (place, own) = self.cell(x, list)?;
        let rule = match own.rule.load(Ordering::Acquire) {
            0 => work::finished(|| self.entry(place, weight, own)),
            rule => rule,
        };
        let known = known_of(rule)?;
        let [noise, share] = [&own.noise, &own.share].map(|bits| f64::from_bits(bits.load(Ordering::Relaxed)));
        Some(Sufficient { known, noise, share })
    }

    /// The index of the sixteenth that contains x, and its entry.
    #[inline]
    fn cell(&self, x: f64, list: usize) -> Option<(u64, &Entry)> {
        let number = x.to_bits() >> BELOW;
        let place = usize::try_from(number.checked_sub(LOWEST)?).ok()?;
        let list = self.continued.0.get(list)?.get_or_init(|| (0..OCTAVES).map(|_| Octave::new()).collect());
        Some((number, list.get(place / SIXTEENTHS)?.get_or_init(Box::default).get(place % SIXTEENTHS)?))
    }

    /// Whether no rule of a reasonable size is proven sufficient away from the end of f′, according to its expression.
    pub(crate) fn is_intricate(&self, x: f64, weight: Weight) -> bool {
        let near_the_end = self.limit.as_ref().is_some_and(|limit| x > 0.9 * NEAR_THE_LIMIT * limit.value.value);
        self.f_prime.is_expression() && !self.singular && !near_the_end && self.sufficient(x, weight).is_none()
    }

    /// Determines the entry for all x between two neighbours in the list.
    #[cold]
    fn entry(&self, place: u64, weight: Weight, own: &Entry) -> u64 {
        let (low, high) = (f64::from_bits(place << BELOW), f64::from_bits((place + 1) << BELOW));
        let (weighted, mut slots) = (!matches!(weight, Weight::Equivalent), Vec::new());
        let around = |region: Region| self.f_prime.largest(region, &mut slots);
        let Some(known) = self.fewest(&self.f_prime, around, (low.max(self.lower.value), high), weighted) else {
            return store(own, None);
        };
        let (noise, share) = self.noise(known, (low, high), weight);
        own.noise.store(noise.to_bits(), Ordering::Relaxed);
        own.share.store(share.to_bits(), Ordering::Relaxed);
        store(own, Some(known))
    }

    /// The absolute and relative rounding error of the mean for x between two values; infinite if unknown.
    fn noise(&self, known: Known, (low, high): (f64, f64), weight: Weight) -> (f64, f64) {
        // Towards the lower end of the piece, the relative error grows without limit.
        if low <= self.lower.value {
            return (f64::INFINITY, f64::INFINITY);
        }
        let found = [low, high].map(|x| self.noise_at(known, x, weight).unwrap_or((f64::NAN, f64::NAN)));
        let [(one, small), (other, large)] = found;
        let noise = WITHIN * one.max(other);
        let share = noise / small.min(large);
        if one + other + share < f64::INFINITY { (noise, share) } else { (f64::INFINITY, f64::INFINITY) }
    }

    /// The rounding error of the mean for one x, by bounds that are valid in a neighbourhood, and the magnitude of the mean.
    ///
    /// # Errors
    /// [`TransformError::NotComputable`] if f′ is not finite.
    pub fn noise_at(&self, known: Known, x: f64, weight: Weight) -> Result<(f64, f64), TransformError> {
        let found = self.by(&self.f_prime, known, x, weight, Bounds::NearBy)?;
        Ok((found.noise, found.mean.abs()))
    }

    /// The smallest rule for all x from `low` to `high`.
    fn fewest(&self, numbers: &Numbers, mut around: impl FnMut(Region) -> f64, (low, high): (f64, f64), weighted: bool) -> Option<Known> {
        if !numbers.is_expression() {
            return None;
        }
        if self.limit.as_ref().is_some_and(|limit| high > NEAR_THE_LIMIT * limit.value.value) || high <= self.lower.value {
            return None;
        }
        let extent = Extent::new(self.lower.value, high, None);
        let size = self.size(numbers, 0.5 * (low + high))?;
        let mut best: Option<Known> = None;
        let mut bound = |sigma: f64| {
            let (region, factor) = self.around(low, &extent, sigma, weighted)?;
            let largest = around(region) * factor;
            largest.is_finite().then_some(largest)
        };
        let (mut sigma, mut step, mut refined) = (FIRST, STEP, 0);
        for _ in 0..ELLIPSES + REFINED {
            match bound(sigma) {
                Some(largest) => match (best, Known::fewest(sigma, largest, NOTHING * size)) {
                    // On larger ellipses, the growth of the bound outweighs the faster convergence.
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

    /// An approximate mean of |f′| over the angle.
    fn size(&self, numbers: &Numbers, x: f64) -> Option<f64> {
        const PLACES: usize = 8;
        let extent = Extent::new(self.lower.value, x, None);
        let angle = extent.angle();
        let mut total = 0.0;
        for i in 0..PLACES {
            let r = x * (angle * (i as f64 + 0.5) / PLACES as f64).cos();
            total += numbers.plain(r - self.lower.value).abs();
        }
        let size = total / PLACES as f64;
        (size.is_normal()).then_some(size)
    }

    /// The region of r − lower for z on the ellipse of σ and every x from `low` to the end of the extent, and a bound on the
    /// ratio of the weighted integrand to |f′|.
    ///
    /// Half or a quarter of the region suffices: f′ is real on the axis, and may be odd.
    pub(crate) fn around(&self, low: f64, extent: &Extent, sigma: f64, weighted: bool) -> Option<(Region, f64)> {
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
            // A margin above the rounding error of the angle.
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

/// Stores the rule, or the fact that there is none, and returns the stored bits.
fn store(entry: &Entry, known: Option<Known>) -> u64 {
    // The bound is rounded up to the remaining bits.
    let rule = known.map_or(NONE, |known| ((known.left_out.to_bits() & !RULE) + RULE + 1) | (known.rule as u64 + 1));
    entry.rule.store(rule, Ordering::Release);
    rule
}

/// Decodes the stored rule.
#[inline]
fn known_of(rule: u64) -> Option<Known> {
    (rule != NONE).then(|| Known { rule: (rule & RULE) as usize - 1, left_out: f64::from_bits(rule & !RULE) })
}
