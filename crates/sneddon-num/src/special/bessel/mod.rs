//! Bessel functions of the first kind, ordinary and modified, of real order.

pub(crate) mod backward;
pub(crate) mod fixed_point;
pub(crate) mod hankel;
pub(crate) mod leading;
pub mod struve;
pub(crate) mod taylor;

use super::carried::{TINY, UNIT, exact, exponential, is_short, minus, opposite, over, rounded, series, times};
use crate::double_double::{DoubleDouble, Precise};
use crate::special::bessel::backward::backward;
use crate::special::bessel::fixed_point::exact_series;
use crate::special::bessel::hankel::{growing, oscillating};
use crate::special::bessel::leading::bessel_leading;

/// From here on Hankel's series has 30 digits.
const FAR: f64 = 40.0;
/// Up to here the backward recurrence, as long as z, is affordable.
const DOWNWARDS: f64 = 3000.0;
/// Orders beyond this are not computed unless they vanish by underflow.
const HIGHEST: f64 = 1e4;

/// `J_n(z) = Σ (-1)^k (z/2)^(n+2k) / (k! Gamma(n+k+1))`.
///
/// Domain: real `n > -1` with `z >= 0`; whole `n` of any sign with any `z`; `|n| <= 10^4`, or larger where `J_n` is 0
/// by underflow; NaN elsewhere.
///
/// Accuracy: the 30-digit value rounded, next to the zeros by a series in whole numbers: at most 0.51 ulp measured.
///
/// ```
/// use sneddon_num::special::besselj;
/// assert_eq!(besselj(0.0, 0.0), 1.0);
/// assert!((besselj(0.5, 2.0) - (1.0 / std::f64::consts::PI).sqrt() * 2.0_f64.sin()).abs() < 1e-16);
/// ```
pub fn besselj(n: f64, z: f64) -> f64 {
    if z.is_infinite() && n.is_finite() {
        return if z > 0.0 || n == n.trunc() { 0.0 } else { f64::NAN };
    }
    let value = besselj_precise(n.into(), z.into());
    if is_short(value)
        && let Some((order, argument, negative)) = reflected(n.into(), z.into(), true)
        && let Some(sum) = exact_series(argument.hi, 1.0, order.hi + 1.0)
    {
        let near_zero = bessel_leading(order, argument.scale(0.5)).value.mul(sum).value();
        return if negative { -near_zero } else { near_zero };
    }
    rounded(value)
}

/// `J_n(z)` to about 28 digits of the amplitude, with its error.
///
/// Method: power series for `z^2/4 <= n + 1`, Hankel's expansion for `z > 40` and `n^2 <= 2 z`, Miller's backward
/// recurrence elsewhere, and the recurrence upwards beyond `z = 3000`. Source: DLMF 10.2.2, 10.17.3, 3.6(v).
///
/// ```
/// let wave = sneddon_num::special::besselj_precise(0.0.into(), 1.0.into());
/// assert!(wave.value.hi == 0.765_197_686_557_966_6 && wave.error < 1e-28);
/// assert!((wave.value.lo + 5.394_209_422_798_62e-17).abs() < 1e-30);
/// ```
pub fn besselj_precise(n: DoubleDouble, z: DoubleDouble) -> Precise {
    match reflected(n, z, true) {
        Some((order, argument, negative)) => {
            let value = ordinary(order, argument);
            if negative { opposite(value) } else { value }
        }
        None => Precise::nan(),
    }
}

/// `I_n(z) = Σ (z/2)^(n+2k) / (k! Gamma(n+k+1))`.
///
/// Domain: real `n > -1` with `z >= 0`; whole `n` of any sign with any `z`; infinite beyond `z = 713`; NaN elsewhere
/// and for `z > 1500` with `n^2 > 20 z`.
///
/// Accuracy: the 30-digit value rounded, at most 0.51 ulp measured. Source: DLMF 10.25.2, 10.40.1.
///
/// ```
/// use sneddon_num::special::besseli;
/// assert_eq!(besseli(0.0, 0.0), 1.0);
/// assert!((besseli(0.5, 2.0) - (1.0 / std::f64::consts::PI).sqrt() * 2.0_f64.sinh()).abs() < 1e-15);
/// ```
pub fn besseli(n: f64, z: f64) -> f64 {
    if z.abs() == f64::INFINITY && n.is_finite() && (z > 0.0 || n == n.trunc()) {
        return if z < 0.0 && n.rem_euclid(2.0) == 1.0 { z } else { z.abs() };
    }
    finished(besseli_precise(n.into(), z.into()))
}

/// `I_n(z)` to about 29 digits, with its error; infinite if a double overflows.
///
/// ```
/// let value = sneddon_num::special::besseli_precise(1.0.into(), 2.0.into());
/// assert!(value.value.hi == 1.590_636_854_637_329 && value.error < 1e-28);
/// ```
pub fn besseli_precise(n: DoubleDouble, z: DoubleDouble) -> Precise {
    modified(n, z, false)
}

/// `e^(-z) I_n(z)`, which neither over- nor underflows.
///
/// Domain: `z >= 0` and otherwise as [`besseli`]. Accuracy: at most 0.51 ulp measured.
///
/// ```
/// use sneddon_num::special::besseli_scaled;
/// assert!((besseli_scaled(0.0, 1e6) - 3.989_423_302_692_458e-4).abs() < 1e-18);
/// ```
pub fn besseli_scaled(n: f64, z: f64) -> f64 {
    if z == f64::INFINITY && n.is_finite() {
        return 0.0;
    }
    finished(besseli_scaled_precise(n.into(), z.into()))
}

