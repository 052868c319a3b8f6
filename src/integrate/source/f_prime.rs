//! Where the numbers of f′ come from on one segment: a compiled expression, or anything else that can say f′ and (r f′)′.

use crate::eval::{BlockInput, BlockScratch, BoundedAlgebra, FloatAlgebra, RegionAlgebra, RoundingAlgebra, Tape, WideAlgebra};
use crate::integrate::error::TransformError;
use crate::integrate::integral::is_singular;
use crate::integrate::integral::{NumericProfile, NumericSegment};
use crate::integrate::source::analytic_bound::AnalyticBound;
use crate::integrate::source::endpoint::Endpoint;
use crate::integrate::source::removable::Removable;
use crate::num::{Bounded, Precise, Region, Wide};
use std::cell::Cell;
use std::sync::{Arc, OnceLock};

/// f′ on one segment [lower, upper) as a function of δ = r − lower, with bounds on its errors.
///
/// Quadrature and the whole-curve path need no more of a profile than this. δ > 0 comes with the bound on its own
/// rounding, which the answer's bound must include; δ = 0 and δ = upper − lower ask for the jumps at kinks. A value that
/// does not exist is NaN.
///
/// ```
/// use sneddon::num::Bounded;
/// use sneddon::transform::{NumericProfile, FPrimeSource};
/// struct Cone;
/// impl FPrimeSource for Cone {
///     fn f_prime(&self, _delta: Bounded) -> Bounded {
///         Bounded::exact(1.0)
///     }
///     fn bend(&self, _delta: Bounded) -> Option<Bounded> {
///         Some(Bounded::exact(1.0))
///     }
/// }
/// let cone = NumericProfile::from_sources([(0.0, None, std::sync::Arc::new(Cone) as _)]);
/// let g = cone.equivalent(2.0, 1e-12).unwrap();
/// assert!((g.value - std::f64::consts::PI).abs() <= g.error);
/// ```
pub trait FPrimeSource: Send + Sync {
    /// f′(lower + δ).
    fn f_prime(&self, delta: Bounded) -> Bounded;

    /// (r f′)′ = f′ + r f″ at r = lower + δ, which only the pressure needs; `None` if it is not known.
    fn bend(&self, delta: Bounded) -> Option<Bounded>;

    /// Returns the distances below `end` at which f′ or f″ may jump, in ascending order; quadrature splits its panels there.
    fn cuts(&self, _end: f64) -> Vec<f64> {
        Vec::new()
    }

    /// f′ in plain doubles at many distances; override it if a loop over them is faster.
    fn f_primes(&self, deltas: &[f64], values: &mut [f64]) {
        for (delta, value) in deltas.iter().zip(values) {
            *value = self.f_prime(Bounded::exact(*delta)).value;
        }
    }
}

/// One function of δ on a segment: a tape, or one of the two functions of a source.
pub(crate) enum Numbers {
    Tape(Tape),
    /// A tape that is 0/0 at the axis, with a series there.
    Removable(Box<Removable>),
    FPrime(Arc<dyn FPrimeSource>),
    Bend(Arc<dyn FPrimeSource>),
}

impl Numbers {
    /// As [`FPrimeSource::cuts`]; empty for formulas, whose jumps are breakpoints of the profile.
    pub(crate) fn cuts(&self, end: f64) -> Vec<f64> {
        match self {
            Self::FPrime(source) => source.cuts(end),
            _ => Vec::new(),
        }
    }

    /// The value with its bound; NaN without a value.
    #[inline]
    pub(crate) fn at(&self, delta: Bounded, slots: &mut Vec<Bounded>) -> Bounded {
        let nothing = Bounded { value: f64::NAN, error: f64::NAN };
        match self {
            Self::Tape(tape) => rescued(tape, delta, tape.run(&mut BoundedAlgebra, &[delta], slots).unwrap_or(nothing)),
            Self::Removable(own) => own.at(delta, slots).unwrap_or(nothing),
            Self::FPrime(source) => source.f_prime(delta),
            Self::Bend(source) => source.bend(delta).unwrap_or(nothing),
        }
    }

