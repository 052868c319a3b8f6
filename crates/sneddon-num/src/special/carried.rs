//! Arithmetic of double-double values that carry an absolute error bound, and the sums that waves are made of.

use crate::double_double::{DoubleDouble, Precise, two_prod, two_sum};
use crate::work;

/// Bound on the relative error of one operation.
pub(super) const UNIT: f64 = 1.0 / (1_u128 << 104) as f64;
/// The largest error of an underflow.
pub(super) const TINY: f64 = 1e-320;
/// Steps of work for a term of a series.
const STEPS_PER_TERM: u64 = 3;
/// 2/π.
pub(super) const TWO_OVER_PI: DoubleDouble = DoubleDouble { hi: std::f64::consts::FRAC_2_PI, lo: -3.935_735_335_036_497e-17 };

/// A value without error.
pub(super) fn exact(value: impl Into<DoubleDouble>) -> Precise {
    Precise { value: value.into(), error: 0.0 }
}

/// A value known to some units of 2^-104.
pub(super) fn known(value: DoubleDouble, units: f64) -> Precise {
    Precise { value, error: units * value.hi.abs() * UNIT + TINY }
}

/// a + b.
pub(super) fn plus(a: Precise, b: Precise) -> Precise {
    let value = a.value.add(b.value);
    Precise { value, error: a.error + b.error + value.hi.abs() * UNIT }
}

/// a − b.
pub(super) fn minus(a: Precise, b: Precise) -> Precise {
    plus(a, opposite(b))
}

/// −a.
pub(super) fn opposite(a: Precise) -> Precise {
    Precise { value: a.value.neg(), error: a.error }
}

/// a·b.
pub(super) fn times(a: Precise, b: Precise) -> Precise {
    let value = a.value.mul(b.value);
    let carried = a.value.hi.abs() * b.error + b.value.hi.abs() * a.error + a.error * b.error;
    Precise { value, error: carried + 2.0 * value.hi.abs() * UNIT + TINY }
}

/// a/b; nothing is known where b may be 0.
pub(super) fn over(a: Precise, b: Precise) -> Precise {
    let value = a.value.div(b.value);
    let least = b.value.hi.abs() * (1.0 - f64::EPSILON) - b.error;
    let carried = if least > 0.0 { (a.error + value.hi.abs() * b.error) / least } else { f64::INFINITY };
    Precise { value, error: carried + 3.0 * value.hi.abs() * UNIT + TINY }
}

/// √a for a > 0.
pub(super) fn root(a: Precise) -> Precise {
    let value = a.value.sqrt();
    Precise { value, error: a.error / value.hi + 2.0 * value.hi * UNIT + TINY }
}

/// e^x · factor, also where e^x alone would overflow.
pub(super) fn exponential(x: Precise, factor: Precise) -> Precise {
    if x.value.hi < -1500.0 {
        return Precise { value: 0.0.into(), error: TINY };
    }
    if x.value.hi > 1500.0 {
        return Precise { value: f64::INFINITY.copysign(factor.value.hi).into(), error: f64::INFINITY };
    }
    // In two halves, the second moved towards 1, so that no word is lost on the way.
    let half = crate::precise::exp(x.value.scale(0.5));
    let shift = if x.value.hi > 0.0 { 2.0_f64.powi(-500) } else { 2.0_f64.powi(500) };
    let product = factor.value.mul(half).mul(half.scale(shift));
    let value = product.scale(shift.recip());
    if !value.hi.is_finite() {
        return Precise { value: value.hi.into(), error: f64::INFINITY };
    }
    let own = if factor.value.hi == 0.0 { 0.0 } else { factor.error / factor.value.hi.abs() };
    Precise { value, error: value.hi.abs() * (own + 1.01 * x.error + 24.0 * UNIT) + TINY }
}

/// a/b for a divisor of one word.
pub(super) fn quotient(a: DoubleDouble, b: f64) -> DoubleDouble {
    let first = a.hi / b;
    let product = two_prod(first, b);
    let second = (((a.hi - product.hi) - product.lo) + a.lo) / b;
    let hi = first + second;
    DoubleDouble { hi, lo: second - (hi - first) }
}

/// a·b for a factor of one word.
pub(super) fn multiple(a: DoubleDouble, b: f64) -> DoubleDouble {
    let product = two_prod(a.hi, b);
    let rest = product.lo + a.lo * b;
    let hi = product.hi + rest;
    DoubleDouble { hi, lo: rest - (hi - product.hi) }
}

/// n + k, as exact as the two words of n allow.
pub(super) fn shifted(n: DoubleDouble, k: f64) -> DoubleDouble {
    let head = two_sum(n.hi, k);
    if n.lo == 0.0 { head } else { head.add(n.lo.into()) }
}

/// Σ s^k / ((a)_k (b)_k), the series of Bessel and Struve functions.
pub(super) fn series(s: DoubleDouble, a: f64, b: DoubleDouble) -> Precise {
    let (mut sum, mut term) = (DoubleDouble::ONE, DoubleDouble::ONE);
    let (mut size, mut units) = (1.0, 0.0);
    for index in 0..6000_u32 {
        let k = f64::from(index);
        let divisor = shifted(b, k).mul((a + k).into());
        term = term.mul(s);
        term = if divisor.lo == 0.0 { quotient(term, divisor.hi) } else { term.div(divisor) };
        sum = sum.add(term);
        let now = term.hi.abs();
        size += now;
        units += now * 6.0 * (k + 1.0) + sum.hi.abs();
        if now < size * UNIT / 512.0 && s.hi.abs() < 0.3 * divisor.hi.abs() {
            work::spend(STEPS_PER_TERM * u64::from(index));
            return Precise { value: sum, error: UNIT * units + 2.0 * now };
        }
    }
    Precise::nan()
}

/// Whether a double of the value would miss its last digits, as next to a zero.
pub(super) fn is_short(value: Precise) -> bool {
    value.error > 0.05 * f64::EPSILON * value.value.hi.abs()
}

/// The nearest double if it is within 1.1 units in the last place, else NaN.
pub(super) fn rounded(value: Precise) -> f64 {
    let nearest = value.value.value();
    if value.error <= 0.55 * f64::EPSILON * nearest.abs() + 100.0 * TINY { nearest } else { f64::NAN }
}
