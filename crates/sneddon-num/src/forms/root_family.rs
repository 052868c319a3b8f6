//! Slopes, integrals and forces of the sphere and the hyperboloid, whole.

use crate::double_double::{two_prod, two_sum};
use crate::stable::{artanh_quotient, exponent, ldexp};

/// `artanh(x/R)`, the slope integral of a sphere of radius `R`: `g = x artanh(x/R)`.
///
/// Domain: `|x| <= R`, odd in `x`; infinite at `x = R`, NaN beyond.
///
/// Accuracy: measured at most 1.1 ulp; for `x << R` it is `x/R` rounded once, and near `x = R` the difference
/// `R - x` is exact.
///
/// Source: MDR chapter, sphere; written as `log1p(2x/(R-x))/2`, and beyond `R/3` as `ln((R+x)/(R-x))/2`.
///
/// ```
/// use sneddon_num::forms::artanh_ratio;
/// assert_eq!(artanh_ratio(1e-200, 1.0), 1e-200);
/// ```
pub fn artanh_ratio(x: f64, r: f64) -> f64 {
    if r > 0.0 && r.is_finite() { artanh_quotient(x.abs(), r).copysign(x) } else { f64::NAN }
}

/// Force of a sphere, `((R^2 + a^2) artanh(a/R) - a R) / 2 = ∫_0^a r^3 / (sqrt(R^2-r^2) sqrt(a^2-r^2)) dr`.
///
/// Domain: `0 <= a <= R`, infinite at `a = R`, NaN elsewhere. About `(2/3) a^3/R` for `a << R`.
///
/// Accuracy: measured at most 4.2 ulp. Source: MDR chapter (3.78).
///
/// ```
/// use sneddon_num::forms::sphere_force;
/// assert!((sphere_force(1e-3, 1.0) - 2e-9 / 3.0).abs() < 1e-15);
/// ```
pub fn sphere_force(a: f64, r: f64) -> f64 {
    if in_sphere(a, r) { sphere_force_core(a, r, artanh_quotient(a, r)) } else { f64::NAN }
}

/// Integral of the sphere's transform, `((a^2 - R^2) artanh(a/R) + a R) / 2 = ∫_0^a x artanh(x/R) dx`.
///
/// Domain: `0 <= a <= R`, NaN elsewhere; `R^2/2` at `a = R`.
///
/// Accuracy: measured at most 5.4 ulp. Source: MDR chapter, sphere.
///
/// ```
/// use sneddon_num::forms::sphere_integral;
/// assert_eq!(sphere_integral(2.0, 2.0), 2.0);
/// ```
pub fn sphere_integral(a: f64, r: f64) -> f64 {
    if !in_sphere(a, r) {
        return f64::NAN;
    }
    let y = a / r;
    if y * y <= SERIES_UP_TO {
        // (R^2/2) Σ 2 y^(2k+1) / ((2k-1)(2k+1)), k >= 1
        return a * a * y * positive_series(y * y, |k| 1.0 / ((2.0 * k - 1.0) * (2.0 * k + 1.0)));
    }
    if a == r {
        return 0.5 * r * r;
    }
    let (scale, a, r) = normalised(a, r);
    let rest = two_sum(r, -a).mul(two_sum(r, a)).mul(artanh_quotient(a, r).into());
    ldexp(0.5 * two_prod(a, r).sub(rest).value(), scale)
}

/// Force of a hyperboloid, `((a^2 - b^2) atan(a/b) + a b) / 2 = ∫_0^a r^3 / (sqrt(b^2+r^2) sqrt(a^2-r^2)) dr`.
///
/// Domain: `a >= 0`, `b > 0`, finite; NaN elsewhere. About `(2/3) a^3/b` for `a << b`.
///
/// Accuracy: measured at most 2.6 ulp. Source: MDR chapter, hyperboloid.
///
/// ```
/// use sneddon_num::forms::hyperboloid_force;
/// assert_eq!(hyperboloid_force(1.0, 1.0), 0.5);
/// ```
pub fn hyperboloid_force(a: f64, b: f64) -> f64 {
    if in_hyperboloid(a, b) { hyperboloid_force_core(a, b) } else { f64::NAN }
}

