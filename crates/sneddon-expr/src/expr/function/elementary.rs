//! Rows of the elementary functions.

use super::precise::{self, one, to_edge, to_one, to_pole};
use super::typeset::{self, Setting};
use super::{Accuracy, Function, PLAIN, Row, exact_angles, slices};
use crate::expr::{Expr, Node, Number, Sign, sign};
use crate::num::{DoubleDouble, Region, precise as thirty};
use num_complex::Complex64;
use std::f64::consts::FRAC_PI_2;

/// Twice the measured maximum error of the platform's elementary functions, in ulps.
const LIBRARY: f64 = 2.0;

pub(super) static ROWS: &[Row] = &[
    Row {
        name: "exp",
        typeset: typeset::upright("exp").set(Setting::Exponential),
        value: |a| unary(a, f64::exp),
        accuracy: Accuracy::Measured(LIBRARY),
        precise: Some(precise::exp),
        spread: Some(|a, by| one(a, by, |z, by| z.hi.exp() * by.exp_m1())),
        slice: Some(slices::EXP),
        complex: Some(|a| complex(a, Complex64::exp)),
        region: Some(|a| region(a, Region::exp)),
        derivative: Some(|a, _| Some(call("exp", a))),
        fold: Some(|a| match a {
            [u] if u.is_zero() => Some(Expr::one()),
            [u] if u.is_one() => Some(Expr::euler()),
            [u] => inverse_of("ln", u),
            _ => None,
        }),
        sign: Some(|_| Sign::Positive),
        ..PLAIN
    },
    Row {
        name: "ln",
        spellings: &["log"],
        typeset: typeset::upright("ln"),
        value: |a| unary(a, f64::ln),
        accuracy: Accuracy::Measured(LIBRARY),
        precise: Some(|a| precise::unary(a, thirty::ln)),
        spread: Some(|a, by| one(a, by, |z, by| to_pole(by, z.hi - 2.0 * by))),
        slice: Some(slices::LN),
        complex: Some(|a| complex(a, Complex64::ln)),
        region: Some(|a| region(a, Region::ln)),
        derivative: Some(|a, _| {
            // The slope of cosh v is sinh v: the quotient of both would overflow where tanh v is 1.
            if let Node::Function(inside, list) = first(a).node()
                && let ("cosh", [v]) = (inside.row().name, list.as_slice())
            {
                return Some(Expr::call("tanh", [v.clone()]) / Expr::call("sinh", [v.clone()]));
            }
            Some(first(a).recip())
        }),
        fold: Some(|a| match a {
            [u] if u.is_one() => Some(Expr::zero()),
            [u] if *u == Expr::euler() => Some(Expr::one()),
            [u] => inverse_of("exp", u),
            _ => None,
        }),
        sign: Some(compare_with_one),
        domain: Some(|a| vec![first(a)]),
        ..PLAIN
    },
    Row {
        name: "sin",
        typeset: typeset::upright("sin"),
        value: |a| unary(a, f64::sin),
        accuracy: Accuracy::Measured(LIBRARY),
        precise: Some(|a| precise::unary(a, thirty::sin)),
        spread: Some(|a, by| one(a, by, |z, by| by * (z.hi.cos().abs() + z.lo.abs() + by))),
        slice: Some(slices::SIN),
        complex: Some(|a| complex(a, Complex64::sin)),
        region: Some(|a| region(a, Region::sin)),
        derivative: Some(|a, _| Some(call("cos", a))),
        fold: Some(|a| only(a).and_then(exact_angles::sine).or_else(|| odd("sin", a))),
        ..PLAIN
    },
    Row {
        name: "cos",
        typeset: typeset::upright("cos"),
        value: |a| unary(a, f64::cos),
        accuracy: Accuracy::Measured(LIBRARY),
        precise: Some(|a| precise::unary(a, thirty::cos)),
        spread: Some(|a, by| one(a, by, |z, by| by * (z.hi.sin().abs() + z.lo.abs() + by))),
        slice: Some(slices::COS),
        complex: Some(|a| complex(a, Complex64::cos)),
        region: Some(|a| region(a, Region::cos)),
        derivative: Some(|a, _| Some(-call("sin", a))),
        fold: Some(|a| only(a).and_then(exact_angles::cosine).or_else(|| even("cos", a))),
        ..PLAIN
    },
    Row {
        name: "tan",
        typeset: typeset::upright("tan"),
        value: |a| unary(a, f64::tan),
        accuracy: Accuracy::Measured(LIBRARY),
        precise: Some(precise::tan),
        spread: Some(|a, by| {
            one(a, by, |z, by| {
                let t = z.hi.tan().abs();
                to_pole(by * (1.0 + t * t), (1.0 - 2.0 * t * (by + z.lo.abs()) - by).max(0.0).powi(2))
            })
        }),
        slice: Some(slices::TAN),
        complex: Some(|a| complex(a, Complex64::tan)),
        region: Some(|a| region(a, Region::tan)),
        derivative: Some(|a, _| Some(Expr::one() + call("tan", a).power(2))),
        fold: Some(|a| only(a).and_then(exact_angles::tangent).or_else(|| odd("tan", a))),
        ..PLAIN
    },
    Row {
        name: "asin",
        spellings: &["arcsin"],
        typeset: typeset::upright("arcsin"),
        value: |a| unary(a, f64::asin),
        accuracy: Accuracy::Measured(LIBRARY),
        precise: Some(|a| precise::unary(a, thirty::asin)),
        spread: Some(|a, by| one(a, by, |z, by| to_edge(by, to_one(z, by), 1.0 + z.hi.abs() - by))),
        slice: Some(slices::ASIN),
        complex: Some(|a| complex(a, Complex64::asin)),
        region: Some(|a| region(a, Region::asin)),
        derivative: Some(|a, _| Some((Expr::one() - first(a).power(2)).sqrt().recip())),
        fold: Some(|a| only(a).and_then(exact_angles::arcsine).or_else(|| odd("asin", a))),
        sign: Some(sign_of_argument),
        domain: Some(|a| vec![Expr::one() - first(a).power(2)]),
        ..PLAIN
    },
    Row {
        name: "acos",
        spellings: &["arccos"],
        typeset: typeset::upright("arccos"),
        value: |a| unary(a, f64::acos),
        accuracy: Accuracy::Measured(LIBRARY),
        precise: Some(|a| precise::unary(a, thirty::acos)),
        spread: Some(|a, by| one(a, by, |z, by| to_edge(by, to_one(z, by), 1.0 + z.hi.abs() - by))),
        slice: Some(slices::ACOS),
        complex: Some(|a| complex(a, Complex64::acos)),
        region: Some(|a| Region::real(FRAC_PI_2) - region(a, Region::asin)),
        derivative: Some(|a, _| Some(-(Expr::one() - first(a).power(2)).sqrt().recip())),
        fold: Some(|a| only(a).and_then(exact_angles::arccosine)),
        domain: Some(|a| vec![Expr::one() - first(a).power(2)]),
        ..PLAIN
    },
    Row {
        name: "atan",
        spellings: &["arctan"],
        typeset: typeset::upright("arctan"),
        value: |a| unary(a, f64::atan),
        accuracy: Accuracy::Measured(LIBRARY),
        precise: Some(|a| precise::unary(a, thirty::atan)),
        spread: Some(|a, by| one(a, by, |z, by| by / (1.0 + (z.hi.abs() - by).max(0.0).powi(2)))),
        slice: Some(slices::ATAN),
        complex: Some(|a| complex(a, Complex64::atan)),
        region: Some(|a| region(a, Region::atan)),
        derivative: Some(|a, _| Some((Expr::one() + first(a).power(2)).recip())),
        fold: Some(|a| only(a).and_then(exact_angles::arctangent).or_else(|| odd("atan", a))),
        sign: Some(sign_of_argument),
        ..PLAIN
    },
    Row {
        name: "sinh",
        typeset: typeset::upright("sinh"),
        value: |a| unary(a, f64::sinh),
        accuracy: Accuracy::Measured(LIBRARY),
        precise: Some(|a| precise::unary(a, thirty::sinh)),
        spread: Some(|a, by| one(a, by, |z, by| by * (z.hi.abs() + by).cosh())),
        slice: Some(slices::SINH),
        complex: Some(|a| complex(a, Complex64::sinh)),
        region: Some(|a| region(a, Region::sinh)),
        derivative: Some(|a, _| Some(call("cosh", a))),
        fold: Some(|a| odd("sinh", a)),
        sign: Some(sign_of_argument),
        ..PLAIN
    },
    Row {
        name: "cosh",
        typeset: typeset::upright("cosh"),
        value: |a| unary(a, f64::cosh),
        accuracy: Accuracy::Measured(LIBRARY),
        precise: Some(|a| precise::unary(a, thirty::cosh)),
        spread: Some(|a, by| one(a, by, |z, by| by * (z.hi.abs() + by).sinh())),
        slice: Some(slices::COSH),
        complex: Some(|a| complex(a, Complex64::cosh)),
        region: Some(|a| region(a, Region::cosh)),
        derivative: Some(|a, _| Some(call("sinh", a))),
        fold: Some(|a| even("cosh", a)),
        sign: Some(|_| Sign::Positive),
        ..PLAIN
    },
    Row {
        name: "tanh",
        typeset: typeset::upright("tanh"),
        value: |a| unary(a, f64::tanh),
        accuracy: Accuracy::Measured(2.5),
        precise: Some(|a| precise::unary(a, thirty::tanh)),
        spread: Some(|a, by| one(a, by, |z, by| by / (z.hi.abs() - by).max(0.0).cosh().powi(2))),
        slice: Some(slices::TANH),
        complex: Some(|a| complex(a, Complex64::tanh)),
        region: Some(|a| region(a, Region::tanh)),
        // Not 1/cosh², which overflows where it hardly counts.
        derivative: Some(|a, _| Some(Expr::one() - call("tanh", a).power(2))),
        fold: Some(|a| odd("tanh", a)),
        sign: Some(sign_of_argument),
        ..PLAIN
    },
    Row {
        name: "asinh",
        spellings: &["arcsinh", "arsinh"],
        typeset: typeset::upright("arsinh"),
        value: |a| unary(a, libm::asinh),
        accuracy: Accuracy::Measured(4.0),
        precise: Some(|a| precise::unary(a, thirty::asinh)),
        spread: Some(|a, by| one(a, by, |z, by| by / 1.0_f64.hypot((z.hi.abs() - by).max(0.0)))),
        slice: Some(slices::ASINH),
        complex: Some(|a| complex(a, Complex64::asinh)),
        region: Some(|a| region(a, Region::asinh)),
        derivative: Some(|a, _| Some((Expr::one() + first(a).power(2)).sqrt().recip())),
        fold: Some(|a| odd("asinh", a)),
        sign: Some(sign_of_argument),
        ..PLAIN
    },
    Row {
        name: "acosh",
        spellings: &["arccosh", "arcosh"],
        typeset: typeset::upright("arcosh"),
        value: |a| unary(a, libm::acosh),
        accuracy: Accuracy::Measured(4.0),
        precise: Some(|a| precise::unary(a, thirty::acosh)),
        spread: Some(|a, by| one(a, by, |z, by| to_edge(by, z.sub(DoubleDouble::ONE).hi * (1.0 - f64::EPSILON) - by, z.hi + 1.0 - by))),
        slice: Some(slices::ACOSH),
        complex: Some(|a| complex(a, Complex64::acosh)),
        derivative: Some(|a, _| Some((first(a).power(2) - Expr::one()).sqrt().recip())),
        fold: Some(|a| only(a).filter(|own| own.is_one()).map(|_| Expr::zero())),
        sign: Some(|_| Sign::Positive),
        domain: Some(|a| vec![first(a) - Expr::one()]),
        region: Some(|a| region(a, Region::acosh)),
        ..PLAIN
    },
    Row {
        name: "atanh",
        spellings: &["arctanh", "artanh"],
        typeset: typeset::upright("artanh"),
        value: |a| unary(a, libm::atanh),
        accuracy: Accuracy::Measured(4.0),
        precise: Some(|a| precise::unary(a, thirty::atanh)),
        spread: Some(|a, by| one(a, by, |z, by| to_pole(by, to_one(z, by) * (1.0 + z.hi.abs() - by).max(0.0)))),
        slice: Some(slices::ATANH),
        complex: Some(|a| complex(a, Complex64::atanh)),
        region: Some(|a| region(a, Region::atanh)),
        derivative: Some(|a, _| Some((Expr::one() - first(a).power(2)).recip())),
        fold: Some(|a| odd("atanh", a)),
        sign: Some(sign_of_argument),
        domain: Some(|a| vec![Expr::one() - first(a).power(2)]),
        ..PLAIN
    },
    Row {
        name: "abs",
        typeset: typeset::upright("abs").set(Setting::Absolute),
        value: |a| unary(a, f64::abs),
        accuracy: Accuracy::Exact,
        precise: Some(precise::abs),
        spread: Some(precise::largest),
        slice: Some(slices::ABS),
        derivative: Some(|a, _| Some(first(a) / call("abs", a))),
        fold: Some(|a| match a {
            [u] => match sign(u) {
                Sign::Positive | Sign::Zero => Some(u.clone()),
                Sign::Negative => Some(-u),
                Sign::Unknown => negated(u).map(|u| Expr::call("abs", [u])),
            },
            _ => None,
        }),
        sign: Some(|a| match sign(&first(a)) {
            Sign::Negative => Sign::Positive,
            known @ (Sign::Positive | Sign::Zero) => known,
            Sign::Unknown => Sign::Unknown,
        }),
        region: Some(|a| region(a, Region::abs)),
        ..PLAIN
    },
    Row {
        name: "max",
        arity: (2, 2),
        typeset: typeset::upright("max"),
        value: |a| pick(a, |u, v| u >= v),
        accuracy: Accuracy::Exact,
        precise: Some(|a| precise::extreme(a, false)),
        spread: Some(|a, by| precise::winner(a, by, false)),
        fold: Some(|a| extreme(a, false)),
        sign: Some(|a| a.iter().map(sign).find(|s| *s == Sign::Positive).unwrap_or(Sign::Unknown)),
        ..PLAIN
    },
    Row {
        name: "min",
        arity: (2, 2),
        typeset: typeset::upright("min"),
        value: |a| pick(a, |u, v| u <= v),
        accuracy: Accuracy::Exact,
        precise: Some(|a| precise::extreme(a, true)),
        spread: Some(|a, by| precise::winner(a, by, true)),
        fold: Some(|a| extreme(a, true)),
        sign: Some(|a| if a.iter().all(|u| sign(u) == Sign::Positive) { Sign::Positive } else { Sign::Unknown }),
        ..PLAIN
    },
    Row {
        name: "atan2",
        arity: (2, 2),
        typeset: typeset::upright("atan2"),
        value: |a| binary(a, f64::atan2),
        accuracy: Accuracy::Measured(LIBRARY),
        precise: Some(precise::atan2),
        spread: Some(precise::turn),
        ..PLAIN
    },
];

