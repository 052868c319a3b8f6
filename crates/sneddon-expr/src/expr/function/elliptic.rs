//! Rows of the elliptic integrals, in the parameter m = k² as in mpmath.

use super::elementary::{binary, first, region, ternary, unary};
use super::typeset::{self, Setting};
use super::{Accuracy, PLAIN, Row};
use crate::expr::{Expr, Sign, sign};
use crate::num::{DoubleDouble, Precise, Region, special};

pub(super) static ROWS: &[Row] = &[
    Row {
        name: "elliprf",
        arity: (3, 3),
        typeset: typeset::upright("R").with_index("F"),
        value: |a| ternary(a, special::rf),
        accuracy: Accuracy::Measured(8.0),
        precise: Some(|a| <[DoubleDouble; 3]>::try_from(a).map_or_else(|_| Precise::nan(), special::rf_precise)),
        derivative: Some(|a, i| match (a, i) {
            ([x, y, z], 0) | ([y, x, z], 1) | ([y, z, x], 2) => Some(-elliprd(y, z, x) / Expr::integer(6)),
            _ => None,
        }),
        sign: Some(|_| Sign::Positive),
        region: Some(|a| <[Region; 3]>::try_from(a).map_or_else(|_| Region::unknown(), |[x, y, z]| Region::elliprf(x, y, z))),
        ..PLAIN
    },
    Row {
        name: "elliprd",
        arity: (3, 3),
        typeset: typeset::upright("R").with_index("D"),
        value: |a| ternary(a, special::rd),
        accuracy: Accuracy::Measured(11.0),
        precise: Some(|a| <[DoubleDouble; 3]>::try_from(a).map_or_else(|_| Precise::nan(), special::rd_precise)),
        derivative: Some(elliprd_derivative),
        sign: Some(|_| Sign::Positive),
        region: Some(|a| <[Region; 3]>::try_from(a).map_or_else(|_| Region::unknown(), |[x, y, z]| Region::elliprd(x, y, z))),
        ..PLAIN
    },
    Row {
        name: "elliprj",
        arity: (4, 4),
        typeset: typeset::upright("R").with_index("J"),
        value: |a| match a {
            [x, y, z, p] => special::rj(*x, *y, *z, *p),
            _ => f64::NAN,
        },
        accuracy: Accuracy::Measured(8.0),
        sign: Some(|_| Sign::Positive),
        ..PLAIN
    },
    Row {
        name: "elliprc",
        arity: (2, 2),
        typeset: typeset::upright("R").with_index("C"),
        value: |a| binary(a, special::rc),
        accuracy: Accuracy::Measured(6.0),
        precise: Some(|a| <[DoubleDouble; 2]>::try_from(a).map_or_else(|_| Precise::nan(), special::rc_precise)),
        derivative: Some(elliprc_derivative),
        fold: Some(|a| match a {
            [x, y] if x == y => Some(x.sqrt().recip()),
            [x, y] if x.is_zero() => Some(Expr::pi() / (Expr::integer(2) * y.sqrt())),
            _ => None,
        }),
        sign: Some(|_| Sign::Positive),
        region: Some(|a| <[Region; 2]>::try_from(a).map_or_else(|_| Region::unknown(), |[x, y]| Region::elliprf(x, y, y))),
        ..PLAIN
    },
    Row {
        name: "ellipk",
        typeset: typeset::upright("K"),
        value: |a| unary(a, special::ellipk),
        accuracy: Accuracy::Measured(6.0),
        precise: Some(|a| match a {
            [m] => special::ellipk_precise(*m),
            _ => Precise::nan(),
        }),
        derivative: Some(|a, _| {
            let m = first(a);
            let rest = Expr::one() - &m;
            Some((call("ellipe", &[&m]) - &rest * call("ellipk", &[&m])) / (Expr::integer(2) * m * rest))
        }),
        domain: Some(|a| vec![Expr::one() - first(a)]),
        fold: Some(|a| first(a).is_zero().then(|| Expr::pi() / Expr::integer(2))),
        sign: Some(|_| Sign::Positive),
        region: Some(|a| region(a, Region::ellipk)),
        ..PLAIN
    },
    Row {
        name: "ellipf",
        arity: (2, 2),
        typeset: typeset::upright("F").set(Setting::Parameter),
        value: |a| binary(a, special::ellipf),
        accuracy: Accuracy::Measured(8.0),
        precise: Some(|a| match a {
            [phi, m] => special::ellipf_precise(*phi, *m),
            _ => Precise::nan(),
        }),
        derivative: Some(first_kind_derivative),
        fold: Some(|a| match a {
            [phi, m] if phi.is_zero() || m.is_zero() => Some(phi.clone()),
            _ => None,
        }),
        sign: Some(|a| sign(&first(a))),
        ..PLAIN
    },
    Row {
        name: "ellipe",
        arity: (1, 2),
        typeset: typeset::upright("E").set(Setting::Parameter),
        value: |a| match a {
            [m] => special::ellipe(*m),
            [phi, m] => special::ellipe_inc(*phi, *m),
            _ => f64::NAN,
        },
        accuracy: Accuracy::Measured(9.0),
        precise: Some(|a| match a {
            [m] => special::ellipe_precise(*m),
            [phi, m] => special::ellipe_inc_precise(*phi, *m),
            _ => Precise::nan(),
        }),
        derivative: Some(second_kind_derivative),
        fold: Some(|a| match a {
            [m] if m.is_zero() => Some(Expr::pi() / Expr::integer(2)),
            [m] if m.is_one() => Some(Expr::one()),
            [phi, m] if phi.is_zero() || m.is_zero() => Some(phi.clone()),
            _ => None,
        }),
        sign: Some(|a| match a {
            [phi, _] => sign(phi),
            _ => Sign::Positive,
        }),
        domain: Some(|a| match a {
            [m] => vec![Expr::one() - m],
            _ => Vec::new(),
        }),
        region: Some(|a| match a {
            [m] => m.ellipe(),
            _ => Region::unknown(),
        }),
        ..PLAIN
    },
];

