//! g(x) and F(a) of one closure at many points, which share an expansion of f′.

use super::super::even::{Expansion, Known};
use super::forms::{Extent, Form};
use super::pieces::{Blocks, by_a_known_rule, target};
use super::{AbelOptions, Radii, Start, abel, abel_force, counted, with_unit, without_spent};
use crate::{Estimate, NumError};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// The transform of one f′, for values at many points.
///
/// If f′ is declared odd ([`Start::Odd`]), it is expanded once over each octave below `up_to`, in powers of r²: about 80
/// evaluations show at which degree the coefficients reach rounding noise. The expansion gives the smallest sufficient number of
/// nodes, usually 2 to 24, whereas [`abel`] determines it at every point and uses 12 to 36. [`abel`] is used if f′ is not
/// declared odd or has no such expansion, and for points beyond a kink or near a limit.
///
/// The expansion is used if its coefficients have reached noise and it agrees with f′ at 16 further radii, down to 1e−9 of the
/// range. The closure must return the same values at every call.
///
/// ```
/// use sneddon_num::quadrature::{AbelOptions, AbelTransform, Radii, Start};
/// // ln cosh r
/// let slope = |at: Radii<'_>, out: &mut [f64]| out.iter_mut().zip(at.r).for_each(|(o, r)| *o = r.tanh());
/// let options = AbelOptions { start: Start::Odd, ..AbelOptions::default() };
/// let mut transform = AbelTransform::new(slope, 3.0, options)?;
/// let first = transform.g(3.0)?;
/// let second = transform.g(3.0)?;
/// assert!((second.value - 3.985952806663719).abs() <= second.error && second.error < 4e-12);
/// assert!(first.evaluations > 80 && second.evaluations <= 20);
/// # Ok::<(), sneddon_num::NumError>(())
/// ```
pub struct AbelTransform<'a, F> {
    slope: F,
    options: AbelOptions<'a>,
    /// f′ is evaluated up to this radius.
    up_to: f64,
    /// Expansions end at this radius, below the first kink and sufficiently far from a limit.
    smooth: f64,
    octaves: BTreeMap<u64, Octave>,
}

/// The range between a power of two and the next.
struct Octave {
    /// The expansion of x f′(r)/r from the axis to the upper end, if it converges.
    expansion: Option<Expansion>,
    /// The rules of each sixteenth, for g and for F.
    rules: [[Option<Chosen>; SIXTEENTHS]; 2],
}

/// The rule for a sixteenth of an octave that suffices at its upper end, if any. A point where this rule misses the tolerance, as
/// for an f′ so steep that its integral is much smaller at the lower end, is computed separately.
type Chosen = Option<Known>;

const SIXTEENTHS: usize = 16;
/// Bits of a double below those that select the sixteenth of its octave.
const BELOW: u32 = 48;
/// Share of the tolerance for truncating an expansion; the rest allows for points of the same sixteenth with a smaller integral.
const SHARE: f64 = 0.3;