/// `e^(-z) I_n(z)` to about 29 digits, with its error.
///
/// ```
/// let value = sneddon_num::special::besseli_scaled_precise(0.0.into(), 1e300.into());
/// assert!((value.value.hi - 3.989_422_804_014_327e-151).abs() < 1e-166);
/// ```
pub fn besseli_scaled_precise(n: DoubleDouble, z: DoubleDouble) -> Precise {
    if z.hi < 0.0 { Precise::nan() } else { modified(n, z, true) }
}

/// The nearest double, or the infinity of an overflow.
fn finished(value: Precise) -> f64 {
    if value.value.hi.is_infinite() { value.value.hi } else { rounded(value) }
}

/// Equivalent order and argument for which the series applies directly, and whether the sign changes.
fn reflected(n: DoubleDouble, z: DoubleDouble, alternating: bool) -> Option<(DoubleDouble, DoubleDouble, bool)> {
    if !(n.hi.is_finite() && z.hi.is_finite()) {
        return None;
    }
    let whole = n.lo == 0.0 && n.hi == n.hi.trunc();
    if !whole {
        return (z.hi >= 0.0 && n.hi > -1.0 && n.hi < HIGHEST).then_some((n, z, false));
    }
    let odd = n.hi.rem_euclid(2.0) == 1.0;
    // J_(−n) = (−1)^n J_n, I_(−n) = I_n; both have the parity of n.
    let flips = u8::from(odd && n.hi < 0.0 && alternating) + u8::from(odd && z.hi < 0.0);
    let argument = if z.hi < 0.0 { z.neg() } else { z };
    Some((n.hi.abs().into(), argument, flips == 1))
}

/// The value at 0: 1 for order 0, 0 above, a pole below.
fn at_zero(n: DoubleDouble) -> Precise {
    match n.hi {
        0.0 => exact(DoubleDouble::ONE),
        n if n > 0.0 => exact(0.0),
        _ => Precise { value: f64::INFINITY.into(), error: f64::INFINITY },
    }
}

/// J_n(z) for n > −1, z >= 0.
fn ordinary(n: DoubleDouble, z: DoubleDouble) -> Precise {
    if z.hi == 0.0 {
        return at_zero(n);
    }
    let half = z.scale(0.5);
    if half.hi * half.hi <= n.hi + 1.0 {
        return times(bessel_leading(n, half), series(half.mul(half).neg(), 1.0, n.add(DoubleDouble::ONE)));
    }
    if n.hi > HIGHEST {
        // (e z/(2n))^n bounds the value.
        return if z.hi < 0.5 * n.hi { Precise { value: 0.0.into(), error: TINY } } else { Precise::nan() };
    }
    if z.hi > FAR && n.hi * n.hi <= 2.0 * z.hi {
        return oscillating(n, z).0;
    }
    let whole = n.hi.floor();
    let fraction = n.sub(whole.into());
    if whole < 0.0 {
        // One step below: J_(f−1) = (2f/z) J_f − J_(f+1).
        let [first, second] = if z.hi > FAR {
            [oscillating(fraction, z).0, oscillating(fraction.add(DoubleDouble::ONE), z).0]
        } else {
            backward(fraction, 0, z, false).wanted
        };
        return minus(times(first, over(exact(fraction.scale(2.0)), exact(z))), second);
    }
    if z.hi <= DOWNWARDS || n.hi > z.hi {
        return backward(fraction, whole as u32, z, false).wanted[0];
    }
    upwards(fraction, whole as u32, z)
}

/// J_(f+m)(z) from orders f and f+1, m <= z: the errors stay relative to the amplitude √(2/π)(z² − n²)^(−1/4).
fn upwards(f: DoubleDouble, m: u32, z: DoubleDouble) -> Precise {
    let start = oscillating(f, z).0;
    let (mut below, mut now) = (start.value, oscillating(f.add(DoubleDouble::ONE), z).0.value);
    let step = DoubleDouble::from(2.0).div(z);
    for order in 1..m {
        let order = f.add(f64::from(order).into());
        (below, now) = (now, now.mul(step.mul(order)).sub(below));
    }
    let (order, width) = (f64::from(m), z.hi.cbrt());
    let least = (z.hi - order).max(width) * (z.hi + order);
    let spread = (z.hi.sqrt() / least.powf(0.25)).min(z.hi);
    let first = start.error + UNIT * (16.0 + order) / z.hi.sqrt();
    Precise { value: now, error: 16.0 * spread * first }
}

/// I_n(z), or e^(−z) I_n(z).
fn modified(n: DoubleDouble, z: DoubleDouble, scaled: bool) -> Precise {
    let Some((n, z, negative)) = reflected(n, z, false) else { return Precise::nan() };
    if z.hi == 0.0 {
        return at_zero(n);
    }
    let reach = if z.hi > 600.0 { 20.0 } else { 2.0 };
    let value = if z.hi > FAR && (z.hi > 1500.0 || n.hi * n.hi <= reach * z.hi) {
        growing(n, z, scaled)
    } else {
        let half = z.scale(0.5);
        // Next to the overflow a product of two words would lose itself.
        let shift = if z.hi > 600.0 { 2.0_f64.powi(-200) } else { 1.0 };
        let leading = times(bessel_leading(n, half), exact(shift));
        let value = times(leading, series(half.mul(half), 1.0, n.add(DoubleDouble::ONE)));
        let value = Precise { value: value.value.scale(shift.recip()), error: value.error / shift };
        if scaled { exponential(exact(z.neg()), value) } else { value }
    };
    if negative { opposite(value) } else { value }
}
