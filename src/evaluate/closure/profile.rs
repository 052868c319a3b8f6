//! The quantities of a profile that is given as Rust code.

use super::cells::Cells;
use super::source::{Faults, Function, Piece, STEP, complex_step};
use super::starts::Starts;
use super::{Closure, Parity};
use crate::evaluate::evaluator::Reading;
use crate::evaluate::quantities::Quantities;
use crate::integrate::error::TransformError;
use crate::integrate::integral::NumericProfile;
use crate::integrate::source::f_prime::FPrimeSource;
use crate::num::{Bounded, Estimate};
use std::sync::Arc;

/// A profile made of a [`Closure`]; its quantities are integrals over f′ and, for the pressure, f″.
///
/// Errors are what the quadrature promises plus what the closure's own stated error and the rounding of r make of it.
pub struct ClosureProfile {
    closure: Closure,
    numeric: NumericProfile,
    at_axis: f64,
    /// The piece that begins at the axis.
    first: Option<Arc<Piece>>,
    faults: Arc<Faults>,
}

impl ClosureProfile {
    pub(super) fn new(closure: Closure) -> Result<Self, TransformError> {
        let faults = Arc::new(Faults::new());
        let ends: Vec<f64> = [0.0].into_iter().chain(closure.breakpoints.iter().copied()).chain([closure.limit]).collect();
        let (mut segments, mut first) = (Vec::new(), None);
        let mut is_smooth = false;
        for pair in ends.windows(2) {
            let [lower, upper] = *pair else { continue };
            let scale = examine(&closure.function, lower, upper)?;
            let cells = Cells::new(lower, upper);
            let starts = (lower == 0.0 && matches!(closure.function, Function::Real(_))).then(|| Starts::new(upper));
            let (function, faults) = (closure.function.clone(), Arc::clone(&faults));
            let piece = Piece { function, lower, upper, ulps: closure.ulps, cells, starts, faults };
            // The lengths of the closure may be much smaller than 1.
            is_smooth |= UNITS.into_iter().any(|unit| piece.begins_smoothly(libm::scalbn(PARTS[0] * scale, unit)));
            let piece = Arc::new(piece);
            first.get_or_insert_with(|| Arc::clone(&piece));
            let piece: Arc<dyn FPrimeSource> = piece;
            segments.push((lower, upper.is_finite().then_some(upper), piece));
        }
        for b in &closure.breakpoints {
            refuse_jump(&closure.function, *b)?;
        }
        let at_axis = match closure.function.height(0.0) {
            value if value.is_finite() => value,
            // A form like sin(r)/r has a limit.
            _ => closure.function.height(f64::MIN_POSITIVE.sqrt()),
        };
        if !at_axis.is_finite() {
            return Err(TransformError::Undefined { radius: 0.0 });
        }
        let mut numeric = NumericProfile::from_sources(segments);
        // Where f is smooth at the axis, its leading exponent is whole, whatever samples of f′ seem to say.
        if let Some(n) = closure.exponent.or(is_smooth.then_some(1.0)) {
            numeric.state_exponent(n);
        }
        if closure.parity == Some(Parity::Even) {
            numeric.state_even();
        }
        // What sampling found undefined next to the axis is found again where it matters.
        faults.take();
        Ok(Self { closure, numeric, at_axis, first, faults })
    }

    /// f′ on its segments, for separate integration.
    pub fn numeric(&self) -> &NumericProfile {
        &self.numeric
    }

    /// Names the radius at which the closure had no value, if it was that.
    fn named(&self, error: TransformError) -> TransformError {
        let (undefined, seam) = self.faults.take();
        match (error, undefined, seam) {
            (TransformError::NotComputable { .. } | TransformError::NoDigits { .. }, Some(radius), _) => {
                TransformError::Undefined { radius }
            }
            (TransformError::NotComputable { .. }, None, Some(radius)) => TransformError::Seam { radius },
            (other, ..) => other,
        }
    }

