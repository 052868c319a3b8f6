//! Polynomials about another point.

use super::{expanded, is_sum};
use crate::expr::{Expr, Symbol};

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
    let tidy = |own: Expr| if own.factors().iter().any(is_sum) { expanded(&own, variable).ok() } else { Some(own) };
    let mut list = coefficients.iter().cloned().map(tidy).collect::<Option<Vec<_>>>()?;
    // Synthetic division by v − b, once for each coefficient.
    for k in 0..list.len() {
        let mut carried = Expr::zero();
        for own in list.iter_mut().skip(k).rev() {
            carried = tidy(&*own + tidy(b * carried)?)?;
            *own = carried.clone();
        }
    }
    Some((0..).zip(list).filter(|(_, value)| !value.is_zero()).collect())
}
