//! Polynomials about another point.

use super::{expanded, is_sum};
use crate::expr::{Expr, Number, Symbol};
use std::collections::BTreeMap;

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
    let list = coefficients.iter().cloned().map(tidy).collect::<Option<Vec<_>>>()?;
    let shifted = match b {
        _ if b.is_zero() => list,
        _ if b.factors().iter().any(is_sum) => by_division(list, b, &tidy)?,
        _ => by_numbers(&list, b),
    };
    Some((0..).zip(shifted).filter(|(_, value)| !value.is_zero()).collect())
}

/// By synthetic division by v − b, once for each coefficient.
fn by_division(mut list: Vec<Expr>, b: &Expr, tidy: &impl Fn(Expr) -> Option<Expr>) -> Option<Vec<Expr>> {
    for k in 0..list.len() {
        let mut carried = Expr::zero();
        for own in list.iter_mut().skip(k).rev() {
            carried = tidy(&*own + tidy(b * carried)?)?;
            *own = carried.clone();
        }
    }
    Some(list)
}

/// p_k = Σ C(m, k) c_m b^(m−k). Terms c_m b^m that differ by a number alone, as in a polynomial that is homogeneous in v and b,
/// are added up as numbers.
fn by_numbers(list: &[Expr], b: &Expr) -> Vec<Expr> {
    let mut sums: BTreeMap<Expr, Vec<Number>> = BTreeMap::new();
    let mut choices: Vec<Number> = Vec::new();
    for (m, c) in (0..).zip(list) {
        // The next row of Pascal's triangle.
        let inner = choices.iter().zip(choices.iter().skip(1)).map(|(one, next)| one + next);
        choices = choices.first().cloned().into_iter().chain(inner).chain([Number::integer(1)]).collect();
        let scale = b.power(m);
        for term in c.terms().into_iter().filter(|own| !own.is_zero()) {
            let (number, rest) = (term * &scale).split_coefficient();
            let own = sums.entry(rest).or_insert_with(|| vec![Number::integer(0); list.len()]);
            for (sum, choice) in own.iter_mut().zip(&choices) {
                *sum = &*sum + &(&number * choice);
            }
        }
    }
    let coefficient = |k: usize| {
        let parts = sums.iter().filter_map(|(rest, own)| Some(Expr::number(own.get(k).filter(|n| !n.is_zero())?.clone()) * rest));
        Expr::sum(parts.map(|own| own * b.power(-(k as i64))))
    };
    (0..list.len()).map(coefficient).collect()
}
