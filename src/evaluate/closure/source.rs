//! A function given as Rust code, as a source of f′ and (r f′)′ on one segment.

use super::cells::Cells;
use super::starts::{Seen, Starts};
use crate::integrate::source::f_prime::FPrimeSource;
use crate::num::Bounded;
use num_complex::Complex64;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// A real function that may be called from many threads.
pub(super) type Real = Arc<dyn Fn(f64) -> f64 + Send + Sync>;

/// The declared properties of f.
#[derive(Clone)]
pub(super) enum Function {
    /// f of a complex radius.
    Complex(Arc<dyn Fn(Complex64) -> Complex64 + Send + Sync>),
    /// f alone, of a real radius.
    Real(Real),
    /// f and f′.
    FPrime(Real, Real),
    /// f, f′ and f″.
    Bend(Real, Real, Real),
}

impl Function {
    /// f(r).
    pub(super) fn height(&self, r: f64) -> f64 {
        match self {
            Self::Complex(f) => f(Complex64::new(r, 0.0)).re,
            Self::Real(f) | Self::FPrime(f, _) | Self::Bend(f, ..) => f(r),
        }
    }

    /// f′(r) where it can be had without a difference.
    pub(super) fn f_prime(&self, r: f64) -> Option<f64> {
        match self {
            Self::Complex(f) => Some(complex_step(f.as_ref(), r, STEP)),
            Self::FPrime(_, f_prime) | Self::Bend(_, f_prime, _) => Some(f_prime(r)),
            Self::Real(_) => None,
        }
    }
}

/// The step of the complex-step derivative relative to r: what it leaves out, (step r)² f‴/6, is below any rounding.
pub(super) const STEP: f64 = 1.0 / (1_u64 << 63) as f64;
/// The step for radii so small that the other one would leave the range of doubles.
const COARSE_STEP: f64 = 1.0 / (1_u64 << 28) as f64;

/// f′(r) = Im f(r + ih)/h: no difference, hence no cancellation (Squire and Trapp 1998).
pub(super) fn complex_step(f: &(impl Fn(Complex64) -> Complex64 + ?Sized), r: f64, step: f64) -> f64 {
    let h = if r < 1e-250 { (r * COARSE_STEP).max(f64::MIN_POSITIVE) } else { r * step };
    f(Complex64::new(r, h)).im / h
}

/// One smooth piece of a closure.
pub(super) struct Piece {
    pub(super) function: Function,
    pub(super) lower: f64,
    pub(super) upper: f64,
    /// The error of the closure's values in units in the last place.
    pub(super) ulps: f64,
    /// The interpolants of what is known and not differentiated: of f alone, else of f′, else of f″.
    pub(super) cells: Cells,
    /// The interpolants of f from the axis on, where f alone is known and the piece begins there.
    pub(super) starts: Option<Starts>,
    /// Where the closure had no value, and where it was not smooth.
    pub(super) faults: Arc<Faults>,
}

/// The first radii at which something was wrong, as bits; an infinity where nothing was.
pub(super) struct Faults {
    undefined: AtomicU64,
    seam: AtomicU64,
}

/// Below this radius a closure's values may underflow; (r f′)′ counts for nothing there, and is about f′.
const FAINT: f64 = 1e-100;

/// Relative error at which a derivative from the axis is not compared with one between powers of two.
const CLOSE: f64 = 1e-8;

const NONE: u64 = f64::INFINITY.to_bits();

impl Faults {
    pub(super) fn new() -> Self {
        Self { undefined: AtomicU64::new(NONE), seam: AtomicU64::new(NONE) }
    }

    fn note(cell: &AtomicU64, r: f64) {
        // Only the first place is kept.
        let _ = cell.compare_exchange(NONE, r.to_bits(), Ordering::Relaxed, Ordering::Relaxed);
    }

    /// Where the closure had no value, and where it was not smooth, since the last time.
    pub(super) fn take(&self) -> (Option<f64>, Option<f64>) {
        let take = |cell: &AtomicU64| Some(f64::from_bits(cell.swap(NONE, Ordering::Relaxed))).filter(|r| r.is_finite());
        (take(&self.undefined), take(&self.seam))
    }
}

impl Piece {
    /// The radius at a distance from the lower end, strictly within the piece.
    ///
    /// At a breakpoint itself the closure may already belong to the next piece.
    fn radius(&self, delta: f64) -> f64 {
        let first = if self.lower > 0.0 { self.lower.next_up() } else { f64::MIN_POSITIVE };
        (self.lower + delta).clamp(first, self.upper.next_down().max(first))
    }

    fn with_ulps(&self, value: f64) -> Bounded {
        Bounded::checked(value, self.ulps * 0.5 * f64::EPSILON * value.abs())
    }

    /// The function whose interpolants are kept, at one radius.
    fn sample(&self, r: f64) -> Bounded {
        let own = match &self.function {
            Function::Real(f) => f(r),
            Function::Bend(_, _, second) => second(r),
            other => other.f_prime(r).unwrap_or(f64::NAN),
        };
        let sample = self.with_ulps(own);
        if own.is_finite() { sample } else { Bounded { value: f64::NAN, error: f64::NAN } }
    }

    fn f_prime_at(&self, r: f64) -> Bounded {
        match self.function.f_prime(r) {
            Some(value) => self.with_ulps(value),
            None => self.derivative(1, r),
        }
    }