pub(super) fn unary(a: &[f64], f: fn(f64) -> f64) -> f64 {
    match a {
        [z] => f(*z),
        _ => f64::NAN,
    }
}

pub(super) fn binary(a: &[f64], f: fn(f64, f64) -> f64) -> f64 {
    match a {
        [u, v] => f(*u, *v),
        _ => f64::NAN,
    }
}

pub(super) fn ternary(a: &[f64], f: fn(f64, f64, f64) -> f64) -> f64 {
    match a {
        [u, v, w] => f(*u, *v, *w),
        _ => f64::NAN,
    }
}

pub(super) fn first(a: &[Expr]) -> Expr {
    a.first().cloned().unwrap_or_else(Expr::zero)
}

pub(super) fn call(name: &'static str, a: &[Expr]) -> Expr {
    Expr::call(name, a.to_vec())
}

fn complex(a: &[Complex64], f: fn(Complex64) -> Complex64) -> Complex64 {
    match a {
        [z] => f(*z),
        _ => Complex64::new(f64::NAN, f64::NAN),
    }
}

pub(super) fn region(a: &[Region], f: fn(Region) -> Region) -> Region {
    match a {
        [z] => f(*z),
        _ => Region::unknown(),
    }
}

fn pick(a: &[f64], first_wins: fn(f64, f64) -> bool) -> f64 {
    match a {
        [u, v] if u.is_nan() || v.is_nan() => f64::NAN,
        [u, v] => {
            if first_wins(*u, *v) {
                *u
            } else {
                *v
            }
        }
        _ => f64::NAN,
    }
}

