//! Decimals beside roots of numbers: √(d/25.46) for √(2546 d)/254.6.

use super::layout::Factor;
use crate::expr::{Expr, Node, Number};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};

/// Largest size of the number under the root, in bits.
const LARGEST: u64 = 128;
/// Largest number of ways in which factors are taken out of a root.
const MOST_WAYS: usize = 256;
/// Number of digits that are distributed anew even without decimals.
const MANY: usize = 8;
/// Primes that are looked for.
const PRIMES: [u32; 11] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31];

/// Distributes the number of a product, if it has decimals or many digits, between the outside and the inside of its root so that few
/// digits are written.
///
/// With `reads_back`, only where parsing restores the product, because it moves numbers out of roots.
pub(super) fn gather(upper: &mut Vec<Factor>, lower: &mut Vec<Factor>, has_decimals: bool, reads_back: bool) {
    let Some((outside, inside, order)) = distributed(upper, lower, has_decimals, reads_back) else { return };
    let is_numeric = |own: &Factor| own.base.as_number().is_some() && own.exponent.as_number().is_some();
    upper.retain(|own| !is_numeric(own));
    lower.retain(|own| !is_numeric(own));
    let (above, below) = outside.printed_parts();
    upper.extend((!above.is_one()).then(|| Factor { base: Expr::number(above), exponent: Expr::one() }));
    lower.extend((!below.is_one()).then(|| Factor { base: Expr::number(below), exponent: Expr::one() }));
    if inside.is_one() {
        return;
    }
    // A perfect power under the root is a power of the root: 12.73^(2/3).
    let power = (2..order).rev().find_map(|power| Some((inside.root(power)?, power)));
    let (base, power) = power.unwrap_or((inside, 1));
    let exponent = Expr::ratio(i64::from(power), i64::from(order));
    if order == 2
        && let Some(own) = upper.iter_mut().find(|own| joins(own))
    {
        let whole = &own.exponent - &exponent;
        let symbol = std::mem::replace(own, Factor { base: &own.base * Expr::number(base), exponent }).base;
        upper.extend((!whole.is_zero()).then_some(Factor { base: symbol, exponent: whole }));
        return;
    }
    let (above, below) = base.printed_parts();
    upper.extend((!above.is_one()).then(|| Factor { base: Expr::number(above), exponent: exponent.clone() }));
    lower.extend((!below.is_one()).then(|| Factor { base: Expr::number(below), exponent }));
}

/// True for the square root of a symbol or a product, or an odd power of it, under which a number may stand.
fn joins(factor: &Factor) -> bool {
    let is_symbol = matches!(factor.base.node(), Node::Symbol(_) | Node::Product(_));
    is_symbol && factor.exponent.as_number().is_some_and(|number| number.is_positive() && number.to_f64().fract() == 0.5)
}

