//! What can go wrong while an expression becomes a number.

use crate::num::Exhausted;
use thiserror::Error;

/// Errors of evaluation.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum EvalError {
    /// A symbol has no value.
    #[error("the parameter {name} has no value")]
    Unbound {
        /// The symbol.
        name: String,
    },
    /// The work limit ended the construction of the expression.
    #[error("the expression is incomplete, because the work limit was reached while it was built")]
    Cut,
    /// The budget of work is used up.
    #[error(transparent)]
    Exhausted(#[from] Exhausted),
}
