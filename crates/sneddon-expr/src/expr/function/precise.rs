//! Properties of functions beyond double precision: 30-digit values, and the propagation of errors of arguments.

use crate::num::{DoubleDouble, Precise, forms, precise};

/// Twice the measured maximum error of `num::precise`, rounded up, in units of 2^-104; see `tests/symbols/precise.rs`.
const UNITS: f64 = 4.0;

/// The value of a function of one number, with a fixed error bound.
pub(super) fn unary(a: &[DoubleDouble], f: fn(DoubleDouble) -> DoubleDouble) -> Precise {
    match a {
        [z] => Precise::relative(f(*z), UNITS),
        _ => Precise::nan(),
    }
}

/// The value of a function of one number that computes its error bound.
pub(super) fn single(a: &[DoubleDouble], f: fn(DoubleDouble) -> Precise) -> Precise {
    match a {
        [z] => f(*z),
        _ => Precise::nan(),
    }
}

/// The same for functions of two numbers.
pub(super) fn pair(a: &[DoubleDouble], f: fn(DoubleDouble, DoubleDouble) -> Precise) -> Precise {
    match a {
        [n, z] => f(*n, *z),
        _ => Precise::nan(),
    }
}

/// e^z, which underflows to a 0 that is not exact.
pub(super) fn exp(a: &[DoubleDouble]) -> Precise {
    let own = unary(a, precise::exp);
    if own.value.hi == 0.0 { Precise { error: f64::from_bits(1), ..own } } else { own }
}

/// tan z, which divides.
pub(super) fn tan(a: &[DoubleDouble]) -> Precise {
    let own = unary(a, precise::tan);
    Precise { error: 3.0 * own.error, ..own }
}

/// The angle of a point.
pub(super) fn atan2(a: &[DoubleDouble]) -> Precise {
    match a {
        [y, x] => Precise::relative(precise::atan2(*y, *x), UNITS),
        _ => Precise::nan(),
    }
}

/// |z|.
pub(super) fn abs(a: &[DoubleDouble]) -> Precise {
    match a {
        [z] => Precise { value: if z.hi < 0.0 { z.neg() } else { *z }, error: 0.0 },
        _ => Precise::nan(),
    }
}

/// The larger or the smaller of two.
pub(super) fn extreme(a: &[DoubleDouble], smaller: bool) -> Precise {
    match a {
        [u, v] if u.hi.is_nan() || v.hi.is_nan() => Precise::nan(),
        [u, v] => Precise { value: if (u.sub(*v).hi < 0.0) == smaller { *u } else { *v }, error: 0.0 },
        _ => Precise::nan(),
    }
}

/// The bound for a function of one number, from the number and its distance; the margin covers rounding errors.
pub(super) fn one(a: &[DoubleDouble], by: &[f64], bound: fn(DoubleDouble, f64) -> f64) -> f64 {
    match (a, by) {
        ([z], [distance]) => bound(*z, *distance) * 1.001,
        _ => f64::INFINITY,
    }
}

/// The value moves by no more than the arguments.
pub(super) fn largest(_: &[DoubleDouble], by: &[f64]) -> f64 {
    by.iter().copied().fold(0.0, f64::max)
}

/// The value moves by no more than the selected argument, or the larger movement if either may be selected.
pub(super) fn winner(a: &[DoubleDouble], by: &[f64], smaller: bool) -> f64 {
    let ([u, v], [along_u, along_v]) = (a, by) else { return f64::INFINITY };
    let lead = if smaller { v.sub(*u).hi } else { u.sub(*v).hi };
    let doubt = (along_u + along_v) * (1.0 + 4.0 * f64::EPSILON);
    match lead {
        lead if lead > doubt => *along_u,
        lead if lead < -doubt => *along_v,
        _ => along_u.max(*along_v),
    }
}

/// change / √(room · factor), where room is the remaining distance to the edge of the domain.
pub(super) fn to_edge(change: f64, room: f64, factor: f64) -> f64 {
    if room > 0.0 { change / (room * factor).sqrt() } else { f64::INFINITY }
}

/// change / room.
pub(super) fn to_pole(change: f64, room: f64) -> f64 {
    if room > 0.0 { change / room } else { f64::INFINITY }
}