    /// Values with their bounds at many distances; NaN without a value.
    pub(crate) fn block(&self, deltas: &[f64], doubts: &[f64], values: &mut [f64], errors: &mut [f64], scratch: &mut Scratch) {
        if let Self::Tape(tape) = self {
            let input = BlockInput { values: deltas, errors: doubts };
            if tape.run_block_bounded(&[input], values, errors, &mut scratch.0).is_some() {
                rescue_block(tape, deltas, doubts, values, errors);
                return;
            }
        }
        if let Self::Removable(own) = self
            && own.block(deltas, doubts, values, errors, scratch).is_some()
        {
            return;
        }
        let mut slots = Vec::new();
        for ((value, error), (delta, doubt)) in values.iter_mut().zip(errors).zip(deltas.iter().zip(doubts)) {
            let own = self.at(Bounded { value: *delta, error: *doubt }, &mut slots);
            (*value, *error) = (own.value, own.error);
        }
    }

    /// Values with bounds that hold near by as well.
    pub(crate) fn block_near_by(&self, deltas: &[f64], doubts: &[f64], values: &mut [f64], errors: &mut [f64]) {
        let mut slots = Vec::new();
        for ((value, error), (delta, doubt)) in values.iter_mut().zip(errors).zip(deltas.iter().zip(doubts)) {
            let delta = Bounded { value: *delta, error: *doubt };
            let own = match self {
                Self::Tape(tape) => tape.run(&mut RoundingAlgebra, &[delta], &mut slots),
                Self::Removable(own) => own.near_by(delta, &mut slots),
                _ => None,
            };
            (*value, *error) = own.map_or((f64::NAN, f64::NAN), |own| (own.value, own.error));
        }
    }

    /// Values alone at many distances.
    pub(crate) fn plain_block(&self, deltas: &[f64], values: &mut [f64], scratch: &mut Scratch) {
        if let Self::Tape(tape) = self
            && tape.run_block(&[deltas], values, &mut scratch.0).is_some()
        {
            for (value, delta) in values.iter_mut().zip(deltas).filter(|(value, _)| !value.is_finite()) {
                *value = rescued(tape, Bounded::exact(*delta), Bounded::exact(*value)).value;
            }
            return;
        }
        for (value, delta) in values.iter_mut().zip(deltas) {
            *value = self.plain(*delta);
        }
    }

    /// The value alone.
    pub(crate) fn plain(&self, delta: f64) -> f64 {
        match self {
            Self::Tape(tape) => {
                let own = tape.run(&mut FloatAlgebra, &[delta], &mut Vec::new()).unwrap_or(f64::NAN);
                rescued(tape, Bounded::exact(delta), Bounded::exact(own)).value
            }
            Self::Removable(own) => own.plain(delta).unwrap_or(f64::NAN),
            _ => self.at(Bounded::exact(delta), &mut Vec::new()).value,
        }
    }
}

/// The value, or where it left the range of doubles on its way the value with exponents that have no end.
pub(crate) fn rescued(tape: &Tape, delta: Bounded, own: Bounded) -> Bounded {
    if !is_lost(own) {
        return own;
    }
    let delta = Wide::new(Precise::checked(delta.value.into(), delta.error));
    let found = tape.run(&mut WideAlgebra, &[delta], &mut Vec::new()).map(|wide| wide.precise().bounded());
    found.filter(|found| found.is_finite()).unwrap_or(own)
}

/// The same for a block of values.
pub(crate) fn rescue_block(tape: &Tape, deltas: &[f64], doubts: &[f64], values: &mut [f64], errors: &mut [f64]) {
    for ((delta, doubt), (value, error)) in deltas.iter().zip(doubts).zip(values.iter_mut().zip(errors)) {
        let own = rescued(tape, Bounded { value: *delta, error: *doubt }, Bounded { value: *value, error: *error });
        (*value, *error) = (own.value, own.error);
    }
}

/// The largest error of a value that only underflowed: [`Bounded::VANISHED`] times factors up to 1e21.
const UNDERFLOW: f64 = 1e21 * Bounded::VANISHED;

/// Returns true if the value overflowed on its way; the reciprocal of an overflow is 0 with an error.
fn is_lost(own: Bounded) -> bool {
    !own.is_finite() || (own.value == 0.0 && own.error > UNDERFLOW)
}

