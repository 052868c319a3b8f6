//! Powers and roots.

use super::exponential::exp;
use super::logarithm::ln;
use super::{frexp, ldexp};
use crate::double_double::{DoubleDouble, Precise};

/// Whole exponents up to this are products.
const LARGEST_PRODUCT: f64 = 64.0;

/// base^exponent, both exact, with its error: about |exponent · ln base| + 4 units of 2^-104 of the value.
///
/// Domain: base >= 0, or a whole exponent.
///
/// ```
/// use sneddon_num::precise::pow;
/// let root = pow(2.0.into(), 0.5.into());
/// assert!(root.value.mul(root.value).sub(2.0.into()).value().abs() < 1e-29 && root.error < 1e-29);
/// ```
pub fn pow(base: DoubleDouble, exponent: DoubleDouble) -> Precise {
    let whole = exponent.lo == 0.0 && exponent.hi.fract() == 0.0;
    if base.hi == 0.0 || !base.hi.is_finite() || !exponent.hi.is_finite() {
        let value = base.hi.powf(exponent.hi);
        return if value.is_nan() || base.hi < 0.0 { Precise::nan() } else { Precise::relative(value.into(), 0.0) };
    }
    if whole && exponent.hi.abs() <= LARGEST_PRODUCT {
        return Precise::relative(powi(base, exponent.hi as i32), 2.0 * exponent.hi.abs() + 4.0);
    }
    if base.hi < 0.0 {
        if !whole {
            return Precise::nan();
        }
        let size = pow(base.neg(), exponent);
        let odd = exponent.hi.rem_euclid(2.0) == 1.0;
        return if odd { Precise { value: size.value.neg(), ..size } } else { size };
    }
    let logarithm = exponent.mul(ln(base));
    Precise::relative(exp(logarithm), 8.0 + 6.0 * logarithm.hi.abs())
}

/// base^n by repeated squaring; error about |n| units of 2^-104 of the value.
pub fn powi(base: DoubleDouble, n: i32) -> DoubleDouble {
    if base.hi == 0.0 || !base.hi.is_finite() {
        return base.hi.powi(n).into();
    }
    // Mantissas only, so that no square leaves the range before the result does.
    let (mut square, mut shift) = frexp(base);
    let (mut value, mut exponent) = (DoubleDouble::ONE, 0_i32);
    let mut rest = n.unsigned_abs();
    while rest > 0 {
        if rest & 1 == 1 {
            let (mantissa, more) = frexp(value.mul(square));
            (value, exponent) = (mantissa, exponent.saturating_add(shift).saturating_add(more));
        }
        let (mantissa, more) = frexp(square.mul(square));
        (square, shift) = (mantissa, shift.saturating_mul(2).saturating_add(more));
        rest >>= 1;
    }
    if n < 0 { ldexp(DoubleDouble::ONE.div(value), exponent.saturating_neg()) } else { ldexp(value, exponent) }
}

/// The square root of a non-negative number of any size.
pub fn sqrt(x: DoubleDouble) -> DoubleDouble {
    if x.hi.is_finite() && x.hi > 0.0 && !(1e-250..1e250).contains(&x.hi) {
        let (mantissa, exponent) = frexp(x);
        let half = exponent.div_euclid(2);
        return ldexp(ldexp(mantissa, exponent - 2 * half).sqrt(), half);
    }
    x.sqrt()
}
