//! Struve functions, ordinary and modified, of whole order from −1.

use crate::double_double::{DoubleDouble, Precise};
use crate::special::bessel::backward::backward;
use crate::special::bessel::besseli_precise;
use crate::special::bessel::fixed_point::exact_series;
use crate::special::bessel::hankel::oscillating;
use crate::special::bessel::leading::struve_leading;
use crate::special::bessel::taylor::difference_pair;
use crate::special::carried::{TWO_OVER_PI, UNIT, exact, is_short, known, minus, opposite, over, plus, rounded, series, times};

/// From here on the asymptotic series, whose smallest term is e^(−z), has 30 digits.
pub(crate) const FAR: f64 = 82.0;
/// Below this the power series of H loses at most one digit.
const NEAR: f64 = 2.0;
/// Orders beyond this are not computed.
const HIGHEST: f64 = 1e4;

/// `H_n(z) = (z/2)^(n+1) Σ (-1)^k (z/2)^(2k) / (Gamma(k+3/2) Gamma(k+n+3/2))`.
///
/// Domain: whole `n` in `[-1, 10^4]`, every finite `z`; NaN elsewhere and where fewer than 15 digits are known, which
/// needs orders above about `z > 80`.
///
/// Accuracy: the 30-digit value rounded, next to the zeros by a series in whole numbers: at most 0.51 ulp measured.
///
/// ```
/// use sneddon_num::special::struveh;
/// assert!((struveh(0.0, 1.0) - 0.568_656_627_048_287_95).abs() < 1e-16);
/// assert_eq!(struveh(-1.0, 0.0), std::f64::consts::FRAC_2_PI);
/// ```
pub fn struveh(n: f64, z: f64) -> f64 {
    let value = struveh_precise(n.into(), z.into());
    if is_short(value)
        && let Some(sum) = exact_series(z.abs(), 1.5, n + 1.5)
    {
        let near_zero = struve_leading(n, (0.5 * z.abs()).into()).value.mul(sum).value();
        return if z < 0.0 && n.rem_euclid(2.0) == 0.0 { -near_zero } else { near_zero };
    }
    rounded(value)
}

/// `H_n(z)` to about 28 digits of its amplitude, with its error.
///
/// Method: power series for small `z` and for `n > z`; Neumann series of Bessel functions from Miller's recurrence up to
/// `z = 82`, `Y_n` and the asymptotic series beyond, raised in order by the recurrence.
/// Source: DLMF 11.2.1, 11.4.5 and 11.4.6 (in `J`), 11.6.1, 11.4.23.
///
/// ```
/// let value = sneddon_num::special::struveh_precise(0.0.into(), 1.0.into());
/// assert!(value.value.hi == 0.568_656_627_048_287_9 && value.error < 1e-29);
/// ```
pub fn struveh_precise(n: DoubleDouble, z: DoubleDouble) -> Precise {
    with_parity(n, z, ordinary)
}

/// `L_n(z) = (z/2)^(n+1) Σ (z/2)^(2k) / (Gamma(k+3/2) Gamma(k+n+3/2))`.
///
/// Domain: whole `n` in `[-1, 10^4]`, every `z`; infinite if a double overflows (beyond 713 for small `n`); NaN elsewhere.
///
/// Accuracy: the 30-digit value rounded, at most 0.51 ulp measured.
///
/// ```
/// use sneddon_num::special::struvel;
/// assert!((struvel(0.0, 1.0) - 0.710_243_185_937_891).abs() < 1e-15);
/// ```
pub fn struvel(n: f64, z: f64) -> f64 {
    finished(struvel_precise(n.into(), z.into()))
}

/// `L_n(z)` to about 29 digits, with its error.
///
/// Method: power series up to `z = 82`, `I_n` less the asymptotic series beyond. Source: DLMF 11.2.2, 11.6.2.
///
/// ```
/// let value = sneddon_num::special::struvel_precise(1.0.into(), 1.0.into());
/// assert!((value.value.hi - 0.226_764_381_055_808_64).abs() < 1e-16 && value.error < 1e-29);
/// ```
pub fn struvel_precise(n: DoubleDouble, z: DoubleDouble) -> Precise {
    with_parity(n, z, modified)
}