impl<'a, F: FnMut(Radii<'_>, &mut [f64])> AbelTransform<'a, F> {
    /// The transform of f′ for points up to `up_to`, a length; f′ is not evaluated beyond it.
    ///
    /// # Errors
    /// [`NumError::OutOfDomain`] if `up_to` is negative, not finite, or not below the limit.
    pub fn new(slope: F, up_to: f64, options: AbelOptions<'a>) -> Result<Self, NumError> {
        let limit = options.limit.unwrap_or(f64::INFINITY);
        if !(up_to >= 0.0 && up_to.is_finite() && up_to < limit) {
            let accepted = "0 <= x, finite, below the limit";
            return Err(NumError::OutOfDomain { what: "upper end of an Abel transform", got: up_to, accepted });
        }
        let kink = options.breakpoints.iter().copied().filter(|b| *b > 0.0).fold(f64::INFINITY, f64::min);
        let is_plain = options.start == Start::Odd && options.from <= 0.0 && options.strip.is_none();
        let smooth = if is_plain { up_to.min(kink).min(Form::plain_below(limit)) } else { 0.0 };
        Ok(Self { slope, options, up_to, smooth, octaves: BTreeMap::new() })
    }

    /// g(x) = x ∫₀ˣ f′(r)/√(x² − r²) dr; units, domain and errors as of [`abel`].
    ///
    /// The evaluations of the first value in an octave include those of its expansion.
    ///
    /// # Errors
    /// As [`abel`]; x beyond `up_to` is out of the domain.
    pub fn g(&mut self, x: f64) -> Result<Estimate, NumError> {
        self.value::<false>(x)
    }

    /// F(a)/(2E*) = ∫₀^a r² f′(r)/√(a² − r²) dr; units, domain and errors as of [`abel_force`].
    ///
    /// # Errors
    /// As [`abel_force`]; a beyond `up_to` is out of the domain.
    pub fn force(&mut self, a: f64) -> Result<Estimate, NumError> {
        self.value::<true>(a)
    }

    #[inline(always)]
    fn value<const FORCE: bool>(&mut self, x: f64) -> Result<Estimate, NumError> {
        let mut spent = 0;
        if x.is_normal() && x > 0.0 && x <= self.smooth {
            let place = x.to_bits() >> BELOW;
            let (chosen, asked) = self.chosen::<FORCE>(place);
            spent = asked;
            if let Some(known) = chosen {
                let extent = Extent::new(0.0, x, self.options.limit);
                let found = by_a_known_rule::<FORCE>(&mut self.slope, known, &extent, Form::AxisSine, &self.options)?;
                spent += found.evaluations;
                let found = with_unit::<FORCE>(x, Ok(Estimate { evaluations: spent, ..found }))?;
                if found.error <= target(&self.options, found.value) {
                    return Ok(found);
                }
            }
        }
        self.anew::<FORCE>(x, spent)
    }

    /// Computes the value separately, after `spent` evaluations.
    #[inline(never)]
    fn anew<const FORCE: bool>(&mut self, x: f64, spent: u64) -> Result<Estimate, NumError> {
        if x > self.up_to {
            let accepted = "0 <= x, up to the end that was stated";
            return Err(NumError::OutOfDomain { what: "place of an Abel transform", got: x, accepted });
        }
        let own = without_spent(&self.options, spent);
        let found = if FORCE { abel_force(&mut self.slope, x, &own) } else { abel(&mut self.slope, x, &own) };
        counted(found, spent)
    }

    /// The rule for a sixteenth of an octave, and the evaluations spent on finding it.
    #[inline]
    fn chosen<const FORCE: bool>(&mut self, place: u64) -> (Chosen, u64) {
        let (octave, sixteenth) = (place / SIXTEENTHS as u64, place as usize % SIXTEENTHS);
        match self.octaves.get(&octave).map(|own| own.rules[usize::from(FORCE)][sixteenth]) {
            Some(Some(chosen)) => (chosen, 0),
            _ => self.choose::<FORCE>(octave, sixteenth),
        }
    }

    #[cold]
    fn choose<const FORCE: bool>(&mut self, octave: u64, sixteenth: usize) -> (Chosen, u64) {
        let upper = |place: u64| f64::from_bits(place << BELOW).min(self.smooth);
        let (whole, own) = (upper((octave + 1) * SIXTEENTHS as u64), upper(octave * SIXTEENTHS as u64 + sixteenth as u64 + 1));
        let (entry, spent) = match self.octaves.entry(octave) {
            Entry::Occupied(entry) => (entry.into_mut(), 0),
            Entry::Vacant(entry) => {
                let extent = Extent::new(0.0, whole, self.options.limit);
                let (slope, roundings, most) = (&mut self.slope, self.options.roundings, self.options.max_evaluations);
                let mut integrand = Blocks::<_, false> { slope, form: Form::AxisSine, extent, roundings };
                let (expansion, spent) = Expansion::of(&mut integrand, most);
                (entry.insert(Octave { expansion, rules: Default::default() }), spent)
            }
        };
        let chosen = entry.expansion.as_ref().and_then(|expansion| {
            let share = own / whole;
            let part = expansion.part(share, FORCE);
            let unit = if FORCE { own * own } else { own };
            part.fewest(SHARE * (self.options.rel_tol * part.mean().abs()).max(self.options.abs_tol / unit))
        });
        entry.rules[usize::from(FORCE)][sixteenth] = Some(chosen);
        (chosen, spent)
    }
}
