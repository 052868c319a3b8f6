//! Canonical constructors: flatten, collect, fold and sort, locally and without expanding.

use super::{Constant, Expr, Function, Node, Number, Sign, sign};
use crate::num::work::is_exhausted;
use std::collections::BTreeMap;

/// The result of a constructor after the budget is exhausted, and of one with such an operand.
///
/// Constructors have no error to return. The smallest expression ends every loop that builds a larger one from the last, and
/// [`within`](crate::num::work::within) throws away what is made of it.
fn cut() -> Expr {
    Expr::raw(Node::Constant(Constant::Cut))
}

/// The sum of the terms: nested sums flattened, like terms collected, numbers folded.
///
/// −1 times a sum is distributed, so that a difference of sums is one sum.
pub(super) fn sum(terms: impl IntoIterator<Item = Expr>) -> Expr {
    sum_of(terms.into_iter().collect())
}

fn sum_of(mut pending: Vec<Expr>) -> Expr {
    if is_exhausted() {
        return cut();
    }
    let mut constant = Number::integer(0);
    let mut collected: BTreeMap<Expr, Number> = BTreeMap::new();
    pending.reverse();
    while let Some(term) = pending.pop() {
        match term.node() {
            Node::Number(number) => constant = &constant + number,
            Node::Constant(Constant::Cut) => return term,
            Node::Sum(inner) => pending.extend(inner.iter().rev().cloned()),
            _ => {
                let (coefficient, rest) = split_coefficient(&term);
                if let Node::Sum(inner) = rest.node()
                    && coefficient == Number::integer(-1)
                {
                    pending.extend(inner.iter().rev().map(|t| -t));
                    continue;
                }
                let entry = collected.entry(rest).or_insert_with(|| Number::integer(0));
                *entry = &*entry + &coefficient;
            }
        }
    }
    let mut terms: Vec<Expr> = Vec::with_capacity(collected.len() + 1);
    for (rest, coefficient) in collected {
        if !coefficient.is_zero() {
            terms.push(scaled(coefficient, rest));
        }
    }
    if !constant.is_zero() {
        terms.push(Expr::number(constant));
    }
    match (terms.pop(), terms.is_empty()) {
        (None, _) => Expr::zero(),
        (Some(only), true) => only,
        (Some(last), false) => {
            terms.push(last);
            terms.sort();
            Expr::raw(Node::Sum(terms))
        }
    }
}

/// `coefficient` times an expression without a numeric factor.
fn scaled(coefficient: Number, rest: Expr) -> Expr {
    if coefficient.is_one() {
        return rest;
    }
    let mut factors = vec![Expr::number(coefficient)];
    match rest.node() {
        Node::Product(inner) => factors.extend(inner.iter().cloned()),
        _ => factors.push(rest),
    }
    Expr::raw(Node::Product(factors))
}

/// The product of the factors: flattened, powers of one base added up, numbers folded.
pub(super) fn product(factors: impl IntoIterator<Item = Expr>) -> Expr {
    product_of(factors.into_iter().collect())
}

fn product_of(mut pending: Vec<Expr>) -> Expr {
    if is_exhausted() {
        return cut();
    }
    let mut coefficient = Number::integer(1);
    let mut exponents: BTreeMap<Expr, Vec<Expr>> = BTreeMap::new();
    // Folding a collected power can give a product again (2^(3/2) = 2·2^(1/2)); a few rounds settle it.
    for _ in 0..8 {
        while let Some(factor) = pending.pop() {
            match factor.node() {
                Node::Number(number) => coefficient = &coefficient * number,
                Node::Constant(Constant::Cut) => return factor,
                Node::Product(inner) => pending.extend(inner.iter().cloned()),
                _ => {
                    let (base, exponent) = split_power(&factor);
                    exponents.entry(base).or_default().push(exponent);
                }
            }
        }
        if coefficient.is_zero() {
            return Expr::zero();
        }
        let mut settled = true;
        let mut next: BTreeMap<Expr, Vec<Expr>> = BTreeMap::new();
        for (base, list) in std::mem::take(&mut exponents) {
            let [only] = list.as_slice() else {
                settled = false;
                pending.push(power(&base, &sum(list)));
                continue;
            };
            next.insert(base, vec![only.clone()]);
        }
        exponents = next;
        if settled {
            break;
        }
    }
    let mut result: Vec<Expr> = Vec::with_capacity(exponents.len() + 1);
    for (base, list) in exponents {
        result.push(rejoin(&base, &sum(list)));
    }
    if result.is_empty() {
        return Expr::number(coefficient);
    }
    if !coefficient.is_one() {
        // A lone −1 before a sum is distributed; nothing else ever expands.
        if let ([only], true) = (result.as_slice(), coefficient == Number::integer(-1))
            && let Node::Sum(terms) = only.node()
        {
            return sum(terms.iter().map(|t| product([Expr::integer(-1), t.clone()])));
        }
    }
    result.sort();
    if coefficient.is_one() && result.len() == 1 {
        return result.swap_remove(0);
    }
    if !coefficient.is_one() {
        result.insert(0, Expr::number(coefficient));
    }
    Expr::raw(Node::Product(result))
}