/// `I_n(z) - L_n(z) = 2 (z/2)^n / (sqrt(pi) Gamma(n+1/2)) ∫_0^1 (1-t^2)^(n-1/2) e^(-z t) dt` without the cancellation of
/// the difference, which grows as `e^z`.
///
/// Domain: whole `n` in `[-1, 10^4]` and `z >= 0`; NaN elsewhere and where fewer than 15 digits are known.
///
/// Accuracy: the 30-digit value rounded, at most 0.51 ulp measured.
///
/// ```
/// use sneddon_num::special::bessel_struve;
/// assert!((bessel_struve(0.0, 1e6) * 1e6 - std::f64::consts::FRAC_2_PI).abs() < 1e-12);
/// ```
pub fn bessel_struve(n: f64, z: f64) -> f64 {
    finished(bessel_struve_precise(n.into(), z.into()))
}

/// `I_n(z) - L_n(z)` to at least 26 digits, with its error.
///
/// Method: the difference up to `z = 4` and for `n > z`; Taylor series about tabulated points up to `z = 82`, the
/// asymptotic series beyond, raised in order by the recurrence. Source: DLMF 11.4.25, 11.5.4, 11.6.2.
///
/// ```
/// let value = sneddon_num::special::bessel_struve_precise(0.0.into(), 30.0.into());
/// assert!(value.value.hi == 0.021_244_480_317_825_293 && value.error < 1e-29);
/// ```
pub fn bessel_struve_precise(n: DoubleDouble, z: DoubleDouble) -> Precise {
    if !allowed(n, z) || z.hi < 0.0 { Precise::nan() } else { difference(n.hi, z) }
}

fn finished(value: Precise) -> f64 {
    if value.value.hi.is_infinite() { value.value.hi } else { rounded(value) }
}

fn allowed(n: DoubleDouble, z: DoubleDouble) -> bool {
    n.lo == 0.0 && n.hi == n.hi.trunc() && (-1.0..=HIGHEST).contains(&n.hi) && z.hi.is_finite()
}

/// H_n and L_n have the parity of n + 1.
fn with_parity(n: DoubleDouble, z: DoubleDouble, at: impl Fn(f64, DoubleDouble) -> Precise) -> Precise {
    if !allowed(n, z) {
        return Precise::nan();
    }
    if z.hi < 0.0 {
        let value = at(n.hi, z.neg());
        return if n.hi.rem_euclid(2.0) == 0.0 { opposite(value) } else { value };
    }
    at(n.hi, z)
}

fn power_series(n: f64, z: DoubleDouble, sign: f64) -> Precise {
    let half = z.scale(0.5);
    times(struve_leading(n, half), series(half.mul(half).scale(sign), 1.5, (n + 1.5).into()))
}

fn ordinary(n: f64, z: DoubleDouble) -> Precise {
    if z.hi < NEAR || n > z.hi {
        return power_series(n, z, -1.0);
    }
    if z.hi >= FAR && (n <= 0.0 || n * n <= 2.0 * z.hi) {
        return plus(oscillating(n.into(), z).1, tail(n, z, 1.0));
    }
    let (zeroth, first) = if z.hi >= FAR {
        (plus(oscillating(0.0.into(), z).1, tail(0.0, z, 1.0)), plus(oscillating(1.0.into(), z).1, tail(1.0, z, 1.0)))
    } else {
        let waves = backward(0.0.into(), 0, z, true);
        let double = exact(2.0);
        // H_0 = (4/π) Σ J_(2k+1)/(2k+1); H_1 = (2/π)(1 − J_0) + (4/π) Σ J_(2k)/(4k²−1).
        let factor = known(TWO_OVER_PI, 1.0);
        let rest = plus(minus(exact(DoubleDouble::ONE), waves.zeroth), times(double, waves.even));
        (times(factor, times(double, waves.odd)), times(factor, rest))
    };
    upwards(n, z, zeroth, first, 1.0)
}

