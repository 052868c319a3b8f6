//! The bodies of a contact, each on its own: where one is too steep or ends, the sum of their shapes may not tell.

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
    /// Its shape is defined below this radius; infinite where there is no end.
    end: f64,
}

/// Towards the outside, a body without a stated end is looked at as far as this …
const FARTHEST: f64 = 1e12;
/// … and from this radius on, in steps of this factor.
const NEAREST: f64 = 1e-12;
const STEP: f64 = 1.2;

impl<'a> Body<'a> {
    /// A body whose shape is a formula with numbers for its parameters.
    ///
    /// # Errors
    /// [`TransformError`] where a piece has no derivative or a parameter is left.
    pub fn formula(name: &'static str, profile: &Profile) -> Result<Self, TransformError> {
        let curvature = Curvature::of(Vec::new()).with(profile)?;
        let limits = profile.limits().filter_map(|limit| constant_value(limit, &Bindings::default()).ok());
        let stated = limits.map(|limit| limit.value).fold(f64::INFINITY, f64::min);
        let end = if stated.is_finite() { stated } else { undefined_from(&curvature) };
        Ok(Self { name, curvature, end })
    }

    /// A body whose shape is no formula; it ends where the contact's own profile does.
    pub fn other(name: &'static str, shape: Arc<dyn Slopes + 'a>) -> Self {
        Self { name, curvature: Curvature::of(vec![shape]), end: f64::INFINITY }
    }

    /// Where the shape ends.
    pub(super) fn end(&self) -> f64 {
        self.end
    }

    /// Its name, and the first of these radii from which on it is too steep for a half-space.
    pub(super) fn steep(&self, places: &[f64]) -> Option<(&'static str, f64)> {
        Some((self.name, first_steep(&self.curvature, 0.0, places)?))
    }
}

/// The first radius at which f′ is not real, where that is in sight; infinite else.
fn undefined_from(curvature: &Curvature<'_>) -> f64 {
    let places: Vec<f64> = std::iter::successors(Some(NEAREST), |r| Some(r * STEP)).take_while(|r| *r < FARTHEST).collect();
    super::landscape::first(|r| curvature.slope(r).value.is_nan(), 0.0, &places).unwrap_or(f64::INFINITY)
}
