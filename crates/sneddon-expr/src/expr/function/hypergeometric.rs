//! Rows of the functions of hypergeometric type and of the dilogarithms, spelled as in mpmath.

use super::elementary::{first, unary};
use super::precise::single;
use super::typeset::{self, Setting};
use super::{Accuracy, PLAIN, Row};
use crate::expr::{Expr, Sign, sign};
use crate::num::{DoubleDouble, Precise, special};

pub(super) static ROWS: &[Row] = &[
    // ∫_z1^z2 t^(a−1) (1−t)^(b−1) dt
    Row {
        name: "betainc",
        arity: (4, 4),
        typeset: typeset::upright("B").set(Setting::Groups(&[2, 2])),
        value: |a| match a {
            [a, b, low, high] => special::betainc(*a, *b, *low, *high),
            _ => f64::NAN,
        },
        accuracy: Accuracy::OWN_BOUND,
        precise: Some(|a| quadruple(a, special::betainc_precise)),
        derivative: Some(beta_derivative),
        fold: Some(|a| match a {
            [_, _, low, high] if low == high => Some(Expr::zero()),
            _ => None,
        }),
        sign: Some(|a| match a {
            [_, _, low, high] => sign(&(high - low)),
            _ => Sign::Unknown,
        }),
        ..PLAIN
    },
    Row {
        name: "hyp1f1",
        arity: (3, 3),
        typeset: typeset::upright("F").set(Setting::Groups(&[1, 1, 1])),
        value: |a| match a {
            [a, b, z] => special::hyp1f1(*a, *b, *z),
            _ => f64::NAN,
        },
        accuracy: Accuracy::OWN_BOUND,
        precise: Some(|a| match a {
            [a, b, z] => special::hyp1f1_precise([*a, *b, *z]),
            _ => Precise::nan(),
        }),
        derivative: Some(|a, i| match (a, i) {
            ([p, q, z], 2) => Some(p / q * Expr::call("hyp1f1", [p + Expr::one(), q + Expr::one(), z.clone()])),
            _ => None,
        }),
        fold: Some(|a| match a {
            [p, _, z] if p.is_zero() || z.is_zero() => Some(Expr::one()),
            [p, q, z] if p == q => Some(Expr::call("exp", [z.clone()])),
            _ => None,
        }),
        // Positive by its series, or by Euler's integral for 0 < a < b.
        sign: Some(|a| match a {
            [p, q, z] if all_positive(&[p, &(q - p)]) || all_positive(&[p, q, z]) => Sign::Positive,
            _ => Sign::Unknown,
        }),
        ..PLAIN
    },
    Row {
        name: "hyp2f1",
        arity: (4, 4),
        typeset: typeset::upright("F").set(Setting::Groups(&[2, 1, 1])),
        value: |a| match a {
            [a, b, c, z] => special::hyp2f1(*a, *b, *c, *z),
            _ => f64::NAN,
        },
        accuracy: Accuracy::OWN_BOUND,
        precise: Some(|a| quadruple(a, special::hyp2f1_precise)),
        derivative: Some(|a, i| match (a, i) {
            ([p, q, c, z], 3) => {
                let next = [p + Expr::one(), q + Expr::one(), c + Expr::one(), z.clone()];
                Some(p * q / c * Expr::call("hyp2f1", next))
            }
            _ => None,
        }),
        fold: Some(|a| match a {
            [p, q, _, z] if p.is_zero() || q.is_zero() || z.is_zero() => Some(Expr::one()),
            [p, q, c, z] if q == c => Some((Expr::one() - z).pow(&-p)),
            [p, q, c, z] if p == c => Some((Expr::one() - z).pow(&-q)),
            _ => None,
        }),
        domain: Some(|a| match a {
            [p, q, _, z] if ![p, q].iter().any(|u| u.as_integer().is_some_and(|n| n <= 0)) => vec![Expr::one() - z],
            _ => Vec::new(),
        }),
        // Positive by its series, or by Euler's integral where a parameter lies between 0 and c.
        sign: Some(|a| match a {
            [p, q, c, z] if all_positive(&[p, &(c - p)]) || all_positive(&[q, &(c - q)]) || all_positive(&[p, q, c, z]) => Sign::Positive,
            _ => Sign::Unknown,
        }),
        ..PLAIN
    },
    // Arguments: p, q, the p upper parameters, the q lower ones, z; read and printed as hyper([a…],[b…],z).
    Row {
        name: "hyper",
        arity: (3, 64),
        typeset: typeset::upright("F").set(Setting::CountedGroups),
        value: |a| match split(a, |n| *n) {
            Some((upper, lower, z)) => special::hyper(upper, lower, *z),
            None => f64::NAN,
        },
        accuracy: Accuracy::OWN_BOUND,
        precise: Some(|a| match split(a, |n| n.value()) {
            Some((upper, lower, z)) => special::hyper_precise(upper, lower, *z),
            None => Precise::nan(),
        }),
        derivative: Some(hyper_derivative),
        fold: Some(fold_hyper),
        sign: Some(|a| match split(a, whole) {
            Some((upper, lower, z)) if upper.iter().chain(lower).chain([z]).all(|p| sign(p) == Sign::Positive) => Sign::Positive,
            _ => Sign::Unknown,
        }),
        ..PLAIN
    },
    // Li₂(z); the order is 2.
    Row {
        name: "polylog",
        arity: (2, 2),
        typeset: typeset::upright("Li").set(Setting::Indexed),
        value: |a| second_order(a, special::polylog2),
        accuracy: Accuracy::Measured(3.5),
        precise: Some(|a| second_order_precise(a, special::polylog2_precise)),
        derivative: Some(|a, i| match (a, i) {
            ([s, z], 1) if s.as_integer() == Some(2) => Some(-Expr::call("ln", [Expr::one() - z]) / z),
            _ => None,
        }),
        fold: Some(|a| match a {
            [_, z] if z.is_zero() => Some(Expr::zero()),
            [s, z] if s.is_one() => Some(-Expr::call("ln", [Expr::one() - z])),
            [s, z] if s.as_integer() == Some(2) && z.is_one() => Some(Expr::pi().power(2) / Expr::integer(6)),
            [s, z] if s.as_integer() == Some(2) && z.as_integer() == Some(-1) => Some(-Expr::pi().power(2) / Expr::integer(12)),
            _ => None,
        }),
        domain: Some(|a| match a {
            [_, z] => vec![Expr::one() - z],
            _ => Vec::new(),
        }),
        sign: Some(|a| match a {
            [s, z] if s.as_integer() == Some(2) => sign(z),
            _ => Sign::Unknown,
        }),
        ..PLAIN
    },
    // Cl₂(z) = −∫₀^z ln|2 sin(t/2)| dt; the order is 2.
    Row {
        name: "clsin",
        arity: (2, 2),
        typeset: typeset::upright("Cl").set(Setting::Indexed),
        value: |a| second_order(a, special::clsin2),
        accuracy: Accuracy::OWN_BOUND,
        precise: Some(|a| second_order_precise(a, special::clsin2_precise)),
        derivative: Some(|a, i| match (a, i) {
            ([s, z], 1) if s.as_integer() == Some(2) => {
                let sine = Expr::call("sin", [z / Expr::integer(2)]);
                Some(-Expr::call("ln", [Expr::call("abs", [Expr::integer(2) * sine])]))
            }
            _ => None,
        }),
        fold: Some(|a| match a {
            [_, z] if z.is_zero() => Some(Expr::zero()),
            [s, z] if s.as_integer() == Some(2) && *z == Expr::pi() => Some(Expr::zero()),
            _ => None,
        }),
        ..PLAIN
    },
    // χ₂(z) = Σ z^(2k+1)/(2k+1)², for |z| ≤ 1.
    Row {
        name: "legendre_chi2",
        typeset: typeset::italic("χ").with_index("2"),
        value: |a| unary(a, special::legendre_chi2),
        accuracy: Accuracy::Measured(3.0),
        precise: Some(|a| single(a, special::legendre_chi2_precise)),
        derivative: Some(|a, _| Some(Expr::call("atanh", a.to_vec()) / first(a))),
        domain: Some(|a| vec![Expr::one() - first(a).power(2)]),
        fold: Some(zero_at_zero),
        sign: Some(|a| sign(&first(a))),
        shown: Some(|a| dilogarithm(a, 1)),
        has_sign: true,
        ..PLAIN
    },
    // Ti₂(z) = ∫₀^z atan(t)/t dt.
    Row {
        name: "inverse_tangent_integral",
        typeset: typeset::upright("Ti").with_index("2"),
        value: |a| unary(a, special::inverse_tangent_integral),
        accuracy: Accuracy::Measured(3.0),
        precise: Some(|a| single(a, special::inverse_tangent_integral_precise)),
        derivative: Some(|a, _| Some(Expr::call("atan", a.to_vec()) / first(a))),
        fold: Some(zero_at_zero),
        sign: Some(|a| sign(&first(a))),
        shown: Some(|a| dilogarithm(a, -1)),
        has_sign: true,
        ..PLAIN
    },
];

