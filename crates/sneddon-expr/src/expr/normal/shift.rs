//! Polynomials about another point.

use super::expanded;
use crate::expr::{Bindings, Expr, Symbol, derivative};

/// The coefficients of Σ c_m v^m in powers of v − b, without zeros: pairs of k and P^(k)(b)/k!; `None` if they cannot be
/// expanded.
///
/// ```
/// use sneddon_expr::expr::{Expr, Symbol, normal::shifted_coefficients};
/// let (b, v) = (Expr::symbol("b"), Symbol::new("r"));
/// // r² − b² = 2b (r − b) + (r − b)²
/// let list = shifted_coefficients(&[-b.power(2), Expr::zero(), Expr::one()], &b, &v).unwrap();
/// assert_eq!(list, [(1, Expr::integer(2) * b), (2, Expr::one())]);
/// ```
pub fn shifted_coefficients(coefficients: &[Expr], b: &Expr, variable: &Symbol) -> Option<Vec<(i64, Expr)>> {
    let v = Expr::from(variable.clone());
    let mut polynomial = Expr::sum(coefficients.iter().enumerate().map(|(m, c)| c * v.power(m as i64)));
    let place = Bindings::one(variable.name(), b.clone());
    let (mut result, mut factorial) = (Vec::new(), Expr::one());
    for k in 0..coefficients.len() as i64 {
        let value = expanded(&place.apply(&polynomial), variable).ok()?;
        if !value.is_zero() {
            result.push((k, value / &factorial));
        }
        polynomial = expanded(&derivative(&polynomial, variable).ok()?, variable).ok()?;
        factorial = factorial * Expr::integer(k + 1);
    }
    Some(result)
}
