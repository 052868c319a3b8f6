//! Elementary functions and constants with about 30 digits, for sums that cancel most of a double's 16 digits.
//!
//! Every function treats its argument as exact. The measured errors, in units of 2^-104 of the result, are listed in
//! `tests/symbols/precise.rs`; outside its domain a function is NaN.

mod circular;
mod constants;
mod double_exponential;
mod exponential;
mod inverse_circular;
mod logarithm;
mod power;
mod running;
mod segment;

pub use circular::{cos, sin, sin_cos, tan};
pub use constants::{E, EULER_GAMMA, LN_2, PI, ROOT_PI};
pub use double_exponential::DoubleExponential;
pub use exponential::{cosh, exp, expm1, sinh, tanh};
pub use inverse_circular::{acos, asin, atan, atan2};
pub use logarithm::{acosh, asinh, atanh, ln, ln1p};
pub use power::{pow, powi, sqrt};
pub use segment::{shifted_power, shifted_power_force};

use super::DoubleDouble;

/// value · 2^exponent; exact unless the result is subnormal or overflows.
///
/// ```
/// use sneddon_num::{DoubleDouble, precise::ldexp};
/// assert_eq!(ldexp(DoubleDouble::ONE, -1074).hi, f64::from_bits(1));
/// ```
pub fn ldexp(value: DoubleDouble, exponent: i32) -> DoubleDouble {
    if (-1000..=1000).contains(&exponent) {
        return finite(value.scale(2.0_f64.powi(exponent)));
    }
    // The first step stays in the normal range if the result does.
    let first = exponent.clamp(-1000, 1000);
    let second = (exponent - first).clamp(-1000, 1000);
    finite(value.scale(2.0_f64.powi(first)).scale(2.0_f64.powi(second)))
}

/// Mantissa and exponent: value = mantissa · 2^exponent with 1 <= |mantissa| < 2, for finite values other than 0.
pub(crate) fn frexp(value: DoubleDouble) -> (DoubleDouble, i32) {
    if value.hi.abs() < f64::MIN_POSITIVE {
        let (mantissa, exponent) = (value.scale(2.0_f64.powi(600)), -600);
        let own = exponent_of(mantissa.hi);
        return (ldexp(mantissa, -own), exponent + own);
    }
    let exponent = exponent_of(value.hi);
    (ldexp(value, -exponent), exponent)
}

/// The binary exponent of a normal number.
fn exponent_of(value: f64) -> i32 {
    ((value.to_bits() >> 52) & 0x7ff) as i32 - 1023
}

/// An overflow is an infinity without a low word.
fn finite(value: DoubleDouble) -> DoubleDouble {
    if value.hi.is_finite() { value } else { value.hi.into() }
}

/// The magnitude, and the sign to give back.
fn unsigned(x: DoubleDouble) -> (DoubleDouble, bool) {
    if x.hi < 0.0 { (x.neg(), true) } else { (x, false) }
}

fn signed(value: DoubleDouble, negative: bool) -> DoubleDouble {
    if negative { value.neg() } else { value }
}
