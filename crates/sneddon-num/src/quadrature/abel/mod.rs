//! g(x) and F(a) of an f′ given as a closure over blocks of radii.

mod forms;
mod pieces;
mod start;
mod transform;

pub use forms::{CHUNK, Extent, Form};
pub use start::{Wish, from_the_axis, growth_below_normal};
pub use transform::AbelTransform;

use super::super::bounded::UNIT;
use super::super::error::NumError;
use super::super::estimate::Estimate;

/// A block of radii at which f′ is evaluated, with distances free of cancellation.
#[derive(Clone, Copy, Debug)]
pub struct Radii<'a> {
    /// r.
    pub r: &'a [f64],
    /// r less the lower end of its piece: of [`AbelOptions::from`] or the breakpoint below, or r itself on the first piece.
    pub past_start: &'a [f64],
    /// [`AbelOptions::limit`] minus r; without a limit, the rounded x − r.
    ///
    /// An f′ that varies rapidly next to the limit must use this: r itself is rounded.
    pub below_limit: &'a [f64],
}

/// The behaviour of f′ at the lower end of every piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Start {
    /// f′ continues to an odd function of r, which is the case if the profile is a smooth function of r².
    ///
    /// This affects only the speed unless a [`Strip`] is given: the rules detect a wrong declaration and use more points.
    Odd,
    /// f′ is smooth up to the end.
    #[default]
    Smooth,
    /// f′ behaves like a fractional power or a logarithm of the distance to the end, such as rⁿ⁻¹ for a profile rⁿ.
    Algebraic,
}

/// Where f′ is analytic around the contact, and how large it is there.
///
/// f′ continues to all complex r with |Im r| ≤ `height` and |Re r| ≤ √(x² + `height`²), and |f′(r)| ≤ `largest` there. This
/// bounds the truncation error of Gauss rules, which gives the smallest sufficient number of nodes without estimates from values.
/// For an f′ with breakpoints, the bound applies to the piece that ends at x.
/// The bound must hold, and [`Start::Odd`] must be true if it is declared as well: neither is checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strip {
    /// A length.
    pub height: f64,
    /// A number, as f′.
    pub largest: f64,
}

/// Options of [`abel`] and [`abel_force`], and known properties of f′.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AbelOptions<'a> {
    /// Accepted error relative to |value|.
    pub rel_tol: f64,
    /// Accepted absolute error; the larger of the two tolerances counts.
    pub abs_tol: f64,
    /// Most evaluations of f′, overrun by one rule at most.
    pub max_evaluations: u64,
    /// Behaviour at the lower end.
    pub start: Start,
    /// f′ is 0 below this radius and is not evaluated there.
    pub from: f64,
    /// Kinks above `from`, in increasing order.
    pub breakpoints: &'a [f64],
    /// Where f′ ends, perhaps like 1/√(limit − r); the equator of a sphere.
    pub limit: Option<f64>,
    /// Bound on the relative error of the values of f′, in units of 2⁻⁵³.
    pub roundings: f64,
    /// A bound on f′ off the real axis. Not used together with [`Self::limit`] or [`Start::Algebraic`].
    pub strip: Option<Strip>,
}

impl Default for AbelOptions<'_> {
    /// Relative tolerance 1e−12, smooth, no kinks, no limit, 200 000 evaluations, values accurate to 8 units, no strip.
    fn default() -> Self {
        Self {
            rel_tol: 1e-12,
            abs_tol: 0.0,
            max_evaluations: 200_000,
            start: Start::Smooth,
            from: 0.0,
            breakpoints: &[],
            limit: None,
            roundings: 8.0,
            strip: None,
        }
    }
}

/// g(x) = x ∫₀ˣ f′(r)/√(x² − r²) dr, with f′ evaluated for blocks of radii.
///
/// Units: x and r are lengths, f′ is a number, g a length. Domain: x ≥ 0, below the limit.
/// The integral is taken over the angle, r = x cos τ, or over its sine where f′ is odd: in both the integrand is even, and
/// half of the points of a rule suffice. Patterson's nested rules of 15 to 511 points are applied until the tolerance is met; if
/// they do not converge, as at an undeclared kink, the range is bisected.
///
/// Accuracy: as [`integrate`](super::integrate): the error is estimated from the coefficients on the nodes, so a feature that
/// affects no node is not detected; near the lower end of a piece, where steep powers hide narrow features, additional values
/// are evaluated for this purpose.
///
/// # Errors
/// * [`NumError::ToleranceNotReached`], [`NumError::EvaluationLimit`]: with the best value and its error.
/// * [`NumError::NotFinite`]: f′ was an infinity or NaN.
/// * [`NumError::OutOfDomain`]: x is negative, not finite, or at the limit or beyond.
///
/// ```
/// use sneddon_num::quadrature::{AbelOptions, Radii, Start, Strip, abel};
/// // The sphere of radius 2: f′ = r/√((R − r)(R + r)), g = x artanh(x/R).
/// let mut slope = |at: Radii<'_>, out: &mut [f64]| {
///     for ((o, r), below) in out.iter_mut().zip(at.r).zip(at.below_limit) {
///         *o = r / (below * (2.0 + r)).sqrt();
///     }
/// };
/// let options = AbelOptions { start: Start::Odd, limit: Some(2.0), rel_tol: 1e-14, ..AbelOptions::default() };
/// let g = abel(&mut slope, 1.999999, &options)?;
/// assert!((g.value - 15.201797068264066).abs() <= g.error && g.error < 2e-13);
/// // ln cosh r, f′ = tanh r with poles at ±iπ/2: |tanh r| ≤ tan 1.4 up to ±1.4i.
/// let mut slope = |at: Radii<'_>, out: &mut [f64]| out.iter_mut().zip(at.r).for_each(|(o, r)| *o = r.tanh());
/// let plain = AbelOptions { start: Start::Odd, ..AbelOptions::default() };
/// let told = AbelOptions { strip: Some(Strip { height: 1.4, largest: 5.8 }), ..plain };
/// let (plain, told) = (abel(&mut slope, 3.0, &plain)?, abel(&mut slope, 3.0, &told)?);
/// assert!((plain.value - told.value).abs() <= plain.error + told.error);
/// assert!(plain.evaluations == 36 && told.evaluations == 22);
/// # Ok::<(), sneddon_num::NumError>(())
/// ```
pub fn abel(slope: &mut impl FnMut(Radii<'_>, &mut [f64]), x: f64, options: &AbelOptions<'_>) -> Result<Estimate, NumError> {
    integral::<false>(slope, x, options)
}

/// g, or F where `FORCE`: the integral over the angle of f′, times (r/x)² for F, is what has no unit.
#[inline]
fn integral<const FORCE: bool>(
    slope: &mut impl FnMut(Radii<'_>, &mut [f64]),
    x: f64,
    options: &AbelOptions<'_>,
) -> Result<Estimate, NumError> {
    let found = if options.abs_tol > 0.0 {
        pieces::over_angle::<FORCE>(slope, x, &without_unit::<FORCE>(x, options))
    } else {
        pieces::over_angle::<FORCE>(slope, x, options)
    };
    with_unit::<FORCE>(x, found)
}

/// The options with the absolute tolerance of the dimensionless integral.
fn without_unit<'a, const FORCE: bool>(x: f64, options: &AbelOptions<'a>) -> AbelOptions<'a> {
    let per = |value: f64| if value > 0.0 && x > 0.0 { (value / x).min(f64::MAX) } else { value };
    let abs_tol = per(options.abs_tol);
    AbelOptions { abs_tol: if FORCE { per(abs_tol) } else { abs_tol }, ..*options }
}

