//! Factors under one root: (d/(Cκ))^(1/n) for a product of n-th roots.

use super::layout::Factor;
use crate::expr::{Expr, Node, Number, Sign, sign};

/// Joins positive factors with the exponent 1/n, and those with 1/(2n) as roots, across the line.
///
/// Parsing a joined root restores the product, because positive factors are moved out of roots.
pub(super) fn gather(upper: &mut Vec<Factor>, lower: &mut Vec<Factor>) {
    gather_roots(upper, lower);
    gather_square_roots(upper);
    gather_square_roots(lower);
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

/// Joins factors under one root of the third or a higher order across the line: d (20 d/C)^(1/6) for 20^(1/6) d^(7/6)/C^(1/6).
///
/// Numbers, symbols and values of Γ join; π joins with half the exponent as well, as in (d Γ(5/4)/(√π C Γ(7/4)))^(2/3).
fn gather_roots(upper: &mut Vec<Factor>, lower: &mut Vec<Factor>) {
    let fractions = |side: &[Factor]| -> Vec<Number> { side.iter().filter_map(fraction_of).collect() };
    let (above, below) = (fractions(upper), fractions(lower));
    let joined = |own: &Number| above.iter().chain(&below).filter(|other| own == *other).count();
    let Some(exponent) = above.iter().filter(|own| below.contains(own)).max_by_key(|own| (joined(own), (*own).clone())) else { return };
    let exponent = Expr::number(exponent.clone());
    let take = |side: &mut Vec<Factor>| -> Vec<Expr> {
        let mut taken = Vec::new();
        for own in std::mem::take(side) {
            let fraction = fraction_of(&own).map(Expr::number);
            if fraction.as_ref() == Some(&exponent) {
                let whole = &own.exponent - &exponent;
                if !whole.is_zero() {
                    side.push(Factor { base: own.base.clone(), exponent: whole });
                }
                taken.push(own.base);
            } else if fraction.is_some() && own.base == Expr::pi() && own.exponent == half(&exponent) {
                taken.push(own.base.sqrt());
            } else {
                side.push(own);
            }
        }
        taken
    };
    let (above, below) = (take(upper), take(lower));
    let base = Expr::product(above.into_iter().chain(below.iter().map(Expr::recip)));
    upper.push(Factor { base, exponent });
}

/// Joins the square roots of symbols and numbers with that of a sum: √(d (2h − d)) for √d √(2h − d).
fn gather_square_roots(side: &mut Vec<Factor>) {
    let is_root = |own: &&Factor| own.exponent == Expr::ratio(1, 2);
    let is_sum = |own: &&Factor| matches!(own.base.node(), Node::Sum(_));
    let joins = |own: &Factor| is_root(&own) && matches!(own.base.node(), Node::Sum(_) | Node::Symbol(_) | Node::Number(_));
    if side.iter().filter(is_root).filter(is_sum).count() != 1 || side.iter().filter(|own| joins(own)).count() < 2 {
        return;
    }
    let (joined, kept): (Vec<Factor>, Vec<Factor>) = side.drain(..).partition(joins);
    *side = kept;
    side.push(Factor { base: Expr::product(joined.into_iter().map(|own| own.base)), exponent: Expr::ratio(1, 2) });
}

fn half(exponent: &Expr) -> Expr {
    exponent / Expr::integer(2)
}

/// The part of a factor's exponent between 0 and 1, if it is no half and the factor may join others under a root.
fn fraction_of(factor: &Factor) -> Option<Number> {
    let number = factor.exponent.as_number().filter(|own| !own.is_integer() && own.is_positive())?;
    let joins = match factor.base.node() {
        Node::Function(function, _) => function.name() == "gamma",
        Node::Number(_) | Node::Symbol(_) | Node::Constant(_) => true,
        _ => false,
    };
    let whole = Number::from(num_rational::BigRational::from_integer(number.value().floor().to_integer()));
    let fraction = number - &whole;
    let is_half = (&fraction + &fraction).is_integer();
    (joins && !is_half && sign(&factor.base) == Sign::Positive).then_some(fraction)
}
