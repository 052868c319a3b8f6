//! Errors that occur while an expression is rewritten.

use crate::num::Exhausted;
use thiserror::Error;

/// Errors of the expression layer.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ExprError {
    /// Expanding would produce more terms than the limit.
    #[error("expanding this expression needs more than {limit} terms; expected a lower power or fewer terms")]
    TooLarge {
        /// The largest number of terms.
        limit: usize,
    },
    /// A function has no derivative with respect to the given argument.
    #[error("{function} has no derivative with respect to its argument {argument} here")]
    NoDerivative {
        /// Name of the function.
        function: &'static str,
        /// Position of the argument, counted from 1.
        argument: usize,
    },
    /// The order of two breakpoints is not known.
    #[error("the order of the breakpoints {left} and {right} is not known; expected numbers for their parameters")]
    UnknownOrder {
        /// One breakpoint.
        left: String,
        /// The other one.
        right: String,
    },
    /// The budget of work is used up.
    #[error(transparent)]
    Exhausted(#[from] Exhausted),
}
