//! The series way (Popov & Heß, Problem 8): f as a power series at r = 0, mapped term by term, with a truncation error bound.
//!
//! Σ A_n r^(n+s) gives g = Σ A_n κ_{n+s} x^(n+s). Cauchy's estimate bounds the remainder: if Σ |A_n| ρ^n ≤ M beyond the last
//! term, each further term is at most M κ (x/ρ)^n; the best of many radii ρ is used.

use crate::derive::profile::Profile;
use crate::eval::{Series, SeriesError, constant_value, power_series};
use crate::evaluate::evaluator::Reading;
use crate::evaluate::ways::SERIES;
use crate::expr::{Bindings, Expr};
use crate::integrate::error::TransformError;
use crate::num::{Bounded, Estimate, forms, kappa::kappa};
use thiserror::Error;

/// The highest order.
pub const HIGHEST_ORDER: usize = 1000;
/// Number of radii ρ of the first round, from the point outward by steps of a quarter of an octave.
const FIRST_ROUND: u32 = 48;
/// Number of radii ρ of the second round, between the best radius of the first round and its neighbours.
const SECOND_ROUND: u32 = 24;
/// Relative margin for rounding errors of the bound.
const MARGIN: f64 = 1e-11;

/// Why the series way has no answer.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SeriesFailure {
    /// The profile has no power series at r = 0.
    #[error("the profile has no power series at r = 0: {0}; expected a power of r times an analytic function")]
    NotAnalytic(#[from] SeriesError),
    /// The point lies beyond the first breakpoint, where another piece begins.
    #[error("{symbol} = {at:?} lies beyond the first breakpoint, r = {end:?}: the series holds for the first piece only")]
    BeyondFirstPiece {
        /// Name of the coordinate.
        symbol: &'static str,
        /// The value.
        at: f64,
        /// The breakpoint.
        end: f64,
    },
    /// The series is not proven to converge there.
    #[error("the series is not proven to converge at {symbol} = {at:?}; expected a smaller {symbol} or another method")]
    NoBound {
        /// Name of the coordinate.
        symbol: &'static str,
        /// The value.
        at: f64,
    },
    /// The quantity has no series here.
    #[error("no series is known for {quantity}; f, g, d, F, G, p and k have one under a smooth edge")]
    Quantity {
        /// The quantity.
        quantity: &'static str,
    },
    /// An error of the profile.
    #[error(transparent)]
    Transform(#[from] TransformError),
}

/// A profile with its series at r = 0; every parameter has a number.
pub struct SeriesEvaluator {
    expr: Expr,
    end: f64,
    order: usize,
}

/// The factor of A_n x^(n+s).
#[derive(Clone, Copy, PartialEq)]
enum Weight {
    /// 1: f.
    Height,
    /// κ: g.
    Equivalent,
    /// κ ν/(ν+1) x: F/(2E*).
    Force,
    /// κ/(ν+1) x: G.
    Integral,
    /// κ ν S_{ν−1}(r, x): p π/E*.
    Pressure(f64),
}

impl SeriesEvaluator {
    /// The default highest power of r.
    pub const ORDER: usize = 24;
    /// The highest power of r for the pressure, for which the series is the only method near the axis.
    pub const PRESSURE_ORDER: usize = 64;

    /// Creates the series from the first piece of every chain of the profile.
    ///
    /// ```
    /// use sneddon::{parse, transform::{Profile, SeriesEvaluator}};
    /// let sphere = Profile::new(&parse::profile("2-sqrt(4-r^2)").unwrap()).unwrap();
    /// let series = SeriesEvaluator::new(&sphere, 30).unwrap();
    /// let g = series.equivalent(0.5).unwrap().estimate;
    /// assert!((g.value - 0.5 * 0.25_f64.atanh()).abs() <= g.error && g.error < 1e-15);
    /// ```
    ///
    /// # Errors
    /// [`SeriesFailure`] if a parameter has no value.
    pub fn new(profile: &Profile, order: usize) -> Result<Self, SeriesFailure> {
        Self::with(profile, &Bindings::default(), order)
    }

    /// As [`Self::new`], with numbers for parameters without a value.
    pub(crate) fn with(profile: &Profile, bindings: &Bindings, order: usize) -> Result<Self, SeriesFailure> {
        let (mut first, mut end) = (Vec::new(), f64::INFINITY);
        for chain in &profile.chains {
            first.extend(chain.pieces.first().map(|piece| bindings.apply(piece)));
            if let Some(breakpoint) = chain.breakpoints.first() {
                let place = constant_value(breakpoint, bindings).map_err(TransformError::from)?;
                end = end.min(place.value - place.error);
            }
        }
        Ok(Self { expr: Expr::sum(first), end, order: order.min(HIGHEST_ORDER) })
    }

    /// f(r) − f(0).
    ///
    /// # Errors
    /// [`SeriesFailure`] if the series is not known, or not proven to converge.
    pub fn height(&self, r: f64) -> Result<Reading, SeriesFailure> {
        self.value("r", r, Weight::Height)
    }

    /// g(x).
    ///
    /// # Errors
    /// As [`Self::height`].
    pub fn equivalent(&self, x: f64) -> Result<Reading, SeriesFailure> {
        self.value("x", x, Weight::Equivalent)
    }

    /// F(a)/(2E*) under a smooth edge.
    ///
    /// # Errors
    /// As [`Self::height`].
    pub fn force(&self, a: f64) -> Result<Reading, SeriesFailure> {
        self.value("a", a, Weight::Force)
    }

    /// G(a) = ∫₀^a g dx.
    ///
    /// # Errors
    /// As [`Self::height`].
    pub fn integral(&self, a: f64) -> Result<Reading, SeriesFailure> {
        self.value("a", a, Weight::Integral)
    }

    /// p(r)·π/E* under a smooth edge of radius a, for 0 < r < a.
    ///
    /// # Errors
    /// As [`Self::height`].
    pub fn pressure(&self, r: f64, a: f64) -> Result<Reading, SeriesFailure> {
        self.value("a", a, Weight::Pressure(r))
    }

    fn value(&self, symbol: &'static str, x: f64, weight: Weight) -> Result<Reading, SeriesFailure> {
        if x > self.end {
            return Err(SeriesFailure::BeyondFirstPiece { symbol, at: x, end: self.end });
        }
        if x == 0.0 {
            return Ok(Reading { estimate: Estimate::exact(0.0), method: "series" });
        }
        let radii: Vec<f64> = (0..FIRST_ROUND).map(|k| x * 2.0_f64.powf(0.25 * f64::from(k + 1))).collect();
        let groups = power_series(&self.expr, self.order + 1, &radii)?;
        let mut total = Bounded::exact(0.0);
        let mut remainder = 0.0;
        for (index, group) in groups.iter().enumerate() {
            total = total + self.partial(group, x, weight)?;
            let (best, at) = self.remainder(group, &radii, x, weight);
            // Refine the best radius between its neighbours; the lower neighbour of the first radius is the point itself.
            let (low, high) = (if at == 0 { x } else { radii.get(at - 1).copied().unwrap_or(x) }, radii.get(at + 1).copied().unwrap_or(x));
            let closer: Vec<f64> =
                (1..SECOND_ROUND).map(|k| low + (high - low) * f64::from(k) / f64::from(SECOND_ROUND)).filter(|rho| *rho > x).collect();
            let again = power_series(&self.expr, self.order + 1, &closer)?;
            let other = again.get(index).map_or(f64::INFINITY, |group| self.remainder(group, &closer, x, weight).0);
            remainder += best.min(other);
        }
        if !remainder.is_finite() || !total.is_finite() {
            return Err(SeriesFailure::NoBound { symbol, at: x });
        }
        let estimate = Estimate::from_bounded(Bounded { error: (total.error + remainder) * (1.0 + MARGIN), ..total }, 0).by(SERIES);
        Ok(Reading { estimate, method: "series" })
    }

    /// The number of terms whose power is at most the order.
    fn kept(&self, group: &Series) -> usize {
        let room = self.order as f64 - group.shift;
        if room < 0.0 { 0 } else { (room.floor() as usize + 1).min(group.coefficients.len()) }
    }

    fn partial(&self, group: &Series, x: f64, weight: Weight) -> Result<Bounded, SeriesFailure> {
        let mut terms = Vec::new();
        for (n, coefficient) in group.coefficients.iter().enumerate().take(self.kept(group)) {
            let power = group.shift + n as f64;
            let vanishes = coefficient.value == 0.0 && coefficient.error == 0.0;
            // Subtract the constant f(0).
            if vanishes || power == 0.0 {
                continue;
            }
            if power < 0.0 {
                return Err(SeriesError::Undecided.into());
            }
            let scale = match weight {
                Weight::Pressure(_) => Bounded::exact(1.0),
                _ => Bounded::exact(x).powf(Bounded::exact(power)),
            };
            let (nu, next) = (Bounded::exact(power), Bounded::exact(power + 1.0));
            let kappa = with_ulps(kappa(power), 1.1);
            let factor = match weight {
                Weight::Height => Bounded::exact(1.0),
                Weight::Equivalent => kappa,
                Weight::Force => kappa * nu / next * Bounded::exact(x),
                Weight::Integral => kappa / next * Bounded::exact(x),
                Weight::Pressure(r) => kappa * nu * with_ulps(forms::pressure_power(power - 1.0, r, x), 7.0),
            };
            terms.push(*coefficient * factor * scale);
        }
        Ok(Bounded::sum(terms))
    }

    /// A bound of the remainder, and the index of the radius that gives it.
    fn remainder(&self, group: &Series, radii: &[f64], x: f64, weight: Weight) -> (f64, usize) {
        let kept = self.kept(group);
        let mut best = (f64::INFINITY, 0);
        for (index, (rest, rho)) in group.rest.iter().zip(radii).enumerate() {
            if !rest.is_finite() {
                continue;
            }
            // Σ_{n ≥ kept} |A_n| ρ^n: the total minus the known terms.
            let mut known = 0.0;
            for (n, c) in group.coefficients.iter().enumerate().take(kept).skip(1) {
                known += (c.value.abs() - c.error).max(0.0) * rho.powi(i32::try_from(n).unwrap_or(i32::MAX));
            }
            let head = if kept == 0 { group.coefficients.first().map_or(0.0, |c| c.value.abs() + c.error) } else { 0.0 };
            let tail = head + (rest - known * (1.0 - MARGIN)).max(0.0) + MARGIN * rest;
            let bound = tail * largest(kept, group.shift, x / rho, weight) * x.powf(group.shift) * scale(x, weight) * (1.0 + MARGIN);
            if bound < best.0 {
                best = (bound, index);
            }
        }
        best
    }
}

/// The largest of W(n + s) q^n over n ≥ first, where W bounds the factor of A_n x^(n+s).
///
/// κ_ν ≤ √(π(ν+1)/2), and S_{ν−1}(r, a) ≤ a^(ν−1) for ν ≥ 2; ln(W q^n) is concave, so the largest is the first or at its peak.
fn largest(first: usize, shift: f64, q: f64, weight: Weight) -> f64 {
    let at = |n: f64| {
        let nu = n + shift;
        let kappa = (std::f64::consts::FRAC_PI_2 * (nu + 1.0)).sqrt();
        let factor = match weight {
            Weight::Height => 1.0,
            Weight::Equivalent | Weight::Force => kappa,
            Weight::Integral => kappa / (nu + 1.0),
            // The pressure has no such bound below ν = 2.
            Weight::Pressure(_) if nu < 2.0 => f64::INFINITY,
            Weight::Pressure(_) => kappa * nu,
        };
        factor * q.powf(n)
    };
    let first = first as f64;
    // √ν q^ν and ν^(3/2) q^ν peak at 1/2 and 3/2 over ln(1/q).
    let peak = 1.5 / -q.ln();
    let (mut most, mut n) = (at(first), first);
    while n < peak + 1.0 && n < first + 1e6 {
        n += 1.0;
        most = most.max(at(n));
    }
    if n < peak { f64::INFINITY } else { most * (1.0 + MARGIN) }
}

/// The power of x in a weight, in addition to x^ν.
fn scale(x: f64, weight: Weight) -> f64 {
    match weight {
        Weight::Height | Weight::Equivalent => 1.0,
        Weight::Force | Weight::Integral => x,
        Weight::Pressure(_) => 1.0 / x,
    }
}

fn with_ulps(value: f64, ulps: f64) -> Bounded {
    Bounded { value, error: ulps * f64::EPSILON * value.abs() }
}
