//! Errors of the transform layer, between a profile and its results.

use crate::eval::EvalError;
use crate::expr::ExprError;
use crate::integrate::table_error::TableError;
use crate::num::{Exhausted, NumError};
use thiserror::Error;

/// Errors of the transform layer.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum TransformError {
    /// f has no finite limit at r = 0.
    #[error("the profile has no finite value at r = 0 ({detail}); expected a shape with finite height, such as C*r^n with n > 0")]
    SingularAtAxis {
        /// The behaviour found at the axis.
        detail: String,
    },
    /// The limit of f at r = 0 was not found.
    #[error("the limit of the profile at r = 0 is not known ({detail}); expected a form with a value there, such as C*r^n with n > 0")]
    UnknownAtAxis {
        /// The profile.
        detail: String,
    },
    /// The value of f jumps at a breakpoint.
    #[error("the profile jumps by {jump} at r = {at}; expected pieces that meet at their breakpoints")]
    Jump {
        /// The breakpoint.
        at: String,
        /// Value beyond minus value before.
        jump: String,
    },
    /// The profile is not real near the axis.
    #[error("the profile is not a real number near r = 0 ({detail}); check the signs under roots and logarithms")]
    NotReal {
        /// The expression that is not real.
        detail: String,
    },
    /// A constant in the profile has no finite real value.
    #[error("{constant} has no finite real value; expected other values of the parameters")]
    UndefinedConstant {
        /// The constant.
        constant: String,
    },
    /// f does not depend on r, and no depth was given.
    #[error("a flat profile without a rim does not define a contact; expected a depth of the punch")]
    Flat,
    /// The kinks of abs, min or max could not be located.
    #[error("the kinks of {function} cannot be located ({reason}); expected numbers for its parameters, or its pieces in piecewise(…)")]
    Kinks {
        /// The function whose kinks are wanted.
        function: &'static str,
        /// Why not.
        reason: String,
    },
    /// Too many pieces.
    #[error("the profile has more than {limit} pieces; expected fewer")]
    TooManyPieces {
        /// The largest number.
        limit: usize,
    },
    /// A point lies outside the profile's domain.
    #[error("{symbol} = {at:?} is not inside the domain of the profile{limit}")]
    OutOfDomain {
        /// Name of the coordinate.
        symbol: &'static str,
        /// The value.
        at: f64,
        /// The known limit, as text that follows the sentence.
        limit: String,
    },
    /// A value whose magnitude is beyond the largest number.
    #[error("the value at {symbol} = {at:?} is too large for a 64-bit float; expected a smaller {symbol} or other units")]
    Overflow {
        /// Name of the coordinate.
        symbol: &'static str,
        /// The coordinate.
        at: f64,
        /// The sign of the value.
        is_negative: bool,
    },
    /// A value below the smallest normal number, too small to compute a further quantity from it.
    #[error("{quantity} at {symbol} = {at:?} is too small for a 64-bit float; expected a larger {symbol}, or other units")]
    Underflow {
        /// The quantity that is too small.
        quantity: &'static str,
        /// Name of the coordinate.
        symbol: &'static str,
        /// The coordinate.
        at: f64,
    },
    /// f′ or f″ has no value in double precision somewhere below the point.
    #[error(
        "the profile's slope up to {at:?} cannot be computed in double precision (0/0, an overflow or a pole); expected a form without cancellation or a smaller range"
    )]
    NotComputable {
        /// The end of the range.
        at: f64,
    },
    /// A quadrature without a reliable digit.
    #[error(
        "no digit of the integral up to {at:?} is reliable ({value:?} with an error of up to {error:?}): the range contains a pole or a feature too narrow to be resolved; expected a smaller range"
    )]
    NoDigits {
        /// The end of the range.
        at: f64,
        /// The best value.
        value: f64,
        /// Its error bound.
        error: f64,
    },
    /// A whole curve that misses its tolerance.
    #[error(
        "the curve of {quantity} reaches a relative error of only {achieved:e}, but {requested:e} was requested; use a looser tolerance, a smaller range, or quadrature at every point"
    )]
    CurveTooRough {
        /// The quantity.
        quantity: &'static str,
        /// Its error relative to its largest value.
        achieved: f64,
        /// The tolerance.
        requested: f64,
    },
    /// The requested way has no answer.
    #[error("method {way} cannot compute this number: {reason}")]
    NotThisWay {
        /// The key of the way.
        way: &'static str,
        /// Why not.
        reason: &'static str,
    },
    /// A way that does not compute the quantity.
    #[error("method {way} does not compute {quantity}")]
    NoSuchWay {
        /// The key of the way.
        way: &'static str,
        /// The key of the quantity.
        quantity: &'static str,
    },
    /// No closed form where one was demanded.
    #[error("no closed form is known for {quantity} of this profile")]
    NoClosedForm {
        /// The quantity.
        quantity: &'static str,
    },
    /// A prescribed pressure whose profile has no known closed form.
    #[error("no profile is known for the part {term} of the pressure; expected a sum of c*r^(2*j)*(a^2-r^2)^s with s > -1")]
    NoProfileForPressure {
        /// The part of the pressure.
        term: String,
    },
    /// A required condition is false.
    #[error("the condition {condition} does not hold for these values; set parameters that satisfy it")]
    ConditionFails {
        /// The condition.
        condition: String,
    },
    /// An output buffer whose length differs from the number of points.
    #[error("the output buffer has length {buffer} for {points} points; expected equal lengths")]
    Buffer {
        /// The number of points.
        points: usize,
        /// The length of the buffer.
        buffer: usize,
    },
    /// A closure without a finite value.
    #[error("the function of the profile has no finite value at r = {radius:?}; set a limit or breakpoints that exclude this radius")]
    Undefined {
        /// The radius.
        radius: f64,
    },
    /// A closure that is not smooth at a radius without a breakpoint.
    #[error(
        "the profile function is not smooth near r = {radius:?}, or oscillates too rapidly there for numerical differentiation; specify a breakpoint or a limit at this radius, or provide the derivatives"
    )]
    Seam {
        /// The radius.
        radius: f64,
    },
    /// A closure whose complex-step derivative differs from its slope.
    #[error(
        "at r = {radius:?} the function of a complex radius has the slope {step:?} by a complex step, but {difference:?} by a difference: it is not analytic there, or discards small imaginary parts, as asin, acos, atan and abs do; expected f together with f′"
    )]
    NotAnalytic {
        /// The radius.
        radius: f64,
        /// Im f(r + ih)/h.
        step: f64,
        /// The difference quotient along the real axis.
        difference: f64,
    },
    /// An impossible property of a closure.
    #[error("{what} is {got:?}; expected {accepted}")]
    Statement {
        /// The property.
        what: &'static str,
        /// Its value.
        got: f64,
        /// The expected value.
        accepted: &'static str,
    },
    /// The budget of work is used up.
    #[error(transparent)]
    Exhausted(#[from] Exhausted),
    /// A table of points that does not define a profile.
    #[error(transparent)]
    Table(#[from] TableError),
    /// An expression could not be rewritten.
    #[error(transparent)]
    Expression(#[from] ExprError),
    /// An expression could not be evaluated.
    #[error(transparent)]
    Evaluation(#[from] EvalError),
    /// A number could not be computed.
    #[error(transparent)]
    Number(#[from] NumError),
}

impl TransformError {
    /// Returns the same error with the coordinate x renamed to the contact radius a.
    #[must_use]
    pub fn of_radius(self) -> Self {
        match self {
            Self::OutOfDomain { symbol: "x", at, limit } => Self::OutOfDomain { symbol: "a", at, limit },
            Self::Overflow { symbol: "x", at, is_negative } => Self::Overflow { symbol: "a", at, is_negative },
            other => other,
        }
    }

    /// Returns true if the value is unavailable at this radius only, so that other radii may have one.
    pub fn is_local(&self) -> bool {
        matches!(
            self,
            Self::NoDigits { .. } | Self::NotComputable { .. } | Self::Underflow { .. } | Self::Undefined { .. } | Self::Seam { .. }
        )
    }
}
