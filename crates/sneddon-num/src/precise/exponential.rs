//! Exponential and hyperbolic functions.

use super::constants::{INVERSE_FACTORIAL, LN_2_HEAD, LN_2_REST};
use super::{finite, ldexp, signed, unsigned};
use crate::double_double::{DoubleDouble, two_sum};

/// The argument is divided by 2^HALVINGS for the series, and the result squared as often.
const HALVINGS: i32 = 8;
/// Below this, expm1 needs no reduction.
const NEAR: f64 = 0.35;
/// Beyond this e^-2x is below 2^-115.
const FAR: f64 = 40.0;

/// e^x.
///
/// ```
/// use sneddon_num::precise::{E, exp};
/// let difference = exp(1.0.into()).sub(E);
/// assert!(difference.value().abs() < 1e-30);
/// ```
pub fn exp(x: DoubleDouble) -> DoubleDouble {
    if x.hi.is_nan() || x.hi > 710.0 {
        return (x.hi + f64::INFINITY).into();
    }
    if x.hi < -746.0 {
        return 0.0.into();
    }
    let (mantissa, exponent) = parts(x);
    ldexp(mantissa, exponent)
}

/// e^x − 1, with its relative error near 0 too.
pub fn expm1(x: DoubleDouble) -> DoubleDouble {
    if x.hi.abs() < NEAR { near_one(x) } else { finite(exp(x).sub(DoubleDouble::ONE)) }
}

/// (e^x − e^−x)/2, with its relative error near 0 too.
pub fn sinh(x: DoubleDouble) -> DoubleDouble {
    let (x, negative) = unsigned(x);
    let value = if x.hi < NEAR {
        let p = near_one(x);
        p.add(p.div(p.add(DoubleDouble::ONE))).scale(0.5)
    } else if x.hi < FAR {
        let e = exp(x);
        e.sub(DoubleDouble::ONE.div(e)).scale(0.5)
    } else {
        half_exp(x)
    };
    signed(value, negative)
}

/// (e^x + e^−x)/2.
pub fn cosh(x: DoubleDouble) -> DoubleDouble {
    let (x, _) = unsigned(x);
    if x.hi < FAR {
        let e = exp(x);
        return e.add(DoubleDouble::ONE.div(e)).scale(0.5);
    }
    half_exp(x)
}

/// sinh x / cosh x.
pub fn tanh(x: DoubleDouble) -> DoubleDouble {
    let (x, negative) = unsigned(x);
    let value = if x.hi < FAR {
        let p = expm1(x.scale(2.0));
        p.div(p.add(2.0.into()))
    } else if x.hi.is_nan() {
        x
    } else {
        DoubleDouble::ONE
    };
    signed(value, negative)
}

/// e^x/2 without an overflow before the halving.
fn half_exp(x: DoubleDouble) -> DoubleDouble {
    if x.hi.is_nan() || x.hi > 712.0 {
        return (x.hi + f64::INFINITY).into();
    }
    let (mantissa, exponent) = parts(x);
    ldexp(mantissa, exponent - 1)
}

/// e^x = mantissa · 2^exponent, mantissa between 0.7 and 1.42.
fn parts(x: DoubleDouble) -> (DoubleDouble, i32) {
    let k = (x.hi * std::f64::consts::LOG2_E).round();
    // k times the head is exact, and so is the difference.
    let rest = two_sum(x.hi, -(k * LN_2_HEAD)).add(x.lo.into()).sub(LN_2_REST.mul(k.into()));
    (near_one(rest).add(DoubleDouble::ONE), k as i32)
}

/// e^r − 1 for |r| < 0.36: series of e^(r/256) − 1, then e^(2s) − 1 = 2p + p² eight times.
fn near_one(r: DoubleDouble) -> DoubleDouble {
    if r.hi.abs() < 2.0_f64.powi(-110) {
        return r;
    }
    let s = r.scale(2.0_f64.powi(-HALVINGS));
    // Terms from s⁶ on count less than 2^-56 of the first.
    let [_, _, second, third, fourth, fifth, sixth, seventh, eighth, ninth, tenth, ..] = INVERSE_FACTORIAL;
    let t = s.hi;
    let tail = sixth.hi + t * (seventh.hi + t * (eighth.hi + t * (ninth.hi + t * tenth.hi)));
    let mut sum = fifth.add((t * tail).into());
    for coefficient in [fourth, third, second] {
        sum = sum.mul(s).add(coefficient);
    }
    let mut p = s.add(s.mul(s).mul(sum));
    for _ in 0..HALVINGS {
        p = p.scale(2.0).add(p.mul(p));
    }
    p
}
