//! The interface between a contact and its profile, which may be a formula, a closure or a table.

use crate::derive::profile::Profile;
use crate::evaluate::curve::PressureCurve;
use crate::evaluate::evaluator::{Evaluator, Method, Reading};
use crate::integrate::error::TransformError;
use crate::num::Bounded;

/// The quantities of a contact with a smooth edge as numbers with errors, in units in which E* = 1.
///
/// Implemented by [`Evaluator`] for formulas, and by closures and tables; a contact works with any implementation.
pub trait Quantities: Send + Sync {
    /// g(x) = x ∫₀^x f′/√(x²−r²) dr.
    ///
    /// # Errors
    /// [`TransformError`] outside the domain, or if no digit is reliable.
    fn equivalent(&self, x: f64) -> Result<Reading, TransformError>;

    /// F(a)/(2E*) = ∫₀^a r² f′/√(a²−r²) dr.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    fn force(&self, a: f64) -> Result<Reading, TransformError>;

    /// G(a) = ∫₀^a g dx.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    fn integral(&self, a: f64) -> Result<Reading, TransformError>;

    /// p(r)·π/E* = ∫_r^a g′(x)/√(x²−r²) dx; `None` if it is theoretically infinite.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    fn pressure(&self, r: f64, a: f64) -> Result<Option<Reading>, TransformError>;

    /// ∫₀^a g′(x) x(x²+3z²)/(x²+z²)² dx, which is −σ_zz·π/E* at the depth z > 0 on the axis.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    fn axial(&self, z: f64, a: f64) -> Result<Reading, TransformError> {
        let _ = (z, a);
        Err(TransformError::NoClosedForm { quantity: "the stress below the surface" })
    }

    /// u_z(r) outside a contact of radius a < r.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    fn displacement(&self, r: f64, a: f64) -> Result<Reading, TransformError>;

    /// f(r) − f(0).
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    fn height(&self, r: f64) -> Result<Reading, TransformError>;

    /// The upper limit of r; infinite if there is none.
    fn limit(&self) -> f64;

    /// The radii below `end` where g is not smooth, in increasing order.
    fn breakpoints_below(&self, end: f64) -> Vec<f64>;

    /// Refuses a coordinate outside the profile.
    ///
    /// # Errors
    /// [`TransformError::OutOfDomain`].
    fn check_domain(&self, symbol: &'static str, at: f64) -> Result<(), TransformError>;

    /// The radius of the flat part around the axis; 0 for a tip that is not flat.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    fn flat_radius(&self) -> Result<f64, TransformError> {
        let mut flat = 0.0;
        for b in self.breakpoints_below(f64::INFINITY) {
            if self.equivalent(b)?.estimate.value == 0.0 {
                flat = b;
            }
        }
        Ok(flat)
    }

    /// Bounds on f′ between two radii that have no breakpoint between them; `None` if unknown.
    fn f_prime_over(&self, _lower: f64, _upper: f64) -> Option<(f64, f64)> {
        None
    }

    /// The formulas, with numbers for all parameters, whose sum is f; `None` if a part of f is not a formula.
    fn formulas(&self) -> Option<Vec<Profile>> {
        None
    }

    /// Numbers s > −1 and M such that |f′| ≤ M r^s from the axis to a radius that no breakpoint precedes; `None` if unknown.
    fn power_at_axis(&self, radius: f64) -> Option<(f64, f64)> {
        self.f_prime_over(0.0, radius).map(|(low, high)| (0.0, low.abs().max(high.abs())))
    }

    /// True for profiles that may have one expansion for all pressures under a contact, and whose method leaves that choice.
    fn has_pressure_curve(&self) -> bool {
        false
    }

    /// The length of the shortest wave of f at a radius, where it is known; infinite otherwise.
    fn shortest_wave(&self, _r: f64) -> f64 {
        f64::INFINITY
    }

    /// The pressures under a contact of radius a as one expansion, for profiles that have one.
    fn pressure_curve(&self, _a: f64) -> Option<PressureCurve<'static>> {
        None
    }

    /// ∫₀^a (d − g)² dx, for profiles with a better method than quadrature between their breakpoints.
    fn squared_gap(&self, _a: f64, _depth: Bounded) -> Option<Result<Reading, TransformError>> {
        None
    }
}

impl Quantities for Evaluator<'_> {
    fn equivalent(&self, x: f64) -> Result<Reading, TransformError> {
        Self::equivalent(self, x)
    }

    fn force(&self, a: f64) -> Result<Reading, TransformError> {
        Self::force(self, a)
    }

    fn integral(&self, a: f64) -> Result<Reading, TransformError> {
        Self::integral(self, a)
    }

    fn pressure(&self, r: f64, a: f64) -> Result<Option<Reading>, TransformError> {
        Self::pressure(self, r, a)
    }

    fn axial(&self, z: f64, a: f64) -> Result<Reading, TransformError> {
        Self::axial(self, z, a)
    }

    fn displacement(&self, r: f64, a: f64) -> Result<Reading, TransformError> {
        Self::displacement(self, r, a)
    }

    fn height(&self, r: f64) -> Result<Reading, TransformError> {
        Self::height(self, r)
    }

    fn f_prime_over(&self, lower: f64, upper: f64) -> Option<(f64, f64)> {
        // One form may have collected terms that cancel in the other.
        let found = self.typed().ok()?.f_prime_over(lower, upper);
        let Ok(recognised) = self.recognised() else { return found };
        match (found, recognised.f_prime_over(lower, upper)) {
            (Some(one), Some(other)) => Some((one.0.max(other.0), one.1.min(other.1))),
            (one, other) => one.or(other),
        }
    }

    fn formulas(&self) -> Option<Vec<Profile>> {
        Some(vec![self.solution.profile.substitute(&self.bindings).ok()?])
    }

    fn power_at_axis(&self, radius: f64) -> Option<(f64, f64)> {
        self.typed().ok()?.power_at_axis(radius)
    }

    fn has_pressure_curve(&self) -> bool {
        self.method == Method::Auto
    }

    fn shortest_wave(&self, r: f64) -> f64 {
        Self::shortest_wave(self, r)
    }

    fn pressure_curve(&self, a: f64) -> Option<PressureCurve<'static>> {
        Self::pressure_curve(self, a).ok()
    }

    fn squared_gap(&self, a: f64, depth: Bounded) -> Option<Result<Reading, TransformError>> {
        self.proven_squared_gap(a, depth)
    }

    fn limit(&self) -> f64 {
        Self::limit(self)
    }

    fn breakpoints_below(&self, end: f64) -> Vec<f64> {
        Self::breakpoints_below(self, end)
    }

    fn check_domain(&self, symbol: &'static str, at: f64) -> Result<(), TransformError> {
        Self::check_domain(self, symbol, at)
    }
}