/// Integral of the hyperboloid's transform, `((a^2 + b^2) atan(a/b) - a b) / 2 = ∫_0^a x atan(x/b) dx`.
///
/// Domain: `a >= 0`, `b > 0`, finite; NaN elsewhere. About `a^3/(3b)` for `a << b`.
///
/// Accuracy: measured at most 3.2 ulp. Source: MDR chapter, hyperboloid.
///
/// ```
/// use sneddon_num::forms::hyperboloid_integral;
/// assert!((hyperboloid_integral(1.0, 1.0) - (std::f64::consts::FRAC_PI_2 - 1.0) / 2.0).abs() < 1e-16);
/// ```
pub fn hyperboloid_integral(a: f64, b: f64) -> f64 {
    if !in_hyperboloid(a, b) {
        return f64::NAN;
    }
    if a <= b {
        // a b / 2 Σ_{k>=1} c_k t^k, t = a^2/(a^2+b^2), c_k = c_(k-1) 2k/(2k+1): Euler's series, all terms positive.
        let square = (a / b) * (a / b);
        let t = square / (1.0 + square);
        let sum = nested(t, |k| (2.0 * k + 2.0) / (2.0 * k + 3.0));
        return a * (a * (a / b)) * sum / 3.0 / (1.0 + square);
    }
    let (scale, a, b) = normalised(a, b);
    let squares = two_prod(a, a).add(two_prod(b, b));
    ldexp(0.5 * squares.mul((a / b).atan().into()).sub(two_prod(a, b)).value(), scale)
}

/// Largest square of the ratio for which the power series is used; beyond, the closed form loses under two bits.
const SERIES_UP_TO: f64 = 0.6;
/// Bound of every series here; 0.6^k falls below 2^-60 long before.
const TERMS: u32 = 120;

pub(super) fn in_sphere(a: f64, r: f64) -> bool {
    a >= 0.0 && r > 0.0 && a <= r && r.is_finite()
}

pub(super) fn in_hyperboloid(a: f64, b: f64) -> bool {
    a >= 0.0 && b > 0.0 && a.is_finite() && b.is_finite()
}

/// Both lengths divided by the power of two of the larger, and twice its exponent for the areas they make.
fn normalised(a: f64, b: f64) -> (i64, f64, f64) {
    let e = i64::from(exponent(a.max(b)));
    (2 * e, ldexp(a, -e), ldexp(b, -e))
}

/// `1 + r_1 t (1 + r_2 t (1 + ...))`, `0 <= t <= 1/2`, from inside out: early roundings are multiplied away.
fn nested(t: f64, ratio: impl Fn(f64) -> f64) -> f64 {
    let levels = if t < 1e-3 {
        6
    } else if t < 0.05 {
        13
    } else {
        58
    };
    (1..=levels).rev().fold(1.0, |inner, k| 1.0 + ratio(f64::from(k)) * t * inner)
}

/// `Σ_{k>=1} term(k) z^(k-1)`, `0 <= z <= 0.6`, terms decreasing.
fn positive_series(z: f64, term: impl Fn(f64) -> f64) -> f64 {
    let (mut power, mut sum) = (1.0, 0.0);
    for k in 1..TERMS {
        let part = term(f64::from(k)) * power;
        sum += part;
        power *= z;
        if part < 1e-18 * sum {
            break;
        }
    }
    sum
}

/// The sphere's force from `a`, `r`, and `artanh(a/r)` from the most accurate source.
pub(super) fn sphere_force_core(a: f64, r: f64, slope: f64) -> f64 {
    let y = a / r;
    if y * y <= SERIES_UP_TO {
        // (R^2/2) Σ 4k y^(2k+1) / ((2k+1)(2k-1)), k >= 1
        return (y * a) * a * positive_series(y * y, |k| 2.0 * k / ((2.0 * k - 1.0) * (2.0 * k + 1.0)));
    }
    if slope == f64::INFINITY {
        return slope;
    }
    let (scale, a, r) = normalised(a, r);
    let squares = two_prod(a, a).add(two_prod(r, r));
    ldexp(0.5 * squares.mul(slope.into()).sub(two_prod(a, r)).value(), scale)
}

/// The hyperboloid's force inside its domain.
pub(super) fn hyperboloid_force_core(a: f64, b: f64) -> f64 {
    if a <= 0.6 * b {
        // a b Σ_{k>=1} e_k t^k, e_1 = 2/3, e_k = (k+1)/(2k+1) c_(k-1): Euler's series of atan, regrouped, positive.
        let square = (a / b) * (a / b);
        let t = square / (1.0 + square);
        let sum = nested(t, |k| 2.0 * k * (k + 2.0) / ((2.0 * k + 3.0) * (k + 1.0)));
        return (a / b) * a * a * (2.0 * sum) / 3.0 / (1.0 + square);
    }
    let (scale, a, b) = normalised(a, b);
    let difference = two_sum(a, -b).mul(two_sum(a, b));
    ldexp(0.5 * difference.mul((a / b).atan().into()).add(two_prod(a, b)).value(), scale)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_the_domain() {
        assert_eq!(artanh_ratio(1.0, 1.0), f64::INFINITY);
        assert_eq!(artanh_ratio(-0.5, 1.0), -artanh_ratio(0.5, 1.0));
        assert_eq!(sphere_force(1.0, 1.0), f64::INFINITY);
        for value in [
            artanh_ratio(2.0, 1.0),
            sphere_force(2.0, 1.0),
            sphere_integral(-1.0, 1.0),
            hyperboloid_force(1.0, 0.0),
            hyperboloid_integral(f64::INFINITY, 1.0),
        ] {
            assert!(value.is_nan());
        }
    }
}
