//! Factors under one root of symbolic order: (d/(Cκ))^(1/n) for a product of n-th roots.

use super::layout::Factor;
use crate::expr::{Expr, Number, Sign, sign};

/// Joins positive factors with the exponent 1/n, and those with 1/(2n) as roots, across the line.
///
/// Parsing a joined root restores the product, because positive factors are moved out of roots.
pub(super) fn gather(upper: &mut Vec<Factor>, lower: &mut Vec<Factor>) {
    let symbolic = |factor: &&Factor| factor.exponent.as_number().is_none() && is_reciprocal(&factor.exponent);
    // The largest of the exponents leads: 1/n before 1/(2n).
    let Some(exponent) = upper.iter().chain(lower.iter()).filter(symbolic).map(|f| f.exponent.clone()).max_by_key(weight) else { return };
    let joins = |factor: &&Factor| root_of(factor, &exponent).is_some();
    if upper.iter().chain(lower.iter()).filter(joins).count() < 2 {
        return;
    }
    let take = |side: &mut Vec<Factor>| -> Vec<Expr> {
        let (taken, kept) = side.drain(..).partition(|factor| root_of(factor, &exponent).is_some());
        *side = kept;
        Vec::from_iter(taken).iter().filter_map(|factor: &Factor| root_of(factor, &exponent)).collect()
    };
    let (above, below) = (take(upper), take(lower));
    let base = Expr::product(above.into_iter().chain(below.iter().map(Expr::recip)));
    upper.push(Factor { base, exponent });
}

/// The base under the common root; of a factor with half the exponent the square root.
fn root_of(factor: &Factor, exponent: &Expr) -> Option<Expr> {
    if sign(&factor.base) != Sign::Positive {
        None
    } else if factor.exponent == *exponent {
        Some(factor.base.clone())
    } else if &factor.exponent * Expr::integer(2) == *exponent {
        Some(factor.base.sqrt())
    } else {
        None
    }
}

/// True for 1/n and its rational multiples: a root of symbolic order.
fn is_reciprocal(exponent: &Expr) -> bool {
    let (number, rest) = exponent.split_coefficient();
    let (base, power) = rest.split_power();
    number.is_positive() && base.as_symbol().is_some() && power == Expr::integer(-1)
}

fn weight(exponent: &Expr) -> Number {
    exponent.split_coefficient().0
}
