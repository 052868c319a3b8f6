//! What needs a look at several terms at once: pairs of exponentials and of logarithms.

use super::polynomial::{Frame, Monomial, Polynomial};
use super::{power, rational};
use crate::expr::{Expr, ExprError, Node, Number, Sign, sign};
use std::collections::BTreeMap;

/// An expanded sum brought to canonical form.
pub(super) fn gathered(sum: Polynomial) -> Result<Polynomial, ExprError> {
    let frame = sum.frame().clone();
    if !frame.is_canonical() {
        return Ok(sum);
    }
    let mut settled = Polynomial::zero(&frame);
    for (monomial, number) in sum.terms() {
        power::settle(monomial.clone(), number, &mut settled)?;
    }
    let split = split_logarithms(settled)?;
    let joined = joined_exponentials(rational::reduced(split)?)?;
    joined_logarithms(joined)
}

/// A factor common to several terms, and per kind of partner the coefficient free of the variable.
type Groups<K> = BTreeMap<(Monomial, Expr), BTreeMap<K, Polynomial>>;

/// The part of a product that is free of the variable, and the part that is not.
fn parted(monomial: &Monomial, frame: &Frame) -> (Monomial, Monomial) {
    monomial
        .iter()
        .map(|(a, p)| (a.clone(), p.clone()))
        .partition(|(atom, power)| !atom.contains(frame.variable()) && !power.contains(frame.variable()))
}

fn add_to<K: Ord>(groups: &mut Groups<K>, key: (Monomial, Expr), kind: K, free: Monomial, number: &Number, frame: &Frame) {
    groups.entry(key).or_default().entry(kind).or_insert_with(|| Polynomial::zero(frame)).add_term(free, number);
}

fn half_sum(first: &Polynomial, second: &Polynomial) -> Result<Polynomial, ExprError> {
    let mut total = first.clone();
    total.add(second)?;
    Ok(total.scaled(&Number::ratio(1, 2)))
}

/// A function of the pair e^u, e^−u, in the order of the coefficients of a group.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Exponential {
    Rising,
    Falling,
    Cosh,
    Sinh,
}

/// The function, and u with the sign that cosh keeps.
fn exponential(atom: &Expr, power: &Expr, frame: &Frame) -> Option<(Exponential, Expr)> {
    match atom.node() {
        Node::Function(function, arguments) if power.is_one() => {
            let u = arguments.first().filter(|u| u.contains(frame.variable()))?.clone();
            match function.name() {
                "cosh" => Some((Exponential::Cosh, u)),
                "sinh" => Some((Exponential::Sinh, u)),
                _ => None,
            }
        }
        _ if *atom == Expr::euler() => {
            let own = Expr::sum(power.terms().into_iter().filter(|term| term.contains(frame.variable())));
            // Of u and −u exactly one is the argument that cosh keeps.
            let kept = match Expr::call("cosh", [own.clone()]).node() {
                Node::Function(_, arguments) => arguments.first().cloned()?,
                _ => return None,
            };
            Some((if kept == own { Exponential::Rising } else { Exponential::Falling }, kept))
        }
        _ => None,
    }
}

/// e^u, e^−u, cosh u and sinh u with the same factor: one or two of them.
///
/// One alone where it suffices; else cosh and sinh where nothing else was typed, and exponentials otherwise.
fn joined_exponentials(sum: Polynomial) -> Result<Polynomial, ExprError> {
    let frame = sum.frame().clone();
    let euler = Expr::euler();
    let own = |monomial: &Monomial| monomial.iter().find_map(|(a, p)| exponential(a, p, &frame).map(|found| (a.clone(), found)));
    let (exponentials, mut result) = sum.split(|monomial| own(monomial).is_some());
    if exponentials.len() < 2 {
        return Ok(sum);
    }
    let mut groups: Groups<Exponential> = Groups::new();
    for (monomial, number) in exponentials.terms() {
        let Some((atom, (kind, u))) = own(monomial) else { continue };
        let (mut free, mut rest) = parted(monomial, &frame);
        if let Some(power) = rest.remove(&atom)
            && atom == euler
        {
            let constant = Expr::sum(power.terms().into_iter().filter(|term| !term.contains(frame.variable())));
            if !constant.is_zero() {
                free.multiply(euler.clone(), constant);
            }
        }
        add_to(&mut groups, (rest, u), kind, free, number, &frame);
    }
    for ((rest, u), kinds) in groups {
        let of = |kind: Exponential| kinds.get(&kind).cloned().unwrap_or_else(|| Polynomial::zero(&frame));
        let (cosh, sinh) = (of(Exponential::Cosh), of(Exponential::Sinh));
        let (mut rising, mut falling) = (of(Exponential::Rising), of(Exponential::Falling));
        let typed = kinds.keys().all(|kind| matches!(kind, Exponential::Cosh | Exponential::Sinh));
        rising.add(&half_sum(&cosh, &sinh)?)?;
        falling.add(&half_sum(&cosh, &sinh.scaled(&Number::integer(-1)))?)?;
        let (mut even, odd) = (rising.clone(), rising.minus(&falling)?);
        even.add(&falling)?;
        let one_is_enough = even.is_zero() || odd.is_zero();
        if one_is_enough || (typed && !rising.is_zero() && !falling.is_zero()) {
            insert(&mut result, &even, &rest, Expr::call("cosh", [u.clone()]));
            insert(&mut result, &odd, &rest, Expr::call("sinh", [u]));
            continue;
        }
        let rest = Polynomial::single(rest, Number::integer(1), &frame);
        for (coefficient, exponent) in [(rising, u.clone()), (falling, -u)] {
            result.add(&coefficient.times(&Polynomial::atom(euler.clone(), exponent, &frame))?.times(&rest)?)?;
        }
    }
    Ok(result)
}