fn sign_of_argument(a: &[Expr]) -> Sign {
    sign(&first(a))
}

/// The sign of ln u.
fn compare_with_one(a: &[Expr]) -> Sign {
    sign(&(first(a) - Expr::one()))
}

/// `u` itself where the argument is the inverse function of u.
fn inverse_of(name: &str, argument: &Expr) -> Option<Expr> {
    match argument.node() {
        crate::expr::Node::Function(f, inner) if f.name() == name => inner.first().cloned(),
        _ => None,
    }
}

/// The negation, where the leading term has a negative coefficient.
///
/// The leading term is the first one by what its coefficient multiplies: negation does not change that order, so of u and −u exactly one is kept.
pub(super) fn negated(u: &Expr) -> Option<Expr> {
    let terms = u.terms().into_iter().filter(|t| t.as_number().is_none()).map(|t| t.split_coefficient());
    let (coefficient, _) = terms.min_by(|(_, left), (_, right)| left.cmp(right))?;
    coefficient.is_negative().then(|| -u)
}

/// The argument of a function of one.
fn only(a: &[Expr]) -> Option<&Expr> {
    if let [u] = a { Some(u) } else { None }
}

/// f(−u) = −f(u), f(0) = 0.
pub(super) fn odd(name: &'static str, a: &[Expr]) -> Option<Expr> {
    match a {
        [u] if u.is_zero() => Some(Expr::zero()),
        [u] if u.as_number().is_some_and(Number::is_negative) => Some(-Expr::call(name, [-u])),
        [u] => negated(u).map(|u| -Expr::call(name, [u])),
        _ => None,
    }
}