fn call(name: &'static str, arguments: &[&Expr]) -> Expr {
    Expr::call(name, arguments.iter().map(|u| (*u).clone()))
}

fn elliprd(x: &Expr, y: &Expr, z: &Expr) -> Expr {
    call("elliprd", &[x, y, z])
}

/// √(1 − m sin²φ).
fn delta(phi: &Expr, m: &Expr) -> Expr {
    (Expr::one() - m * call("sin", &[phi]).power(2)).sqrt()
}

/// DLMF 19.4.6, and the integrand.
fn first_kind_derivative(a: &[Expr], position: usize) -> Option<Expr> {
    let [phi, m] = a else { return None };
    if position == 0 {
        return Some(delta(phi, m).recip());
    }
    let (two, rest) = (Expr::integer(2), Expr::one() - m);
    let ends = call("sin", &[phi]) * call("cos", &[phi]) / (&two * &rest * delta(phi, m));
    Some(call("ellipe", &[phi, m]) / (&two * m * rest) - call("ellipf", &[phi, m]) / (two * m) - ends)
}

/// DLMF 19.4.2 and 19.4.7, and the integrand.
fn second_kind_derivative(a: &[Expr], position: usize) -> Option<Expr> {
    match (a, position) {
        ([m], 0) => Some((call("ellipe", &[m]) - call("ellipk", &[m])) / (Expr::integer(2) * m)),
        ([phi, m], 0) => Some(delta(phi, m)),
        ([phi, m], 1) => Some((call("ellipe", &[phi, m]) - call("ellipf", &[phi, m])) / (Expr::integer(2) * m)),
        _ => None,
    }
}

/// From 1/((t+x)(t+y)) in partial fractions: both have the factor 1/(2(y − x)).
fn elliprc_derivative(a: &[Expr], position: usize) -> Option<Expr> {
    let [x, y] = a else { return None };
    let own = call("elliprc", &[x, y]);
    let bracket = if position == 0 { own - x.sqrt().recip() } else { x.sqrt() / y - own };
    Some(bracket / (Expr::integer(2) * (y - x)))
}

/// By partial fractions for x and y, by homogeneity of degree −3/2 for z.
fn elliprd_derivative(a: &[Expr], position: usize) -> Option<Expr> {
    let [x, y, z] = a else { return None };
    let by_first = |x: &Expr, y: &Expr| (elliprd(x, y, z) - elliprd(y, z, x)) / (Expr::integer(2) * (z - x));
    match position {
        0 => Some(by_first(x, y)),
        1 => Some(by_first(y, x)),
        _ => Some(-(Expr::ratio(3, 2) * elliprd(x, y, z) + x * by_first(x, y) + y * by_first(y, x)) / z),
    }
}
