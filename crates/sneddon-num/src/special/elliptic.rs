//! Legendre's elliptic integrals of the first and second kind, complete and incomplete, in the parameter m = k^2.

use super::ball::Ball;
use super::carlson::{rd, rd_ball, rf, rf_ball};
use crate::special::ball::elementary::PI;
use crate::{DoubleDouble, Precise};

/// `K(m) = ∫_0^{pi/2} dt / sqrt(1 - m sin^2 t)`.
///
/// Domain: `m < 1` finite; infinite at `m = 1`, NaN beyond. Accuracy: measured at most 2.9 ulp for `m` from
/// -1e300 to `1 - 1e-16`. Source: DLMF 19.25.1.
///
/// ```
/// use sneddon_num::special::ellipk;
/// assert!((ellipk(0.0) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// ```
pub fn ellipk(m: f64) -> f64 {
    if m <= 1.0 { rf(0.0, 1.0 - m, 1.0) } else { f64::NAN }
}

/// `E(m) = ∫_0^{pi/2} sqrt(1 - m sin^2 t) dt`.
///
/// Domain: `m <= 1` finite; `E(1) = 1`, NaN beyond. Accuracy: measured at most 3.8 ulp for `m` from -1e300 to 1.
/// Source: DLMF 19.25.1 in the form with two positive terms.
///
/// ```
/// use sneddon_num::special::ellipe;
/// assert_eq!(ellipe(1.0), 1.0);
/// ```
pub fn ellipe(m: f64) -> f64 {
    if m == 1.0 {
        return 1.0;
    }
    if m.is_nan() || m > 1.0 {
        return f64::NAN;
    }
    let complement = 1.0 - m;
    (complement * rd(0.0, complement, 1.0) + complement * rd(0.0, 1.0, complement)) / 3.0
}

/// `F(phi | m) = ∫_0^phi dt / sqrt(1 - m sin^2 t)`.
///
/// Domain: `0 <= phi <= pi/2`, `m <= 1` finite; NaN elsewhere. Accuracy: measured at most 4.0 ulp for `m` from
/// -1e15 to 1. Source: DLMF 19.25.5.
///
/// ```
/// use sneddon_num::special::ellipf;
/// assert!((ellipf(0.7, 0.0) - 0.7).abs() < 1e-15);
/// ```
pub fn ellipf(phi: f64, m: f64) -> f64 {
    match arguments(phi, m) {
        Some((sine, cosine2, delta2)) => sine * rf(cosine2, delta2, 1.0),
        None => f64::NAN,
    }
}

/// `E(phi | m) = ∫_0^phi sqrt(1 - m sin^2 t) dt`.
///
/// Domain: `0 <= phi <= pi/2`, `m <= 1` finite; NaN elsewhere. Accuracy: measured at most 4.5 ulp for `m`
/// from -1e15 to 1. Source: DLMF 19.25.9 for `m <= 0`, 19.25.10 for `m > 0`: positive terms only.
///
/// ```
/// use sneddon_num::special::ellipe_inc;
/// assert!((ellipe_inc(0.7, 1.0) - 0.7_f64.sin()).abs() < 1e-15);
/// ```
pub fn ellipe_inc(phi: f64, m: f64) -> f64 {
    let Some((sine, cosine2, delta2)) = arguments(phi, m) else {
        return f64::NAN;
    };
    if sine < 1e-9 || m == 1.0 {
        // Next term m sin^3/6, unless m is huge; E(phi|1) = sin phi.
        if m > -10.0 {
            return sine;
        }
    }
    let cube = sine * sine * sine;
    if m <= 0.0 {
        return sine * rf(cosine2, delta2, 1.0) - m / 3.0 * (cube * rd(cosine2, delta2, 1.0));
    }
    let complement = 1.0 - m;
    complement * (sine * rf(cosine2, delta2, 1.0) + m / 3.0 * cube * rd(cosine2, 1.0, delta2)) + m * sine * (cosine2 / delta2).sqrt()
}

/// `sin phi`, `cos^2 phi`, and `1 - m sin^2 phi` as a sum of positive terms.
fn arguments(phi: f64, m: f64) -> Option<(f64, f64, f64)> {
    if !((0.0..=std::f64::consts::FRAC_PI_2).contains(&phi) && m <= 1.0 && m.is_finite()) {
        return None;
    }
    let (sine, cosine) = phi.sin_cos();
    let cosine2 = cosine * cosine;
    let delta2 = if m > 0.0 { cosine2 + (1.0 - m) * (sine * sine) } else { 1.0 - m * (sine * sine) };
    Some((sine, cosine2, delta2))
}

/// [`ellipk`] with about 30 digits: `π / (2 agm(1, √(1-m)))`.
///
/// Source: DLMF 19.8.5.
///
/// ```
/// use sneddon_num::special::ellipk_precise;
/// assert!(ellipk_precise(0.5.into()).error < 1e-28);
/// ```
pub fn ellipk_precise(m: DoubleDouble) -> Precise {
    complete(Ball::ONE - Ball::exact(m)).0.precise()
}

