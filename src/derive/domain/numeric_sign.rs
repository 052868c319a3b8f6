//! The sign of an expression without symbols.

use crate::eval::constant_value;
use crate::expr::{Bindings, Condition, Expr, Relation, Sign, sign};

/// The sign of an expression without symbols, if its error bound determines it.
pub(crate) fn numeric_sign(expr: &Expr) -> Option<f64> {
    if !expr.symbols().is_empty() {
        return None;
    }
    let value = constant_value(expr, &Bindings::default()).ok()?;
    (value.value.abs() > value.error).then(|| value.value.signum())
}

/// True if both are numbers and the first is not certainly below the second.
pub(crate) fn is_proven_not_below(one: &Expr, other: &Expr) -> bool {
    let difference = constant_value(&(one - other), &Bindings::default());
    one == other || difference.is_ok_and(|difference| difference.value + difference.error >= 0.0)
}

/// True or false where a condition holds, or fails, for all positive parameters.
pub(crate) fn decided(condition: &Condition) -> Option<bool> {
    let room = &condition.right - &condition.left;
    condition.decided().or_else(|| match (condition.relation, sign(&room)) {
        (Relation::Equal, Sign::Positive | Sign::Negative) => Some(false),
        // That a slope angle is positive is stated with its upper limit.
        (Relation::Less, Sign::Positive) if condition.left.is_zero() => None,
        (Relation::Less | Relation::LessOrEqual, Sign::Positive) => Some(true),
        (Relation::Less | Relation::LessOrEqual, Sign::Negative) => Some(false),
        (relation, Sign::Zero) => Some(relation != Relation::Less),
        (relation, Sign::Unknown) => numeric_sign(&room).map(|own| relation != Relation::Equal && own > 0.0),
    })
}
