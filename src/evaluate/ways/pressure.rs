//! The pressure, and its infinities: under a tip with nonzero slope at the axis, and where f′ jumps.
//!
//! p(0) is an integral of f′/r, and p(b) contains a logarithm times the jump of f′ at b; whether these are infinite is decided
//! from the expressions, never from the error of a computed value.

use crate::derive::chain::Chain;
use crate::derive::domain;
use crate::derive::superposed::Superposed;
use crate::eval::constant_value;
use crate::evaluate::evaluator::{Evaluator, Method, Reading};
use crate::evaluate::ways::best::{Answer, Best, by_quadrature};
use crate::expr::{Bindings, Expr, Symbol, normal};
use crate::integrate::admit::finite_and_not_negative;
use crate::integrate::ask::{Ask, PIECES};
use crate::integrate::error::TransformError;
use crate::integrate::integral::NumericProfile;
use crate::num::{Bound, Estimate, work};

/// Steps of work for a few more digits of a pressure, about twenty milliseconds.
pub(crate) const MORE_DIGITS: u64 = 2_000_000;
/// Steps of work for the first digits of a pressure.
pub(crate) const FIRST_DIGITS: u64 = 50_000_000;
/// Relative error above which a pressure counts as rough.
const ROUGH: f64 = 1e-7;

/// The work to spend on a better value than the given one.
fn worth(found: Option<&Reading>) -> u64 {
    if found.is_some_and(|own| own.estimate.relative_error() <= ROUGH) { MORE_DIGITS } else { FIRST_DIGITS }
}

