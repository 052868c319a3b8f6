//! Conditions that hold whatever the parameters are, or because others hold.

use crate::derive::angles::Positive;
use crate::derive::domain::located::is_approximate;
use crate::derive::domain::numeric_sign::numeric_sign;
use crate::eval::constant_value;
use crate::expr::{Bindings, Condition, Expr, Relation, Sign, normal, over_one_denominator, sign};

/// True if both are numbers and the first is not certainly below the second.
pub(crate) fn is_proven_not_below(one: &Expr, other: &Expr) -> bool {
    let difference = constant_value(&(one - other), &Bindings::default());
    one == other || difference.is_ok_and(|difference| difference.value + difference.error >= 0.0)
}

/// True or false where a condition holds, or fails, for all positive parameters.
pub(crate) fn decided_for_all(condition: &Condition) -> Option<bool> {
    let room = &condition.right - &condition.left;
    condition.decided().or_else(|| match (condition.relation, sign(&room)) {
        (Relation::Equal, Sign::Positive | Sign::Negative) => Some(false),
        // That a slope angle is positive is stated with its upper limit.
        (Relation::Less, Sign::Positive) if condition.left.is_zero() => None,
        (Relation::Less | Relation::LessOrEqual, Sign::Positive) => Some(true),
        (Relation::Less | Relation::LessOrEqual, Sign::Negative) => Some(false),
        (relation, Sign::Zero) => Some(relation != Relation::Less),
        (Relation::LessOrEqual, Sign::Unknown) if is_square(&room) => Some(true),
        (relation, Sign::Unknown) => numeric_sign(&room).map(|own| relation != Relation::Equal && own > 0.0),
    })
}

/// True for a square over what is positive, as R − 2bhR/(b² + h²) is; false proves nothing.
fn is_square(room: &Expr) -> bool {
    let is_one = |own: &Expr| {
        let (base, exponent) = own.split_power();
        sign(own) == Sign::Positive || (exponent.is_one() && normal::square_root(&base).is_some())
    };
    let room = Positive::of(room).replaced(room);
    over_one_denominator(&room).is_some_and(|own| own.factors().iter().all(is_one))
}

/// Drops u <= v beside u < v, and numbers as limits of r beside smaller ones.
pub(crate) fn drop_implied(conditions: &mut Vec<Condition>) {
    let radius = Expr::symbol("r");
    let all = conditions.clone();
    let is_limit = |own: &Condition| own.left == radius && own.relation != Relation::Equal;
    // Of two that may be equal, the one that was not located numerically is kept.
    let is_smaller = |own: &Expr, other: &Expr| {
        numeric_sign(&(other - own)) == Some(1.0) || (is_approximate(other) && !is_approximate(own) && is_proven_not_below(other, own))
    };
    conditions.retain(|own| match own.relation {
        Relation::LessOrEqual if all.contains(&Condition::less(own.left.clone(), own.right.clone())) => false,
        _ => !(is_limit(own) && all.iter().any(|other| is_limit(other) && is_smaller(&other.right, &own.right))),
    });
}
