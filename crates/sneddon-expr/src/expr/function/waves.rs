//! Rows of the functions of exponential type: Bessel and Struve functions, error functions, Dawson's and Fresnel's integrals.

use super::elementary::{binary, first, negated, odd, region, unary};
use super::precise::{pair, single};
use super::typeset::{self, Setting};
use super::{Accuracy, PLAIN, Row};
use crate::expr::{Expr, Number, Sign, sign};
use crate::num::{DoubleDouble, Region, special};

pub(super) static ROWS: &[Row] = &[
    Row {
        name: "erf",
        typeset: typeset::upright("erf"),
        value: |a| unary(a, libm::erf),
        accuracy: Accuracy::Measured(2.0),
        precise: Some(|a| single(a, special::erf_precise)),
        region: Some(|a| region(a, Region::erf)),
        derivative: Some(|a, _| Some(gaussian(a, -1))),
        fold: Some(|a| odd("erf", a)),
        sign: Some(|a| sign(&first(a))),
        ..PLAIN
    },
    Row {
        name: "erfi",
        typeset: typeset::upright("erfi"),
        value: |a| unary(a, special::erfi),
        accuracy: Accuracy::ROUNDED,
        precise: Some(|a| single(a, special::erfi_precise)),
        derivative: Some(|a, _| Some(gaussian(a, 1))),
        fold: Some(|a| odd("erfi", a)),
        sign: Some(|a| sign(&first(a))),
        region: Some(|a| region(a, Region::erfi)),
        ..PLAIN
    },
    // e^(−z²) ∫₀^z e^(t²) dt.
    Row {
        name: "dawson",
        typeset: typeset::upright("D"),
        value: |a| unary(a, special::dawson),
        accuracy: Accuracy::ROUNDED,
        precise: Some(|a| single(a, special::dawson_precise)),
        derivative: Some(|a, _| Some(Expr::one() - Expr::integer(2) * first(a) * Expr::call("dawson", a.to_vec()))),
        fold: Some(|a| odd("dawson", a)),
        sign: Some(|a| sign(&first(a))),
        region: Some(|a| region(a, Region::dawson)),
        ..PLAIN
    },
    // ∫₀^z cos(πt²/2) dt.
    Row {
        name: "fresnelc",
        typeset: typeset::upright("C"),
        value: |a| unary(a, special::fresnelc),
        accuracy: Accuracy::ROUNDED,
        precise: Some(|a| single(a, special::fresnelc_precise)),
        derivative: Some(|a, _| Some(Expr::call("cos", [half_turns(a)]))),
        fold: Some(|a| odd("fresnelc", a)),
        sign: Some(|a| sign(&first(a))),
        region: Some(|a| region(a, Region::fresnelc)),
        ..PLAIN
    },
    // ∫₀^z sin(πt²/2) dt.
    Row {
        name: "fresnels",
        typeset: typeset::upright("S"),
        value: |a| unary(a, special::fresnels),
        accuracy: Accuracy::ROUNDED,
        precise: Some(|a| single(a, special::fresnels_precise)),
        derivative: Some(|a, _| Some(Expr::call("sin", [half_turns(a)]))),
        fold: Some(|a| odd("fresnels", a)),
        sign: Some(|a| sign(&first(a))),
        region: Some(|a| region(a, Region::fresnels)),
        ..PLAIN
    },
    Row {
        name: "besselj",
        arity: (2, 2),
        typeset: typeset::upright("J").set(Setting::Indexed),
        value: |a| binary(a, special::besselj),
        accuracy: Accuracy::ROUNDED,
        precise: Some(|a| pair(a, special::besselj_precise)),
        spread: Some(|a, by| wave_spread(a, by, special::besselj)),
        region: Some(|a| of_order(a, Region::besselj)),
        derivative: Some(|a, i| bessel_derivative("besselj", a, i, -1)),
        fold: Some(|a| bessel_fold("besselj", a, -1)),
        ..PLAIN
    },
    Row {
        name: "besseli",
        arity: (2, 2),
        typeset: typeset::upright("I").set(Setting::Indexed),
        value: |a| binary(a, special::besseli),
        accuracy: Accuracy::ROUNDED,
        precise: Some(|a| pair(a, special::besseli_precise)),
        region: Some(|a| of_order(a, Region::besseli)),
        derivative: Some(|a, i| bessel_derivative("besseli", a, i, 1)),
        fold: Some(|a| bessel_fold("besseli", a, 1)),
        sign: Some(positive_order_and_argument),
        ..PLAIN
    },
    // e^(−z) I_n(z), where e^z alone would overflow.
    Row {
        name: "besseli_scaled",
        arity: (2, 2),
        typeset: typeset::upright("form"),
        value: |a| binary(a, special::besseli_scaled),
        accuracy: Accuracy::ROUNDED,
        precise: Some(|a| pair(a, special::besseli_scaled_precise)),
        sign: Some(positive_order_and_argument),
        shown: Some(|a| match a {
            [_, z] => Expr::call("exp", [-z]) * Expr::call("besseli", a.to_vec()),
            _ => Expr::zero(),
        }),
        ..PLAIN
    },
    Row {
        name: "struveh",
        arity: (2, 2),
        typeset: typeset::bold("H").set(Setting::Indexed),
        value: |a| binary(a, special::struveh),
        accuracy: Accuracy::ROUNDED,
        precise: Some(|a| pair(a, special::struveh_precise)),
        spread: Some(|a, by| wave_spread(a, by, special::struveh)),
        derivative: Some(|a, i| struve_derivative("struveh", a, i, -1)),
        fold: Some(|a| struve_fold("struveh", a)),
        region: Some(|a| of_order(a, Region::struveh)),
        ..PLAIN
    },
    Row {
        name: "struvel",
        arity: (2, 2),
        typeset: typeset::bold("L").set(Setting::Indexed),
        value: |a| binary(a, special::struvel),
        accuracy: Accuracy::ROUNDED,
        precise: Some(|a| pair(a, special::struvel_precise)),
        derivative: Some(|a, i| struve_derivative("struvel", a, i, 1)),
        fold: Some(|a| struve_fold("struvel", a)),
        sign: Some(positive_order_and_argument),
        region: Some(|a| of_order(a, Region::struvel)),
        ..PLAIN
    },
    // I_n(z) − L_n(z), which cancels as e^z grows.
    Row {
        name: "bessel_struve",
        arity: (2, 2),
        typeset: typeset::upright("form"),
        value: |a| binary(a, special::bessel_struve),
        accuracy: Accuracy::ROUNDED,
        precise: Some(|a| pair(a, special::bessel_struve_precise)),
        sign: Some(positive_order_and_argument),
        shown: Some(|a| Expr::call("besseli", a.to_vec()) - Expr::call("struvel", a.to_vec())),
        ..PLAIN
    },
];