fn all_positive(list: &[&Expr]) -> bool {
    list.iter().all(|u| sign(u) == Sign::Positive)
}

fn quadruple(a: &[DoubleDouble], f: fn([DoubleDouble; 4]) -> Precise) -> Precise {
    match a {
        [p, q, u, v] => f([*p, *q, *u, *v]),
        _ => Precise::nan(),
    }
}

fn second_order(a: &[f64], f: fn(f64) -> f64) -> f64 {
    match a {
        [s, z] if *s == 2.0 => f(*z),
        _ => f64::NAN,
    }
}

fn second_order_precise(a: &[DoubleDouble], f: fn(DoubleDouble) -> Precise) -> Precise {
    match a {
        [s, z] if s.value() == 2.0 => f(*z),
        _ => Precise::nan(),
    }
}

fn zero_at_zero(a: &[Expr]) -> Option<Expr> {
    first(a).is_zero().then(Expr::zero)
}

/// Upper parameters, lower parameters and argument of `hyper`; the counts must be whole and leave exactly one argument.
fn split<T>(a: &[T], number: fn(&T) -> f64) -> Option<(&[T], &[T], &T)> {
    let [p, q, rest @ ..] = a else { return None };
    let count = |value: f64| (value.fract() == 0.0 && value >= 0.0 && value <= rest.len() as f64).then_some(value as usize);
    let (upper, rest) = rest.split_at(count(number(p))?);
    match rest.split_at_checked(count(number(q))?) {
        Some((lower, [z])) => Some((upper, lower, z)),
        _ => None,
    }
}

