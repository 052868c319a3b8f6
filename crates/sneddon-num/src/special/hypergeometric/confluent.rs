//! Kummer's confluent hypergeometric function.

use crate::special::ball::Ball;
use crate::special::ball::ENOUGH;
use crate::special::gamma::is_pole;
use crate::special::hypergeometric::continuation::asymptotic;
use crate::special::hypergeometric::series::series;
use crate::{DoubleDouble, Precise};

/// Kummer's `1F1(a; b; z) = Σ (a)_k / (b)_k z^k / k!`.
///
/// Domain: real `a`, `b`, `z`; `b` must not be a whole number <= 0 (unless the polynomial ends before). NaN elsewhere and if
/// the value is outside the range of doubles.
///
/// Accuracy: the value is within 2.5 ulp wherever it is not NaN, by its computed bound; measured at most 0.51 ulp.
///
/// Source: as [`hyp1f1_precise`].
///
/// ```
/// use sneddon_num::special::hyp1f1;
/// assert_eq!(hyp1f1(1.5, 1.5, -2.0), (-2.0_f64).exp());
/// assert!((hyp1f1(1.0, 2.0, -1e6) - 1e-6).abs() < 1e-21);
/// ```
pub fn hyp1f1(a: f64, b: f64, z: f64) -> f64 {
    checked([a, b, z].map(Ball::from)).rounded(ENOUGH)
}

/// [`hyp1f1`] with about 30 digits.
///
/// Method: the series for `z >= 0`, Kummer's transformation for `z < 0`, the asymptotic series for `z < -90`.
///
/// Source: DLMF 13.2.2, 13.2.39, 13.7.2.
///
/// ```
/// use sneddon_num::special::hyp1f1_precise;
/// assert!(hyp1f1_precise([1.0, 2.5, -3.0].map(Into::into)).error < 1e-28);
/// ```
pub fn hyp1f1_precise(arguments: [DoubleDouble; 3]) -> Precise {
    checked(arguments.map(Ball::exact)).precise()
}

fn checked([a, b, z]: [Ball; 3]) -> Ball {
    if [a, b, z].iter().any(|p| !p.hi().is_finite()) {
        return Ball::NONE;
    }
    if z.hi() == 0.0 || a.hi() == 0.0 {
        return if is_pole(b) && z.hi() != 0.0 { Ball::NONE } else { Ball::ONE };
    }
    if is_pole(b) && !(is_pole(a) && a.hi() >= b.hi()) {
        return Ball::NONE;
    }
    confluent(a, b, z)
}

/// `1F1` at finite arguments off the poles.
pub(crate) fn confluent(a: Ball, b: Ball, z: Ball) -> Ball {
    let difference = b - a;
    if is_pole(b) || is_pole(a) {
        return series(&[a], &[b], z);
    }
    if z.hi() >= 0.0 {
        let value = series(&[a], &[b], z);
        // Kummer's form may be a polynomial, or free of the signs of (a)_k.
        return if value.relative() < 1e-26 { value } else { value.better(series(&[difference], &[b], -z) * z.exp()) };
    }
    if z.hi() < -90.0 && !is_pole(difference) {
        let far = asymptotic(&[a], &[b], z);
        if far.relative() < 1e-26 {
            return far;
        }
        return far.better(series(&[difference], &[b], -z) * z.exp());
    }
    let value = series(&[difference], &[b], -z) * z.exp();
    if value.relative() < 1e-26 { value } else { value.better(series(&[a], &[b], z)) }
}
