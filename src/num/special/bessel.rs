//! Bessel functions of the first kind, ordinary and modified.

use crate::num::double_double::{DoubleDouble, two_prod, two_sum};
use crate::num::stable::ldexp;

/// `J_n(z) = Σ (-1)^k (z/2)^(n+2k) / (k! Gamma(n+k+1))`.
///
/// Domain: real `n >= 0`. Integer `n <= 1000`: every finite `z`. Other `n`: `z >= 0`, `z^2/4 < 30 + n`, by the
/// series in double-double, which has digits to spare for its cancellation; NaN elsewhere.
///
/// Accuracy: measured at most 16.8 ulp for `z` in (0, 20) and at least 0.05 away from a zero of `J_n`; near a zero
/// the relative error grows as the distance shrinks.
///
/// Source: DLMF 10.2.2; integer orders from `libm::jn`.
///
/// ```
/// use sneddon::num::special::besselj;
/// assert_eq!(besselj(0.0, 0.0), 1.0);
/// assert!((besselj(0.5, 2.0) - (1.0 / std::f64::consts::PI).sqrt() * 2.0_f64.sin()).abs() < 1e-15);
/// ```
pub fn besselj(n: f64, z: f64) -> f64 {
    if !(n >= 0.0 && z.is_finite()) {
        return f64::NAN;
    }
    if n == n.trunc() {
        if n > 1000.0 {
            return f64::NAN;
        }
        let order = n as i32;
        return match order {
            0 => libm::j0(z),
            1 => libm::j1(z),
            _ => libm::jn(order, z),
        };
    }
    if z < 0.0 || 0.25 * z * z >= 30.0 + n {
        return f64::NAN;
    }
    leading(n, z) * series(n, z, -1.0)
}

/// `I_n(z) = Σ (z/2)^(n+2k) / (k! Gamma(n+k+1))`.
///
/// Domain: real `n >= 0`, `z >= 0`, also `z < 0` for integer `n`; infinite beyond `z = 713`; NaN elsewhere and where
/// neither the series (`z^2/4 < 1000`) nor Hankel's asymptotic series (`z > n^2`) reaches.
///
/// Accuracy: measured at most 7.4 ulp. Source: DLMF 10.25.2, 10.40.1.
///
/// ```
/// use sneddon::num::special::besseli;
/// assert_eq!(besseli(0.0, 0.0), 1.0);
/// assert!((besseli(0.5, 2.0) - (1.0 / std::f64::consts::PI).sqrt() * 2.0_f64.sinh()).abs() < 1e-15);
/// ```
pub fn besseli(n: f64, z: f64) -> f64 {
    if n.is_nan() || n < 0.0 || z.is_nan() {
        return f64::NAN;
    }
    if z == f64::INFINITY {
        return z;
    }
    if z < 0.0 {
        let integer = n == n.trunc() && n < 9e15;
        let sign = if n % 2.0 == 0.0 { 1.0 } else { -1.0 };
        return if integer { sign * besseli(n, -z) } else { f64::NAN };
    }
    let square = 0.25 * z * z;
    if square < 1000.0 {
        return leading(n, z) * series(n, z, 1.0);
    }
    if z <= n * n {
        return f64::NAN;
    }
    if z < 1500.0 { asymptotic(n, z) } else { f64::INFINITY }
}

/// `Σ (sign z^2/4)^k Gamma(n+1) / (k! Gamma(n+k+1))`, at most 200 terms; in double-double, since for `I_n` the
/// roundings of 60 terms, for `J_n` the cancellation of terms up to `e^(2 sqrt(30+n))` would show.
fn series(n: f64, z: f64, sign: f64) -> f64 {
    let half = 0.5 * z;
    let square = two_prod(half, sign * half);
    let (mut sum, mut term) = (DoubleDouble::ONE, DoubleDouble::ONE);
    for k in 1..200 {
        let k = f64::from(k);
        term = term.mul(square).div(two_sum(n, k).mul(k.into()));
        sum = sum.add(term);
        if term.hi.abs() < 1e-20 * sum.hi.abs() {
            break;
        }
    }
    sum.value()
}

/// `(z/2)^n / Gamma(n+1)`, as a product so that neither factor need be representable.
fn leading(n: f64, z: f64) -> f64 {
    if n == 0.0 {
        return 1.0;
    }
    if n > 1e4 || z == 0.0 {
        return 0.0;
    }
    let half = 0.5 * z;
    let whole = n.floor();
    let fraction = n - whole;
    // (z/2)^n/Γ(n+1) = [(z/2)^f/Γ(f+1)] Π (z/2)/(f+j): bounded by 10^4 factors, each one rounding.
    let mut product = half.powf(fraction) / libm::tgamma(1.0 + fraction);
    let mut exponent = 0_i64;
    for j in 1..=(whole as u32) {
        product *= half / (fraction + f64::from(j));
        if product < 1e-200 {
            product *= 2.0_f64.powi(600);
            exponent -= 600;
        } else if product > 1e200 {
            product *= 2.0_f64.powi(-600);
            exponent += 600;
        }
    }
    ldexp(product, exponent)
}

/// `e^z / sqrt(2 pi z) Σ (-1)^k a_k(n) / z^k`, stopped at the smallest term.
fn asymptotic(n: f64, z: f64) -> f64 {
    let four_n2 = 4.0 * n * n;
    let (mut sum, mut term) = (1.0, 1.0_f64);
    for k in 1..60 {
        let odd = f64::from(2 * k - 1);
        let next = term * (odd * odd - four_n2) / (8.0 * f64::from(k) * z);
        if next.abs() > term.abs() && f64::from(k) > n {
            break;
        }
        term = next;
        sum += term;
        if term.abs() < 1e-18 {
            break;
        }
    }
    // In two halves: e^z overflows before I_n does.
    let half = (0.5 * z).exp();
    half * (sum / (std::f64::consts::TAU * z).sqrt()) * half
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_the_domain() {
        assert_eq!(besselj(2.5, 0.0), 0.0);
        assert_eq!(besseli(3.0, -1.0), -besseli(3.0, 1.0));
        assert_eq!(besseli(0.0, f64::INFINITY), f64::INFINITY);
        assert!(besselj(-1.0, 1.0).is_nan() && besselj(0.5, 100.0).is_nan() && besselj(1e9, 1.0).is_nan());
        assert!(besseli(0.5, -1.0).is_nan() && besseli(f64::NAN, 1.0).is_nan());
        assert!(besselj(0.0, 1e300).is_finite());
    }
}