    fn reading(&self, found: Result<Estimate, TransformError>) -> Result<Reading, TransformError> {
        let estimate = found.map_err(|error| self.named(error))?;
        Ok(Reading { estimate, method: "quadrature" })
    }

    /// Adds the error due to steps of f below x that are not resolved: `factor` times what they may change g by.
    fn with_steps(&self, found: Result<Estimate, TransformError>, x: f64, factor: f64) -> Result<Reading, TransformError> {
        let mut own = self.reading(found)?;
        let hidden = factor * self.first.as_ref().map_or(0.0, |piece| piece.mismatch(x));
        own.estimate.error += hidden;
        if hidden > LOST * own.estimate.value.abs() {
            return Err(TransformError::NoDigits { at: x, value: own.estimate.value, error: own.estimate.error });
        }
        Ok(own)
    }
}

/// Finds the closure's value and slope at a few radii of a piece, and returns the length of the part in which they lie.
///
/// An unbounded piece may have an undeclared end, like a sphere; the part is halved until the closure has values there.
fn examine(function: &Function, lower: f64, upper: f64) -> Result<f64, TransformError> {
    let is_defined = |r: f64| function.height(r).is_finite() && function.f_prime(r).is_none_or(f64::is_finite);
    let mut scale = if upper.is_finite() { upper - lower } else { lower.max(1.0) };
    while let Some(radius) = PARTS.map(|part| lower + part * scale).into_iter().find(|r| !is_defined(*r)) {
        scale *= 0.5;
        if upper.is_finite() || lower + scale == lower || !scale.is_normal() {
            return Err(TransformError::Undefined { radius });
        }
    }
    for r in PARTS.map(|part| lower + part * scale) {
        if let Function::Complex(f) = function {
            // A larger step is as good, unless f forgets small imaginary parts; real parts must agree with f on the axis.
            let (small, large) = (complex_step(f.as_ref(), r, STEP), complex_step(f.as_ref(), r, LARGE_STEP));
            let h = 1e-6 * r;
            let difference = (function.height(r + h) - function.height(r - h)) / (2.0 * h);
            let rounding = 1e-8 * function.height(r).abs() / r;
            let size = small.abs().max(large.abs()).max(difference.abs());
            if (small - large).abs() > 1e-4 * size || (small - difference).abs() > 1e-3 * size + rounding {
                return Err(TransformError::NotAnalytic { radius: r, step: small, difference });
            }
        }
    }
    Ok(scale)
}

/// Where a part of a piece is examined, as shares of it.
const PARTS: [f64; 3] = [0.127, 0.489, 0.831];

/// Binary exponents of the units of length in which f is examined next to the axis.
const UNITS: [i32; 6] = [0, -8, -16, -24, -32, -40];

/// A step of the complex-step derivative whose imaginary parts no function forgets.
const LARGE_STEP: f64 = 1.0 / (1_u64 << 17) as f64;

/// f must be continuous at its breakpoints.
fn refuse_jump(function: &Function, b: f64) -> Result<(), TransformError> {
    let (below, beyond) = (function.height(b * (1.0 - NEAR)), function.height(b * (1.0 + NEAR)));
    let (inner, outer) = (function.height(b * (1.0 - 2.0 * NEAR)), function.height(b * (1.0 + 2.0 * NEAR)));
    // What f changes by over such a distance anyway, ten times over.
    let usual = 10.0 * ((below - inner).abs() + (outer - beyond).abs()) + 1e-9 * below.abs().max(beyond.abs());
    let jump = beyond - below;
    if jump.abs() > usual { Err(TransformError::Jump { at: format!("{b:?}"), jump: format!("{jump:?}") }) } else { Ok(()) }
}

const NEAR: f64 = 1e-7;

/// Safety factor for unresolved steps, whose heights are sampled at four radii per octave.
const STEP_SAFETY: f64 = 2.0;
/// Maximum error due to unresolved steps relative to the value.
const LOST: f64 = 0.5;
/// Relative error of g above which steps of f may have been taken for noise.
const UNSURE: f64 = 1e-5;