/// [`ellipe`] with about 30 digits: `K (1 - Σ 2^(n-1) c_n^2)` from the same means, a negative `m` by
/// `E(m) = √(1-m) E(m/(m-1))`.
///
/// Source: DLMF 19.8.6, 19.7.2.
///
/// ```
/// use sneddon_num::special::ellipe_precise;
/// assert!(ellipe_precise((-3.0).into()).error < 1e-28);
/// ```
pub fn ellipe_precise(m: DoubleDouble) -> Precise {
    let rest = Ball::ONE - Ball::exact(m);
    if rest.hi() == 0.0 {
        return Ball::ONE.precise();
    }
    if rest.hi() > 1.0 { (rest.sqrt() * complete(rest.recip()).1).precise() } else { complete(rest).1.precise() }
}

/// [`ellipf`] with about 30 digits, by Carlson's `R_F`.
///
/// ```
/// use sneddon_num::special::ellipf_precise;
/// assert!(ellipf_precise(0.7.into(), 0.5.into()).error < 1e-28);
/// ```
pub fn ellipf_precise(phi: DoubleDouble, m: DoubleDouble) -> Precise {
    match ball_arguments(phi, m) {
        Some((sine, cosine2, delta2)) => (sine * rf_ball(cosine2, delta2, Ball::ONE)).precise(),
        None => Precise::nan(),
    }
}

/// [`ellipe_inc`] with about 30 digits, by the same forms with positive terms.
///
/// ```
/// use sneddon_num::special::ellipe_inc_precise;
/// assert!(ellipe_inc_precise(0.7.into(), 0.5.into()).error < 1e-28);
/// ```
pub fn ellipe_inc_precise(phi: DoubleDouble, m: DoubleDouble) -> Precise {
    let Some((sine, cosine2, delta2)) = ball_arguments(phi, m) else { return Precise::nan() };
    if sine.hi() == 0.0 {
        return Ball::ZERO.precise();
    }
    let m = Ball::exact(m);
    let third = m * sine.powi(3) / 3.0;
    if m.hi() <= 0.0 {
        return (sine * rf_ball(cosine2, delta2, Ball::ONE) - third * rd_ball(cosine2, delta2, Ball::ONE)).precise();
    }
    let rest = Ball::ONE - m;
    if rest.hi() == 0.0 {
        return sine.precise();
    }
    let main = rest * (sine * rf_ball(cosine2, delta2, Ball::ONE) + third * rd_ball(cosine2, Ball::ONE, delta2));
    (main + m * sine * (cosine2 / delta2).sqrt()).precise()
}

/// `K` and `E` by arithmetic-geometric means, from `1 - m`; `E` for `m >= 0`.
fn complete(rest: Ball) -> (Ball, Ball) {
    if !(rest.hi() > 0.0 && rest.hi().is_finite()) {
        return (Ball::NONE, Ball::NONE);
    }
    let (mut mean, mut root) = (Ball::ONE, rest.sqrt());
    let mut sum = (Ball::ONE - rest).scale(0.5);
    let mut weight = 1.0;
    for _ in 0..60 {
        let half = (mean - root).scale(0.5);
        let square = half.square();
        sum = sum + square.scale(weight);
        (mean, root) = ((mean + root).scale(0.5), (mean * root).sqrt());
        weight *= 2.0;
        // The next difference is half²/(2 mean), of no account for K and E.
        if square.hi() * weight < 1e-35 * mean.hi() * mean.hi() && square.hi() < 1e-35 * mean.hi() * mean.hi() {
            break;
        }
    }
    let first = PI.scale(0.5) / mean;
    (first, first * (Ball::ONE - sum))
}

/// [`arguments`] as balls.
fn ball_arguments(phi: DoubleDouble, m: DoubleDouble) -> Option<(Ball, Ball, Ball)> {
    if !(phi.hi >= 0.0 && phi.sub(PI.value.scale(0.5)).hi <= 1e-30 && m.sub(DoubleDouble::ONE).hi <= 0.0 && m.hi.is_finite()) {
        return None;
    }
    let (sine, cosine) = Ball::exact(phi).sin_cos();
    let (m, cosine2, sine2) = (Ball::exact(m), cosine.square(), sine.square());
    let delta2 = if m.hi() > 0.0 { cosine2 + (Ball::ONE - m) * sine2 } else { Ball::ONE - m * sine2 };
    Some((sine, cosine2, delta2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_the_domain() {
        assert_eq!(ellipk(1.0), f64::INFINITY);
        assert_eq!(ellipf(0.0, 0.5), 0.0);
        assert_eq!(ellipe_inc(0.0, -5.0), 0.0);
        for value in [ellipk(1.5), ellipe(f64::NAN), ellipf(2.0, 0.5), ellipe_inc(0.5, 1.5), ellipf(-0.1, 0.5)] {
            assert!(value.is_nan());
        }
    }
}