/// The number outside, the number under the root, and the order of the root; `None` if the product is as short as it can be.
fn distributed(upper: &[Factor], lower: &[Factor], mut has_decimals: bool, reads_back: bool) -> Option<(Number, Number, u32)> {
    let (mut outside, mut roots, mut order) = (Number::integer(1), Vec::new(), 1_u32);
    for (factors, direction) in [(upper, 1), (lower, -1)] {
        for own in factors {
            let (Some(base), Some(exponent)) = (own.base.as_number(), own.exponent.as_number()) else { continue };
            if !base.is_positive() {
                return None;
            }
            has_decimals |= base.has_decimals();
            match exponent.to_i64() {
                Some(power) => outside = product(&outside, &base.power(direction * power)?),
                None => {
                    let denominator = exponent.value().denom().to_u32().filter(|own| *own <= 9)?;
                    order = order.lcm(&denominator);
                    roots.push((base.clone(), exponent.value() * BigRational::from_integer(direction.into())));
                }
            }
        }
    }
    // A root of a number alone is not shorter for an author: 0.78125 sqrt(2), not 25/(8 sqrt(8)).
    let is_root = |own: &Factor| own.base.as_number().is_none() && own.exponent.as_number().is_some_and(|own| !own.is_integer());
    let has_partner = if order == 2 { upper.iter().any(joins) } else { upper.iter().chain(lower).any(is_root) };
    if roots.is_empty() || order > 9 || !has_partner {
        return None;
    }
    let cost = |outside: &Number, inside: &Number| (digits(outside) + digits(inside), digits(inside));
    let decimal = |value: BigRational| if has_decimals { Number::from(value).with_decimals() } else { Number::from(value) };
    let typed = roots.iter().try_fold(Number::integer(1), |all, (base, exponent)| {
        let power = (exponent * BigRational::from_integer(order.into())).to_integer().to_i64()?;
        Some(product(&all, &base.power(power)?))
    })?;
    let whole = product(&outside.power(i64::from(order))?, &typed);
    let now = cost(&outside, &typed);
    if whole.bits() > LARGEST || (!has_decimals && now.0 < MANY) {
        return None;
    }
    let best = taken_out(whole.value(), order)
        .into_iter()
        .map(|out| {
            let within = whole.value() / num_traits::Pow::pow(&out, order);
            (decimal(out), decimal(within))
        })
        .min_by_key(|(out, within)| cost(out, within))?;
    if cost(&best.0, &best.1) >= now {
        return None;
    }
    if !reads_back {
        return Some((best.0, best.1, order));
    }
    let (above, below) = best.1.printed_parts();
    // Without a decimal that is written, the formula has none after it was read.
    let (over, under) = best.0.printed_parts();
    if has_decimals && [&above, &below, &over, &under].into_iter().all(Number::is_integer) {
        return None;
    }
    // Not every number has one form: 80^(5/6)/32 is 12500^(1/6)/4, and sqrt(6.29)/sqrt(6.33) is a product of two roots.
    let as_now =
        Expr::product(roots.iter().map(|(base, exponent)| Expr::number(base.clone()).pow(&Expr::number(Number::from(exponent.clone())))));
    let as_best = Expr::number(best.1.clone()).pow(&Expr::ratio(1, i64::from(order)));
    let is_same = Expr::number(outside.clone()) * as_now == Expr::number(best.0.clone()) * as_best;
    (is_same && (above.is_one() || below.is_one())).then_some((best.0, best.1, order))
}

fn product(one: &Number, other: &Number) -> Number {
    let value = Number::from(one.value() * other.value());
    if one.has_decimals() || other.has_decimals() { value.with_decimals() } else { value }
}

/// The numbers whose powers of this order are factors of the numerator over factors of the denominator.
fn taken_out(whole: &BigRational, order: u32) -> Vec<BigRational> {
    let mut ways = vec![BigRational::one()];
    for prime in PRIMES.map(BigInt::from) {
        let exponent = |own: &BigInt| {
            let (mut rest, mut count) = (own.abs(), 0);
            while rest.is_multiple_of(&prime) && !rest.is_one() {
                rest /= &prime;
                count += 1;
            }
            count
        };
        let (above, below) = (exponent(whole.numer()) / order, exponent(whole.denom()) / order);
        let step = if above > 0 { BigRational::from_integer(prime.clone()) } else { BigRational::new(BigInt::one(), prime.clone()) };
        let mut more = Vec::new();
        let mut power = BigRational::one();
        for _ in 0..above.max(below) {
            power *= &step;
            more.extend(ways.iter().map(|own| own * &power));
        }
        ways.extend(more);
        if ways.len() > MOST_WAYS {
            break;
        }
    }
    ways
}

/// The number of digits that are written, 0 for 1.
fn digits(number: &Number) -> usize {
    let (above, below) = number.printed_parts();
    let count = |own: &Number| if own.is_one() { 0 } else { written(own) };
    count(&above) + count(&below)
}

fn written(number: &Number) -> usize {
    super::number::digits(number).mantissa.chars().filter(char::is_ascii_digit).count()
}