impl Quantities for ClosureProfile {
    fn equivalent(&self, x: f64) -> Result<Reading, TransformError> {
        self.check_domain("x", x)?;
        self.with_steps(self.numeric.equivalent(x, self.closure.tolerance), x, STEP_SAFETY)
    }

    fn force(&self, a: f64) -> Result<Reading, TransformError> {
        self.check_domain("a", a)?;
        self.with_steps(self.numeric.force(a, self.closure.tolerance), a, 2.0 * STEP_SAFETY * a)
    }

    fn integral(&self, a: f64) -> Result<Reading, TransformError> {
        self.check_domain("a", a)?;
        self.with_steps(self.numeric.integral(a, self.closure.tolerance), a, 2.0 * STEP_SAFETY * a)
    }

    fn pressure(&self, r: f64, a: f64) -> Result<Option<Reading>, TransformError> {
        self.check_domain("r", r)?;
        self.check_domain("a", a)?;
        if r >= a {
            return Ok(Some(Reading { estimate: Estimate::exact(0.0), method: "exact" }));
        }
        let found = self.numeric.pressure(r, a, self.closure.tolerance).map_err(|error| self.named(error))?;
        // The relative error of g bounds what steps of f taken for noise change in p.
        let g = self.equivalent(a)?.estimate;
        let doubt = if g.error > UNSURE * g.value.abs() { g.relative_error() } else { 0.0 };
        Ok(found.map(|own| Reading { estimate: Estimate { error: own.error + doubt * own.value.abs(), ..own }, method: "quadrature" }))
    }

    fn axial(&self, z: f64, a: f64) -> Result<Reading, TransformError> {
        self.check_domain("a", a)?;
        self.reading(self.numeric.axial(z, a, self.closure.tolerance))
    }

    fn displacement(&self, r: f64, a: f64) -> Result<Reading, TransformError> {
        self.check_domain("a", a)?;
        if r.is_nan() || r <= a {
            return Err(TransformError::OutOfDomain { symbol: "r", at: r, limit: format!(", which begins at a = {a:?} here") });
        }
        self.reading(self.numeric.displacement(r, a, self.closure.tolerance))
    }

    /// The closure less its value at the axis or, where that cancels, the integral of f′.
    fn height(&self, r: f64) -> Result<Reading, TransformError> {
        self.check_domain("r", r)?;
        let own = self.closure.function.height(r);
        if !own.is_finite() {
            return Err(TransformError::Undefined { radius: r });
        }
        let unit = self.closure.ulps * 0.5 * f64::EPSILON;
        let exact = self.at_axis == 0.0;
        let shift = Bounded::checked(self.at_axis, if exact { 0.0 } else { unit * self.at_axis.abs() });
        let found = Bounded::checked(own, unit * own.abs()) - shift;
        let plain = Reading { estimate: Estimate::estimated(found.value, found.error, 1), method: "exact" };
        if plain.estimate.relative_error() <= self.closure.tolerance {
            return Ok(plain);
        }
        match self.reading(self.numeric.height(r, self.closure.tolerance)) {
            Ok(other) if other.estimate.error < plain.estimate.error => Ok(other),
            _ => Ok(plain),
        }
    }

    fn limit(&self) -> f64 {
        self.closure.limit
    }

    fn breakpoints_below(&self, end: f64) -> Vec<f64> {
        self.closure.breakpoints.iter().copied().filter(|b| *b < end).collect()
    }

    fn check_domain(&self, symbol: &'static str, at: f64) -> Result<(), TransformError> {
        if at.is_nan() || at < 0.0 || at.is_infinite() {
            return Err(TransformError::OutOfDomain { symbol, at, limit: ", which begins at r = 0".to_owned() });
        }
        if at >= self.closure.limit {
            return Err(TransformError::OutOfDomain { symbol, at, limit: format!(", which ends at r = {:?}", self.closure.limit) });
        }
        Ok(())
    }
}
