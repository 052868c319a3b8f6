//! The separate bodies of a contact: the sum of their shapes may not show where one of them is too steep or ends.

use super::curvature::Curvature;
use super::landscape::first_steep;
use crate::eval::constant_value;
use crate::expr::Bindings;
use crate::transform::{Profile, Slopes, TransformError};
use std::sync::Arc;

/// The shape of one of the bodies in contact.
pub struct Body<'a> {
    name: &'static str,
    curvature: Curvature<'a>,
    /// The shape is defined below this radius; infinite if unbounded.
    end: f64,
}

/// Largest radius at which a body without a declared end is examined.
const FARTHEST: f64 = 1e12;
/// Smallest radius at which a body is examined, and the ratio of consecutive radii.
const NEAREST: f64 = 1e-12;
const STEP: f64 = 1.2;

impl<'a> Body<'a> {
    /// A body whose shape is a formula with numbers for its parameters.
    ///
    /// # Errors
    /// [`TransformError`] if a piece has no derivative or a parameter has no value.
    pub fn formula(name: &'static str, profile: &Profile) -> Result<Self, TransformError> {
        let curvature = Curvature::of(Vec::new()).with(profile)?;
        let limits = profile.limits().filter_map(|limit| constant_value(limit, &Bindings::default()).ok());
        let stated = limits.map(|limit| limit.value).fold(f64::INFINITY, f64::min);
        let end = if stated.is_finite() { stated } else { undefined_from(&curvature) };
        Ok(Self { name, curvature, end })
    }

    /// A body whose shape is not a formula; it ends where the profile of the contact ends.
    pub fn other(name: &'static str, shape: Arc<dyn Slopes + 'a>) -> Self {
        Self { name, curvature: Curvature::of(vec![shape]), end: f64::INFINITY }
    }

    /// The radius at which the shape ends.
    pub(super) fn end(&self) -> f64 {
        self.end
    }

    /// The name of the body, and the first of these radii at which it is too steep for a half-space.
    pub(super) fn steep(&self, places: &[f64]) -> Option<(&'static str, f64)> {
        Some((self.name, first_steep(&self.curvature, 0.0, places)?))
    }
}

/// The first examined radius at which f′ is not real; infinite if there is none.
fn undefined_from(curvature: &Curvature<'_>) -> f64 {
    let places: Vec<f64> = std::iter::successors(Some(NEAREST), |r| Some(r * STEP)).take_while(|r| *r < FARTHEST).collect();
    super::landscape::first(|r| curvature.f_prime(r).value.is_nan(), 0.0, &places).unwrap_or(f64::INFINITY)
}