/// The node of an already canonical base and exponent.
fn rejoin(base: &Expr, exponent: &Expr) -> Expr {
    if exponent.is_one() {
        base.clone()
    } else if matches!(base.node(), Node::Constant(Constant::Euler)) {
        power(base, exponent)
    } else {
        Expr::raw(Node::Power(base.clone(), exponent.clone()))
    }
}

/// `base`^`exponent` with the laws of powers that hold for real numbers, and no others.
///
/// (u^p)^q becomes u^(pq) only for whole q or u proven positive; √(u²) of unknown sign becomes |u|.
pub(super) fn power(base: &Expr, exponent: &Expr) -> Expr {
    if is_exhausted() || base.is_cut() || exponent.is_cut() {
        return cut();
    }
    if exponent.is_zero() || base.is_one() {
        return Expr::one();
    }
    if exponent.is_one() {
        return base.clone();
    }
    let whole = exponent.as_integer();
    match base.node() {
        Node::Number(number) => {
            if number.is_zero() {
                if sign(exponent) == Sign::Positive {
                    return Expr::zero();
                }
            } else if let Some(folded) = whole.and_then(|n| number.power(n)) {
                return Expr::number(folded);
            } else if let Some(folded) = fold_root(number, exponent) {
                return folded;
            }
        }
        Node::Constant(Constant::Euler) => {
            return Function::named("exp").map_or_else(|| base.clone(), |exp| function(exp, vec![exponent.clone()]));
        }
        Node::Function(f, arguments) if f.name() == "exp" => {
            if let [argument] = arguments.as_slice() {
                return power(&Expr::euler(), &product([argument.clone(), exponent.clone()]));
            }
        }
        Node::Function(f, arguments) if f.name() == "abs" && whole.is_some_and(|n| n % 2 == 0) => {
            if let [argument] = arguments.as_slice() {
                return power(argument, exponent);
            }
        }
        Node::Power(inner, first) => {
            if whole.is_some() || sign(inner) == Sign::Positive {
                return power(inner, &product([first.clone(), exponent.clone()]));
            }
            if first.as_integer().is_some_and(|n| n % 2 == 0) && exponent.as_number().is_some() {
                let magnitude = Expr::call("abs", [inner.clone()]);
                return power(&magnitude, &product([first.clone(), exponent.clone()]));
            }
        }
        Node::Product(factors) => {
            if whole.is_some() {
                return product(factors.iter().map(|f| power(f, exponent)));
            }
            let (positive, rest): (Vec<Expr>, Vec<Expr>) = factors.iter().cloned().partition(|f| sign(f) == Sign::Positive);
            if !positive.is_empty() {
                let inner = product(rest);
                let kept = if inner.is_one() {
                    Expr::one()
                } else if inner == *base {
                    Expr::raw(Node::Power(inner, exponent.clone()))
                } else {
                    power(&inner, exponent)
                };
                let mut result: Vec<Expr> = positive.iter().map(|f| power(f, exponent)).collect();
                result.push(kept);
                return product(result);
            }
            // (−2)·u with u negative: take the magnitude of the number out.
            if let Some(Node::Number(number)) = factors.first().map(Expr::node)
                && number.is_negative()
                && *number != Number::integer(-1)
            {
                let magnitude = power(&Expr::number(number.abs()), exponent);
                let inner = product(std::iter::once(Expr::integer(-1)).chain(factors.iter().skip(1).cloned()));
                return product([magnitude, power(&inner, exponent)]);
            }
        }
        _ => {}
    }
    Expr::raw(Node::Power(base.clone(), exponent.clone()))
}

/// The primes that are looked for under roots.
const SMALL_PRIMES: [i64; 6] = [2, 3, 5, 7, 11, 13];