/// The estimate of x times the integral.
fn times(found: Result<Estimate, NumError>, x: f64) -> Result<Estimate, NumError> {
    let by = |value: f64, error: f64| {
        let product = value * x;
        // The rounding error of the product, and the error of an underflow.
        let rounding = UNIT * product.abs() + f64::from_bits(1);
        let none = value == 0.0 && error == 0.0;
        (product, if none { 0.0 } else { (error * x + rounding) * (1.0 + f64::EPSILON) })
    };
    let too_large = NumError::OutOfDomain { what: "upper end of an Abel integral", got: x, accepted: "x where the value is a double" };
    match found {
        Ok(own) => {
            let (value, error) = by(own.value, own.error);
            if value.is_finite() && error.is_finite() { Ok(Estimate { value, error, ..own }) } else { Err(too_large) }
        }
        Err(NumError::ToleranceNotReached { value, error, requested, evaluations }) => {
            let (value, error) = by(value, error);
            let requested = requested * x;
            Err(if value.is_finite() { NumError::ToleranceNotReached { value, error, requested, evaluations } } else { too_large })
        }
        Err(NumError::EvaluationLimit { value, error, evaluations }) => {
            let (value, error) = by(value, error);
            Err(if value.is_finite() { NumError::EvaluationLimit { value, error, evaluations } } else { too_large })
        }
        other => other,
    }
}

/// Adds evaluations that were spent before.
fn counted(found: Result<Estimate, NumError>, spent: u64) -> Result<Estimate, NumError> {
    match found {
        Ok(found) => Ok(Estimate { evaluations: found.evaluations + spent, ..found }),
        Err(NumError::ToleranceNotReached { value, error, requested, evaluations }) => {
            Err(NumError::ToleranceNotReached { value, error, requested, evaluations: evaluations + spent })
        }
        Err(NumError::EvaluationLimit { value, error, evaluations }) => {
            Err(NumError::EvaluationLimit { value, error, evaluations: evaluations + spent })
        }
        Err(other) => Err(other),
    }
}

/// The options with the remaining number of evaluations.
fn without_spent<'a>(options: &AbelOptions<'a>, spent: u64) -> AbelOptions<'a> {
    AbelOptions { max_evaluations: options.max_evaluations.saturating_sub(spent), ..*options }
}

/// The integral with its unit, times x for g and x² for F.
#[inline]
fn with_unit<const FORCE: bool>(x: f64, found: Result<Estimate, NumError>) -> Result<Estimate, NumError> {
    let found = times(found, x);
    if FORCE { times(found, x) } else { found }
}

/// F(a)/(2E*) = ∫₀^a r² f′(r)/√(a² − r²) dr, the force under a smooth edge of radius a, without the cancellation of a g − G.
///
/// Units: a is a length, the value an area. Domain, accuracy and errors: as [`abel`].
///
/// # Errors
/// As [`abel`].
///
/// ```
/// use sneddon_num::quadrature::{AbelOptions, Radii, Start, abel_force};
/// // A paraboloid, f′ = r: F/(2E*) = 2a³/3.
/// let options = AbelOptions { start: Start::Odd, ..AbelOptions::default() };
/// let force = abel_force(&mut |at: Radii<'_>, out: &mut [f64]| out.copy_from_slice(at.r), 3.0, &options)?;
/// assert!((force.value - 18.0).abs() <= force.error && force.error < 2e-11);
/// # Ok::<(), sneddon_num::NumError>(())
/// ```
pub fn abel_force(slope: &mut impl FnMut(Radii<'_>, &mut [f64]), a: f64, options: &AbelOptions<'_>) -> Result<Estimate, NumError> {
    integral::<true>(slope, a, options)
}
