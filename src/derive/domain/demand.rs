//! What an expression in a profile must be, for the profile to have a value.

use crate::derive::domain::first_zero::Zero;
use crate::expr::Expr;

/// An expression that must keep its sign between the ends of a piece, of which this is not proven for all parameters.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Demand {
    /// Positive where the profile has a value.
    pub(crate) expr: Expr,
    pub(crate) zero: Zero,
    /// True for a divisor, which may have either sign.
    pub(crate) either_sign: bool,
    /// The ends of the piece.
    pub(crate) lower: Expr,
    pub(crate) upper: Option<Expr>,
    /// True if f has no finite limit at the upper end.
    pub(crate) is_unbounded: bool,
}