/// The argument u and the coefficients of ln(1+u) and ln(1−u) in a logarithm or an atanh.
fn as_pair(atom: &Expr, power: &Expr, frame: &Frame) -> Option<(Expr, [Number; 2])> {
    let Node::Function(function, arguments) = atom.node() else { return None };
    let [argument] = arguments.as_slice() else { return None };
    if !power.is_one() || !argument.contains(frame.variable()) {
        return None;
    }
    match function.name() {
        "atanh" => Some((argument.clone(), [Number::ratio(1, 2), Number::ratio(-1, 2)])),
        "ln" => {
            let u = argument - Expr::one();
            // Sums contain several logarithms and are left unchanged.
            if u.as_number().is_some() || matches!(u.node(), Node::Sum(_)) {
                return None;
            }
            match sign(&u) {
                Sign::Positive => Some((u, [Number::integer(1), Number::integer(0)])),
                Sign::Negative => Some(match minus_square(&u, frame) {
                    Some(root) => (root, [Number::integer(1), Number::integer(1)]),
                    None => (-u, [Number::integer(0), Number::integer(1)]),
                }),
                _ => None,
            }
        }
        _ => None,
    }
}

/// c·r^k where u = −c²·r^(2k).
fn minus_square(u: &Expr, frame: &Frame) -> Option<Expr> {
    let radius = Expr::from(frame.variable().clone());
    let magnitude = -u;
    let exponent = magnitude.factors().iter().find_map(|f| (f.split_power().0 == radius).then(|| f.split_power().1))?;
    let half = exponent.as_integer().filter(|k| k % 2 == 0)?;
    let rest = &magnitude / radius.power(half);
    (!rest.contains(frame.variable()) && half == 2).then(|| magnitude.sqrt())
}

/// ln(1−u²) and atanh u where ln(1+u) or ln(1−u) of the same u occur too, as these two.
fn split_logarithms(sum: Polynomial) -> Result<Polynomial, ExprError> {
    let frame = sum.frame().clone();
    let mut result = Polynomial::zero(&frame);
    for (monomial, number) in sum.terms() {
        let mut pairs = monomial.iter().filter_map(|(atom, power)| Some((atom.clone(), as_pair(atom, power, &frame)?)));
        let (first, others) = (pairs.next(), pairs.next().is_some());
        let Some((atom, (u, coefficients))) = first.filter(|_| !others) else {
            result.add_term(monomial.clone(), number);
            continue;
        };
        let mut rest = monomial.clone();
        rest.remove(&atom);
        for (argument, coefficient) in [Expr::one() + &u, Expr::one() - &u].into_iter().zip(coefficients) {
            if !coefficient.is_zero() {
                let mut total = rest.clone();
                total.multiply(Expr::call("ln", [argument]), Expr::one());
                result.add_term(total, &(number * &coefficient));
            }
        }
    }
    Ok(result)
}

/// ln(1+u) and ln(1−u) with the same factor become atanh u and ln(1−u²).
fn joined_logarithms(sum: Polynomial) -> Result<Polynomial, ExprError> {
    let frame = sum.frame().clone();
    let own = |monomial: &Monomial| {
        let mut pairs = monomial.iter().filter_map(|(atom, power)| Some((atom.clone(), as_pair(atom, power, &frame)?)));
        match (pairs.next(), pairs.next()) {
            (Some(found), None) => Some(found),
            _ => None,
        }
    };
    let (logarithms, mut result) = sum.split(|monomial| own(monomial).is_some());
    if logarithms.is_zero() {
        return Ok(sum);
    }
    let mut groups: Groups<bool> = Groups::new();
    for (monomial, number) in logarithms.terms() {
        let Some((atom, (u, coefficients))) = own(monomial) else { continue };
        let (free, mut rest) = parted(monomial, &frame);
        rest.remove(&atom);
        // ln(1−u²) is both of them.
        for (is_plus, coefficient) in [true, false].into_iter().zip(coefficients).filter(|(_, own)| !own.is_zero()) {
            add_to(&mut groups, (rest.clone(), u.clone()), is_plus, free.clone(), &(number * &coefficient), &frame);
        }
    }
    for ((rest, u), sides) in groups {
        let (plus, minus) = (sides.get(&true), sides.get(&false));
        let call = |name: &'static str, argument: Expr| Expr::call(name, [argument]);
        if let (Some(plus), Some(minus)) = (plus, minus)
            && is_linear(&u, &frame)
        {
            insert(&mut result, &plus.minus(minus)?, &rest, call("atanh", u.clone()));
            insert(&mut result, &half_sum(plus, minus)?, &rest, call("ln", Expr::one() - u.power(2)));
            continue;
        }
        for (side, argument) in [(plus, Expr::one() + &u), (minus, Expr::one() - &u)] {
            if let Some(side) = side {
                insert(&mut result, side, &rest, call("ln", argument));
            }
        }
    }
    Ok(result)
}

/// True for c·r with c free of the variable.
fn is_linear(u: &Expr, frame: &Frame) -> bool {
    !(u / Expr::from(frame.variable().clone())).contains(frame.variable())
}

/// Adds coefficient · rest · atom.
fn insert(result: &mut Polynomial, coefficient: &Polynomial, rest: &Monomial, atom: Expr) {
    for (monomial, number) in coefficient.terms() {
        let mut total = rest.times(monomial);
        total.multiply(atom.clone(), Expr::one());
        result.add_term(total, number);
    }
}
