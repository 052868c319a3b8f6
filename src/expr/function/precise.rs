//! What the rows of elementary functions know beyond double precision: 30-digit values, and how errors of arguments grow.

use crate::num::{DoubleDouble, Precise, precise};

/// Twice the measured maximum error of `num::precise`, rounded up, in units of 2^-104; see `tests/precise.rs`.
const UNITS: f64 = 4.0;

/// The value of a function of one number, with its own error.
pub(super) fn unary(a: &[DoubleDouble], f: fn(DoubleDouble) -> DoubleDouble) -> Precise {
    match a {
        [z] => Precise::relative(f(*z), UNITS),
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

/// The bound for a function of one number, from the number and its distance; the margin covers what doubles lose of it.
pub(super) fn one(a: &[DoubleDouble], by: &[f64], bound: fn(DoubleDouble, f64) -> f64) -> f64 {
    match (a, by) {
        ([z], [distance]) => bound(*z, *distance) * 1.001,
        _ => f64::INFINITY,
    }
}

/// No more than the arguments move.
pub(super) fn largest(_: &[DoubleDouble], by: &[f64]) -> f64 {
    by.iter().copied().fold(0.0, f64::max)
}

/// change / √(room · factor), where room is what is left to the edge of the domain.
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