impl Evaluator<'_> {
    /// p(r)·π/E* under a smooth edge of radius a; `None` if it is theoretically infinite.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    pub fn pressure(&self, r: f64, a: f64) -> Result<Option<Reading>, TransformError> {
        self.check_domain("a", a)?;
        finite_and_not_negative("r", r)?;
        if r >= a {
            let zero = Estimate::exact(0.0);
            return Ok(Some(Reading { estimate: zero, method: "exact" }));
        }
        if let Method::Only(way) = self.method {
            // Also where theory makes the pressure infinite.
            way.check(Ask::Pressure { r, a })?;
        }
        let special = self.may_be_infinite(r);
        if special && self.is_infinite_at(r)? {
            return Ok(None);
        }
        if let Method::Only(way) = self.method {
            return way.answer(self, Ask::Pressure { r, a });
        }
        let found = self.combine(Superposed::Pressure, Ask::Pressure { r, a });
        let most = worth(found.as_ref().ok().and_then(Option::as_ref));
        // No search for a better value is needed after a closed form or a proven number.
        let enough = |own: &Reading| own.method == "exact" || is_trusted(own.estimate);
        let may_rise = self.method == Method::Auto && matches!(&found, Ok(Some(own)) if !enough(own));
        let by_closed_slope = || {
            let found = work::share(most, || self.pressure_by_closed_slope(r, a, most)).flatten();
            by_quadrature(found.map(Some).ok_or(TransformError::NotComputable { at: a }))
        };
        // Infinite parts may combine to a value without a reliable digit, or to NaN.
        let found =
            if special && self.method != Method::Exact && found == Ok(None) { Err(TransformError::NotComputable { at: a }) } else { found };
        let best = Best::of(self.tolerance, found);
        let best = if may_rise { best.or(by_closed_slope) } else { best };
        let best = if special && self.method != Method::Exact { best.or(|| self.finite_pressure(r, a)) } else { best };
        match best.answer()? {
            Some(own) if own.estimate.value.is_nan() => Err(TransformError::NotComputable { at: a }),
            Some(own) if own.estimate.value.is_finite() && !own.estimate.error.is_finite() => Err(TransformError::NotComputable { at: a }),
            Some(own) if own.estimate.value.is_infinite() => {
                Err(TransformError::Overflow { symbol: "a", at: a, is_negative: own.estimate.value < 0.0 })
            }
            Some(own) => Ok(Some(own)),
            None if self.method == Method::Exact => Err(TransformError::NoClosedForm { quantity: "p" }),
            None => Err(TransformError::NotComputable { at: a }),
        }
    }

    /// True if r is the axis or a breakpoint, the only radii at which the pressure below a smooth edge may be infinite.
    pub(crate) fn may_be_infinite(&self, r: f64) -> bool {
        r == 0.0 || self.chains.iter().any(|chain| chain.breakpoints.iter().any(|b| b.value == r))
    }

    /// True if the pressure is theoretically infinite.
    ///
    /// # Errors
    /// [`TransformError`] if f′ cannot be formed.
    pub(crate) fn is_infinite_at(&self, r: f64) -> Result<bool, TransformError> {
        if r == 0.0 {
            if let Some(ready) = self.steep.get() {
                return Ok(*ready);
            }
            let mut first = Vec::new();
            for chain in &self.solution.profile.chains {
                first.extend(chain.f_primes()?.into_iter().next());
            }
            let f_prime = self.bindings.apply(&Expr::sum(first));
            // The limit does not exist at a pole or a logarithm.
            let steep = limit(&f_prime).is_none_or(|own| !is_zero(&own));
            work::check()?;
            return Ok(*self.steep.get_or_init(|| steep));
        }
        let mut jump = Vec::new();
        for (numeric, chain) in self.chains.iter().zip(&self.solution.profile.chains) {
            let places = numeric.breakpoints.iter().enumerate().filter(|(_, b)| b.value == r);
            for (index, _) in places {
                match self.jump(chain, index)? {
                    Some(own) => jump.push(own),
                    None => return Ok(true),
                }
            }
        }
        Ok(!is_zero(&Expr::sum(jump)))
    }

    /// p·π/E* by quadrature at a radius where it is theoretically finite, although some of its parts may not be.
    ///
    /// # Errors
    /// [`TransformError`] if the quadrature has no reliable digit.
    pub(crate) fn finite_pressure(&self, r: f64, a: f64) -> Answer {
        let lost = TransformError::NotComputable { at: a };
        if r > 0.0 {
            return by_quadrature(self.typed()?.pressure_by_elliptic_kernel(r, a, self.tolerance)?.map(Some).ok_or(lost));
        }
        let level = self.typed_without_slopes_at_axis()?;
        let typed = level.as_ref().map_or_else(|| self.typed(), Ok)?;
        Best::of(
            self.tolerance,
            by_quadrature(typed.pressure_on_axis(a, self.tolerance).map(|own| Some(own.by(PIECES))).ok_or(lost.clone())),
        )
        .or(|| by_quadrature(typed.axial(0.0, a, self.tolerance).map(Some)))
        .or(|| self.by_recognition(Ask::Axial { z: 0.0, a }))
        // Where a root of r is in f′ the nodes come so close to the axis that its weight overflows; (r f′)′ has another one.
        .or(|| by_quadrature(typed.pressure(0.0, a, self.tolerance)?.map(Some).ok_or(lost)))
        .answer()
    }

    /// The profile as typed, minus the slopes of its chains at the axis times r, if these slopes add up to 0 but are not all 0;
    /// `None` for every other profile.
    fn typed_without_slopes_at_axis(&self) -> Result<Option<NumericProfile>, TransformError> {
        let mut slopes = Vec::new();
        for chain in &self.solution.profile.chains {
            let first = chain.f_primes()?.into_iter().next().unwrap_or(Expr::zero());
            let Some(slope) = limit(&self.bindings.apply(&first)) else { return Ok(None) };
            slopes.push(slope);
        }
        if slopes.iter().all(Expr::is_zero) || !normal::is_proven_zero(&Expr::sum(slopes.clone()), &Symbol::new("r")) {
            return Ok(None);
        }
        self.typed_less(&slopes).map(Some)
    }

    /// f′ beyond a breakpoint minus f′ before it; `None` if one of them is infinite.
    fn jump(&self, chain: &Chain, index: usize) -> Result<Option<Expr>, TransformError> {
        let (Some(place), slopes) = (chain.breakpoints.get(index), chain.f_primes()?) else { return Ok(None) };
        let (Some(below), Some(beyond)) = (slopes.get(index), slopes.get(index + 1)) else { return Ok(None) };
        let place = self.bindings.apply(place);
        let distance = Expr::symbol("r");
        let at = |f_prime: &Expr, distance: Expr| limit(&Bindings::one("r", &place + distance).apply(&self.bindings.apply(f_prime)));
        Ok(at(beyond, distance.clone()).and_then(|beyond| Some(beyond - at(below, -distance)?)))
    }
}

/// True for a proven error that is at least as small as the best estimates.
fn is_trusted(own: Estimate) -> bool {
    own.bound == Bound::Proven && own.relative_error() <= Estimate::TRUSTED
}

fn limit(f_prime: &Expr) -> Option<Expr> {
    domain::value_at_axis(f_prime, &mut Vec::new()).ok()
}

/// True for a number that is exactly zero, and for other constants that are zero within their error.
fn is_zero(value: &Expr) -> bool {
    if value.as_number().is_some() {
        return value.is_zero();
    }
    normal::is_proven_zero(value, &Symbol::new("r"))
        || constant_value(value, &Bindings::default()).is_ok_and(|own| own.value.abs() <= own.error)
}
