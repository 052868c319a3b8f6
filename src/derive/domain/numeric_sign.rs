//! The sign of an expression without symbols.

use crate::eval::constant_value;
use crate::expr::{Bindings, Expr};

/// The sign of an expression without symbols, if its error bound determines it.
pub(crate) fn numeric_sign(expr: &Expr) -> Option<f64> {
    if !expr.symbols().is_empty() {
        return None;
    }
    let value = constant_value(expr, &Bindings::default()).ok()?;
    (value.value.abs() > value.error).then(|| value.value.signum())
}