/// A function of an order that is a number, and of z.
pub(super) fn of_order(a: &[Region], f: fn(Region, f64) -> Region) -> Region {
    match a {
        [order, z] => order.as_real().map_or_else(Region::unknown, |n| f(*z, n)),
        _ => Region::unknown(),
    }
}

/// (2/√π) e^(±z²).
fn gaussian(a: &[Expr], sign: i64) -> Expr {
    Expr::integer(2) / Expr::pi().sqrt() * Expr::call("exp", [Expr::integer(sign) * first(a).power(2)])
}

/// π z²/2.
fn half_turns(a: &[Expr]) -> Expr {
    Expr::pi() / Expr::integer(2) * first(a).power(2)
}

/// Positive where the argument is and the order is not negative.
fn positive_order_and_argument(a: &[Expr]) -> Sign {
    match a {
        [n, z] if matches!(sign(n), Sign::Positive | Sign::Zero) && sign(z) == Sign::Positive => Sign::Positive,
        _ => Sign::Unknown,
    }
}

/// J_0′ = −J_1, J_n′ = (J_(n−1) − J_(n+1))/2, and the same with + for I; n/z·J_n ∓ J_(n+1) for a symbolic order.
fn bessel_derivative(name: &'static str, a: &[Expr], position: usize, sign_of_next: i64) -> Option<Expr> {
    let [n, z] = a else { return None };
    if position != 1 {
        return None;
    }
    let next = Expr::integer(sign_of_next) * Expr::call(name, [n + Expr::one(), z.clone()]);
    match n.as_number() {
        Some(order) if order.is_zero() => Some(next),
        Some(order) if *order > Number::integer(0) => Some((Expr::call(name, [n - Expr::one(), z.clone()]) + next) / Expr::integer(2)),
        _ => Some(n / z * Expr::call(name, a.to_vec()) + next),
    }
}

