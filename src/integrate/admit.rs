//! Checks of coordinates and tolerances passed to the library.

use crate::integrate::error::TransformError;

/// Refuses a coordinate that is negative, infinite or NaN.
#[inline]
pub(crate) fn finite_and_not_negative(what: &'static str, got: f64) -> Result<(), TransformError> {
    if got >= 0.0 && got.is_finite() { Ok(()) } else { refused(what, got, "a finite number from 0 on") }
}

/// Refuses a place that does not lie outside a contact of radius a.
#[inline]
pub(crate) fn beyond_the_edge(what: &'static str, got: f64, a: f64) -> Result<(), TransformError> {
    if got >= a && got.is_finite() { Ok(()) } else { refused(what, got, "a finite radius outside the contact") }
}

/// Refuses a relative tolerance that is not between 0 and 1.
#[inline]
pub(crate) fn tolerance_in_range(got: f64) -> Result<(), TransformError> {
    if got > 0.0 && got < 1.0 { Ok(()) } else { refused("the tolerance", got, "a number between 0 and 1") }
}

#[cold]
fn refused(what: &'static str, got: f64, accepted: &'static str) -> Result<(), TransformError> {
    Err(TransformError::Statement { what, got, accepted })
}