/// Folds a positive rational to a rational power as far as roots come out, e.g. 8^(1/2) = 2·2^(1/2).
fn fold_root(base: &Number, exponent: &Expr) -> Option<Expr> {
    let exponent = exponent.as_number()?;
    if !base.is_positive() || exponent.is_integer() {
        return None;
    }
    let k = u32::try_from(exponent.value().denom()).ok().filter(|k| *k <= 64)?;
    let p = i64::try_from(exponent.value().numer()).ok().filter(|p| p.unsigned_abs() <= 4096)?;
    // base^(p/k) = base^⌊p/k⌋ · base^(rest/k) with 0 < rest < k.
    let (whole, rest) = (p.div_euclid(i64::from(k)), p.rem_euclid(i64::from(k)));
    if let Some(root) = base.root(k) {
        return root.power(p).map(Expr::number);
    }
    // The common radicand is p q^(k−1); do not combine the roots if it exceeds the range of doubles.
    if base.bits() * u64::from(k) > 512 {
        return None;
    }
    let outside = base.power(whole)?;
    let denominator = Number::from(num_rational::BigRational::from_integer(base.value().denom().clone()));
    // Under the root an integer: (p/q)^(rest/k) = (p q^(k−1))^(rest/k) / q^rest.
    let radicand =
        &Number::from(num_rational::BigRational::from_integer(base.value().numer().clone())) * &denominator.power(i64::from(k) - 1)?;
    let outside = &outside * &denominator.power(-rest)?;
    let (out, inner) = extract_root(&radicand, k);
    let out = out.power(rest)?;
    // More may come out of the power of the radicand, as in 50000^(5/6) = 5000·20^(1/6).
    let (more, left) = extract_power(&inner, rest, k)?;
    // A power of a small number stays in preference to the root of a large one.
    let (out, inner, rest) = if more.is_one() || left.bits() > inner.bits() { (out, inner, rest) } else { (&out * &more, left, 1) };
    let outside = &outside * &out;
    if whole == 0 && outside.is_one() {
        return None;
    }
    let outside = if base.has_decimals() { outside.with_decimals() } else { outside };
    let root = Expr::raw(Node::Power(Expr::number(inner), Expr::ratio(rest, i64::from(k))));
    Some(if outside.is_one() { root } else { Expr::raw(Node::Product(vec![Expr::number(outside), root])) })
}

/// Splits a positive integer into out^k · inner by small primes.
fn extract_root(radicand: &Number, k: u32) -> (Number, Number) {
    let (mut out, mut inner) = (Number::integer(1), radicand.clone());
    if radicand.bits() > 512 {
        return (out, inner);
    }
    for prime in SMALL_PRIMES {
        let Some(factor) = Number::integer(prime).power(i64::from(k)) else { continue };
        let Some(inverse) = factor.reciprocal() else { continue };
        loop {
            let reduced = &inner * &inverse;
            // A product beyond the work limit is 0.
            if reduced.is_zero() || !reduced.is_integer() {
                break;
            }
            inner = reduced;
            out = &out * &Number::integer(prime);
        }
    }
    if let Some(root) = inner.root(k) {
        out = &out * &root;
        inner = Number::integer(1);
    }
    (out, inner)
}

/// Splits a positive integer to the power `rest` into out^k · inner by small primes.
fn extract_power(radicand: &Number, rest: i64, k: u32) -> Option<(Number, Number)> {
    let (mut out, mut inner, mut left) = (Number::integer(1), Number::integer(1), radicand.clone());
    if rest > 1 {
        for prime in SMALL_PRIMES {
            let prime = Number::integer(prime);
            let inverse = prime.reciprocal()?;
            let mut count = 0;
            // A product beyond the work limit is 0.
            while !left.is_zero() && (&left * &inverse).is_integer() {
                left = &left * &inverse;
                count += rest;
            }
            out = &out * &prime.power(count / i64::from(k))?;
            inner = &inner * &prime.power(count % i64::from(k))?;
        }
    }
    // A large rest stays under its own power.
    if left.bits() * rest.unsigned_abs() > 512 {
        Some((Number::integer(1), radicand.clone()))
    } else {
        Some((out, &inner * &left.power(rest)?))
    }
}

/// The function of the arguments, folded if its row has a shorter form.
pub(super) fn function(function: Function, arguments: Vec<Expr>) -> Expr {
    if is_exhausted() || arguments.iter().any(Expr::is_cut) {
        return cut();
    }
    if let Some(folded) = function.row().fold.and_then(|fold| fold(&arguments)) {
        return folded;
    }
    Expr::raw(Node::Function(function, arguments))
}

pub(super) fn split_coefficient(expr: &Expr) -> (Number, Expr) {
    match expr.node() {
        Node::Number(number) => (number.clone(), Expr::one()),
        Node::Product(factors) => match factors.split_first() {
            Some((first, rest)) => match (first.as_number(), rest) {
                (Some(number), [only]) => (number.clone(), only.clone()),
                (Some(number), _) => (number.clone(), Expr::raw(Node::Product(rest.to_vec()))),
                (None, _) => (Number::integer(1), expr.clone()),
            },
            None => (Number::integer(1), Expr::one()),
        },
        _ => (Number::integer(1), expr.clone()),
    }
}

pub(super) fn split_power(expr: &Expr) -> (Expr, Expr) {
    match expr.node() {
        Node::Power(base, exponent) => (base.clone(), exponent.clone()),
        Node::Function(f, arguments) if f.name() == "exp" => match arguments.as_slice() {
            [argument] => (Expr::euler(), argument.clone()),
            _ => (expr.clone(), Expr::one()),
        },
        _ => (expr.clone(), Expr::one()),
    }
}