/// J_(−n) = (−1)^n J_n and I_(−n) = I_n for whole n, which have the parity of n; J_0(0) = I_0(0) = 1, and 0 for every positive
/// order.
fn bessel_fold(name: &'static str, a: &[Expr], sign_of_odd: i64) -> Option<Expr> {
    match a {
        [n, z] if z.is_zero() && n.is_zero() => Some(Expr::one()),
        [n, z] if z.is_zero() && sign(n) == Sign::Positive => Some(Expr::zero()),
        [n, z] => {
            let order = n.as_integer()?;
            if order < 0 {
                let factor = if order % 2 == 0 { 1 } else { sign_of_odd };
                return Some(Expr::integer(factor) * Expr::call(name, [-n, z.clone()]));
            }
            mirrored(name, n, z, order % 2 == 0)
        }
        _ => None,
    }
}

/// f_n(−z) = ±f_n(z), if −z is the canonical form of the argument.
fn mirrored(name: &'static str, n: &Expr, z: &Expr, even: bool) -> Option<Expr> {
    let kept = match z.as_number() {
        Some(number) if number.is_negative() => -z,
        Some(_) => return None,
        None => negated(z)?,
    };
    let value = Expr::call(name, [n.clone(), kept]);
    Some(if even { value } else { -value })
}

/// H_0′ = 2/π − H_1, L_0′ = 2/π + L_1, and H_n′ = H_(n−1) − (n/z) H_n for n ≥ 1, likewise for L. The derivatives of H_(−1) and
/// L_(−1) follow from H_(−1) = 2/π − H_1 and L_(−1) = 2/π + L_1, which avoids the order −2.
fn struve_derivative(name: &'static str, a: &[Expr], position: usize, sign_of_next: i64) -> Option<Expr> {
    let [n, z] = a else { return None };
    if position != 1 {
        return None;
    }
    if n.is_zero() {
        let next = Expr::integer(sign_of_next) * Expr::call(name, [Expr::one(), z.clone()]);
        return Some(Expr::integer(2) / Expr::pi() + next);
    }
    if n.as_integer() == Some(-1) {
        let first = struve_derivative(name, &[Expr::one(), z.clone()], 1, sign_of_next)?;
        return Some(Expr::integer(sign_of_next) * first);
    }
    let order = n.as_integer().filter(|order| *order > 0)?;
    Some(Expr::call(name, [Expr::integer(order - 1), z.clone()]) - n / z * Expr::call(name, a.to_vec()))
}

/// Uses the parity of n + 1; the value at z = 0 is 2/π for the order −1, and 0 for nonnegative orders.
fn struve_fold(name: &'static str, a: &[Expr]) -> Option<Expr> {
    match a {
        [n, z] if z.is_zero() && matches!(sign(n), Sign::Positive | Sign::Zero) => Some(Expr::zero()),
        [n, z] if z.is_zero() && n.as_integer() == Some(-1) => Some(Expr::integer(2) / Expr::pi()),
        [n, z] => mirrored(name, n, z, n.as_integer()? % 2 != 0),
        _ => None,
    }
}

/// The change of J or H of order 0 or 1 with its argument, from bounds of the slope: |J₀′| = |J₁|, |J₁′| ≤ 1/2,
/// |H₀′| = |2/π − H₁| and |H₁′| = |H₀ − H₁/z| are below 1, and J₀′ and H₁′ below z/2 near 0. Other orders use differences.
fn wave_spread(arguments: &[DoubleDouble], by: &[f64], wave: fn(f64, f64) -> f64) -> f64 {
    let ([order, z], [moved, by]) = (arguments, by) else { return f64::INFINITY };
    let far = z.hi.abs() + by;
    match order.hi {
        _ if *moved != 0.0 || order.lo != 0.0 => probed(order.hi, z.hi, *moved, *by, wave),
        0.0 | 1.0 => {
            let even = wave(0.0, 0.0) == 1.0;
            let vanishes = (order.hi == 0.0) == even;
            by * if vanishes { far.min(2.0) * 0.5 } else { 1.0 }
        }
        order => probed(order, z.hi, 0.0, *by, wave),
    }
}

/// Twice the larger change, the estimate for functions without a bound of the slope.
fn probed(order: f64, z: f64, moved: f64, by: f64, wave: fn(f64, f64) -> f64) -> f64 {
    let here = wave(order, z);
    let (far, wide) = (by.max(z.abs() * f64::EPSILON), moved.max(order.abs() * f64::EPSILON));
    let along = (wave(order, z + far) - here).abs().max((wave(order, z - far) - here).abs());
    let across = if moved == 0.0 { 0.0 } else { (wave(order + wide, z) - here).abs().max((wave(order - wide, z) - here).abs()) };
    let total = 2.0 * (along + across) + 4.0 * f64::EPSILON * here.abs();
    if total.is_nan() { f64::INFINITY } else { total }
}
