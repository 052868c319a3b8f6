//! The error type of the numeric layer.

use super::work::Exhausted;
use thiserror::Error;

/// Why a numeric routine has no result, or only a less accurate one than requested.
///
/// Every message names the place, the reason and what was expected.
/// Variants that end an iteration early carry the best value and a bound on its error,
/// so that a caller can decide whether it is good enough.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum NumError {
    /// Rounding errors in the integrand or in the sums prevent the requested accuracy.
    #[error(
        "tolerance {requested:e} not reached: rounding leaves {value:e} with an error of up to {error:e} after {evaluations} evaluations; accept that error, or evaluate the integrand more accurately"
    )]
    ToleranceNotReached {
        /// The best value found.
        value: f64,
        /// Absolute bound on its error; infinite if there is none.
        error: f64,
        /// The requested absolute error.
        requested: f64,
        /// Calls of the integrand so far.
        evaluations: u64,
    },
    /// The allowed number of function calls is used up.
    #[error(
        "evaluation limit reached after {evaluations} calls: best value {value:e} with an error of up to {error:e}; split at kinks, declare singular ends, or raise the limit"
    )]
    EvaluationLimit {
        /// The best value found.
        value: f64,
        /// Absolute bound on its error.
        error: f64,
        /// Calls of the function so far.
        evaluations: u64,
    },
    /// The function returned an infinity or NaN where a number is needed.
    #[error("the function is not finite at {at:e}; a finite value is needed there")]
    NotFinite {
        /// The argument at which it happened.
        at: f64,
    },
    /// The function has the same sign at both ends, so no root is enclosed.
    #[error("no sign change between {lower:e} (value {at_lower:e}) and {upper:e} (value {at_upper:e}); the ends must enclose a root")]
    NoBracket {
        /// Lower end of the interval.
        lower: f64,
        /// Upper end of the interval.
        upper: f64,
        /// Function value at the lower end.
        at_lower: f64,
        /// Function value at the upper end.
        at_upper: f64,
    },
    /// An argument lies outside of the domain.
    #[error("{what} = {got:e} is outside of the domain; accepted: {accepted}")]
    OutOfDomain {
        /// Name of the argument, with the function where that helps.
        what: &'static str,
        /// Its value.
        got: f64,
        /// The expected value, in words or as an inequality.
        accepted: &'static str,
    },
    /// The budget of work is used up.
    #[error(transparent)]
    Exhausted(#[from] Exhausted),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_say_place_reason_and_remedy() {
        let message = NumError::OutOfDomain { what: "n", got: -1.0, accepted: "n > 0" }.to_string();
        assert_eq!(message, "n = -1e0 is outside of the domain; accepted: n > 0");
        let message = NumError::NotFinite { at: 0.5 }.to_string();
        assert!(message.contains("5e-1") && message.contains("finite"));
    }
}
