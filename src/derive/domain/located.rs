//! Places that are known as numbers only, marked as `approximate` so that no formula over them is called exact.

use crate::expr::{Expr, Node, Number};

/// The shortest decimal of a place that was found numerically, marked as approximate.
pub(crate) fn approximate(place: f64) -> Option<Expr> {
    let number = Number::parse_decimal(&format!("{place:?}"))?;
    Some(Expr::call("approximate", [Expr::number(number)]))
}

/// True if a place was located numerically, so that no formula over it is exact.
pub(crate) fn is_approximate(expr: &Expr) -> bool {
    expr.parts().any(|own| matches!(own.node(), Node::Function(function, _) if function.name() == "approximate"))
}