impl Numbers {
    /// True for what has enclosures.
    pub(crate) fn is_expression(&self) -> bool {
        matches!(self, Self::Tape(_) | Self::Removable(_))
    }

    /// A bound on the magnitude for δ in a part of the complex plane, where it is analytic there; else infinite.
    pub(crate) fn largest(&self, delta: Region, slots: &mut Vec<Region>) -> f64 {
        match self {
            Self::Tape(tape) => tape.run(&mut RegionAlgebra, &[delta], slots).map_or(f64::INFINITY, Region::largest),
            Self::Removable(own) => own.largest(delta, slots),
            Self::FPrime(_) | Self::Bend(_) => f64::INFINITY,
        }
    }
}

/// Scratch memory for the intermediate values of blocks, kept by each thread to avoid allocations in short integrals.
pub(crate) struct Scratch(BlockScratch);

thread_local! {
    static KEPT: Cell<Option<BlockScratch>> = const { Cell::new(None) };
}

impl Scratch {
    /// The thread's own, or a new one while that is in use.
    pub(crate) fn take() -> Self {
        Self(KEPT.take().unwrap_or_default())
    }

    /// The room itself.
    pub(crate) fn room(&mut self) -> &mut BlockScratch {
        &mut self.0
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        KEPT.set(Some(std::mem::take(&mut self.0)));
    }
}

impl NumericProfile {
    /// A profile from sources of f′: lower end, upper end (`None`: no end) and source of each segment.
    ///
    /// The ends are meant exactly; a jump of f′ where two segments meet is a kink. Behaviour like a fractional power
    /// of δ at a lower end is found from samples.
    pub fn from_sources(segments: impl IntoIterator<Item = (f64, Option<f64>, Arc<dyn FPrimeSource>)>) -> Self {
        let segments = segments.into_iter().map(|(lower, upper, source)| NumericSegment::from_source(lower, upper, source)).collect();
        Self { segments }
    }

    /// Sets the leading behaviour f ~ C rⁿ at the axis, which is otherwise estimated from samples.
    pub(crate) fn state_exponent(&mut self, n: f64) {
        for segment in self.segments.iter_mut().filter(|segment| segment.lower.value == 0.0) {
            segment.singular = n.fract() != 0.0;
        }
    }

    /// States that f is even where it begins at the axis, so that f′ is odd there.
    pub(crate) fn state_even(&mut self) {
        for segment in self.segments.iter_mut().filter(|segment| segment.lower.value == 0.0) {
            segment.odd = true;
        }
    }

    /// True if (r f′)′ is known on every segment, so that pressures can be had.
    pub fn has_bend(&self) -> bool {
        self.segments.iter().all(|segment| segment.bend().is_ok())
    }
}

impl NumericSegment {
    fn from_source(lower: f64, upper: Option<f64>, source: Arc<dyn FPrimeSource>) -> Self {
        let scale = match upper {
            Some(upper) => upper - lower,
            None if lower > 0.0 => lower,
            None => 1.0,
        };
        let has_bend = source.bend(Bounded::exact(0.5 * scale)).is_some();
        let bend = OnceLock::from(has_bend.then(|| Numbers::Bend(Arc::clone(&source))));
        let f_prime = Numbers::FPrime(source);
        let singular = is_singular(&f_prime, lower, upper);
        Self {
            lower: Bounded::exact(lower),
            upper: upper.map(Bounded::exact),
            ends: (Endpoint::exact(lower), upper.map(Endpoint::exact)),
            f_prime,
            source: None,
            enclosing: OnceLock::new(),
            power: OnceLock::new(),
            bend,
            end: None,
            falling: OnceLock::new(),
            bend_enclosing: OnceLock::new(),
            bend_power: OnceLock::new(),
            singular,
            odd: false,
            limit: None,
            continued: AnalyticBound::default(),
            ragged: false,
            near: None,
        }
    }
}

/// The error if a source has no second derivative.
pub(crate) const NO_BEND: TransformError = TransformError::NoClosedForm { quantity: "the derivative (r f′)′" };