fn whole(count: &Expr) -> f64 {
    count.as_integer().map_or(f64::NAN, |n| n as f64)
}

/// `hyper` of these parameters.
fn hyper(upper: Vec<Expr>, lower: Vec<Expr>, z: Expr) -> Expr {
    let counts = [Expr::integer(upper.len() as i64), Expr::integer(lower.len() as i64)];
    Expr::call("hyper", counts.into_iter().chain(upper).chain(lower).chain([z]))
}

/// Π a/Π b · pFq(a + 1; b + 1; z).
fn hyper_derivative(a: &[Expr], position: usize) -> Option<Expr> {
    let (upper, lower, z) = split(a, whole)?;
    if position + 1 != a.len() {
        return None;
    }
    let raised = |list: &[Expr]| list.iter().map(|p| p + Expr::one()).collect::<Vec<_>>();
    let factor = Expr::product(upper.iter().cloned()) / Expr::product(lower.iter().cloned());
    Some(factor * hyper(raised(upper), raised(lower), z.clone()))
}

/// Equal upper and lower parameters cancel; 1 at z = 0 and where an upper parameter is 0.
fn fold_hyper(a: &[Expr]) -> Option<Expr> {
    let (upper, lower, z) = split(a, whole)?;
    if z.is_zero() || upper.iter().any(Expr::is_zero) {
        return Some(Expr::one());
    }
    let (mut kept, mut left) = (Vec::new(), lower.to_vec());
    for parameter in upper {
        match left.iter().position(|q| q == parameter) {
            Some(place) => drop(left.remove(place)),
            None => kept.push(parameter.clone()),
        }
    }
    (kept.len() < upper.len()).then(|| hyper(kept, left, z.clone()))
}

/// ± z^(a−1) (1−z)^(b−1) at the end that moves.
fn beta_derivative(a: &[Expr], position: usize) -> Option<Expr> {
    let [p, q, low, high] = a else { return None };
    let density = |z: &Expr| z.pow(&(p - Expr::one())) * (Expr::one() - z).pow(&(q - Expr::one()));
    match position {
        2 => Some(-density(low)),
        3 => Some(density(high)),
        _ => None,
    }
}

/// z·3F2(1/2, 1/2, 1; 3/2, 3/2; ±z²), which is χ₂(z) or Ti₂(z).
fn dilogarithm(a: &[Expr], sign: i64) -> Expr {
    let z = first(a);
    let (half, one) = (Expr::ratio(1, 2), Expr::one());
    let parameters = [Expr::integer(3), Expr::integer(2), half.clone(), half, one, Expr::ratio(3, 2), Expr::ratio(3, 2)];
    let argument = Expr::integer(sign) * z.power(2);
    z * Expr::call("hyper", parameters.into_iter().chain([argument]))
}