    /// Returns true if f alone is known, and is smooth from the axis to beyond r.
    pub(super) fn begins_smoothly(&self, r: f64) -> bool {
        self.starts.as_ref().is_some_and(|own| own.begin(r, &|r| self.sample(r)))
    }

    /// Returns a bound on the change of g at r due to steps of f that are not resolved; see [`Starts::mismatch`].
    pub(super) fn mismatch(&self, r: f64) -> f64 {
        let serves = |r: f64| self.across_the_axis(1, r).is_some();
        self.starts.as_ref().map_or(0.0, |own| own.mismatch(r, &|r| self.sample(r), &serves))
    }

    /// A derivative of f from its values.
    fn derivative(&self, order: usize, r: f64) -> Bounded {
        let phi = |r: f64| self.sample(r);
        self.across_the_axis(order, r).unwrap_or_else(|| self.cells.derivative(order, r, &phi))
    }

    /// Returns a derivative from the fits that begin at the axis, or `None` if the fits between powers of two are more accurate.
    fn across_the_axis(&self, order: usize, r: f64) -> Option<Bounded> {
        let phi = |r: f64| self.sample(r);
        let (own, seen) = self.starts.as_ref()?.derivative(order, r, &phi)?;
        if seen != Seen::Slopes || own.error <= CLOSE * own.value.abs() {
            return Some(own);
        }
        let between = self.cells.derivative(order, r, &phi);
        let is_better = between.error.is_nan() || own.error <= between.error;
        // A fit that begins at the axis may be too wide to see a kink that the cells around it see.
        let f_prime = |r: f64| Some(self.starts.as_ref()?.derivative(1, r, &phi)?.0);
        (is_better && self.cells.agree(r, &phi, &f_prime)).then_some(own)
    }

    /// Returns a bound on the slope at r of steps of f that were taken for noise.
    fn hidden_f_prime(&self, r: f64) -> f64 {
        let phi = |r: f64| self.sample(r);
        match self.starts.as_ref().filter(|_| self.across_the_axis(1, r).is_some()) {
            Some(own) => own.hidden_f_prime(r, &phi),
            None => self.cells.hidden_f_prime(r, &phi),
        }
    }

    /// A place near r at which what is interpolated is not smooth.
    fn seam(&self, r: f64) -> Option<f64> {
        if self.across_the_axis(1, r).is_some() { None } else { self.cells.seam(r, &|r| self.sample(r)) }
    }

    fn second_at(&self, r: f64) -> Bounded {
        match &self.function {
            Function::Bend(_, _, second) => self.with_ulps(second(r)),
            Function::Real(_) => self.derivative(2, r),
            _ => self.cells.derivative(1, r, &|r| self.sample(r)),
        }
    }

    /// Records the radius if the closure itself is not finite there; a derivative may be unknown where the closure is finite.
    fn noted(&self, r: f64, value: Bounded) -> Bounded {
        let is_defined = || self.function.height(r).is_finite() && self.function.f_prime(r).is_none_or(f64::is_finite);
        if !value.value.is_finite() {
            if !is_defined() {
                Faults::note(&self.faults.undefined, r);
            } else if let Some(seam) = self.seam(r) {
                Faults::note(&self.faults.seam, seam);
            }
        }
        value
    }
}

impl FPrimeSource for Piece {
    fn f_prime(&self, delta: Bounded) -> Bounded {
        let r = self.radius(delta.value);
        let own = self.noted(r, self.f_prime_at(r));
        // The closure sees r, not δ: the rounding of r moves f′ by f″.
        let moved = delta.error + 0.5 * f64::EPSILON * r;
        let moved = match &self.function {
            Function::Bend(_, _, second) => moved * second(r).abs(),
            // A closure that is differentiated by interpolation has the rounding of r in the bound of its cell.
            Function::Real(_) => self.hidden_f_prime(r),
            _ => moved * self.cells.steepness(r, &|r| self.sample(r)),
        };
        Bounded::checked(own.value, own.error + moved)
    }

    fn cuts(&self, end: f64) -> Vec<f64> {
        let phi = |r: f64| self.sample(r);
        let r = self.radius(end);
        if !matches!(self.function, Function::Real(_)) || self.across_the_axis(1, r).is_some() {
            return Vec::new();
        }
        let beyond = self.cells.cuts(r, &phi).into_iter().filter(|cut| *cut > self.lower);
        beyond.map(|cut| cut - self.lower).collect()
    }

    fn bend(&self, delta: Bounded) -> Option<Bounded> {
        let r = self.radius(delta.value);
        if r < FAINT {
            let f_prime = self.f_prime_at(r);
            return Some(Bounded::checked(f_prime.value, 16.0 * f_prime.value.abs() + f_prime.error));
        }
        if !matches!(self.function, Function::Bend(..))
            && let Some(seam) = self.seam(r)
        {
            Faults::note(&self.faults.seam, seam);
            return Some(Bounded { value: f64::NAN, error: f64::NAN });
        }
        let second = self.second_at(r);
        let value = self.f_prime_at(r) + Bounded::exact(r) * second;
        // The rounding of r moves (r f′)′ by 2f″ + r f‴; where f″ is interpolated, its bound has the second part.
        let third = match &self.function {
            Function::Bend(..) => self.cells.steepness(r, &|r| self.sample(r)),
            _ => 0.0,
        };
        let moved = (delta.error + 0.5 * f64::EPSILON * r) * (2.0 * second.value.abs() + r * third);
        Some(self.noted(r, Bounded::checked(value.value, value.error + moved)))
    }
}
