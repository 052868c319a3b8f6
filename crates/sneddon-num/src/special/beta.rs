//! The generalised incomplete beta function.

use super::ball::{Ball, UNIT};
use super::gamma::{gamma_ratio, is_pole};
use crate::special::ball::ENOUGH;
use crate::special::hypergeometric::series::series;
use crate::{DoubleDouble, Precise, work};

/// `B(a, b; z1, z2) = ∫_{z1}^{z2} t^(a-1) (1-t)^(b-1) dt`.
///
/// Domain: real `a`, `b`, `0 <= z1, z2 <= 1`; infinite if an end meets a power of -1 or below; NaN elsewhere.
/// The sign turns with `z1 > z2`.
///
/// Accuracy: the value is within 2.5 ulp wherever it is not NaN, by its own bound; measured at most 0.51 ulp, also
/// for `z1` next to `z2`. At `z2` next to 1 the double `z2` is what counts, not its distance to 1.
///
/// Source: as [`betainc_precise`].
///
/// ```
/// use sneddon_num::special::betainc;
/// assert!((betainc(1.0, 1.0, 0.25, 0.75) - 0.5).abs() < 1e-16);
/// assert!((betainc(0.5, 0.5, 0.0, 1.0) - std::f64::consts::PI).abs() < 1e-15);
/// ```
pub fn betainc(a: f64, b: f64, z1: f64, z2: f64) -> f64 {
    if diverges(a, b, z1.min(z2), z1.max(z2)) {
        return if z1 < z2 { f64::INFINITY } else { f64::NEG_INFINITY };
    }
    between([a, b, z1, z2].map(Ball::from)).rounded(ENOUGH)
}

/// [`betainc`] with about 30 digits.
///
/// Method: the interval is cut at 1/2 and its right part mirrored. From 0 the series of `2F1(p+q, 1; p+1; v)`;
/// elsewhere differences of it where one end is far below the other, else Taylor's series about the middle of panels
/// whose ends have the ratio 2: all of one sign, for every `a` and `b`.
///
/// Source: DLMF 8.17.7, 8.17.8 and the definition.
///
/// ```
/// use sneddon_num::special::betainc_precise;
/// assert!(betainc_precise([0.5, -1.0, 0.25, 0.5].map(Into::into)).error < 1e-28);
/// ```
pub fn betainc_precise(arguments: [DoubleDouble; 4]) -> Precise {
    between(arguments.map(Ball::exact)).precise()
}

fn diverges(a: f64, b: f64, low: f64, high: f64) -> bool {
    low < high && low >= 0.0 && high <= 1.0 && ((low == 0.0 && a <= 0.0) || (high == 1.0 && b <= 0.0)) && a.is_finite() && b.is_finite()
}

fn between([a, b, z1, z2]: [Ball; 4]) -> Ball {
    if [a, b, z1, z2].iter().any(|p| !p.hi().is_finite()) {
        return Ball::NONE;
    }
    let width = z2 - z1;
    if width.hi() < 0.0 {
        return -between([a, b, z2, z1]);
    }
    if width.hi() == 0.0 {
        return Ball::ZERO;
    }
    let (left1, left2) = (Ball::ONE - z1, Ball::ONE - z2);
    if z1.hi() < 0.0 || left2.hi() < 0.0 || diverges(a.hi(), b.hi(), z1.hi(), 1.0 - left2.hi()) {
        return Ball::NONE;
    }
    if z1.hi() == 0.0 && left2.hi() == 0.0 {
        return gamma_ratio(&[a, b], &[a + b]);
    }
    if z2.hi() <= 0.5 {
        return part(a, b, z1, z2, width);
    }
    if left1.hi() <= 0.5 {
        return part(b, a, left2, left1, width);
    }
    // A short interval across 1/2 is one panel.
    if z2.hi() < 0.6 && z1.hi() > 0.4 {
        return panel(a, b, z1, width);
    }
    let half = Ball::from(0.5);
    let below = if z1.hi() < 0.5 { part(a, b, z1, half, half - z1) } else { Ball::ZERO };
    let above = if left2.hi() < 0.5 { part(b, a, left2, half, half - left2) } else { Ball::ZERO };
    below + above
}

