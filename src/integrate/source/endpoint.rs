//! A place on the axis with more digits than a double has, so that the distance of a radius to a kink does not cancel.

use crate::eval::precise_value;
use crate::expr::{Bindings, Expr};
use crate::integrate::error::TransformError;
use crate::num::Bounded;

/// The place `at + rest`, up to `doubt`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Endpoint {
    /// The nearest double.
    pub(crate) at: f64,
    rest: f64,
    /// The error of the place; 0 if 30 digits are known.
    pub(crate) doubt: f64,
}

/// The relative error up to which a place counts as known.
const KNOWN: f64 = 1e-28;

impl Endpoint {
    pub(crate) fn exact(at: f64) -> Self {
        Self { at, rest: 0.0, doubt: 0.0 }
    }

    /// The value of a constant expression, of which `rounded` is the double.
    ///
    /// # Errors
    /// [`TransformError::Evaluation`] if a parameter has no value.
    pub(crate) fn of(expr: &Expr, rounded: Bounded) -> Result<Self, TransformError> {
        let plain = Self { at: rounded.value, rest: 0.0, doubt: rounded.error };
        if rounded.error == 0.0 {
            return Ok(plain);
        }
        let known = precise_value(expr, &Bindings::default())?;
        if known.error <= KNOWN * rounded.value.abs() {
            return Ok(Self { rest: (known.value.hi - rounded.value) + known.value.lo, doubt: 0.0, ..plain });
        }
        Ok(plain)
    }

    /// The distance to a place further out: correct to a few roundings, also next to this one.
    pub(crate) fn to(self, other: Self) -> f64 {
        (other.at - self.at) + (other.rest - self.rest)
    }

    /// Whether a place was rounded: its distances have one more rounding.
    pub(crate) fn is_split(self) -> bool {
        self.rest != 0.0
    }
}