/// The angle of (x, y) turns by at most the distance over the radius.
pub(super) fn turn(a: &[DoubleDouble], by: &[f64]) -> f64 {
    let ([y, x], [along_y, along_x]) = (a, by) else { return f64::INFINITY };
    let radius = y.hi.hypot(x.hi) * (1.0 - 4.0 * f64::EPSILON) - along_x - along_y;
    let across = (x.hi.abs() + along_x) * along_y + (y.hi.abs() + along_y) * along_x;
    to_pole(to_pole(across * (1.0 + 16.0 * f64::EPSILON), radius), radius)
}

/// 1 − |z|, which keeps its digits next to the ends.
pub(super) fn to_one(z: DoubleDouble, by: f64) -> f64 {
    let z = if z.hi < 0.0 { z.neg() } else { z };
    DoubleDouble::ONE.sub(z).hi * (1.0 - f64::EPSILON) - by
}

/// The order of a segment function, where it is one.
pub(super) fn order(k: f64) -> Option<u32> {
    (k.fract() == 0.0 && (0.0..=400.0).contains(&k)).then_some(k as u32)
}

/// An integral over a segment: order, lower end, perhaps upper end, radius.
type Segment = fn(u32, DoubleDouble, Option<DoubleDouble>, DoubleDouble) -> Precise;

/// The value of such an integral.
pub(super) fn segment(a: &[DoubleDouble], f: Segment) -> Precise {
    let (k, b, c, x) = match a {
        [k, b, x] => (k, b, None, x),
        [k, b, c, x] => (k, b, Some(*c), x),
        _ => return Precise::nan(),
    };
    order(k.hi).map_or(Precise::nan(), |k| f(k, *b, c, *x))
}

/// The distance of the ends, relative to the radius, below which doubles do not suffice for the slopes of such an integral.
const NEAR: f64 = 1e-8;

/// The change of such an integral T: T_b = −k T of order k − 1, T_c from the integrand, T_x because T is homogeneous.
///
/// Returns infinity if the distance between the ends is as small as the changes of the ends.
pub(super) fn segment_spread(a: &[DoubleDouble], by: &[f64], force: bool) -> f64 {
    let (k, b, c, x, by_b, by_c, by_x) = match (a, by) {
        ([k, b, x], [_, by_b, by_x]) => (k.hi, *b, None, *x, *by_b, 0.0, *by_x),
        ([k, b, c, x], [_, by_b, by_c, by_x]) => (k.hi, *b, Some(*c), *x, *by_b, *by_c, *by_x),
        _ => return f64::INFINITY,
    };
    let Some(order) = order(k) else { return f64::INFINITY };
    let inner = c.filter(|c| c.sub(x).hi < 0.0);
    let room = match inner {
        Some(c) => c.sub(b).hi.min(x.sub(c).hi),
        None => x.sub(b).hi,
    };
    if 10.0 * (k + 1.0) * (by_b + by_c + by_x) >= room {
        return f64::INFINITY;
    }
    // The ends as doubles may be the same number.
    let is_near = room < NEAR * x.hi;
    let value = |order: u32| match (is_near, force) {
        (true, false) => precise::shifted_power(order, b, inner, x).value.hi,
        (true, true) => precise::shifted_power_force(order, b, inner, x).value.hi,
        (false, false) => forms::shifted_power(order, b.hi, inner.map_or(f64::INFINITY, |c| c.hi), x.hi),
        (false, true) => forms::shifted_power_force(order, b.hi, inner.map_or(f64::INFINITY, |c| c.hi), x.hi),
    };
    let end = |e: DoubleDouble| {
        let weight = if force { e.hi * e.hi } else { 1.0 };
        weight / (x.sub(e).hi * (x.hi + e.hi)).sqrt()
    };
    let along_b = order.checked_sub(1).map_or_else(|| end(b), |lower| k * value(lower));
    let along_c = inner.map_or(0.0, |c| c.sub(b).hi.powf(k) * end(c));
    let degree = if force { k + 2.0 } else { k };
    let along_x = (degree * value(order) + b.hi * along_b + inner.map_or(0.0, |c| c.hi) * along_c) / x.hi;
    2.0 * (along_b * by_b + along_c * by_c + along_x * by_x)
}