/// `∫_u^v t^(p-1) (1-t)^(q-1) dt`, `0 <= u < v <= 1/2` up to a rounding, `width = v - u`.
fn part(p: Ball, q: Ball, u: Ball, v: Ball, width: Ball) -> Ball {
    if u.hi() == 0.0 {
        return if p.hi() > 0.0 { from_zero(p, q, v) } else { Ball::NONE };
    }
    let ratio = v.hi() / u.hi();
    if ratio > 16.0 && !is_pole(p) {
        let difference = from_zero(p, q, v) - from_zero(p, q, u);
        if difference.relative() < 1e-26 {
            return difference;
        }
    }
    let mut sum = Ball::ZERO;
    let (mut low, mut left) = (u, width);
    for _ in 0..1100 {
        work::spend(100);
        if left.hi() <= low.hi() {
            return sum + panel(p, q, low, left);
        }
        sum = sum + panel(p, q, low, low);
        left = left - low;
        low = low.scale(2.0);
    }
    Ball::NONE
}

/// The antiderivative `v^p (1-v)^q / p · 2F1(p+q, 1; p+1; v)`, which is the integral from 0 for `p > 0`.
fn from_zero(p: Ball, q: Ball, v: Ball) -> Ball {
    let power = (v.ln() * p).exp();
    let one = power * ((-v).ln_1p() * q).exp() * series(&[p + q, Ball::ONE], &[p + 1.0], v) / p;
    if one.relative() < 1e-26 {
        return one;
    }
    one.better(power * series(&[p, Ball::ONE - q], &[p + 1.0], v) / p)
}

/// `∫ t^(p-1) (1-t)^(q-1) dt` over `low < t < low + width`, by Taylor's series about the middle `m`:
/// with `t = m + h s` the coefficients have three terms, and every second one counts.
fn panel(p: Ball, q: Ball, low: Ball, width: Ball) -> Ball {
    let half = width.scale(0.5);
    let middle = low + half;
    let rest = Ball::ONE - middle;
    let scale = (middle.ln() * (p - 1.0) + rest.ln() * (q - 1.0)).exp();
    // h(s) = (1 + x s)^(p-1) (1 - y s)^(q-1): (1 + x s)(1 - y s) h' = ((p-1) x (1 - y s) - (q-1) y (1 + x s)) h.
    let (x, y) = ((half / middle).value, (half / rest).value);
    let (left, right) = ((p - 1.0).value, (q - 1.0).value);
    let first = left.mul(x).sub(right.mul(y));
    let second = x.mul(y).mul(left.add(right)).neg();
    let (slope, product) = (x.sub(y), x.mul(y));
    let (mut before, mut now) = (DoubleDouble::from(0.0), DoubleDouble::ONE);
    let (mut sum, mut error, mut largest) = (DoubleDouble::ONE, 0.0, 1.0_f64);
    for k in 0..600_u32 {
        let order = f64::from(k);
        // (k+1) c_(k+1) = (first - k (x-y)) c_k + (second + (k-1) x y) c_(k-1).
        let one = first.sub(slope.mul(order.into())).mul(now);
        let two = second.add(product.mul((order - 1.0).into())).mul(before);
        let next = one.add(two).div((order + 1.0).into());
        before = now;
        now = next;
        largest = largest.max(now.hi.abs());
        error +=
            8.0 * UNIT * (one.hi.abs() + two.hi.abs()) / (order + 1.0) + 4.0 * UNIT * now.hi.abs() * (1.0 + left.hi.abs() + right.hi.abs());
        if k % 2 == 1 {
            sum = sum.add(now.div((order + 2.0).into()));
            let size = now.hi.abs().max(before.hi.abs());
            if order > left.hi.abs() + right.hi.abs() && size < 0.001 * UNIT * sum.hi.abs() {
                return scale * width * Ball { value: sum, error: error + 4.0 * size + UNIT * largest };
            }
        }
    }
    Ball::NONE
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_the_domain() {
        assert_eq!(betainc(0.0, 1.0, 0.0, 0.5), f64::INFINITY);
        assert_eq!(betainc(2.0, -0.5, 0.5, 1.0), f64::INFINITY);
        assert_eq!(betainc(2.0, 3.0, 0.25, 0.25), 0.0);
        assert_eq!(betainc(2.0, 3.0, 0.5, 0.25), -betainc(2.0, 3.0, 0.25, 0.5));
        assert!(betainc(1.0, 1.0, -0.1, 0.5).is_nan() && betainc(1.0, 1.0, 0.1, 1.5).is_nan() && betainc(1.0, f64::NAN, 0.1, 0.5).is_nan());
        assert!((betainc(0.0, 1.0, 0.25, 0.5) - std::f64::consts::LN_2).abs() < 1e-16);
    }
}