/// f(−u) = f(u), f(0) = 1.
fn even(name: &'static str, a: &[Expr]) -> Option<Expr> {
    match a {
        [u] if u.is_zero() => Some(Expr::one()),
        [u] if u.as_number().is_some_and(Number::is_negative) => Some(Expr::call(name, [-u])),
        [u] => negated(u).map(|u| Expr::call(name, [u])),
        _ => None,
    }
}

/// The larger or smaller argument where the order is provable and the other one is real everywhere; else the arguments in canonical order.
fn extreme(a: &[Expr], smaller: bool) -> Option<Expr> {
    let [u, v] = a else { return None };
    let order = sign(&(u - v));
    let (kept, dropped) = if (order == Sign::Positive) == smaller { (v, u) } else { (u, v) };
    if order == Sign::Zero || (order != Sign::Unknown && is_real_everywhere(dropped)) {
        return Some(kept.clone());
    }
    let function = Function::named(if smaller { "min" } else { "max" })?;
    (v < u).then(|| Expr::function(function, vec![v.clone(), u.clone()]))
}

/// True if an expression is real and finite for all positive symbols, as far as signs show it.
fn is_real_everywhere(expr: &Expr) -> bool {
    expr.parts().all(|own| match own.node() {
        Node::Power(base, exponent) => sign(base) == Sign::Positive || exponent.as_integer().is_some_and(|n| n >= 0),
        Node::Function(function, arguments) => {
            let demands = function.row().domain.map_or_else(Vec::new, |domain| domain(arguments));
            demands.iter().all(|own| sign(own) == Sign::Positive) && !matches!(function.name(), "tan" | "gamma" | "digamma" | "polygamma")
        }
        _ => true,
    })
}
