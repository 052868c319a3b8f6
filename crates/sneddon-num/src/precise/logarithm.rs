//! Logarithms and inverse hyperbolic functions.

use super::constants::LN_2;
use super::exponential::expm1;
use super::{frexp, signed, unsigned};
use crate::double_double::DoubleDouble;

/// Beyond this 1/x² is below 2^-120, and below its reciprocal x² is.
const FAR: f64 = (1_u64 << 60) as f64;

/// The natural logarithm; with its relative error next to 1 too.
///
/// ```
/// use sneddon_num::precise::{LN_2, ln};
/// assert!(ln(2.0.into()).sub(LN_2).value().abs() < 1e-31);
/// ```
pub fn ln(x: DoubleDouble) -> DoubleDouble {
    if x.hi.is_nan() || x.hi <= 0.0 || x.hi.is_infinite() {
        return x.hi.ln().into();
    }
    let (mut mantissa, mut exponent) = frexp(x);
    if mantissa.hi > std::f64::consts::SQRT_2 {
        mantissa = mantissa.scale(0.5);
        exponent += 1;
    }
    let near = ln_near_one(mantissa.sub(DoubleDouble::ONE));
    if exponent == 0 { near } else { LN_2.mul(f64::from(exponent).into()).add(near) }
}

/// ln(1 + x), with its relative error near 0 too.
pub fn ln1p(x: DoubleDouble) -> DoubleDouble {
    if (-0.29..0.41).contains(&x.hi) { ln_near_one(x) } else { ln(x.add(DoubleDouble::ONE)) }
}

/// The inverse of sinh.
pub fn asinh(x: DoubleDouble) -> DoubleDouble {
    let (x, negative) = unsigned(x);
    let value = if x.hi < 1.0 / FAR {
        x
    } else if x.hi > FAR {
        ln(x).add(LN_2)
    } else {
        let square = x.mul(x);
        ln1p(x.add(square.div(DoubleDouble::ONE.add(DoubleDouble::ONE.add(square).sqrt()))))
    };
    signed(value, negative)
}

/// The inverse of cosh for x >= 1.
pub fn acosh(x: DoubleDouble) -> DoubleDouble {
    if x.hi > FAR {
        return ln(x).add(LN_2);
    }
    let beyond = x.sub(DoubleDouble::ONE);
    if beyond.hi.is_nan() || beyond.hi < 0.0 {
        return f64::NAN.into();
    }
    ln1p(beyond.add(beyond.mul(beyond.add(2.0.into())).sqrt()))
}

/// The inverse of tanh for |x| < 1; infinite at ±1.
pub fn atanh(x: DoubleDouble) -> DoubleDouble {
    let (x, negative) = unsigned(x);
    let rest = DoubleDouble::ONE.sub(x);
    let value = if x.hi < 1.0 / FAR {
        x
    } else if rest.hi == 0.0 {
        f64::INFINITY.into()
    } else if rest.hi > 0.0 {
        ln1p(x.scale(2.0).div(rest)).scale(0.5)
    } else {
        f64::NAN.into()
    };
    signed(value, negative)
}

/// ln(1 + t) for −0.3 < t < 0.42: one step of second order from the double value.
fn ln_near_one(t: DoubleDouble) -> DoubleDouble {
    if t.hi.abs() < 2.0_f64.powi(-110) {
        return t;
    }
    let start = DoubleDouble::from(t.hi.ln_1p());
    let reached = expm1(start);
    let step = t.sub(reached).div(reached.add(DoubleDouble::ONE));
    start.add(step.sub((0.5 * step.hi * step.hi).into()))
}