fn modified(n: f64, z: DoubleDouble) -> Precise {
    if z.hi < FAR || (n * n > 2.0 * z.hi && z.hi < 600.0) {
        return power_series(n, z, 1.0);
    }
    let (wave, algebraic) = (besseli_precise(n.abs().into(), z), difference(n, z));
    if wave.value.hi.is_infinite() { wave } else { minus(wave, algebraic) }
}

/// I_n − L_n.
fn difference(n: f64, z: DoubleDouble) -> Precise {
    if z.hi < 4.0 || (n > z.hi && z.hi < 600.0) {
        return minus(besseli_precise(n.abs().into(), z), power_series(n, z, 1.0));
    }
    if z.hi >= FAR && (n <= 0.0 || n * n <= 2.0 * z.hi) {
        return tail(n, z, -1.0);
    }
    let (zeroth, first) = if z.hi >= FAR {
        (tail(0.0, z, -1.0), tail(1.0, z, -1.0))
    } else {
        let (zeroth, below) = difference_pair(z);
        if n < 0.0 {
            return below;
        }
        (zeroth, plus(below, known(TWO_OVER_PI, 1.0)))
    };
    upwards(n, z, zeroth, first, -1.0)
}

/// The value of order n from those of orders 0 and 1 by X_(m+1) = s (2m/z X_m − X_(m−1)) + (z/2)^m/(√π Γ(m+3/2)),
/// with s = 1 for H and s = −1 for I − L.
fn upwards(n: f64, z: DoubleDouble, zeroth: Precise, first: Precise, s: f64) -> Precise {
    if n < 0.0 {
        // X_(−1) = s (2/π − X_1).
        let below = minus(known(TWO_OVER_PI, 1.0), first);
        return if s < 0.0 { opposite(below) } else { below };
    }
    if n == 0.0 {
        return zeroth;
    }
    let (mut below, mut now) = (zeroth, first);
    let step = over(exact(2.0), exact(z));
    let half = exact(z.scale(0.5));
    // (z/2)^m/(√π Γ(m+3/2)) = (2/π) (z/2)^m / ((3/2)_m).
    let mut source = known(TWO_OVER_PI, 1.0);
    for m in 1..(n as u32) {
        let m = f64::from(m);
        source = over(times(source, half), exact(m + 0.5));
        let wave = minus(times(times(step, exact(m)), now), below);
        (below, now) = (now, plus(source, if s < 0.0 { opposite(wave) } else { wave }));
    }
    now
}

/// (1/π) Σ s^… Γ(k+1/2) (z/2)^(n−2k−1)/Γ(n+1/2−k): H_n − Y_n for s = 1, I_n − L_n for s = −1; z > 80.
fn tail(n: f64, z: DoubleDouble, s: f64) -> Precise {
    let inverse = over(exact(2.0), exact(z));
    // (1/π)(z/2)^(n−1)/((1/2)(3/2)…(n−1/2)).
    let mut term = times(known(TWO_OVER_PI, 1.0), exact(0.5));
    if n < 0.0 {
        term = times(times(term, exact(-0.5)), times(inverse, inverse));
    } else if n == 0.0 {
        term = times(term, inverse);
    } else {
        let half = exact(z.scale(0.5));
        term = over(term, exact(0.5));
        for m in 1..(n as u32) {
            term = over(times(term, half), exact(f64::from(m) + 0.5));
        }
    }
    let lead = term;
    let square = inverse.value.mul(inverse.value);
    let (mut sum, mut part, mut units) = (DoubleDouble::ONE, DoubleDouble::ONE, 4.0);
    for k in 0..400_u32 {
        let k = f64::from(k);
        let next = part.mul(square).mul((s * (k + 0.5) * (n - 0.5 - k)).into());
        let (now, before) = (next.hi.abs(), part.hi.abs());
        if now < UNIT / 1024.0 || (now >= before && k > n) {
            return times(lead, Precise { value: sum, error: UNIT * units + 4.0 * now.min(before) });
        }
        part = next;
        sum = sum.add(part);
        units += 6.0 * (k + 1.0) * now + sum.hi.abs();
    }
    Precise::nan()
}
