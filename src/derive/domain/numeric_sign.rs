//! The sign of an expression without symbols, and of a number with an error bound.

use crate::eval::constant_value;
use crate::expr::{Bindings, Expr};
use crate::num::Bounded;

/// The sign of an expression without symbols, if its error bound determines it.
pub(crate) fn numeric_sign(expr: &Expr) -> Option<f64> {
    if !expr.symbols().is_empty() {
        return None;
    }
    certain_sign(constant_value(expr, &Bindings::default()).ok()?)
}

/// 1 or −1 if the bound determines the sign.
pub(crate) fn certain_sign(value: Bounded) -> Option<f64> {
    (value.value.abs() > value.error).then(|| value.value.signum())
}
